//! What the compiler knows about a formula, as the constant `REPORT`.

use super::stages::{Compiled, Counted};
use super::text::count;
use crate::functions::Function;
use crate::graph::{Id, Op, Undecided};
use crate::tree::FoldKind;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The constant.
pub fn report(
    compiled: &Compiled,
    surface: &str,
    segment: &[Counted],
    space: &[Counted],
) -> TokenStream {
    let info = compiled.graph.info(compiled.root);
    let degree = match info.degree {
        Some(d) => quote!(__zeroset::Option::Some(#d)),
        None => quote!(__zeroset::Option::None),
    };
    let nodes = compiled.graph.reachable(&[compiled.root], |_| false);
    let continuity = format_ident!("{}", continuity(compiled, &nodes));
    let total = info.total;
    let functions = functions(compiled, &nodes);
    let leaves = count(compiled.staged.leaves.len());
    let (segment, space) = (
        segment.iter().map(|c| c.operations),
        space.iter().map(|c| c.operations),
    );
    quote! {
        const REPORT: __zeroset::Report = __zeroset::Report {
            name: #surface,
            degree: #degree,
            continuity: __zeroset::Continuity::#continuity,
            total: #total,
            functions: &[#(#functions),*],
            leaves: #leaves,
            segment_operations: [#(#segment),*],
            space_operations: [#(#space),*],
        };
    }
}

/// The least smooth operation decides.
fn continuity(compiled: &Compiled, nodes: &[Id]) -> &'static str {
    let mut smooth = true;
    for &id in nodes {
        match compiled.graph.op(id) {
            Op::Choose(_, _, _, Undecided::Jump) | Op::Binary(Function::Atan2, ..) => {
                return "Jumps";
            }
            Op::Fold(FoldKind::Minimum | FoldKind::Maximum, ..)
            | Op::Choose(..)
            | Op::RealPower(..) => {
                smooth = false;
            }
            Op::Unary(f, _) | Op::Binary(f, ..) => smooth &= f.entry().smooth,
            _ => {}
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
