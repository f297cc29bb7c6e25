//! From the staged graph to Rust tokens.

mod block;
mod enclosure;
mod item;
mod layout;
mod polynomial;
mod rebind;
mod report;
mod rows;
mod scalar;
mod stages;
mod text;

pub use item::{FieldHead, definition};

use crate::front::Head;
use crate::graph::{Graph, Id, Op};
use crate::lower::{Lowering, TooLarge};
use crate::stage::Staged;
use crate::tree::Formula;
use layout::Layout;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use stages::Compiled;

/// The code of a formula without errors. `root` is the path of the runtime's crate.
pub fn surface(formula: &Formula, root: &TokenStream) -> Result<TokenStream, TooLarge> {
    let name = formula
        .name
        .clone()
        .unwrap_or_else(|| Ident::new("Implicit", Span::mixed_site()));
    let heads: Vec<FieldHead> = formula.fields.iter().map(FieldHead::from).collect();
    if formula.name.is_some() {
        let implementation = implementation(formula, &name, root, &item::default(formula, &name))?;
        let definition = definition(&formula.attributes, &formula.visibility, &name, &heads);
        let setters = item::setters(&name, &heads);
        return Ok(quote!(#definition #implementation #setters));
    }
    let implementation = implementation(formula, &name, root, &TokenStream::new())?;
    let definition = definition(
        &quote!(#[derive(Clone, Debug)]),
        &TokenStream::new(),
        &name,
        &heads,
    );
    let captured: Vec<&Ident> = heads.iter().map(|f| &f.name).collect();
    let value = if heads.is_empty() {
        quote!(#name)
    } else {
        quote!(#name { #(#captured: #captured),* })
    };
    Ok(quote!({ #definition #implementation #value }))
}

/// The type of a formula with mistakes: its definition, and an implementation of `Surface` that stands for nothing, so
/// that uses of the type are not reported as well.
pub fn placeholder(head: &Head, root: &TokenStream) -> TokenStream {
    let heads: Vec<FieldHead> = head.fields.iter().map(FieldHead::from).collect();
    let definition = definition(&head.attributes, &head.visibility, &head.name, &heads);
    let setters = item::setters(&head.name, &heads);
    let default = item::placeholder_default(head);
    let empty = Formula::coordinate(head.name.clone());
    let implementation = implementation(&empty, &head.name, root, &default).unwrap_or_default();
    quote!(#definition #implementation #setters)
}

fn implementation(
    formula: &Formula,
    name: &Ident,
    root: &TokenStream,
    default: &TokenStream,
) -> Result<TokenStream, TooLarge> {
    let mut lowering = Lowering::new(formula);
    let value = lowering.root()?;
    let mut graph = lowering.graph;
    let space = derivatives(&mut graph, value);
    let staged = Staged::new(&mut graph, value);
    let mut roots = space.clone();
    roots.extend(staged.jet.iter().flatten());
    let layout = Layout::new(&graph, &staged.leaves, &roots);
    let fields: Vec<Ident> = formula.fields.iter().map(|f| f.name.clone()).collect();
    let partial = surface_values(&layout).any(|id| !graph.info(id).total);
    let compiled = Compiled {
        graph: &graph,
        layout: &layout,
        fields: &fields,
        root: value,
        staged: &staged,
        space: &space,
        partial,
    };
    let text = name.to_string();
    let members = members(&compiled, formula, &text)?;
    let operators = item::operators(name);
    Ok(quote! {
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
        const _: () = {
            use #root::__private as __zeroset;
            #[allow(unused_imports)]
            use __zeroset::Arithmetic as _;
            impl __zeroset::Surface for #name {
                #members
            }
            #operators
            #default
        };
    })
}

fn members(compiled: &Compiled, formula: &Formula, surface: &str) -> Result<TokenStream, TooLarge> {
    let (prepared, bound) = (
        compiled.layout.prepared_type(),
        compiled.layout.bound_type(),
    );
    let check = item::check(compiled.graph, compiled.root, surface, &formula.fields);
    let (domain, at) = (item::domain(formula)?, scalar::at(formula));
    let (prepare, everything, bind) = (compiled.prepare(), compiled.everything(), compiled.bind());
    let rebind = rebind::rebind(compiled);
    let segment = [
        compiled.segment("value", 1),
        compiled.segment("slope", 2),
        compiled.segment("curvature", 3),
    ];
    let space = [compiled.space("gradient", 4), compiled.space("hessian", 10)];
    let report = report::report(compiled, surface, &segment, &space);
    let (along, in_space) = (
        segment.iter().map(|f| &f.code),
        space.iter().map(|f| &f.code),
    );
    let quadric = compiled.quadric();
    Ok(quote! {
        #report
        type Prepared = #prepared;
        type Bound<L: __zeroset::Leaves> = #bound;
        #check
        #domain
        #at
        #prepare
        #everything
        #bind
        #rebind
        #(#along)*
        #(#in_space)*
        #quadric
    })
}

/// f, its gradient, and the upper triangle of its Hessian, by rows.
fn derivatives(graph: &mut Graph, value: Id) -> Vec<Id> {
    let axes: Vec<Id> = (0..3).map(|k| graph.input(Op::Coordinate(k))).collect();
    let gradient = graph.gradient(value, &axes);
    let mut all = vec![value];
    all.extend(&gradient);
    for (k, row) in gradient.iter().enumerate() {
        let second = graph.gradient(*row, &axes);
        all.extend(second.iter().skip(k));
    }
    all
}

fn surface_values(layout: &Layout) -> impl Iterator<Item = Id> {
    layout
        .top
        .values
        .iter()
        .chain(layout.rows.iter().flat_map(|r| r.1.values.iter()))
        .copied()
}
