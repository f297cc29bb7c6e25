//! What the compiler knows about a formula, as the constant `REPORT`.

use super::stages::Compiled;
use super::text::count;
use crate::form::Form;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Undecided};
use crate::stage::Staged;
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

/// How many of the nodes of `Compiled::space`, and of the derivatives along a ray, each entry point computes.
const SPACE: [usize; 3] = [1, 4, 10];
const SEGMENT: [usize; 3] = [1, 2, 3];

/// What the entry points would cost without stages: along a ray (value, slope, curvature) and in space (value,
/// gradient, Hessian), naively and with sharing.
pub struct Counts {
    segment: Vec<[u32; 2]>,
    space: Vec<[u32; 2]>,
}

impl Counts {
    /// Counts for the formula `root`, whose value and derivatives in space are `space`.
    pub fn new(graph: &Graph, root: Id, space: &[Id]) -> Counts {
        let mut plain = graph.clone();
        let staged = Staged::in_form(&mut plain, root, Form::Shared);
        let jet: Vec<Id> = staged.jet.iter().flatten().copied().collect();
        let both = |graph: &Graph, roots: &[Id]| {
            let ready = |id| Form::Shared.ready(graph, id);
            [
                graph.naive_operations(roots),
                graph.shared_operations(roots, ready),
            ]
        };
        Counts {
            segment: SEGMENT.map(|n| both(&plain, first(&jet, n))).to_vec(),
            space: SPACE.map(|n| both(graph, first(space, n))).to_vec(),
        }
    }
}

fn first(all: &[Id], n: usize) -> &[Id] {
    all.get(..n).unwrap_or(all)
}

/// Operations of an entry point in its three forms.
struct Operations([u32; 3]);

impl ToTokens for Operations {
    fn to_tokens(&self, out: &mut TokenStream) {
        let [naive, shared, staged] = self.0;
        out.extend(quote! {
            __zeroset::Operations { naive: #naive, shared: #shared, staged: #staged }
        });
    }
}

/// The constant.
pub fn report(compiled: &Compiled, counts: &Counts, surface: &str) -> TokenStream {
    let graph = compiled.graph;
    let info = graph.info(compiled.root);
    let degree = match info.degree {
        Some(d) => quote!(__zeroset::Option::Some(#d)),
        None => quote!(__zeroset::Option::None),
    };
    let nodes = graph.reachable(&[compiled.root], |_| false);
    let continuity = format_ident!("{}", continuity(compiled, &nodes));
    let total = info.total;
    let functions = functions(compiled, &nodes);
    let leaves = count(compiled.staged.leaves.len());
    let polynomials = count(compiled.staged.polynomials.len());
    let of_leaves: Vec<Id> = compiled.staged.leaves.iter().map(|l| l.node).collect();
    let ray = graph.shared_operations(&of_leaves, |id| !graph.varies(id));
    let written: Vec<Id> = compiled.staged.jet.iter().flatten().copied().collect();
    let jet = compiled.staged.over.map_or(written, |jet| jet.to_vec());
    let segment = operations(graph, &counts.segment, &jet, SEGMENT);
    let space = operations(graph, &counts.space, compiled.space, SPACE);
    let prepared: Vec<Id> = compiled.layout.surface_values().collect();
    let at_surface = graph.shared_operations(&prepared, |_| false);
    quote! {
        const REPORT: __zeroset::Report = __zeroset::Report {
            name: #surface,
            degree: #degree,
            continuity: __zeroset::Continuity::#continuity,
            total: #total,
            functions: &[#(#functions),*],
            surface_operations: #at_surface,
            leaves: #leaves,
            polynomials: #polynomials,
            ray_operations: #ray,
            segment: [#(#segment),*],
            space: [#(#space),*],
        };
    }
}

/// The counts of entry points that compute the first nodes of `roots`.
fn operations<const N: usize>(
    graph: &Graph,
    counts: &[[u32; 2]],
    roots: &[Id],
    entries: [usize; N],
) -> Vec<Operations> {
    let staged = |n| graph.shared_operations(first(roots, n), |id| !graph.varies(id));
    let all = counts.iter().zip(entries);
    all.map(|([naive, shared], n)| Operations([*naive, *shared, staged(n)]))
        .collect()
}

/// The least smooth operation decides.
fn continuity(compiled: &Compiled, nodes: &[Id]) -> &'static str {
    let mut smooth = true;
    for &id in nodes {
        match compiled.graph.op(id) {
            Op::Choose(_, _, _, Undecided::Jump) => return "Jumps",
            op @ Op::Binary(Function::Atan2, ..) if !compiled.graph.is_regular(op) => {
                return "Jumps";
            }
            Op::Unary(f, _) | Op::Binary(f, ..) if f.entry().smooth => {}
            Op::Divide(..) => {}
            op => smooth &= compiled.graph.is_regular(op),
        }
    }
    if smooth { "Smooth" } else { "Continuous" }
}

/// The names of the functions that the formula and its derivatives may call.
fn functions(compiled: &Compiled, nodes: &[Id]) -> Vec<&'static str> {
    let mut all: Vec<&'static str> = Vec::new();
    let derived = compiled.graph.reachable(compiled.space, |_| false);
    for &id in nodes.iter().chain(&derived) {
        let name = match compiled.graph.op(id) {
            Op::Unary(f, _) | Op::Binary(f, ..) => f.entry().name,
            Op::RealPower(..) => "pow",
            _ => continue,
        };
        if !all.contains(&name) {
            all.push(name);
        }
    }
    all.sort_unstable();
    all
}
