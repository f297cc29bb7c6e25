//! Rewriting is safe: random formulas, enclosed over random boxes by the graph as written and by the graph as the
//! compiler rewrites it. Both must hold the truth, and the rewritten one must not be wider.

#![forbid(unsafe_code)]

pub mod enclose;
pub mod formula;
pub mod truth;

use formula::{Formula, Random};
use proc_macro2::TokenStream;
use zeroset_compiler::front::front;
use zeroset_compiler::graph::{Graph, Id};
use zeroset_compiler::lower::Lowering;

/// The graph of a formula in the macro's language, and its root; nothing if the language refuses it, as it does what
/// does not depend on the point, and what is certainly undefined.
///
/// # Panics
/// If the formula is no Rust tokens, or too large for a graph.
pub fn lowered(source: &str, graph: Graph) -> Option<(Graph, Id)> {
    let tokens: TokenStream = format!("struct S; {source}").parse().expect("tokens");
    let formula = front(tokens).formula?;
    let mut lowering = Lowering::into_graph(&formula, graph);
    let root = lowering.root().expect("a small formula");
    Some((lowering.graph, root))
}

/// Both graphs of a random formula that the language takes: as written, and rewritten.
pub fn random_pair(random: &mut Random, depth: u32, rational: bool) -> (Formula, [(Graph, Id); 2]) {
    loop {
        let formula = Formula::random(random, depth, rational);
        let source = formula.source();
        let graphs = [Graph::as_written(), Graph::default()].map(|g| lowered(&source, g));
        if let [Some(written), Some(rewritten)] = graphs {
            return (formula, [written, rewritten]);
        }
    }
}
