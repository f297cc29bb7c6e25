//! The ray stage: coefficients of linear and quadratic subexpressions in t, by propagation through the graph as written.

use super::block::{Declared, Instead, Target};
use super::choices::Side;
use super::folds::{Visit, enter_rows};
use super::layout::Layout;
use super::text::{interval, variable};
use crate::graph::{Graph, Id, Op, Scope};
use crate::tree::FoldKind;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// The target.
pub struct Polynomial<'a> {
    /// The graph.
    pub graph: &'a Graph,
    /// The storage.
    pub layout: &'a Layout,
    /// The nodes whose leaf is written as soon as its coefficients are there: its type, and its place.
    pub leaves: HashMap<Id, (Ident, TokenStream)>,
}

/// The variables of the coefficients: c₀, and where the degree asks for them c₁ and c₂.
pub type Coefficients = Vec<Ident>;

impl Polynomial<'_> {
    fn names(&self, id: Id, degree: usize) -> Coefficients {
        let n = variable(id);
        (0..=degree).map(|k| format_ident!("{n}_{k}")).collect()
    }

    /// Where a number is that does not depend on the point and is an `f64`: a field's, or as it is written.
    fn exact(&self, id: Id) -> Option<TokenStream> {
        match self.graph.op(id) {
            Op::Literal(r) => {
                let (lo, hi) = crate::rational::bounds(r);
                (lo == hi).then(|| interval(r))
            }
            Op::Row(..) | Op::Field(..) | Op::Counter(_) => self.layout.value(id),
            _ => None,
        }
    }

    /// Names the coefficients of `id` and computes them.
    fn define(&self, id: Id, coefficients: &[TokenStream], out: &mut TokenStream) -> Coefficients {
        let names = self.names(id, coefficients.len().saturating_sub(1));
        for (name, code) in names.iter().zip(coefficients) {
            out.extend(quote!(let #name = #code;));
        }
        names
    }
}

impl Target for Polynomial<'_> {
    type Value = Coefficients;

    fn ready(&self, id: Id) -> bool {
        !self.graph.varies(id)
    }

    fn given(&mut self, id: Id, out: &mut TokenStream) -> Option<Coefficients> {
        let code = match self.graph.op(id) {
            Op::Literal(r) => {
                let r = interval(r);
                vec![quote!(a.constant(&#r))]
            }
            Op::Coordinate(axis) => {
                let axis = Literal::usize_unsuffixed(*axis);
                vec![quote!(rays.origin[#axis]), quote!(rays.direction[#axis])]
            }
            _ if !self.graph.varies(id) => {
                let place = self.layout.value(id)?;
                vec![quote!(a.constant(&#place))]
            }
            _ => return None,
        };
        Some(self.define(id, &code, out))
    }

    fn operation(
        &mut self,
        id: Id,
        values: &dyn Fn(Id) -> Option<Coefficients>,
        out: &mut TokenStream,
    ) -> Coefficients {
        let get = |id: &Id| values(*id).unwrap_or_default();
        let code = match self.graph.op(id) {
            Op::Negate(a) => get(a).iter().map(|c| quote!(a.neg(#c))).collect(),
            Op::Add(a, b) => sum(&get(a), &get(b)),
            Op::Subtract(a, b) => difference(&get(a), &get(b)),
            Op::Multiply(a, b) => match (self.exact(*a), self.exact(*b)) {
                (Some(s), _) => multiple(&s, &get(b)),
                (_, Some(s)) => multiple(&s, &get(a)),
                (None, None) => product(&get(a), &get(b)),
            },
            Op::Power(a, _) => square(&get(a)),
            // No other operation has degree 1 or 2.
            _ => vec![],
        };
        self.define(id, &code, out)
    }

    fn guard(&self, id: Id) -> Option<Side> {
        self.layout.choices.shape(id)
    }

    fn step(&self, from: Option<Side>, guard: Side) -> Side {
        self.layout.choices.step(from, guard)
    }

    fn keeps(&self, id: Id) -> bool {
        self.leaves.contains_key(&id)
    }

    fn write(&mut self, id: Id, value: &Coefficients, out: &mut TokenStream) {
        if let Some((kind, place)) = self.leaves.get(&id) {
            out.extend(quote!(#place = __zeroset::#kind::new(a, #(#value),*);));
        }
    }

    fn declared(&self, _: Id, value: &Coefficients, _: Option<&Coefficients>) -> Declared {
        let zero = interval(&crate::exact::Rational::from(0));
        let nothing = Instead::Code(quote!(a.constant(&#zero)));
        let all = value.iter().cloned();
        all.map(|name| (name, nothing.clone())).collect()
    }

    fn names(&self, value: &Coefficients) -> Vec<Ident> {
        value.clone()
    }

    fn enter(&mut self, fold: usize, scope: Scope) -> (TokenStream, TokenStream) {
        // A leaf holds the sum of all rows: which of them are active is a matter of loops over segments.
        enter_rows(self.graph, self.layout, fold, scope, Visit::All)
    }

    fn accumulate(
        &mut self,
        id: Id,
        _: (FoldKind, usize),
        arguments: &[Coefficients],
    ) -> (TokenStream, TokenStream, Coefficients) {
        let body = arguments.first().cloned().unwrap_or_default();
        let names = self.names(id, body.len().saturating_sub(1));
        let zero = interval(&crate::exact::Rational::from(0));
        let declare = quote!(#(let mut #names = a.constant(&#zero);)*);
        let update = quote!(#(#names = a.add(#names, #body);)*);
        (declare, update, names)
    }

    fn finish(&mut self, _: Id, value: Coefficients, _: &mut TokenStream) -> Coefficients {
        value
    }
}

/// A loop over the active rows alone.
pub fn enter_active(fold: usize, list: &Literal, start: TokenStream) -> (TokenStream, TokenStream) {
    let (j, i) = (format_ident!("j{fold}"), format_ident!("at{fold}"));
    let header = quote!(for #i in 0..active.rows[#list].len());
    (
        header,
        quote!(let #j = active.rows[#list][#i] as __zeroset::primitive::usize; #start),
    )
}

fn sum(a: &[Ident], b: &[Ident]) -> Vec<TokenStream> {
    (0..a.len().max(b.len()))
        .map(|k| match (a.get(k), b.get(k)) {
            (Some(a), Some(b)) => quote!(a.add(#a, #b)),
            (Some(c), None) | (None, Some(c)) => quote!(#c),
            (None, None) => quote!(),
        })
        .collect()
}

fn difference(a: &[Ident], b: &[Ident]) -> Vec<TokenStream> {
    (0..a.len().max(b.len()))
        .map(|k| match (a.get(k), b.get(k)) {
            (Some(a), Some(b)) => quote!(a.sub(#a, #b)),
            (Some(a), None) => quote!(#a),
            (None, Some(b)) => quote!(a.neg(#b)),
            (None, None) => quote!(),
        })
        .collect()
}

/// An exact number times a polynomial.
fn multiple(s: &TokenStream, a: &[Ident]) -> Vec<TokenStream> {
    a.iter().map(|k| quote!(a.times(&#s, #k))).collect()
}

/// (a₀ + a₁t)(b₀ + b₁t), or a number times a polynomial.
fn product(a: &[Ident], b: &[Ident]) -> Vec<TokenStream> {
    match (a, b) {
        ([c], all) | (all, [c]) => all.iter().map(|k| quote!(a.mul(#c, #k))).collect(),
        ([a0, a1], [b0, b1]) => vec![
            quote!(a.mul(#a0, #b0)),
            quote!(a.add(a.mul(#a0, #b1), a.mul(#a1, #b0))),
            quote!(a.mul(#a1, #b1)),
        ],
        _ => vec![],
    }
}

/// (a₀ + a₁t)² = a₀² + 2a₀a₁t + a₁²t²
fn square(a: &[Ident]) -> Vec<TokenStream> {
    match a {
        [a0, a1] => vec![
            quote!(a.sqr(#a0)),
            quote!({
                let half = a.mul(#a0, #a1);
                a.add(half, half)
            }),
            quote!(a.sqr(#a1)),
        ],
        _ => vec![],
    }
}
