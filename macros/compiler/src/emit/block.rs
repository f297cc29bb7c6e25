//! Straight-line code with loops: puts the nodes that are needed into order, and folds into loops.
//!
//! What a node becomes is the business of a [`Target`]; where it stands is decided here. A node belongs to the loops of
//! its scope. Inside a block (a function, or a loop's body) the nodes of that scope come in the order of their ids, which
//! is topological; folds over the same rows that wait for the same things share one loop.

use super::choices::{Side, side};
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope, operands};
use crate::tree::FoldKind;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// Turns nodes into code.
pub trait Target {
    /// What a node's value is in the code: one variable, or several.
    type Value: Clone;

    /// Does this stage find the node ready, in whatever loop it stands?
    fn ready(&self, id: Id) -> bool;
    /// The value of a node that this stage finds ready (a constant, a leaf, a coordinate), or `None`.
    fn given(&mut self, id: Id, out: &mut TokenStream) -> Option<Self::Value>;
    /// Computes an operation that is no fold.
    fn operation(
        &mut self,
        id: Id,
        values: &dyn Fn(Id) -> Option<Self::Value>,
        out: &mut TokenStream,
    ) -> Self::Value;
    /// Computes a sine and the cosine of the same node together, where that is less than both one by one.
    fn sine_and_cosine(
        &mut self,
        _ids: [Id; 2],
        _values: &dyn Fn(Id) -> Option<Self::Value>,
        _out: &mut TokenStream,
    ) -> Option<[Self::Value; 2]> {
        None
    }
    /// The header of a loop, `for … in …`, and what its body starts with. `scope` holds the loop itself.
    fn enter(&mut self, fold: usize, scope: Scope) -> (TokenStream, TokenStream);
    /// Declares a fold's accumulator in front of the loop, and updates it at the end of the body.
    fn accumulate(
        &mut self,
        id: Id,
        fold: (FoldKind, usize),
        arguments: &[Self::Value],
    ) -> (TokenStream, TokenStream, Self::Value);
    /// The side of a choice that guards a node: it is computed only where this is alive.
    fn guard(&self, _id: Id) -> Option<Side> {
        None
    }
    /// The variables that a node's code declares, each with what stands for it where it is not computed.
    fn declared(&self, _id: Id, _value: &Self::Value) -> Vec<(Ident, TokenStream)> {
        Vec::new()
    }
    /// The variables in which a value stands.
    fn names(&self, _value: &Self::Value) -> Vec<Ident> {
        Vec::new()
    }
    /// Work after the loop on an accumulator.
    fn finish(&mut self, id: Id, value: Self::Value, out: &mut TokenStream) -> Self::Value;
}

/// Code for `targets` inside `scope`; returns their values. `known` holds what is computed already.
pub fn block<T: Target>(
    graph: &Graph,
    target: &mut T,
    scope: Scope,
    targets: &[Id],
    known: &mut HashMap<Id, T::Value>,
    out: &mut TokenStream,
) -> Vec<T::Value> {
    let mut block = Block {
        graph,
        target,
        scope,
        known,
    };
    block.run(targets, out);
    targets
        .iter()
        .filter_map(|t| block.known.get(t).cloned())
        .collect()
}

struct Block<'a, T: Target> {
    graph: &'a Graph,
    target: &'a mut T,
    scope: Scope,
    known: &'a mut HashMap<Id, T::Value>,
}

/// The nodes that use each node, in a block and in its loops.
struct Uses {
    by: HashMap<Id, HashSet<Id>>,
    targets: HashSet<Id>,
}

impl Uses {
    /// Is a node used by others than these?
    fn outside(&self, id: Id, these: &HashSet<Id>) -> bool {
        let used = |by: &HashSet<Id>| !by.is_subset(these);
        self.targets.contains(&id) || self.by.get(&id).is_some_and(used)
    }
}

/// An order in which operands come first, and nodes with the same guard in a row: as they come, if none has a guard. What can be
/// computed now is taken in the order of the ids, but guarded nodes, if possible, only when all with their guard can be.
fn runs(graph: &Graph, mut nodes: Vec<(Id, Option<Side>)>) -> Vec<(Option<Side>, Vec<Id>)> {
    let mut runs = Vec::new();
    while !nodes.is_empty() {
        let waiting: HashSet<Id> = nodes.iter().map(|(id, _)| *id).collect();
        let guards: BTreeSet<Option<Side>> = nodes.iter().map(|(_, guard)| *guard).collect();
        let able = guards
            .into_iter()
            .map(|guard| (guard, able(graph, &nodes, guard, &waiting)));
        let all = |guard| nodes.iter().filter(|(_, g)| *g == guard).count();
        let best = able.min_by_key(|(guard, run)| {
            let part = guard.is_some() && run.len() < all(*guard);
            (run.is_empty(), part, run.first().copied())
        });
        let Some((guard, run)) = best.filter(|(_, run)| !run.is_empty()) else {
            // Operands come first by their ids: there is always one that can be computed.
            break;
        };
        nodes.retain(|(id, _)| !run.contains(id));
        runs.push((guard, run));
    }
    runs
}

/// The nodes with this guard that can be computed in a row, now.
fn able(
    graph: &Graph,
    nodes: &[(Id, Option<Side>)],
    guard: Option<Side>,
    waiting: &HashSet<Id>,
) -> Vec<Id> {
    let mut run: Vec<Id> = Vec::new();
    for (id, _) in nodes.iter().filter(|(_, g)| *g == guard) {
        let ready = |operand: Id| !waiting.contains(&operand) || run.contains(&operand);
        if operands(graph.op(*id)).into_iter().all(ready) {
            run.push(*id);
        }
    }
    run
}

/// A sine and the cosine of the same node, if one of them is `id` and the other is in the run.
fn sine_and_cosine(graph: &Graph, id: Id, run: &[Id]) -> Option<[Id; 2]> {
    let Op::Unary(function, a) = graph.op(id) else {
        return None;
    };
    let find = |other| {
        let other = Op::Unary(other, *a);
        run.iter().copied().find(|id| graph.op(*id) == &other)
    };
    match function {
        Function::Sin => Some([id, find(Function::Cos)?]),
        Function::Cos => Some([find(Function::Sin)?, id]),
        _ => None,
    }
}

/// The folds that one loop computes: the same fold, after the same loops of this block.
type Loops = BTreeMap<(u32, usize), Vec<Id>>;

impl<T: Target> Block<'_, T> {
    fn run(&mut self, targets: &[Id], out: &mut TokenStream) {
        let here = self.needed(targets, out);
        let phases = self.phases(&here);
        let uses = self.uses(targets);
        let last = phases.values().copied().max().unwrap_or(0);
        for phase in 0..=last {
            let mut loops = Loops::new();
            let mut plain = Vec::new();
            for &id in here.iter().filter(|id| phases.get(id) == Some(&phase)) {
                match self.graph.op(id) {
                    Op::Fold(_, fold, _) => loops.entry((phase, *fold)).or_default().push(id),
                    _ => plain.push((id, self.guard(id))),
                }
            }
            for (guard, run) in runs(self.graph, plain) {
                match guard {
                    None => run.iter().for_each(|id| self.operation(*id, &run, out)),
                    Some(guard) => self.guarded(guard, &run, &uses, out),
                }
            }
            for ((_, fold), ids) in loops {
                self.emit_loop(fold, &ids, out);
            }
        }
    }

    /// Nodes that one side guards. What is used behind them is declared in front; the others are forgotten.
    fn guarded(&mut self, guard: Side, run: &[Id], uses: &Uses, out: &mut TokenStream) {
        let (mut code, mut declared) = (TokenStream::new(), Vec::new());
        for &id in run {
            self.operation(id, run, &mut code);
            if let Some(value) = self.known.get(&id) {
                declared.extend(self.target.declared(id, value));
            }
        }
        let inside: HashSet<Id> = run.iter().copied().collect();
        let mut lasting = HashSet::new();
        for id in run {
            match self.known.get(id) {
                Some(value) if uses.outside(*id, &inside) => {
                    lasting.extend(self.target.names(value))
                }
                _ => _ = self.known.remove(id),
            }
        }
        declared.retain(|(name, _)| lasting.contains(name));
        let (names, nothing): (Vec<_>, Vec<_>) = declared.into_iter().unzip();
        let of = side(guard);
        out.extend(quote! {
            let (#(#names,)*) = if #of { #code (#(#names,)*) } else { (#(#nothing,)*) };
        });
    }

    fn uses(&self, targets: &[Id]) -> Uses {
        let mut uses = Uses {
            by: HashMap::new(),
            targets: targets.iter().copied().collect(),
        };
        for id in self.graph.reachable(targets, |id| self.target.ready(id)) {
            if !self.target.ready(id) {
                for operand in operands(self.graph.op(id)) {
                    uses.by.entry(operand).or_default().insert(id);
                }
            }
        }
        uses
    }

    /// The nodes of this block's scope that are still to be computed, also those that only a loop's body needs.
    fn needed(&mut self, targets: &[Id], out: &mut TokenStream) -> Vec<Id> {
        let mut here = Vec::new();
        let mut todo: Vec<Id> = targets.to_vec();
        let mut seen = std::collections::HashSet::new();
        while let Some(id) = todo.pop() {
            if !seen.insert(id) || self.known.contains_key(&id) {
                continue;
            }
            if self.graph.info(id).scope.within(self.scope) {
                if self.guard(id).is_none()
                    && let Some(value) = self.target.given(id, out)
                {
                    self.known.insert(id, value);
                    continue;
                }
                here.push(id);
            }
            if self.target.ready(id) {
                continue;
            }
            todo.extend(operands(self.graph.op(id)));
        }
        here.sort();
        here
    }

    /// How many loops of this block a node waits for; a fold belongs to the phase in which its loop runs.
    fn phases(&self, here: &[Id]) -> HashMap<Id, u32> {
        let mut phases = HashMap::new();
        for &id in here {
            let phase = self.ready(id, &phases, &mut HashMap::new());
            phases.insert(id, phase);
        }
        phases
    }

    /// The phase in which all that `id` needs is there, looking through nodes that stand in inner loops.
    fn ready(&self, id: Id, phases: &HashMap<Id, u32>, memo: &mut HashMap<Id, u32>) -> u32 {
        if let Some(&phase) = memo.get(&id) {
            return phase;
        }
        let mut phase = 0;
        for operand in operands(self.graph.op(id)) {
            let needs = match phases.get(&operand) {
                Some(&p) => p + u32::from(matches!(self.graph.op(operand), Op::Fold(..))),
                None if self.known.contains_key(&operand) => 0,
                None => self.ready(operand, phases, memo),
            };
            phase = phase.max(needs);
        }
        memo.insert(id, phase);
        phase
    }

    /// Loops compute all of their bodies.
    fn guard(&self, id: Id) -> Option<Side> {
        self.target
            .guard(id)
            .filter(|_| self.scope == Scope::default())
    }

    /// Computes a node of a run.
    fn operation(&mut self, id: Id, run: &[Id], out: &mut TokenStream) {
        if self.known.contains_key(&id) {
            // With its partner.
            return;
        }
        if let Some(value) = self.target.given(id, out) {
            self.known.insert(id, value);
            return;
        }
        let known = &*self.known;
        let values = |a: Id| known.get(&a).cloned();
        if let Some(ids) = sine_and_cosine(self.graph, id, run)
            && !ids.iter().any(|id| self.target.ready(*id))
            && let Some(both) = self.target.sine_and_cosine(ids, &values, out)
        {
            self.known.extend(ids.into_iter().zip(both));
            return;
        }
        let value = self.target.operation(id, &values, out);
        self.known.insert(id, value);
    }

    fn emit_loop(&mut self, fold: usize, ids: &[Id], out: &mut TokenStream) {
        let scope = self.scope.union(self.graph.chain(fold));
        let (header, start) = self.target.enter(fold, scope);
        let mut body = start;
        let mut inner = self.known.clone();
        let mut before = TokenStream::new();
        let mut after = Vec::new();
        for &id in ids {
            let Op::Fold(kind, fold, arguments) = self.graph.op(id) else {
                continue;
            };
            let values = block(
                self.graph,
                self.target,
                scope,
                arguments,
                &mut inner,
                &mut body,
            );
            let (declare, update, value) = self.target.accumulate(id, (*kind, *fold), &values);
            before.extend(declare);
            body.extend(update);
            after.push((id, value));
        }
        out.extend(quote! { #before #header { #body } });
        for (id, value) in after {
            let value = self.target.finish(id, value, out);
            self.known.insert(id, value);
        }
    }
}
