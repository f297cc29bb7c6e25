//! What need not be computed where a choice is decided: the side of a minimum, a maximum or an `if` that does not matter.
//!
//! A choice compares two numbers. On one *side* of it the first is less, on the other it is not. A side is alive where the choice
//! is open, or decided for it, and what guards the choice itself is alive. A node that is only used on some sides is *guarded*
//! by their union, and computed where one of them is alive. So is a node that is 0 unless a side is alive, as the smooth
//! part of a blend is: it is 0 where it is not computed.

use super::signs::Signs;
use crate::exact::Rational;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope, operands};
use crate::stage::Staged;
use std::collections::{BTreeSet, HashMap, HashSet};

/// A side: twice the choice's number, and one more where the first number is not less. Behind the sides come unions of
/// them.
pub type Side = usize;

/// A union has no more sides than this: it is widened to what guards them.
const MOST: usize = 4;

/// The choices of a formula's segment stage.
#[derive(Debug, Default)]
pub struct Choices {
    /// The numbers that are compared.
    pub(super) pairs: Vec<(Id, Id)>,
    /// Is there a minimum or maximum of them?
    extreme: Vec<bool>,
    /// Is it all that they are compared for, and does its sign do? Then this is which of the two.
    pub(super) signs: Vec<Option<Function>>,
    /// What guards each choice.
    pub(super) within: Vec<Option<Side>>,
    /// The nodes that are 0 unless a side is alive.
    pub(super) zeros: HashMap<Id, Side>,
    /// The nodes that pass on an operand unless a side is alive.
    pub(super) passes: HashMap<Id, (Side, Id)>,
    /// The unions, each with its sides.
    pub(super) unions: Vec<BTreeSet<Side>>,
    /// The guarded nodes of the segment stage, and those that leaves are made of.
    pub(super) guards: HashMap<Id, Side>,
    pub(super) shapes: HashMap<Id, Side>,
    /// The innermost side or union around each of them.
    pub(super) around: Vec<Option<Side>>,
}

/// The numbers that a node compares; where the first is less, its first branch is taken.
pub(super) fn pair(graph: &Graph, id: Id) -> Option<(Id, Id)> {
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

/// The function that makes a choice wherever f does, if f's sign depends on its sign alone. Derivatives choose as f does.
fn sign(graph: &Graph, signs: &Signs, nodes: &[Id], of: (Id, Id)) -> Option<Function> {
    let made = |id: &&Id| signs.uses(**id) && pair(graph, **id) == Some(of);
    let mut by = nodes.iter().filter(made).map(|id| match graph.op(*id) {
        Op::Binary(function, ..) if signs.suffices(*id) => Some(*function),
        _ => None,
    });
    let first = by.next()??;
    by.all(|other| other == Some(first)).then_some(first)
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
    pub fn new(
        graph: &Graph,
        staged: &Staged,
        signs: &Signs,
        ready: impl Fn(Id) -> bool,
    ) -> Choices {
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
        choices.signs = choices
            .pairs
            .iter()
            .map(|of| sign(graph, signs, &nodes, *of))
            .collect();
        if choices.guard_all(graph, &nodes, &roots, &ready) {
            choices.shapes = choices.of_leaves(graph, staged, &nodes);
            choices.around = choices.nested();
            choices
        } else {
            Choices::default()
        }
    }

    /// Finds out what guards choices, and what guards nodes; false if choices guard each other.
    pub(super) fn guard_all(
        &mut self,
        graph: &Graph,
        nodes: &[Id],
        roots: &[Id],
        ready: &impl Fn(Id) -> bool,
    ) -> bool {
        self.within = vec![None; self.pairs.len()];
        let extreme = |of: &(Id, Id)| {
            nodes
                .iter()
                .filter(|id| matches!(graph.op(**id), Op::Binary(..)))
                .any(|id| pair(graph, *id) == Some(*of))
        };
        self.extreme = self.pairs.iter().map(extreme).collect();
        for _ in 0..16 {
            self.guards = self.guarded(graph, nodes, roots, ready);
            let within = self.standing(graph, nodes);
            if within == self.within {
                break;
            }
            self.within = within;
        }
        self.guards = self.guarded(graph, nodes, roots, ready);
        if self.standing(graph, nodes) != self.within || !self.has_order() {
            return false;
        }
        // What guards a choice is known: from here on nodes may be narrowed to its sides.
        self.zeros = self.vanishing(graph, nodes);
        self.guards = self.guarded(graph, nodes, roots, ready);
        self.passes = self.passing(graph, nodes);
        true
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.guards.is_empty()
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        if self.is_empty() { 0 } else { self.pairs.len() }
    }

    /// The minimum or maximum that a choice is all about, if its sign does.
    pub fn sign(&self, choice: usize) -> Option<Function> {
        self.signs.get(choice).copied().flatten()
    }

    /// The side that guards a node of the segment stage.
    pub fn guard(&self, id: Id) -> Option<Side> {
        self.guards.get(&id).copied()
    }

    /// The side in whose region a node stands that passes on an operand elsewhere, and that operand.
    pub fn passed(&self, id: Id) -> Option<(Side, Id)> {
        self.passes.get(&id).copied()
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

    /// Each choice, and the numbers that it compares.
    pub fn all(&self) -> impl Iterator<Item = (usize, (Id, Id))> {
        self.pairs.iter().copied().enumerate().take(self.count())
    }

    /// The sides of a union, or the side.
    pub(super) fn sides(&self, of: Side) -> BTreeSet<Side> {
        let union = of.checked_sub(2 * self.pairs.len());
        match union.and_then(|number| self.unions.get(number)) {
            Some(sides) => sides.clone(),
            None => BTreeSet::from([of]),
        }
    }

    /// The sides that guard the choice of a side.
    fn outer(&self, side: Side) -> Option<BTreeSet<Side>> {
        let guard = self.within.get(side / 2).copied().flatten()?;
        Some(self.sides(guard))
    }

    /// Is one of `set` alive wherever this side is? Yes, if each way outward meets the set.
    pub(super) fn covers(&self, set: &BTreeSet<Side>, side: Side) -> bool {
        let (mut todo, mut seen) = (vec![side], HashSet::new());
        while let Some(side) = todo.pop() {
            if set.contains(&side) || !seen.insert(side) {
                continue;
            }
            match self.outer(side) {
                Some(outer) => todo.extend(outer),
                None => return false,
            }
        }
        true
    }

    /// Alive where one of the two is; `None` is alive everywhere.
    fn either(&mut self, a: Option<Side>, b: Option<Side>) -> Option<Side> {
        let mut set = self.sides(a?);
        set.extend(self.sides(b?));
        loop {
            let both = set.iter().find(|s| set.contains(&(*s ^ 1))).copied();
            let many = || set.iter().max_by_key(|s| self.depth(**s / 2)).copied();
            let wide = both.or_else(|| many().filter(|_| set.len() > MOST));
            let within = |s: &Side| {
                let mut others = set.clone();
                others.remove(s) && self.covers(&others, *s)
            };
            if let Some(inner) = set.iter().find(|s| within(s)).copied() {
                set.remove(&inner);
            } else if let Some(wide) = wide {
                set.extend(self.outer(wide)?);
                set.remove(&wide);
                if both.is_some() {
                    set.remove(&(wide ^ 1));
                }
            } else {
                return self.union(set);
            }
        }
    }

    /// The number of a union.
    fn union(&mut self, set: BTreeSet<Side>) -> Option<Side> {
        if set.len() == 1 {
            return set.first().copied();
        }
        let known = self.unions.iter().position(|u| *u == set);
        let number = known.unwrap_or_else(|| {
            self.unions.push(set);
            self.unions.len() - 1
        });
        Some(2 * self.pairs.len() + number)
    }

    /// How many choices guard this one, one inside the other; as many as there are where that is a circle.
    pub(super) fn depth(&self, choice: usize) -> usize {
        let (mut depth, mut level) = (0, BTreeSet::from([choice]));
        while depth <= self.pairs.len() {
            let outer = level.iter().filter_map(|k| self.outer(2 * k)).flatten();
            level = outer.map(|side| side / 2).collect();
            if level.is_empty() {
                break;
            }
            depth += 1;
        }
        depth
    }

    /// Does no choice guard itself?
    fn has_order(&self) -> bool {
        (0..self.pairs.len()).all(|k| self.depth(k) <= self.pairs.len())
    }

    /// What guards each choice: what is alive where any node that makes it is.
    fn standing(&mut self, graph: &Graph, nodes: &[Id]) -> Vec<Option<Side>> {
        let mut within: Vec<Option<Option<Side>>> = vec![None; self.pairs.len()];
        for &id in nodes {
            let own = pair(graph, id).and_then(|p| self.pairs.iter().position(|q| *q == p));
            if let Some(k) = own {
                let guard = self.guards.get(&id).copied();
                within[k] = Some(match within[k] {
                    None => guard,
                    Some(known) => self.either(known, guard),
                });
            }
        }
        within.into_iter().map(Option::flatten).collect()
    }

    /// Users come after what they use: from the last node to the first, each is guarded by the union of its uses.
    fn guarded(
        &mut self,
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
                let own = uses.get(&id).copied().flatten();
                self.narrowed(id, own)
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
                let guard = known.map_or(guard, |known| self.either(known, guard));
                uses.insert(operand, guard);
            }
        }
        // What a stage finds ready is there at no cost.
        uses.into_iter()
            .filter(|(id, _)| graph.varies(*id))
            .filter_map(|(id, side)| Some((id, side?)))
            .collect()
    }

    /// What guards a node, if it is 0 unless a side is alive that lies inside of what guards it otherwise.
    fn narrowed(&self, id: Id, own: Option<Side>) -> Option<Side> {
        let Some(&side) = self.zeros.get(&id) else {
            return own;
        };
        let inside = own.is_none_or(|own| self.covers(&self.sides(own), side));
        if inside { Some(side) } else { own }
    }

    /// The nodes that are 0 unless a side is alive: choices of 0 on their other side, and products with such nodes. The
    /// other factor must be so, too, or a number: else it could be undefined.
    fn vanishing(&self, graph: &Graph, nodes: &[Id]) -> HashMap<Id, Side> {
        let zero = |id: &Id| graph.literal(*id).is_some_and(Rational::is_zero);
        let mut zeros: HashMap<Id, Side> = HashMap::new();
        for &id in nodes {
            if graph.info(id).scope != Scope::default() {
                continue;
            }
            let of = |id: &Id| zeros.get(id).copied();
            let side = match graph.op(id) {
                Op::Negate(a) | Op::Power(a, _) => of(a),
                Op::Multiply(a, b) if graph.literal(*a).is_some() => of(b),
                Op::Multiply(a, b) | Op::Divide(a, b) if graph.literal(*b).is_some() => of(a),
                Op::Multiply(a, b) | Op::Add(a, b) | Op::Subtract(a, b) => {
                    of(a).filter(|side| of(b) == Some(*side))
                }
                op => {
                    let choice =
                        pair(graph, id).and_then(|p| self.pairs.iter().position(|q| *q == p));
                    match (choice, branches(op)) {
                        (Some(k), Some([_, no])) if zero(&no) => Some(2 * k),
                        (Some(k), Some([yes, _])) if zero(&yes) => Some(2 * k + 1),
                        _ => None,
                    }
                }
            };
            zeros.extend(side.map(|side| (id, side)));
        }
        zeros
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

    /// The guards of all that leaves are made of: of a leaf, the union of its value's and its derivatives'.
    fn of_leaves(&mut self, graph: &Graph, staged: &Staged, nodes: &[Id]) -> HashMap<Id, Side> {
        let mut uses: HashMap<Id, Option<Side>> = HashMap::new();
        for &id in nodes {
            if let Op::Leaf(_, _, node) = graph.op(id) {
                let guard = self.guard(id);
                let known = uses.get(node).copied();
                let guard = known.map_or(guard, |known| self.either(known, guard));
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
                let guard = known.map_or(own, |known| self.either(known, own));
                uses.insert(operand, guard);
            }
        }
        // What a stage finds ready is there at no cost.
        uses.into_iter()
            .filter(|(id, _)| graph.varies(*id))
            .filter_map(|(id, side)| Some((id, side?)))
            .collect()
    }
}
