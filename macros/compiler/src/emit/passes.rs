//! Nodes that pass on an operand's value unless a side is alive: a minimum or a maximum whose other side does not matter, and
//! a sum with what is 0 there. They are computed in that side's region, and elsewhere are that operand: a long chain of them
//! costs no copies.

use super::choices::{Choices, Side, branches};
use crate::graph::{Graph, Id, Op, operands};
use std::collections::HashMap;

impl Choices {
    /// These nodes, each with the side and the operand.
    pub(super) fn passing(&self, graph: &Graph, nodes: &[Id]) -> HashMap<Id, (Side, Id)> {
        let mut heights: HashMap<Id, u32> = HashMap::new();
        let mut passes = HashMap::new();
        for &id in nodes {
            let height = |id: &Id| heights.get(id).copied().unwrap_or(0);
            let below = operands(graph.op(id)).iter().map(height).max();
            let made = self.made(graph, id);
            let passed = match (made, branches(graph.op(id)), graph.op(id)) {
                // The higher operand is passed on: there the chain goes on.
                (Some(k), Some([first, second]), _) if height(&first) < height(&second) => {
                    Some((2 * k, second))
                }
                (Some(k), Some([first, _]), _) => Some((2 * k + 1, first)),
                (None, _, Op::Add(a, b) | Op::Subtract(a, b)) => {
                    self.zeros.get(b).map(|side| (*side, *a))
                }
                _ => None,
            };
            heights.insert(id, below.unwrap_or(0) + u32::from(made.is_some()));
            // Where something narrower than the choice's own region guards it, it stands there.
            let fits = |(side, _): &(Side, Id)| self.guard(id) == self.within[side / 2];
            passes.extend(passed.filter(fits).map(|passed| (id, passed)));
        }
        passes
    }
}
