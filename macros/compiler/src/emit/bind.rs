//! The ray stage: leaves and polynomials along a packet's rays.

use super::block::block;
use super::folds::{Visit, enter_rows};
use super::polynomial::{Coefficients, Polynomial, enter_active};
use super::series::Series;
use super::stages::Compiled;
use crate::graph::{Id, Scope};
use crate::stage::Leaf;
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::collections::HashMap;

impl Compiled<'_> {
    /// `unbound`, `bind_leaves` and `bind_series`: the ray stage.
    pub fn bind(&self) -> TokenStream {
        let top = self.bind_scope(Scope::default());
        let linear = Literal::usize_unsuffixed(self.layout.top.linear.len());
        let quadratic = Literal::usize_unsuffixed(self.layout.top.quadratic.len());
        let new = self
            .layout
            .rows
            .iter()
            .map(|_| quote!(__zeroset::Vec::new()));
        let active = self.layout.copy_active(&quote!(bound));
        let sides = self.layout.choices.declare(&quote!(active));
        let mut before = TokenStream::new();
        let shared = self.bind_shared(&mut before);
        let rows = (0..self.layout.rows.len()).map(|k| self.bind_rows(k, &shared));
        let lengths = self.layout.coefficients();
        let room = quote!((#(L::polynomial::<#lengths>(p),)*));
        let polynomials = self.bind_polynomials();
        quote! {
            #[inline(always)]
            fn unbound<L: __zeroset::Leaves>(p: L::Packet) -> Self::Bound<L> {
                (
                    [L::linear(p); #linear],
                    [L::quadratic(p); #quadratic],
                    __zeroset::Default::default(),
                    #(#new,)*
                    #room,
                )
            }

            #[inline(always)]
            fn bind_leaves<P: __zeroset::Packet>(
                a: P,
                prepared: &Self::Prepared,
                rays: &__zeroset::Rays<P>,
                active: &__zeroset::Active,
                bound: &mut Self::Bound<P>,
            ) {
                #active
                #sides
                #top
                #before
                #(#rows)*
            }

            #polynomials
        }
    }

    fn polynomial(&self) -> Polynomial<'_> {
        Polynomial {
            graph: self.graph,
            layout: self.layout,
        }
    }

    /// What all rows' leaves are made of: computed once, before the loops.
    fn bind_shared(&self, out: &mut TokenStream) -> HashMap<Id, Coefficients> {
        let of_rows = |leaf: &&Leaf| self.graph.info(leaf.node).scope != Scope::default();
        let leaves = self.staged.leaves.iter().filter(of_rows);
        let nodes: Vec<Id> = leaves.map(|l| l.node).collect();
        let shared = |id: Id| self.graph.info(id).scope == Scope::default();
        let mut all = self.graph.reachable(&nodes, shared);
        all.retain(|id| shared(*id) && self.graph.varies(*id));
        let mut known = HashMap::new();
        let target = &mut self.polynomial();
        block(self.graph, target, Scope::default(), &all, &mut known, out);
        known
    }

    /// The leaves of a scope, as (linear, quadratic) expressions after the code that computes them.
    fn leaves(
        &self,
        scope: Scope,
        linear: &[usize],
        quadratic: &[usize],
        known: &HashMap<Id, Coefficients>,
    ) -> (TokenStream, Vec<TokenStream>, Vec<TokenStream>) {
        let mut body = TokenStream::new();
        let node = |k: &usize| self.staged.leaves.get(*k).map(|l| l.node);
        let targets: Vec<Id> = linear.iter().chain(quadratic).filter_map(node).collect();
        let values = block(
            self.graph,
            &mut self.polynomial(),
            scope,
            &targets,
            &mut known.clone(),
            &mut body,
        );
        let (first, second) = values.split_at(linear.len().min(values.len()));
        let linear = first
            .iter()
            .map(|c| quote!(__zeroset::Linear::new(a, #(#c),*)))
            .collect();
        let quadratic = second
            .iter()
            .map(|c| quote!(__zeroset::Quadratic::new(a, #(#c),*)))
            .collect();
        (body, linear, quadratic)
    }

    fn bind_scope(&self, scope: Scope) -> TokenStream {
        let store = &self.layout.top;
        let (body, linear, quadratic) =
            self.leaves(scope, &store.linear, &store.quadratic, &HashMap::new());
        if linear.is_empty() && quadratic.is_empty() {
            return TokenStream::new();
        }
        let linear = self.where_alive(
            &store.linear,
            &linear,
            |i, code| quote!(bound.0[#i] = #code;),
        );
        let quadratic = self.where_alive(
            &store.quadratic,
            &quadratic,
            |j, code| quote!(bound.1[#j] = #code;),
        );
        quote!(#body #linear #quadratic)
    }

    /// Writes leaves of the scope without loops, each where its guard is alive.
    fn where_alive(
        &self,
        leaves: &[usize],
        codes: &[TokenStream],
        write: impl Fn(Literal, &TokenStream) -> TokenStream,
    ) -> TokenStream {
        let all = leaves
            .iter()
            .zip(codes)
            .enumerate()
            .map(|(place, (leaf, code))| {
                let code = write(Literal::usize_unsuffixed(place), code);
                self.layout.guarded(self.staged, *leaf, code)
            });
        all.collect()
    }

    fn bind_rows(&self, k: usize, shared: &HashMap<Id, Coefficients>) -> TokenStream {
        let Some((scope, store)) = self.layout.rows.get(k) else {
            return TokenStream::new();
        };
        let (body, linear, quadratic) =
            self.leaves(*scope, &store.linear, &store.quadratic, shared);
        let place = self.layout.bound_rows(k);
        let mut code = quote!({ #body ([#(#linear),*], [#(#quadratic),*]) });
        let folds: Vec<usize> = scope.folds().collect();
        let mut around = Scope::default();
        let mut loops = Vec::new();
        for fold in folds {
            around = around.union(Scope::of(fold));
            let (header, start) = enter_rows(self.graph, self.layout, fold, around, Visit::All);
            loops.push(match self.layout.active(fold) {
                Some(list) => enter_active(fold, &list, start),
                None => (header, start),
            });
        }
        // The outermost `Vec` keeps its room from packet to packet.
        for (depth, (header, start)) in loops.into_iter().enumerate().rev() {
            code = if depth == 0 {
                quote!(#place.clear(); #header { #start let leaves = #code; #place.push(leaves); })
            } else {
                quote! {{
                    let mut rows = __zeroset::Vec::new();
                    #header { #start let leaves = #code; rows.push(leaves); }
                    rows
                }}
            };
        }
        code
    }

    /// The coefficients of polynomials of higher degree, around the middle of the rays.
    fn bind_polynomials(&self) -> TokenStream {
        let nodes: Vec<Id> = self.staged.polynomials.iter().map(|p| p.0).collect();
        if nodes.is_empty() {
            return TokenStream::new();
        }
        let mut target = Series {
            graph: self.graph,
            layout: self.layout,
        };
        let mut body = TokenStream::new();
        let values = block(
            self.graph,
            &mut target,
            Scope::default(),
            &nodes,
            &mut HashMap::new(),
            &mut body,
        );
        let places = (0..values.len()).map(|k| self.layout.polynomial(k));
        quote! {
            #[inline(always)]
            fn bind_series<P: __zeroset::Packet>(
                a: P,
                prepared: &Self::Prepared,
                rays: &__zeroset::Rays<P>,
                bound: &mut Self::Bound<P>,
            ) {
                let (half, middle) = rays.middle(a);
                #body
                #(#places = __zeroset::Polynomial::new(a, half, &#values);)*
            }
        }
    }
}
