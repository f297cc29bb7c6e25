//! f at a point in plain `f64`, without any guarantee: `Surface::at`, and the defaults of fields.
//!
//! It has the shape of the source and carries the user's own tokens. So an editor finds what a name inside the macro
//! means, and rustc reports the fields and `let`s that nothing uses.

use super::text::float;
use crate::exact::Rational;
use crate::tree::{Condition, FoldKind, Formula, Index, Operator, Over, Term, TermKind};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// `at`: left − right, after the `let`s.
pub fn at(formula: &Formula) -> TokenStream {
    let scalar = Scalar { formula };
    let lets = scalar.lets(&formula.body);
    let left = scalar.term(&formula.left);
    let value = match &formula.right {
        Some(right) => {
            let right = scalar.term(right);
            // A fold is a block, which must not begin a statement.
            quote!(let value = #left - #right; value)
        }
        None => left,
    };
    quote! {
        fn at(&self, point: [__zeroset::primitive::f64; 3]) -> __zeroset::primitive::f64 {
            #lets
            #value
        }
    }
}

/// A constant, as an expression.
pub fn constant(formula: &Formula, term: &Term) -> TokenStream {
    Scalar { formula }.term(term)
}

struct Scalar<'a> {
    formula: &'a Formula,
}

impl Scalar<'_> {
    fn lets(&self, indices: &[usize]) -> TokenStream {
        let lets = indices.iter().filter_map(|k| self.formula.lets.get(*k));
        let lines = lets.map(|l| {
            let (name, value) = (&l.name, self.term(&l.value));
            let quiet = l.known.then(|| quote!(#[allow(unused_variables)]));
            quote!(#quiet let #name: __zeroset::primitive::f64 = #value;)
        });
        quote!(#(#lines)*)
    }

    fn term(&self, term: &Term) -> TokenStream {
        if let Some(number) = self.rational(term, 0) {
            return float(crate::rational::nearest(&number));
        }
        match &term.kind {
            TermKind::Number(number) => float(crate::rational::nearest(number)),
            TermKind::Pi(name) | TermKind::Tau(name) => quote!(__zeroset::language::#name()),
            TermKind::Coordinate(_, name) => quote!(__zeroset::language::#name(&point)),
            TermKind::Field {
                field: _,
                name,
                indices,
            } => {
                let indices = indices.iter().map(|i| self.index(i));
                quote!(self.#name #(#indices)*)
            }
            TermKind::Let(_, name) => quote!(#name),
            TermKind::Row { fold, column, name } => self.row(*fold, *column, name),
            TermKind::Counter(_, name) => quote!((#name as __zeroset::primitive::f64)),
            TermKind::Negate(a) => {
                let a = self.term(a);
                quote!((-#a))
            }
            TermKind::Binary(operator, a, b) => self.binary(*operator, a, b),
            TermKind::Call(_, name, arguments) => {
                let arguments = arguments.iter().map(|a| self.term(a));
                quote!(__zeroset::language::#name(#(#arguments),*))
            }
            TermKind::Fold(kind, fold, body) => self.fold(*kind, *fold, body),
            TermKind::Block(lets, value) => {
                let (lets, value) = (self.lets(lets), self.term(value));
                quote!({ #lets #value })
            }
            TermKind::If(condition, yes, no) => {
                let condition = self.condition(condition);
                let (yes, no) = (self.term(yes), self.term(no));
                quote!((if #condition { #yes } else { #no }))
            }
        }
    }

    /// The value of numbers under `+ − * /`, so that `1/3` is one rounding and exponents are known.
    fn rational(&self, term: &Term, depth: u32) -> Option<Rational> {
        // Names stay names.
        match &term.kind {
            TermKind::Number(number) => Some(number.clone()),
            TermKind::Negate(a) if depth < 64 => Some(-self.rational(a, depth + 1)?),
            TermKind::Binary(operator, a, b) if depth < 64 => {
                let a = self.rational(a, depth + 1)?;
                let b = self.rational(b, depth + 1)?;
                match operator {
                    Operator::Add => Some(&a + &b),
                    Operator::Subtract => Some(&a - &b),
                    Operator::Multiply => Some(&a * &b),
                    Operator::Divide => a.over(&b),
                    Operator::Power => None,
                }
            }
            _ => None,
        }
    }

    fn binary(&self, operator: Operator, a: &Term, b: &Term) -> TokenStream {
        let base = self.term(a);
        if operator == Operator::Power {
            let whole = self.rational(b, 0).filter(Rational::is_integer);
            return match whole.and_then(|e| i32::try_from(e.to_i64()?).ok()) {
                Some(n) => {
                    let size = Literal::i32_suffixed(n.saturating_abs());
                    let n = if n.is_negative() {
                        quote!(-#size)
                    } else {
                        quote!(#size)
                    };
                    quote!(__zeroset::primitive::f64::powi(#base, #n))
                }
                None => {
                    let exponent = self.term(b);
                    quote!(__zeroset::primitive::f64::powf(#base, #exponent))
                }
            };
        }
        let b = self.term(b);
        match operator {
            Operator::Add => quote!((#base + #b)),
            Operator::Subtract => quote!((#base - #b)),
            Operator::Divide => quote!((#base / #b)),
            Operator::Multiply | Operator::Power => quote!((#base * #b)),
        }
    }

    fn row(&self, fold: usize, column: Option<usize>, name: &Ident) -> TokenStream {
        let list = self.formula.folds.get(fold).is_some_and(|f| f.list);
        match column.filter(|_| !list).map(Literal::usize_unsuffixed) {
            Some(column) => quote!(#name[#column]),
            None => quote!(#name),
        }
    }

    fn index(&self, index: &Index) -> TokenStream {
        match index {
            Index::Constant(k) => {
                let k = Literal::usize_unsuffixed(*k);
                quote!([#k])
            }
            Index::Counter(fold, shift) => {
                let name = self.formula.folds.get(*fold).and_then(|f| f.names.first());
                let shift = Literal::i64_suffixed(*shift);
                quote!([(#name + #shift) as __zeroset::primitive::usize])
            }
        }
    }

    fn fold(&self, kind: FoldKind, fold: usize, body: &Term) -> TokenStream {
        let Some(over) = self.formula.folds.get(fold) else {
            return quote!(0.0);
        };
        let names = &over.names;
        let pattern = if over.list {
            quote!([#(#names),*])
        } else {
            quote!(#(#names)*)
        };
        let rows = match &over.over {
            Over::Range(start, end) => {
                let (start, end) = (Literal::i64_suffixed(*start), Literal::i64_suffixed(*end));
                quote!(#start..#end)
            }
            Over::Table { name, indices, .. } => {
                let indices = indices.iter().map(|i| self.index(i));
                quote!(self.#name #(#indices)*.iter().copied())
            }
        };
        let body = self.term(body);
        let sum = Ident::new("folded", Span::mixed_site());
        let (start, step) = match kind {
            FoldKind::Sum => (quote!(0.0), quote!(#sum + #body)),
            FoldKind::Product => (quote!(1.0), quote!(#sum * #body)),
            FoldKind::Minimum => (
                float(f64::INFINITY),
                quote!(__zeroset::language::min(#sum, #body)),
            ),
            FoldKind::Maximum => (
                float(f64::NEG_INFINITY),
                quote!(__zeroset::language::max(#sum, #body)),
            ),
        };
        quote!({
            let mut #sum: __zeroset::primitive::f64 = #start;
            for #pattern in #rows { #sum = #step; }
            #sum
        })
    }

    fn condition(&self, condition: &Condition) -> TokenStream {
        match condition {
            Condition::Less(a, b) => {
                let (a, b) = (self.term(a), self.term(b));
                quote!((#a < #b))
            }
            Condition::LessOrEqual(a, b) => {
                let (a, b) = (self.term(a), self.term(b));
                quote!((#a <= #b))
            }
            Condition::Both(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                quote!((#a && #b))
            }
            Condition::Either(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                quote!((#a || #b))
            }
        }
    }
}
