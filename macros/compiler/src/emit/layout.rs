//! Where the values of the surface and ray stages are stored.
//!
//! `Prepared` is the tuple (values, undefined, rows of scope 0, rows of scope 1, …, values in twice the precision, their
//! rows), `Bound` the tuple (linear leaves,
//! quadratic leaves, what is active, rows of scope 0, …, polynomials of higher degree). A scope is a set of nested loops; its rows are a `Vec` of arrays
//! for one loop, a `Vec` of `Vec`s for two, and so on.

use super::choices::Choices;
use super::regions::alive;
use super::signs::Signs;
use super::terms::Terms;
use crate::form::Form;
use crate::graph::{Graph, Id, Op, Scope, operands};
use crate::stage::Staged;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::collections::HashMap;

/// What is stored for one scope.
#[derive(Default, Debug)]
pub struct Store {
    /// Values of the surface stage.
    pub values: Vec<Id>,
    /// Linear leaves.
    pub linear: Vec<usize>,
    /// Quadratic leaves.
    pub quadratic: Vec<usize>,
}

/// The storage of a surface.
#[derive(Debug)]
pub struct Layout {
    /// How far the formula is compiled.
    pub form: Form,
    /// The scope without loops.
    pub top: Store,
    /// The other scopes.
    pub rows: Vec<(Scope, Store)>,
    /// Folds whose rows depend on no other fold: they have lists of active rows.
    pub outermost: Vec<usize>,
    /// The folds among them that may leave out rows.
    pub terms: Terms,
    /// The choices whose sides need not all be computed.
    pub choices: Choices,
    /// The same in space, of f and its gradient.
    pub choices_in_space: Choices,
    /// Are the surface values kept in twice the precision too?
    pub twice: bool,
    values: HashMap<Id, (Scope, usize)>,
    leaves: Vec<(Scope, bool, usize)>,
    /// The degrees of the polynomials, all in the scope without loops.
    polynomials: Vec<u32>,
}

impl Layout {
    /// Storage for all surface values that the nodes under `roots` use, for the leaves and for the polynomials.
    ///
    /// f and its gradient in space are the first four of them.
    pub fn new(graph: &Graph, form: Form, staged: &Staged, roots: &[Id]) -> Layout {
        let (leaves, polynomials) = (&staged.leaves, &staged.polynomials);
        let outermost: Vec<usize> = (0..graph.folds.len())
            .filter(|&f| graph.chain(f) == Scope::of(f))
            .collect();
        let ready = |id| form.ready(graph, id);
        let signs = Signs::new(graph, &staged.values(), ready);
        let terms = Terms::new(graph, staged, (&outermost, &signs), ready);
        let choices = Choices::new(graph, staged, &signs, ready);
        let space = roots.get(..4).unwrap_or(&[]);
        let choices_in_space = choices.in_space(graph, staged, space, ready);
        let mut layout = Layout {
            form,
            top: Store::default(),
            rows: Vec::new(),
            outermost,
            terms,
            choices,
            choices_in_space,
            twice: false,
            values: HashMap::new(),
            leaves: Vec::new(),
            polynomials: polynomials.iter().map(|p| p.1).collect(),
        };
        for fold in 0..graph.folds.len() {
            layout.store(graph.chain(fold));
        }
        let nodes: Vec<Id> = roots
            .iter()
            .copied()
            .chain(leaves.iter().map(|l| l.node))
            .chain(polynomials.iter().map(|p| p.0))
            .collect();
        for &id in &nodes {
            layout.keep(graph, id);
        }
        for id in graph.reachable(&nodes, |id| form.ready(graph, id)) {
            if !form.ready(graph, id) {
                for operand in operands(graph.op(id)) {
                    layout.keep(graph, operand);
                }
                // A loop needs its fold's length, even if no row is stored.
                if let Op::Fold(_, fold, _) = graph.op(id) {
                    layout.store(graph.chain(*fold));
                }
            }
        }
        for (k, leaf) in leaves.iter().enumerate() {
            let scope = graph.info(leaf.node).scope;
            let store = layout.store(scope);
            let list = if leaf.quadratic {
                &mut store.quadratic
            } else {
                &mut store.linear
            };
            let index = list.len();
            list.push(k);
            layout.leaves.push((scope, leaf.quadratic, index));
        }
        let exact = |id| matches!(graph.op(id), Op::Field(..) | Op::Row(..) | Op::Counter(_));
        let all_exact = layout.surface_values().all(exact);
        layout.twice = !all_exact;
        layout
    }

    fn store(&mut self, scope: Scope) -> &mut Store {
        if scope == Scope::default() {
            return &mut self.top;
        }
        let index = match self.rows.iter().position(|r| r.0 == scope) {
            Some(index) => index,
            None => {
                self.rows.push((scope, Store::default()));
                self.rows.len() - 1
            }
        };
        &mut self.rows[index].1
    }

    /// All values of the surface stage.
    pub fn surface_values(&self) -> impl Iterator<Item = Id> {
        let stores = std::iter::once(&self.top).chain(self.rows.iter().map(|r| &r.1));
        stores.flat_map(|s| s.values.iter().copied())
    }

    fn keep(&mut self, graph: &Graph, id: Id) {
        if !self.form.ready(graph, id)
            || graph.literal(id).is_some()
            || self.values.contains_key(&id)
        {
            return;
        }
        let scope = graph.info(id).scope;
        let values = &mut self.store(scope).values;
        let index = values.len();
        values.push(id);
        self.values.insert(id, (scope, index));
    }

    /// The place of a surface value: `prepared.0[3]`, or `row2[3]` inside loops.
    pub fn value(&self, id: Id) -> Option<TokenStream> {
        let (scope, index) = self.values.get(&id)?;
        let index = Literal::usize_unsuffixed(*index);
        Some(match self.row(*scope) {
            None => quote!(prepared.0[#index]),
            Some(k) => {
                let row = format_ident!("row{k}");
                quote!(#row[#index])
            }
        })
    }

    /// The place of a surface value in twice the precision: `prepared.3[3]`, or `fine2[3]` inside loops. Nothing if
    /// `f64` holds all of them.
    pub fn fine_value(&self, id: Id) -> Option<TokenStream> {
        let (scope, index) = self.values.get(&id)?;
        let index = Literal::usize_unsuffixed(*index);
        let place = match self.row(*scope) {
            None => self.fine_store(0),
            Some(k) => format_ident!("fine{k}").into_token_stream(),
        };
        self.twice.then(|| quote!(#place[#index]))
    }

    /// The place of a leaf, and whether it is quadratic.
    pub fn leaf(&self, leaf: usize) -> Option<(TokenStream, bool)> {
        let (scope, quadratic, index) = self.leaves.get(leaf)?;
        let (index, part) = (
            Literal::usize_unsuffixed(*index),
            Literal::u8_unsuffixed(u8::from(*quadratic)),
        );
        let place = match self.row(*scope) {
            None => quote!(bound.#part[#index]),
            Some(k) => {
                let row = format_ident!("leaves{k}");
                quote!(#row.#part[#index])
            }
        };
        Some((place, *quadratic))
    }

    /// An option of a reference to a quadratic leaf: there is one if it stands in no loop, or in one with a single row.
    pub fn only_leaf(&self, leaf: usize) -> Option<TokenStream> {
        let (scope, quadratic, index) = self.leaves.get(leaf)?;
        let index = Literal::usize_unsuffixed(*index);
        if !*quadratic || scope.folds().count() > 1 {
            return None;
        }
        Some(match self.row(*scope) {
            None => quote!(__zeroset::Option::Some(&bound.1[#index])),
            Some(k) => {
                let rows = self.bound_rows(k);
                quote! {
                    match #rows.as_slice() {
                        [row] => __zeroset::Option::Some(&row.1[#index]),
                        _ => __zeroset::Option::None,
                    }
                }
            }
        })
    }

    fn row(&self, scope: Scope) -> Option<usize> {
        self.rows.iter().position(|r| r.0 == scope)
    }

    /// The scopes that become complete when the loop of `fold` is entered inside `scope` (which holds it).
    pub fn entered(&self, fold: usize, scope: Scope) -> impl Iterator<Item = (usize, Scope)> {
        let all = self.rows.iter().enumerate().map(|(k, r)| (k, r.0));
        all.filter(move |(_, s)| s.has(fold) && s.within(scope))
    }

    /// `prepared.4`: all rows of a scope in the tuple `Prepared`.
    pub fn prepared_rows(&self, k: usize) -> TokenStream {
        let field = Literal::usize_unsuffixed(2 + k);
        quote!(prepared.#field)
    }

    /// The same in twice the precision.
    pub fn fine_rows(&self, k: usize) -> Option<TokenStream> {
        self.twice.then(|| self.fine_store(1 + k))
    }

    fn fine_store(&self, k: usize) -> TokenStream {
        let field = Literal::usize_unsuffixed(2 + self.rows.len() + k);
        quote!(prepared.#field)
    }

    /// `bound.5`: all rows of a scope in the tuple `Bound`.
    pub fn bound_rows(&self, k: usize) -> TokenStream {
        let field = Literal::usize_unsuffixed(3 + k);
        quote!(bound.#field)
    }

    /// `bound.7.0`: a polynomial in the tuple `Bound`.
    pub fn polynomial(&self, k: usize) -> TokenStream {
        let (all, k) = (
            Literal::usize_unsuffixed(3 + self.rows.len()),
            Literal::usize_unsuffixed(k),
        );
        quote!(bound.#all.#k)
    }

    /// How many coefficients each polynomial has.
    pub fn coefficients(&self) -> impl Iterator<Item = Literal> {
        self.polynomials
            .iter()
            .map(|d| Literal::usize_unsuffixed(*d as usize + 1))
    }

    /// How many rows a fold has, once the loops around it are entered.
    pub fn length(&self, graph: &Graph, fold: usize) -> TokenStream {
        let chain = graph.chain(fold);
        let mut place = match self.row(chain) {
            Some(k) => self.prepared_rows(k),
            None => return quote!(0),
        };
        for outer in chain.without(fold).folds() {
            let k = format_ident!("k{outer}");
            place = quote!(#place[#k]);
        }
        quote!(#place.len())
    }

    /// Code that is run where a leaf's guard is alive.
    pub fn guarded(&self, staged: &Staged, leaf: usize, code: TokenStream) -> TokenStream {
        let node = staged.leaves.get(leaf).map(|leaf| leaf.node);
        match node.and_then(|node| self.choices.shape(node)) {
            Some(of) => {
                let alive = alive(of);
                quote!(if #alive { #code })
            }
            None => code,
        }
    }

    /// Notes what is active, if there is a choice.
    pub fn copy_active(&self, bound: &TokenStream) -> TokenStream {
        if self.outermost.is_empty() && self.choices.is_empty() {
            return TokenStream::new();
        }
        quote!(#bound.2.load(active);)
    }

    /// The list of a fold's active rows: its index in `Active::rows`.
    pub fn active(&self, fold: usize) -> Option<Literal> {
        self.outermost
            .iter()
            .position(|f| *f == fold)
            .map(Literal::usize_unsuffixed)
    }

    /// The type `Prepared`.
    pub fn prepared_type(&self) -> TokenStream {
        let stores = |number: TokenStream| {
            let array = |store: &Store| {
                let count = Literal::usize_unsuffixed(store.values.len());
                quote!([#number; #count])
            };
            let rows = self.rows.iter();
            let rows = rows.map(|(scope, store)| nested(*scope, array(store)));
            (array(&self.top), rows.collect::<Vec<_>>())
        };
        let (top, rows) = stores(quote!(__zeroset::Interval));
        let fine = self.twice.then(|| {
            let (top, rows) = stores(quote!(__zeroset::Ball));
            quote!(#top, #(#rows,)*)
        });
        quote!((#top, __zeroset::primitive::bool, #(#rows,)* #fine))
    }

    /// The type `Bound<L>`.
    pub fn bound_type(&self) -> TokenStream {
        let top = leaves_type(&self.top);
        let rows = self.rows.iter().map(|(scope, store)| {
            let row = leaves_type(store);
            nested(*scope, quote!((#row)))
        });
        let lengths = self.coefficients();
        quote!((
            #top
            __zeroset::Active,
            #(#rows,)*
            (#(L::Polynomial<#lengths>,)*),
        ))
    }
}

fn leaves_type(store: &Store) -> TokenStream {
    let linear = Literal::usize_unsuffixed(store.linear.len());
    let quadratic = Literal::usize_unsuffixed(store.quadratic.len());
    quote!([L::Linear; #linear], [L::Quadratic; #quadratic],)
}

fn nested(scope: Scope, row: TokenStream) -> TokenStream {
    scope
        .folds()
        .fold(row, |inner, _| quote!(__zeroset::Vec<#inner>))
}
