//! What evaluations cost, roughly: whether it pays to leave something out.

use super::stages::Compiled;
use crate::functions::Function;
use crate::graph::{Id, Op, Scope};
use proc_macro2::TokenStream;
use quote::quote;

/// In additions of two enclosures.
fn cost(op: &Op, quadratic: impl Fn(usize) -> bool) -> u32 {
    match op {
        Op::Leaf(k, ..) => 4 + 8 * u32::from(quadratic(*k)),
        Op::Multiply(..) | Op::Power(..) => 4,
        Op::Divide(..) | Op::Unary(Function::Sqrt, _) => 8,
        Op::Unary(Function::Abs, _) | Op::Binary(Function::Min | Function::Max, ..) => 1,
        Op::Unary(..) | Op::Binary(..) | Op::RealPower(..) => 40,
        Op::Add(..) | Op::Subtract(..) | Op::Negate(_) | Op::Choose(..) => 1,
        _ => 0,
    }
}

impl Compiled<'_> {
    /// `work`: of f along a ray outside of regions, of one row of each outermost fold, and of each region.
    pub fn work(&self) -> TokenStream {
        let (graph, layout) = (self.graph, self.layout);
        let roots: Vec<Id> = self.staged.jet.into_iter().flatten().take(1).collect();
        let nodes = graph.reachable(&roots, |id| layout.form.ready(graph, id));
        let quadratic = |k: usize| self.staged.leaves.get(k).is_some_and(|l| l.quadratic);
        let of = |id: &Id| cost(graph.op(*id), quadratic);
        let rows = layout.outermost.iter().map(|fold| {
            let own = nodes.iter().filter(|id| graph.info(**id).scope.has(*fold));
            own.map(of).sum::<u32>()
        });
        let mut whole = 0;
        let mut regions = vec![0; layout.choices.regions()];
        let top = |id: &&Id| graph.info(**id).scope == Scope::default();
        for id in nodes.iter().filter(top) {
            let region = layout.choices.guard(*id);
            let place = region.and_then(|region| regions.get_mut(region));
            *place.unwrap_or(&mut whole) += of(id);
        }
        quote! {
            const WORK: __zeroset::Work = __zeroset::Work {
                whole: #whole,
                rows: &[#(#rows),*],
                regions: &[#(#regions),*],
            };
        }
    }
}
