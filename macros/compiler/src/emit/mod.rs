//! From the staged graph to Rust tokens.

mod bind;
mod block;
mod choices;
mod enclosure;
mod folds;
mod in_space;
mod item;
mod layout;
mod passes;
mod polynomial;
mod prepare;
mod rebind;
mod regions;
mod report;
mod rows;
mod scalar;
mod series;
mod signs;
mod stages;
mod terms;
mod text;
mod work;

pub use item::{FieldHead, definition};

use crate::form::Form;
use crate::front::Head;
use crate::graph::{Graph, Id};
use crate::lower::{Lowering, TooLarge};
use crate::stage::Staged;
use crate::tree::Formula;
use layout::Layout;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use report::{Counts, Facts};
use stages::Compiled;

/// The code of a formula without errors. `root` is the path of the runtime's crate.
pub fn surface(formula: &Formula, root: &TokenStream, form: Form) -> Result<TokenStream, TooLarge> {
    let name = formula
        .name
        .clone()
        .unwrap_or_else(|| Ident::new("Implicit", Span::mixed_site()));
    let heads: Vec<FieldHead> = formula.fields.iter().map(FieldHead::from).collect();
    if formula.name.is_some() {
        let (implementation, page) =
            implementation(formula, &name, root, form, &item::default(formula, &name))?;
        let mut attributes = formula.attributes.clone();
        attributes.extend(page.lines().map(|line| quote!(#[doc = #line])));
        let definition = definition(&attributes, &formula.visibility, &name, &heads);
        let setters = item::setters(&name, &heads);
        return Ok(quote!(#definition #implementation #setters));
    }
    let (implementation, _) = implementation(formula, &name, root, form, &TokenStream::new())?;
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
    let (implementation, _) =
        implementation(&empty, &head.name, root, Form::Staged, &default).unwrap_or_default();
    quote!(#definition #implementation #setters)
}

/// The implementation of `Surface`, and a section of documentation.
fn implementation(
    formula: &Formula,
    name: &Ident,
    root: &TokenStream,
    form: Form,
    default: &TokenStream,
) -> Result<(TokenStream, String), TooLarge> {
    let mut lowering = Lowering::new(formula);
    let value = lowering.root()?;
    let mut graph = lowering.graph;
    let space = derivatives(&mut graph, value);
    let counts = Counts::new(&graph, value, &space);
    let staged = Staged::in_form(&mut graph, value, form);
    let mut roots = space.clone();
    roots.extend(staged.jet.iter().flatten());
    roots.extend(staged.over.iter().flatten());
    let layout = Layout::new(&graph, form, &staged, &roots);
    let fields: Vec<Ident> = formula.fields.iter().map(|f| f.name.clone()).collect();
    let partial = layout.surface_values().any(|id| !graph.info(id).total);
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
    let facts = Facts::new(&compiled, &counts);
    let members = members(&compiled, &facts, formula, &text)?;
    let operators = item::operators(name);
    let code = quote! {
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
    };
    Ok((code, facts.page()))
}

fn members(
    compiled: &Compiled,
    facts: &Facts,
    formula: &Formula,
    surface: &str,
) -> Result<TokenStream, TooLarge> {
    let (prepared, bound) = (
        compiled.layout.prepared_type(),
        compiled.layout.bound_type(),
    );
    let check = item::check(compiled.graph, compiled.root, surface, &formula.fields);
    let (domain, at) = (item::domain(formula)?, scalar::at(formula));
    let (prepare, everything, bind) = (compiled.prepare(), compiled.everything(), compiled.bind());
    let (rebind, terms) = (rebind::rebind(compiled), compiled.terms());
    let segment = [
        compiled.segment("value", 1),
        compiled.segment("slope", 2),
        compiled.segment("curvature", 3),
    ];
    let space = [compiled.space("gradient", 4), compiled.space("hessian", 10)];
    let seen = compiled.seen();
    let report = facts.constant(surface);
    let (quadric, work) = (compiled.quadric(), compiled.work());
    let (regions, signs_in_space) = (compiled.regions(), compiled.signs_in_space());
    Ok(quote! {
        #report
        #work
        #regions
        #signs_in_space
        type Prepared = #prepared;
        type Bound<L: __zeroset::Leaves> = #bound;
        #check
        #domain
        #at
        #prepare
        #everything
        #bind
        #rebind
        #terms
        #(#segment)*
        #(#space)*
        #seen
        #quadric
    })
}

/// f, its gradient, and the upper triangle of its Hessian, by rows.
fn derivatives(graph: &mut Graph, value: Id) -> Vec<Id> {
    let gradient = graph.gradient(value);
    let mut all = vec![value];
    all.extend(&gradient);
    for (k, row) in gradient.iter().enumerate() {
        all.extend(graph.gradient(*row).into_iter().skip(k));
    }
    all
}
