//! The functions of `Surface`, one per binding time and entry point.

use super::block::block;
use super::enclosure::{Enclosure, Stage, Value};
use super::folds::{enter_fields, enter_rows};
use super::layout::Layout;
use super::polynomial::{Coefficients, Polynomial, enter_active};
use super::series::Series;
use crate::graph::{Graph, Id, Op, Scope};
use crate::stage::{Leaf, Staged};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// A compiled formula: the graph with everything that code is made from.
pub struct Compiled<'a> {
    /// The graph.
    pub graph: &'a Graph,
    /// The storage.
    pub layout: &'a Layout,
    /// The fields' names.
    pub fields: &'a [Ident],
    /// f in space.
    pub root: Id,
    /// The segment stage.
    pub staged: &'a Staged,
    /// f, its gradient and its Hessian (upper triangle by rows) in space.
    pub space: &'a [Id],
    /// May an operation of the surface stage be undefined?
    pub partial: bool,
}

impl Compiled<'_> {
    fn enclosure(&self, stage: Stage) -> Enclosure<'_> {
        Enclosure {
            graph: self.graph,
            layout: self.layout,
            stage,
            fields: self.fields,
        }
    }

    /// `prepare`: the surface stage, in scalars, and in twice the precision if that tells more.
    pub fn prepare(&self) -> TokenStream {
        let (body, top, rows) = self.surface_stage();
        let of = |numbers: TokenStream| {
            quote! {{
                let a = #numbers;
                let mut undefined = false;
                #body
                (#top, undefined, #(#rows,)*)
            }}
        };
        let coarse = of(quote!(__zeroset::scalar()));
        if !self.layout.twice {
            return quote!(fn prepare(&self) -> Self::Prepared { #coarse });
        }
        let fine = of(quote!(__zeroset::Fine));
        let fine_rows = (0..rows.len()).map(|k| format_ident!("fine{k}"));
        let fine_rows: Vec<Ident> = fine_rows.collect();
        quote! {
            fn prepare(&self) -> Self::Prepared {
                let (values, undefined, #(#rows,)*) = #coarse;
                let (fine, _, #(#fine_rows,)*) = #fine;
                (values, undefined, #(#rows,)* fine, #(#fine_rows,)*)
            }
        }
    }

    /// The code of the surface stage, the array of its values without loops, and the names of its rows.
    fn surface_stage(&self) -> (TokenStream, TokenStream, Vec<Ident>) {
        let mut body = TokenStream::new();
        let mut target = self.enclosure(Stage::Surface);
        let mut known = HashMap::new();
        let values = block(
            self.graph,
            &mut target,
            Scope::default(),
            &self.layout.top.values,
            &mut known,
            &mut body,
        );
        let mut rows = Vec::new();
        for (k, (scope, store)) in self.layout.rows.iter().enumerate() {
            let name = format_ident!("rows{k}");
            let code = self.prepared_rows(*scope, &store.values, &known);
            body.extend(quote!(let #name = #code;));
            rows.push(name);
        }
        body.extend(undefined(&values));
        let names = values.iter().map(|v| &v.name);
        (body, quote!([#(#names),*]), rows)
    }

    /// The rows of one scope: a `Vec` per loop.
    fn prepared_rows(
        &self,
        scope: Scope,
        values: &[Id],
        known: &HashMap<Id, Value>,
    ) -> TokenStream {
        let folds: Vec<usize> = scope.folds().collect();
        let mut target = self.enclosure(Stage::Surface);
        let mut known = known.clone();
        let mut body = TokenStream::new();
        let row = block(
            self.graph,
            &mut target,
            scope,
            values,
            &mut known,
            &mut body,
        );
        let (undefined, names) = (undefined(&row), row.iter().map(|v| &v.name));
        let mut code = quote!({ #body #undefined [#(#names),*] });
        for fold in folds.into_iter().rev() {
            let (header, start) = enter_fields(self.graph, self.fields, fold);
            code = quote! {{
                let mut rows = __zeroset::Vec::new();
                #header {
                    #start
                    let row = #code;
                    rows.push(row);
                }
                rows
            }};
        }
        code
    }

    /// `everything`: all rows of the outermost folds.
    pub fn everything(&self) -> TokenStream {
        let lengths = self
            .layout
            .outermost
            .iter()
            .map(|f| self.layout.length(self.graph, *f));
        let rests = Literal::usize_unsuffixed(self.layout.terms.rests());
        let choices = Literal::usize_unsuffixed(self.layout.choices.count());
        quote! {
            fn everything(prepared: &Self::Prepared) -> __zeroset::Active {
                __zeroset::Active::everything(&[#(#lengths),*], #rests, #choices)
            }
        }
    }

    /// `unbound` and `bind`: the ray stage.
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
            fn bind<P: __zeroset::Packet>(
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
                #polynomials
            }
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
            let (header, start) = enter_rows(self.graph, self.layout, fold, around, false);
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
            let (half, middle) = rays.middle(a);
            #body
            #(#places = __zeroset::Polynomial::new(a, half, &#values);)*
        }
    }

    /// The polynomials over the segment `t`, if this parameter is one: then the function ends here.
    fn over(&self, n: usize) -> TokenStream {
        let Some(jet) = &self.staged.over else {
            return TokenStream::new();
        };
        let mut known = HashMap::new();
        let mut names: Vec<Vec<Ident>> = vec![Vec::new(); self.staged.polynomials.len()];
        let targets: Vec<Id> = jet.iter().take(n).copied().collect();
        for (k, all) in names.iter_mut().enumerate() {
            *all = (0..n).map(|order| format_ident!("p{k}_{order}")).collect();
        }
        let mut start = TokenStream::new();
        for id in self.graph.reachable(&targets, |_| false) {
            if let Op::Polynomial(k, order, _) = *self.graph.op(id)
                && let Some(name) = names.get(k).and_then(|all| all.get(usize::from(order)))
            {
                if self.graph.nonnegative(id) {
                    start.extend(quote!(let #name = a.nonneg(#name);));
                }
                let name = name.clone();
                known.insert(id, Value { name, flags: None });
            }
        }
        let (body, jet) = self.jet(&mut self.enclosure(Stage::Segment), &targets, 1, known);
        let places = (0..names.len()).map(|k| self.layout.polynomial(k));
        quote! {
            if let (#(__zeroset::Option::Some([#(#names),*]),)*) = (#(t.polynomial(a, &#places),)*) {
                #start
                #body
                return #jet;
            }
        }
    }

    /// `value`, `slope` or `curvature`: the first `n` derivatives along the ray.
    pub fn segment(&self, name: &str, n: usize) -> TokenStream {
        let targets: Vec<Id> = self.staged.jet.iter().take(n).flatten().copied().collect();
        let mut target = self.enclosure(Stage::Segment);
        let (body, jet) = self.jet(&mut target, &targets, 1, HashMap::new());
        let over = self.over(n);
        let sides = self.layout.choices.declare(&quote!(bound.2));
        let (name, n) = (format_ident!("{name}"), Literal::usize_unsuffixed(n));
        quote! {
            #[inline(always)]
            fn #name<A: __zeroset::Arithmetic, T: __zeroset::Parameter<A>>(
                a: A,
                prepared: &Self::Prepared,
                bound: &Self::Bound<T::Leaves>,
                t: T,
            ) -> __zeroset::Jet<A::Value, A::Packet, #n> {
                #sides
                #over
                #body
                #jet
            }
        }
    }

    /// `terms`, where rows can be left out.
    pub fn terms(&self) -> TokenStream {
        let body = self
            .layout
            .terms
            .body(self.graph, &mut self.enclosure(Stage::Segment));
        if body.is_empty() {
            return body;
        }
        let sides = self.layout.choices.declare(&quote!(bound.2));
        quote! {
            #[inline(always)]
            fn terms<A: __zeroset::Arithmetic, T: __zeroset::Parameter<A>>(
                a: A,
                prepared: &Self::Prepared,
                bound: &Self::Bound<T::Leaves>,
                t: T,
                to: &mut impl __zeroset::Terms<A>,
            ) {
                #sides
                #body
            }
        }
    }

    /// `gradient` or `hessian`: the first `n` of the values in space.
    pub fn space(&self, name: &str, n: usize) -> TokenStream {
        let targets: Vec<Id> = self.space.iter().take(n).copied().collect();
        let mut target = self.enclosure(Stage::Space);
        let (body, jet) = self.jet(&mut target, &targets, 1, HashMap::new());
        let (name, n) = (format_ident!("{name}"), Literal::usize_unsuffixed(n));
        quote! {
            #[inline(always)]
            fn #name<A: __zeroset::Arithmetic>(
                a: A,
                prepared: &Self::Prepared,
                point: [A::Value; 3],
            ) -> __zeroset::Jet<A::Value, A::Packet, #n> {
                #body
                #jet
            }
        }
    }

    /// Code for a value and its derivatives, and the `Jet` of them. The first `values` targets are the function itself:
    /// only they can say that it is *empty*. `known` is there already.
    fn jet(
        &self,
        target: &mut Enclosure,
        targets: &[Id],
        values: usize,
        mut known: HashMap<Id, Value>,
    ) -> (TokenStream, TokenStream) {
        let mut body = TokenStream::new();
        let all = block(
            self.graph,
            target,
            Scope::default(),
            targets,
            &mut known,
            &mut body,
        );
        let mut flags = quote!(a.clear());
        let mut seen: Vec<&Ident> = Vec::new();
        for (k, value) in all.iter().enumerate() {
            let Some(f) = &value.flags else { continue };
            if seen.contains(&f) {
                continue;
            }
            seen.push(f);
            flags = if k < values {
                quote!(a.join(#flags, #f))
            } else {
                quote!(a.join_derivative(#flags, #f))
            };
        }
        if self.partial {
            flags = quote!(a.join(#flags, a.undefined_if(prepared.1)));
        }
        let names = all.iter().map(|v| &v.name);
        (
            body,
            quote!(__zeroset::Jet { d: [#(#names),*], flags: #flags }),
        )
    }

    /// `quadric`: the leaf that is the whole formula, if there is one.
    pub fn quadric(&self) -> TokenStream {
        let whole = self
            .staged
            .leaves
            .first()
            .filter(|l| l.quadratic && l.node == self.root);
        if whole.is_none() {
            return TokenStream::new();
        }
        quote! {
            #[inline(always)]
            fn quadric<P: __zeroset::Packet>(
                bound: &Self::Bound<P>,
            ) -> __zeroset::Option<&__zeroset::Quadratic<P>> {
                __zeroset::Option::Some(&bound.1[0])
            }
        }
    }
}

/// Notes whether any of these values of the surface stage may be undefined.
fn undefined(values: &[Value]) -> TokenStream {
    let flags = values.iter().filter_map(|v| v.flags.as_ref());
    quote!(#(undefined |= __zeroset::may_be_undefined(&#flags);)*)
}
