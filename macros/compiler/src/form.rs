//! How far a formula is compiled. Users get [`Form::Staged`]; the others exist to be counted and measured beside it.

use crate::graph::{Graph, Id, Op, operands, operands_mut};
use std::collections::HashMap;

/// How far a formula is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Form {
    /// Each use of a subexpression computes it again, and everything is computed at the last stage.
    Naive,
    /// What is equal is computed once, but everything at the last stage.
    Shared,
    /// In stages, but polynomials of higher degree are evaluated as they are written.
    Written,
    /// Everything is computed once, at the first stage that can, and polynomials from their coefficients where that is
    /// cheaper.
    #[default]
    Staged,
}

impl Form {
    /// The form of this name, for the hidden first argument of the macro.
    pub fn named(name: &str) -> Option<Form> {
        Some(match name {
            "naive" => Form::Naive,
            "shared" => Form::Shared,
            "written" => Form::Written,
            "staged" => Form::Staged,
            _ => return None,
        })
    }

    /// Is everything computed at the first stage that can?
    pub fn in_stages(self) -> bool {
        matches!(self, Form::Written | Form::Staged)
    }

    /// Is the node ready when the last stage begins? Inputs always are.
    pub fn ready(self, graph: &Graph, id: Id) -> bool {
        !graph.varies(id) && (self.in_stages() || operands(graph.op(id)).is_empty())
    }
}

impl Graph {
    /// Operations that `roots` need, what is equal counted once, up to the nodes where `ready` stops; bodies of loops
    /// count once.
    pub fn shared_operations(&self, roots: &[Id], ready: impl Fn(Id) -> bool) -> u32 {
        let nodes = self.reachable(roots, &ready);
        let count = nodes.iter().filter(|id| !ready(**id));
        count.map(|id| self.weight(*id)).sum()
    }

    /// Operations of the trees of `roots`: each use counts. Saturates.
    pub fn naive_operations(&self, roots: &[Id]) -> u32 {
        let mut trees: HashMap<Id, u32> = HashMap::new();
        for id in self.reachable(roots, |_| false) {
            let op = self.op(id);
            let below = operands(op);
            let below = below.iter().filter_map(|a| trees.get(a));
            let tree = below.fold(self.weight(id), |sum, n| sum.saturating_add(*n));
            trees.insert(id, tree);
        }
        let all = roots.iter().filter_map(|r| trees.get(r));
        all.fold(0, |sum: u32, n| sum.saturating_add(*n))
    }

    /// Interval operations of a node. A leaf along a ray is one, and a polynomial as many as its degree says, for that is
    /// what it takes; the derivatives of products need several accumulators.
    fn weight(&self, id: Id) -> u32 {
        match self.op(id) {
            Op::Leaf(..) => 1,
            Op::Polynomial(..) => self.info(id).degree.unwrap_or(1),
            Op::Fold(_, _, args) => 1 << args.len().saturating_sub(1).min(2),
            op => u32::from(!operands(op).is_empty()),
        }
    }

    /// A copy of the tree of `id` in which nothing but numbers is shared.
    pub fn unshared(&mut self, id: Id) -> Id {
        if self.literal(id).is_some() {
            return id;
        }
        let mut op = self.op(id).clone();
        for operand in operands_mut(&mut op) {
            *operand = self.unshared(*operand);
        }
        let info = self.info(id).clone();
        self.push(op, info)
    }
}
