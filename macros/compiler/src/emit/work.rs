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
    /// `work`: of f along a ray, with one row of each outermost fold, and what either side of a choice adds to it.
    pub fn work(&self) -> TokenStream {
        let (graph, layout) = (self.graph, self.layout);
        let roots: Vec<Id> = self.staged.jet.into_iter().flatten().take(1).collect();
        let nodes = graph.reachable(&roots, |id| layout.form.ready(graph, id));
        let quadratic = |k: usize| self.staged.leaves.get(k).is_some_and(|l| l.quadratic);
        let of = |id: &Id| cost(graph.op(*id), quadratic);
        let within = |scope: &dyn Fn(Scope) -> bool| {
            let own = nodes.iter().filter(|id| scope(graph.info(**id).scope));
            own.map(of).sum::<u32>()
        };
        let whole = within(&|scope| scope == Scope::default());
        let rows = layout
            .outermost
            .iter()
            .map(|f| within(&|scope| scope.has(*f)));
        let sides = layout.choices.work(nodes.iter().map(|id| (*id, of(id))));
        let sides = sides.iter().map(|[a, b]| quote!([#a, #b]));
        quote! {
            const WORK: __zeroset::Work = __zeroset::Work {
                whole: #whole,
                rows: &[#(#rows),*],
                sides: &[#(#sides),*],
            };
        }
    }
}
