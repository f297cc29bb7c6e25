//! f at a point in plain `f64`, without any guarantee: `Surface::at`, and the defaults of fields.

use super::block::Target;
use super::enclosure::enter_fields;
use super::text::{float, index, variable};
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope};
use crate::tree::FoldKind;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The target.
pub struct Plain<'a> {
    /// The graph.
    pub graph: &'a Graph,
    /// Names of the fields.
    pub fields: &'a [Ident],
}

impl Target for Plain<'_> {
    type Value = Ident;

    fn ready(&self, _: Id) -> bool {
        false
    }

    fn given(&mut self, id: Id, out: &mut TokenStream) -> Option<Ident> {
        let code = match self.graph.op(id) {
            Op::Literal(r) => float(crate::rational::nearest(r)),
            Op::Pi => quote!(__zeroset::primitive::consts::PI),
            Op::Coordinate(axis) => {
                let axis = Literal::usize_unsuffixed(*axis);
                quote!(point[#axis])
            }
            Op::Field(field, indices) => {
                let (name, indices) = (self.fields.get(*field)?, indices.iter().map(index));
                quote!(self.#name #(#indices)*)
            }
            Op::Row(fold, column) => {
                let row = format_ident!("r{fold}");
                let column = column.map(Literal::usize_unsuffixed).map(|c| quote!([#c]));
                quote!(#row #column)
            }
            Op::Counter(fold) => {
                let counter = format_ident!("i{fold}");
                quote!(#counter as __zeroset::primitive::f64)
            }
            _ => return None,
        };
        let name = variable(id);
        out.extend(quote!(let #name = #code;));
        Some(name)
    }

    fn operation(
        &mut self,
        id: Id,
        values: &dyn Fn(Id) -> Option<Ident>,
        out: &mut TokenStream,
    ) -> Ident {
        let v = |id: &Id| values(*id).map_or_else(|| quote!(()), |v| v.to_token_stream());
        let code = match self.graph.op(id) {
            Op::Negate(a) => {
                let a = v(a);
                quote!(-#a)
            }
            Op::Add(a, b) => infix(v(a), quote!(+), v(b)),
            Op::Subtract(a, b) => infix(v(a), quote!(-), v(b)),
            Op::Multiply(a, b) => infix(v(a), quote!(*), v(b)),
            Op::Divide(a, b) => infix(v(a), quote!(/), v(b)),
            Op::Power(a, 2) => infix(v(a), quote!(*), v(a)),
            Op::Power(a, n) => {
                let (a, n) = (
                    v(a),
                    Literal::i32_unsuffixed(i32::try_from(*n).unwrap_or(i32::MAX)),
                );
                quote!(#a.powi(#n))
            }
            Op::RealPower(a, b) => method(v(a), "powf", Some(v(b))),
            Op::Unary(f, a) => method(v(a), f.entry().name, None),
            Op::Binary(f, a, b) => method(v(a), f.entry().name, Some(v(b))),
            Op::AbsSlope(a) => method(v(a), "signum", None),
            Op::Less(a, b) => infix(v(a), quote!(<), v(b)),
            Op::LessOrEqual(a, b) => infix(v(a), quote!(<=), v(b)),
            Op::Both(a, b) => infix(v(a), quote!(&&), v(b)),
            Op::Either(a, b) => infix(v(a), quote!(||), v(b)),
            Op::Choose(c, a, b, _) => {
                let (c, a, b) = (v(c), v(a), v(b));
                quote!(if #c { #a } else { #b })
            }
            _ => quote!(()),
        };
        let name = variable(id);
        out.extend(quote!(let #name = #code;));
        name
    }

    fn enter(&mut self, fold: usize, _: Scope) -> (TokenStream, TokenStream) {
        enter_fields(self.graph, self.fields, fold)
    }

    fn accumulate(
        &mut self,
        id: Id,
        fold: (FoldKind, usize),
        arguments: &[Ident],
    ) -> (TokenStream, TokenStream, Ident) {
        let name = variable(id);
        let infinity = quote!(__zeroset::primitive::f64::INFINITY);
        let (start, update) = match (fold.0, arguments.first()) {
            (FoldKind::Sum, Some(b)) => (quote!(0.0), quote!(#name += #b;)),
            (FoldKind::Product, Some(b)) => (quote!(1.0), quote!(#name *= #b;)),
            (FoldKind::Minimum, Some(b)) => (infinity, quote!(#name = #name.min(#b);)),
            (FoldKind::Maximum, Some(b)) => (quote!(-#infinity), quote!(#name = #name.max(#b);)),
            (_, None) => (quote!(0.0), quote!()),
        };
        (
            quote!(let mut #name: __zeroset::primitive::f64 = #start;),
            update,
            name,
        )
    }

    fn finish(&mut self, _: Id, value: Ident, _: &mut TokenStream) -> Ident {
        value
    }
}

fn infix(a: TokenStream, operator: TokenStream, b: TokenStream) -> TokenStream {
    quote!(#a #operator #b)
}

/// std's methods carry the functions' names.
fn method(a: TokenStream, name: &str, b: Option<TokenStream>) -> TokenStream {
    let name = if name == Function::Ln1p.entry().name {
        format_ident!("ln_1p")
    } else {
        format_ident!("{name}")
    };
    quote!(#a.#name(#b))
}
