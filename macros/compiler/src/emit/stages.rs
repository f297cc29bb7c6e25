//! The functions of `Surface` over segments and in space; those of the earlier stages are in `prepare` and `bind`.

use super::block::block;
use super::enclosure::{Enclosure, Stage, Value};
use super::layout::Layout;
use crate::graph::{Graph, Id, Op, Scope};
use crate::stage::Staged;
use crate::tree::FoldKind;
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
    pub(super) fn enclosure(&self, stage: Stage) -> Enclosure<'_> {
        Enclosure {
            graph: self.graph,
            layout: self.layout,
            stage,
            fields: self.fields,
            flat: false,
        }
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
                __zeroset::Active::everything(&[#(#lengths),*], #rests, #choices, &Self::REGIONS)
            }
        }
    }

    /// `REGIONS`: along rays.
    pub fn regions(&self) -> TokenStream {
        let table = self.layout.choices.table();
        quote!(const REGIONS: __zeroset::Regions = #table;)
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
        let regions = self.layout.choices.known(&quote!(bound.2));
        let (name, n) = (format_ident!("{name}"), Literal::usize_unsuffixed(n));
        quote! {
            #[inline(always)]
            fn #name<A: __zeroset::Arithmetic, T: __zeroset::Parameter<A>>(
                a: A,
                prepared: &Self::Prepared,
                bound: &Self::Bound<T::Leaves>,
                t: T,
            ) -> __zeroset::Jet<A::Value, A::Packet, #n> {
                #regions
                #over
                #body
                #jet
            }
        }
    }

    /// `terms`, where rows can be left out.
    pub fn terms(&self) -> TokenStream {
        let mut target = self.enclosure(Stage::Segment);
        target.flat = true;
        let body = self.layout.terms.body(self.graph, &mut target);
        if body.is_empty() {
            return body;
        }
        let regions = self.layout.choices.known(&quote!(bound.2));
        quote! {
            #[inline(always)]
            fn terms<A: __zeroset::Arithmetic, T: __zeroset::Parameter<A>>(
                a: A,
                prepared: &Self::Prepared,
                bound: &Self::Bound<T::Leaves>,
                t: T,
                to: &mut impl __zeroset::Terms<A>,
            ) {
                #regions
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

    /// `seen`: f with the active rows and what the others add, and its gradient from the active rows alone, where rows or sides
    /// can be left out.
    pub fn seen(&self) -> TokenStream {
        let choices = &self.layout.choices_in_space;
        if self.layout.terms.is_empty() && choices.is_empty() {
            return TokenStream::new();
        }
        let regions = choices.known_in_space();
        let targets: Vec<Id> = self.space.iter().take(4).copied().collect();
        let (body, jet) = self.jet(
            &mut self.enclosure(Stage::Seen),
            &targets,
            1,
            HashMap::new(),
        );
        quote! {
            #[inline(always)]
            fn seen<A: __zeroset::Arithmetic>(
                a: A,
                prepared: &Self::Prepared,
                active: &__zeroset::Active,
                point: [A::Value; 3],
            ) -> __zeroset::Jet<A::Value, A::Packet, 4> {
                #regions
                #body
                #jet
            }
        }
    }

    /// `SIGNS_IN_SPACE`: does `seen` leave out what segments do by its sign?
    pub fn signs_in_space(&self) -> TokenStream {
        let layout = self.layout;
        let sides = layout.choices.is_empty()
            || !layout.choices_in_space.is_empty()
                && layout.choices.signs_are(self.graph, self.staged);
        let same = sides && layout.terms.signs_are_in_space();
        quote!(const SIGNS_IN_SPACE: __zeroset::primitive::bool = #same;)
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

    /// `quadric`: the leaf that is the whole formula, or the whole body of a minimum or maximum of which one row is left.
    pub fn quadric(&self) -> TokenStream {
        let whole = match self.graph.op(self.root) {
            Op::Fold(FoldKind::Minimum | FoldKind::Maximum, _, body) => body.first().copied(),
            _ => Some(self.root),
        };
        let leaves = &self.staged.leaves;
        let leaf = leaves
            .iter()
            .position(|l| l.quadratic && Some(l.node) == whole);
        let Some(code) = leaf.and_then(|leaf| self.layout.only_leaf(leaf)) else {
            return TokenStream::new();
        };
        quote! {
            #[inline(always)]
            fn quadric<L: __zeroset::Leaves>(
                bound: &Self::Bound<L>,
            ) -> __zeroset::Option<&L::Quadratic> {
                #code
            }
        }
    }
}
