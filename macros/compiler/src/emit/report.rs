//! What the compiler knows about a formula, as the constant `REPORT`.

use super::stages::Compiled;
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
#[derive(Clone, Copy)]
struct Operations([u32; 3]);

impl ToTokens for Operations {
    fn to_tokens(&self, out: &mut TokenStream) {
        let [naive, shared, staged] = self.0;
        out.extend(quote! {
            __zeroset::Operations { naive: #naive, shared: #shared, staged: #staged }
        });
    }
}

/// What is known.
pub struct Facts {
    degree: Option<u32>,
    continuity: &'static str,
    total: bool,
    functions: Vec<&'static str>,
    leaves: u32,
    polynomials: u32,
    surface: u32,
    ray: u32,
    segment: Vec<Operations>,
    space: Vec<Operations>,
}

impl Facts {
    /// What is known of a compiled formula; `counts` has what its entry points would cost in other forms.
    pub fn new(compiled: &Compiled, counts: &Counts) -> Facts {
        let (graph, staged) = (compiled.graph, compiled.staged);
        let info = graph.info(compiled.root);
        let nodes = graph.reachable(&[compiled.root], |_| false);
        let leaves = staged.leaves.iter().map(|l| l.node);
        let of_ray: Vec<Id> = leaves
            .chain(staged.polynomials.iter().map(|p| p.0))
            .collect();
        let written: Vec<Id> = staged.jet.iter().flatten().copied().collect();
        let jet = staged.over.map_or(written, |jet| jet.to_vec());
        let prepared: Vec<Id> = compiled.layout.surface_values().collect();
        let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Facts {
            degree: info.degree,
            continuity: continuity(compiled, &nodes),
            total: info.total,
            functions: functions(compiled, &nodes),
            leaves: number(staged.leaves.len()),
            polynomials: number(staged.polynomials.len()),
            surface: graph.shared_operations(&prepared, |_| false),
            ray: graph.shared_operations(&of_ray, |id| !graph.varies(id)),
            segment: operations(graph, &counts.segment, &jet, SEGMENT),
            space: operations(graph, &counts.space, compiled.space, SPACE),
        }
    }

    /// The constant `REPORT`.
    pub fn constant(&self, surface: &str) -> TokenStream {
        let degree = match self.degree {
            Some(d) => quote!(__zeroset::Option::Some(#d)),
            None => quote!(__zeroset::Option::None),
        };
        let continuity = format_ident!("{}", self.continuity);
        let Facts {
            total,
            functions,
            leaves,
            polynomials,
            surface: at_surface,
            ray,
            segment,
            space,
            ..
        } = self;
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

    /// The same as a section of the surface's documentation.
    pub fn page(&self) -> String {
        let kind = match self.degree {
            Some(d) => format!("A polynomial of degree {d}"),
            None => "No polynomial".to_owned(),
        };
        let continuity = match self.continuity {
            "Smooth" => "all derivatives exist",
            "Continuous" => "continuous, with kinks",
            _ => "it may jump",
        };
        let domain = if self.total {
            "defined everywhere"
        } else {
            "not defined everywhere, or for all fields"
        };
        let entries = [
            "`value` along a ray",
            "`slope`",
            "`curvature`",
            "value in space",
            "`gradient`",
            "`hessian`",
        ];
        let rows = entries.iter().zip(self.segment.iter().chain(&self.space));
        let rows: String = rows
            .map(|(name, Operations([a, b, c]))| format!("| {name} | {a} | {b} | {c} |\n"))
            .collect();
        format!(
            "\n# What is computed\n\n{kind}; {domain}; {continuity}.\n\n\
             Interval operations per entry point, bodies of loops counted once:\n\n\
             | | naive | shared | staged |\n|---|---|---|---|\n{rows}\n\
             Before that, once per render: {}. Once per ray: {} on polynomials in t, for {} linear and quadratic leaves \
             and {} polynomials of higher degree.\n",
            self.surface, self.ray, self.leaves, self.polynomials
        )
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
