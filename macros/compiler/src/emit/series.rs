//! The ray stage of polynomials of higher degree: their coefficients in t, by propagation through the graph as written.

use super::block::Target;
use super::folds::{Visit, enter_rows};
use super::layout::Layout;
use super::text::{interval, variable};
use crate::graph::{Graph, Id, Op, Scope};
use crate::tree::FoldKind;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// The target. Values are arrays of coefficients, around the middle of the rays.
pub struct Series<'a> {
    /// The graph.
    pub graph: &'a Graph,
    /// The storage.
    pub layout: &'a Layout,
}

impl Series<'_> {
    /// Names the coefficients of a node and computes them. The length of an array tells the runtime the degree.
    fn define(&self, id: Id, code: &TokenStream, out: &mut TokenStream) -> Ident {
        let (name, length) = (variable(id), self.length(id));
        out.extend(quote!(let #name: [_; #length] = #code;));
        name
    }

    fn length(&self, id: Id) -> Literal {
        let degree = self.graph.info(id).degree.unwrap_or(0);
        Literal::usize_unsuffixed(degree as usize + 1)
    }

    /// aⁿ by squares and products.
    fn power(&self, a: &TokenStream, degree: u32, n: u32) -> TokenStream {
        let length = |n: u32| Literal::usize_unsuffixed((degree * n) as usize + 1);
        if n <= 1 {
            return a.clone();
        }
        let (half, of) = (self.power(a, degree, n / 2), length(n / 2));
        let whole = length(n);
        if n.is_multiple_of(2) {
            return quote!({ let half: [_; #of] = #half; __zeroset::series::square::<P, #of, #whole>(a, &half) });
        }
        let (rest, less) = (self.power(a, degree, n - 1), length(n - 1));
        quote!({ let rest: [_; #less] = #rest; __zeroset::series::product(a, &rest, &#a) })
    }
}

impl Target for Series<'_> {
    type Value = Ident;

    fn ready(&self, id: Id) -> bool {
        !self.graph.varies(id)
    }

    fn given(&mut self, id: Id, out: &mut TokenStream) -> Option<Ident> {
        let code = match self.graph.op(id) {
            Op::Literal(r) => {
                let r = interval(r);
                quote!([a.constant(&#r)])
            }
            Op::Coordinate(axis) => {
                let axis = Literal::usize_unsuffixed(*axis);
                quote!([middle[#axis], rays.direction[#axis]])
            }
            _ if !self.graph.varies(id) => {
                let place = self.layout.value(id)?;
                quote!([a.constant(&#place)])
            }
            _ => return None,
        };
        Some(self.define(id, &code, out))
    }

    fn operation(
        &mut self,
        id: Id,
        values: &dyn Fn(Id) -> Option<Ident>,
        out: &mut TokenStream,
    ) -> Ident {
        let get = |id: &Id| values(*id).map_or_else(|| quote!([]), |name| quote!(#name));
        let two = |name: TokenStream, a: &Id, b: &Id| {
            let (a, b) = (get(a), get(b));
            quote!(__zeroset::series::#name(a, &#a, &#b))
        };
        let code = match self.graph.op(id) {
            Op::Negate(a) => {
                let a = get(a);
                quote!(__zeroset::series::negative(a, &#a))
            }
            Op::Add(a, b) => two(quote!(sum), a, b),
            Op::Subtract(a, b) => two(quote!(difference), a, b),
            Op::Multiply(a, b) => two(quote!(product), a, b),
            Op::Power(a, n) => {
                let degree = self.graph.info(*a).degree.unwrap_or(0);
                self.power(&get(a), degree, *n)
            }
            // No other operation is a polynomial.
            _ => quote!([]),
        };
        self.define(id, &code, out)
    }

    fn enter(&mut self, fold: usize, scope: Scope) -> (TokenStream, TokenStream) {
        enter_rows(self.graph, self.layout, fold, scope, Visit::All)
    }

    fn accumulate(
        &mut self,
        id: Id,
        _: (FoldKind, usize),
        arguments: &[Ident],
    ) -> (TokenStream, TokenStream, Ident) {
        let (name, length) = (variable(id), self.length(id));
        let body = arguments.first();
        let declare = quote!(let mut #name: [_; #length] = __zeroset::series::zero(a););
        let update = quote!(#name = __zeroset::series::sum(a, &#name, &#body););
        (declare, update, name)
    }

    fn finish(&mut self, _: Id, value: Ident, _: &mut TokenStream) -> Ident {
        value
    }
}
