//! What need not be computed where a choice is decided: the side of a minimum, a maximum or an `if` that does not matter.
//!
//! A choice compares two numbers. On one *side* of it the first is less, on the other it is not. A node that is only used on
//! one side is *guarded* by that side, and computed where the side is alive: where the choice is open, or decided for it, and
//! the side that the choice itself stands on is alive.

use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope, operands};
use crate::stage::Staged;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// A side: twice the choice's number, and one more where the first number is not less.
pub type Side = usize;

/// The choices of a formula's segment stage.
#[derive(Debug, Default)]
pub struct Choices {
    /// The numbers that are compared.
    pairs: Vec<(Id, Id)>,
    /// Is there a minimum or maximum of them?
    extreme: Vec<bool>,
    /// The side that each choice stands on.
    within: Vec<Option<Side>>,
    /// The guarded nodes of the segment stage, and those that leaves are made of.
    guards: HashMap<Id, Side>,
    shapes: HashMap<Id, Side>,
}

/// The numbers that a node compares; where the first is less, its first branch is taken.
fn pair(graph: &Graph, id: Id) -> Option<(Id, Id)> {
    match graph.op(id) {
        Op::Binary(Function::Min, a, b) => Some((*a, *b)),
        Op::Binary(Function::Max, a, b) => Some((*b, *a)),
        Op::Choose(c, ..) => match graph.op(*c) {
            Op::Less(a, b) | Op::LessOrEqual(a, b) => Some((*a, *b)),
            _ => None,
        },
        _ => None,
    }
}

/// Are both numbers evaluated as they are written? Polynomials that are kept by their coefficients are not there over beams.
fn is_written(graph: &Graph, (a, b): (Id, Id)) -> bool {
    let all = graph.reachable(&[a, b], |_| false);
    !all.iter()
        .any(|id| matches!(graph.op(*id), Op::Polynomial(..)))
}

/// The branches of an operation that chooses.
pub fn branches(op: &Op) -> Option<[Id; 2]> {
    match op {
        Op::Binary(Function::Min | Function::Max, a, b) | Op::Choose(_, a, b, _) => Some([*a, *b]),
        _ => None,
    }
}

impl Choices {
    /// Those whose sides guard anything.
    pub fn new(graph: &Graph, staged: &Staged, ready: impl Fn(Id) -> bool) -> Choices {
        let written = staged.jet.iter().flatten();
        let roots: Vec<Id> = written
            .chain(staged.over.iter().flatten())
            .copied()
            .collect();
        let nodes = graph.reachable(&roots, &ready);
        let mut choices = Choices::default();
        for &id in &nodes {
            if let Some(pair) = pair(graph, id)
                && graph.info(id).scope == Scope::default()
                && !choices.pairs.contains(&pair)
                && is_written(graph, pair)
            {
                choices.pairs.push(pair);
            }
        }
        choices.within = vec![None; choices.pairs.len()];
        choices.extreme = choices
            .pairs
            .iter()
            .map(|of| {
                let extreme = |id: &Id| matches!(graph.op(*id), Op::Binary(..));
                nodes
                    .iter()
                    .filter(|id| extreme(id))
                    .any(|id| pair(graph, *id) == Some(*of))
            })
            .collect();
        for _ in 0..8 {
            choices.guards = choices.guarded(graph, &nodes, &roots, &ready);
            let within = choices.standing(graph, &nodes);
            if within == choices.within {
                break;
            }
            choices.within = within;
        }
        choices.guards = choices.guarded(graph, &nodes, &roots, &ready);
        if choices.standing(graph, &nodes) != choices.within || !choices.has_order() {
            return Choices::default();
        }
        choices.shapes = choices.of_leaves(graph, staged, &nodes);
        choices
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.guards.is_empty()
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        if self.is_empty() { 0 } else { self.pairs.len() }
    }

    /// The side that guards a node of the segment stage.
    pub fn guard(&self, id: Id) -> Option<Side> {
        self.guards.get(&id).copied()
    }

    /// The side that guards a node which leaves are made of, or a leaf.
    pub fn shape(&self, id: Id) -> Option<Side> {
        self.shapes.get(&id).copied()
    }

    /// The choice that a node makes.
    pub fn made(&self, graph: &Graph, id: Id) -> Option<usize> {
        if self.is_empty() || graph.info(id).scope != Scope::default() {
            return None;
        }
        let pair = pair(graph, id)?;
        self.pairs.iter().position(|p| *p == pair)
    }

    /// Declares the sides, each a `bool`: whether it is alive, as `active` says.
    pub fn declare(&self, active: &TokenStream) -> TokenStream {
        if self.is_empty() {
            return TokenStream::new();
        }
        let mut order: Vec<usize> = (0..self.pairs.len()).collect();
        order.sort_by_key(|k| self.depth(*k));
        let sides = order.into_iter().map(|k| {
            let (first, second) = (side(2 * k), side(2 * k + 1));
            let number = Literal::usize_unsuffixed(k);
            let outer = self.within[k].map(|s| {
                let s = side(s);
                quote!(let (#first, #second) = (#s & #first, #s & #second);)
            });
            quote!(let (#first, #second) = #active.sides(#number); #outer)
        });
        quote!(#(#sides)*)
    }

    /// Each choice, and the numbers that it compares.
    pub fn all(&self) -> impl Iterator<Item = (usize, (Id, Id))> {
        self.pairs.iter().copied().enumerate().take(self.count())
    }

    /// The sides that a side stands on, from itself outward.
    fn outward(&self, from: Option<Side>) -> impl Iterator<Item = Side> {
        let outer = |s: &Side| self.within.get(s / 2).copied().flatten();
        // As many as there are choices at most: more would be a circle.
        std::iter::successors(from, outer).take(self.pairs.len() + 1)
    }

    fn depth(&self, choice: usize) -> usize {
        self.outward(self.within[choice]).count()
    }

    /// Does no choice stand on a side of its own?
    fn has_order(&self) -> bool {
        (0..self.pairs.len()).all(|k| self.depth(k) <= self.pairs.len())
    }

    /// The innermost side on which both are.
    fn common(&self, a: Option<Side>, b: Option<Side>) -> Option<Side> {
        let others: Vec<Side> = self.outward(b).collect();
        self.outward(a).find(|s| others.contains(s))
    }

    /// The side that each choice stands on: what is common to all nodes that make it.
    fn standing(&self, graph: &Graph, nodes: &[Id]) -> Vec<Option<Side>> {
        let mut within: Vec<Option<Option<Side>>> = vec![None; self.pairs.len()];
        for &id in nodes {
            let own = pair(graph, id).and_then(|p| self.pairs.iter().position(|q| *q == p));
            if let Some(k) = own {
                let guard = self.guards.get(&id).copied();
                within[k] = Some(match within[k] {
                    None => guard,
                    Some(known) => self.common(known, guard),
                });
            }
        }
        within.into_iter().map(Option::flatten).collect()
    }

    /// Users come after what they use: from the last node to the first, each is guarded by what is common to its uses.
    fn guarded(
        &self,
        graph: &Graph,
        nodes: &[Id],
        roots: &[Id],
        ready: impl Fn(Id) -> bool,
    ) -> HashMap<Id, Side> {
        let mut uses: HashMap<Id, Option<Side>> = roots.iter().map(|id| (*id, None)).collect();
        for &id in nodes.iter().rev() {
            let top = graph.info(id).scope == Scope::default();
            let fold = matches!(graph.op(id), Op::Fold(..));
            let own = if top && !fold {
                uses.get(&id).copied().flatten()
            } else {
                None
            };
            uses.insert(id, own);
            if ready(id) {
                continue;
            }
            for (operand, side) in self.used(graph, id) {
                let guard = side.or(own);
                let known = uses.get(&operand).copied();
                let guard = known.map_or(guard, |known| self.common(known, guard));
                uses.insert(operand, guard);
            }
        }
        uses.into_iter()
            .filter_map(|(id, side)| Some((id, side?)))
            .collect()
    }

    /// The operands that a node uses, and the sides that it uses them on.
    fn used(&self, graph: &Graph, id: Id) -> Vec<(Id, Option<Side>)> {
        let number = |pair: (Id, Id)| self.pairs.iter().position(|p| *p == pair);
        let top = graph.info(id).scope == Scope::default();
        if let Some(k) = pair(graph, id).filter(|_| top).and_then(number)
            && let Some([yes, no]) = branches(graph.op(id))
        {
            let condition = match graph.op(id) {
                Op::Choose(c, ..) => Some((*c, None)),
                _ => None,
            };
            let branches = [(yes, Some(2 * k)), (no, Some(2 * k + 1))];
            return branches.into_iter().chain(condition).collect();
        }
        // The numbers of an extreme are compared only where both sides are alive: it uses them itself.
        if let Op::Less(a, b) = graph.op(id)
            && number((*a, *b)).is_some_and(|k| self.extreme[k])
        {
            return Vec::new();
        }
        operands(graph.op(id))
            .into_iter()
            .map(|a| (a, None))
            .collect()
    }

    /// The guards of all that leaves are made of: of a leaf, what is common to its value and its derivatives.
    fn of_leaves(&self, graph: &Graph, staged: &Staged, nodes: &[Id]) -> HashMap<Id, Side> {
        let mut uses: HashMap<Id, Option<Side>> = HashMap::new();
        for &id in nodes {
            if let Op::Leaf(_, _, node) = graph.op(id) {
                let guard = self.guard(id);
                let known = uses.get(node).copied();
                let guard = known.map_or(guard, |known| self.common(known, guard));
                uses.insert(*node, guard);
            }
        }
        let leaves = staged.leaves.iter().map(|leaf| leaf.node);
        let roots: Vec<Id> = leaves.collect();
        for id in graph
            .reachable(&roots, |id| !graph.varies(id))
            .into_iter()
            .rev()
        {
            let own = uses.get(&id).copied().flatten();
            let fold = matches!(graph.op(id), Op::Fold(..));
            let own = own.filter(|_| !fold && graph.info(id).scope == Scope::default());
            uses.insert(id, own);
            for operand in operands(graph.op(id)) {
                let known = uses.get(&operand).copied();
                let guard = known.map_or(own, |known| self.common(known, own));
                uses.insert(operand, guard);
            }
        }
        uses.into_iter()
            .filter_map(|(id, side)| Some((id, side?)))
            .collect()
    }
}

/// The variable of a side.
pub fn side(side: Side) -> Ident {
    format_ident!("g{side}")
}
