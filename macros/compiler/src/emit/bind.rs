//! The ray stage: leaves and polynomials along a packet's rays.

use super::block::block;
use super::folds::{Visit, enter_rows};
use super::polynomial::{Coefficients, Polynomial, enter_active};
use super::series::Series;
use super::stages::Compiled;
use crate::graph::{Id, Scope};
use crate::stage::Leaf;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

impl Compiled<'_> {
    /// `unbound`, `bind_leaves` and `bind_series`: the ray stage.
    pub fn bind(&self) -> TokenStream {
        let top = self.bind_top();
        let linear = Literal::usize_unsuffixed(self.layout.top.linear.len());
        let quadratic = Literal::usize_unsuffixed(self.layout.top.quadratic.len());
        let new = self
            .layout
            .rows
            .iter()
            .map(|_| quote!(__zeroset::Vec::new()));
        let active = self.layout.copy_active(&quote!(bound));
        let regions = self.layout.choices.known(&quote!(active));
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
                #regions
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
            leaves: HashMap::new(),
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

    /// Writes the leaves without loops around them, each where its guard is alive.
    fn bind_top(&self) -> TokenStream {
        let store = &self.layout.top;
        let mut target = self.polynomial();
        let mut nodes = Vec::new();
        for (part, kind, leaves) in [
            (0, "Linear", &store.linear),
            (1, "Quadratic", &store.quadratic),
        ] {
            let (part, kind) = (Literal::u8_unsuffixed(part), format_ident!("{kind}"));
            for (index, leaf) in leaves.iter().enumerate() {
                let index = Literal::usize_unsuffixed(index);
                let place = quote!(bound.#part[#index]);
                if let Some(leaf) = self.staged.leaves.get(*leaf) {
                    target.leaves.insert(leaf.node, (kind.clone(), place));
                    nodes.push(leaf.node);
                }
            }
        }
        let mut body = TokenStream::new();
        block(
            self.graph,
            &mut target,
            Scope::default(),
            &nodes,
            &mut HashMap::new(),
            &mut body,
        );
        body
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
