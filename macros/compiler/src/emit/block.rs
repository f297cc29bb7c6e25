//! Straight-line code with loops: puts the nodes that are needed into order, and folds into loops.
//!
//! What a node becomes is the business of a [`Target`]; where it stands is decided here. A node belongs to the loops of
//! its scope. Inside a block (a function, or a loop's body) the nodes of that scope come in the order of their ids, which
//! is topological; folds over the same rows that wait for the same things share one loop.

use super::choices::Side;
use super::regions::alive;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope, operands};
use crate::tree::FoldKind;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
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
    /// The region inside of `from` in which code stands that `guard` guards.
    fn step(&self, _from: Option<Side>, guard: Side) -> Side {
        guard
    }
    /// Is a node written to where it is kept as soon as it is computed? Then it need not last until the end of the block.
    fn keeps(&self, _id: Id) -> bool {
        false
    }
    /// Writes such a node.
    fn write(&mut self, _id: Id, _value: &Self::Value, _out: &mut TokenStream) {}
    /// The operand that a node passes on where it is not computed.
    fn passed(&self, _id: Id) -> Option<Id> {
        None
    }
    /// The variables that a node's code declares, each with what stands for it where it is not computed: those of the operand
    /// that is passed on, or nothing.
    fn declared(&self, _id: Id, _value: &Self::Value, _passed: Option<&Self::Value>) -> Declared {
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
        region: None,
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
    /// Where in the code its nodes stand.
    region: Option<Side>,
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

/// An order in which operands come first, and nodes of the same region in a row: as they come, if none has a region. What can be
/// computed now is taken in the order of the ids, but regions, if possible, only when all of them can be.
fn runs(graph: &Graph, mut nodes: Vec<(Id, Option<Side>)>) -> Vec<(Option<Side>, Vec<Id>)> {
    let mut runs = Vec::new();
    while !nodes.is_empty() {
        let waiting: HashSet<Id> = nodes.iter().map(|(id, _)| *id).collect();
        let regions: BTreeSet<Option<Side>> = nodes.iter().map(|(_, region)| *region).collect();
        let able = regions
            .into_iter()
            .map(|region| (region, able(graph, &nodes, region, &waiting)));
        let all = |region| nodes.iter().filter(|(_, r)| *r == region).count();
        let best = able.min_by_key(|(region, run)| {
            let part = region.is_some() && run.len() < all(*region);
            (run.is_empty(), part, run.first().copied())
        });
        let Some((region, run)) = best.filter(|(_, run)| !run.is_empty()) else {
            // Operands come first by their ids: there is always one that can be computed.
            break;
        };
        let done: HashSet<Id> = run.iter().copied().collect();
        nodes.retain(|(id, _)| !done.contains(id));
        runs.push((region, run));
    }
    runs
}

/// The nodes of this region that can be computed in a row, now.
fn able(
    graph: &Graph,
    nodes: &[(Id, Option<Side>)],
    region: Option<Side>,
    waiting: &HashSet<Id>,
) -> Vec<Id> {
    let (mut run, mut done) = (Vec::new(), HashSet::new());
    for (id, _) in nodes.iter().filter(|(_, r)| *r == region) {
        let ready = |operand: Id| !waiting.contains(&operand) || done.contains(&operand);
        if operands(graph.op(*id)).into_iter().all(ready) {
            run.push(*id);
            done.insert(*id);
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

/// What stands for a variable where it is not computed.
#[derive(Clone)]
pub enum Instead {
    /// This expression.
    Code(TokenStream),
    /// Another variable.
    Variable(Ident),
}

impl ToTokens for Instead {
    fn to_tokens(&self, out: &mut TokenStream) {
        match self {
            Instead::Code(code) => code.to_tokens(out),
            Instead::Variable(name) => name.to_tokens(out),
        }
    }
}

/// Variables, each with what stands for it where it is not computed.
pub type Declared = Vec<(Ident, Instead)>;

/// Outside of the code that declares these, what stands for them there.
fn outside(mut declared: Declared) -> Declared {
    let inner: HashMap<Ident, Instead> = declared.iter().cloned().collect();
    for (_, instead) in &mut declared {
        while let Instead::Variable(name) = instead
            && let Some(next) = inner.get(name)
        {
            *instead = next.clone();
        }
    }
    declared
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
                    _ => plain.push(id),
                }
            }
            self.nodes(&plain, &uses, out);
            for ((_, fold), ids) in loops {
                self.emit_loop(fold, &ids, out);
            }
        }
    }

    /// Nodes of the region where the code stands, and of those inside of it. The variables that it declares, each with what
    /// stands for it where it is not computed.
    fn nodes(&mut self, nodes: &[Id], uses: &Uses, out: &mut TokenStream) -> Declared {
        let mut declared = Vec::new();
        let own = |id: &Id| (*id, self.inner(*id));
        for (region, run) in runs(self.graph, nodes.iter().map(own).collect()) {
            if let Some(region) = region {
                declared.extend(self.inside(region, &run, uses, out));
                continue;
            }
            for id in &run {
                self.operation(*id, &run, out);
                let passed = self.target.passed(*id).and_then(|a| self.known.get(&a));
                if let Some(value) = self.known.get(id) {
                    declared.extend(self.target.declared(*id, value, passed));
                }
            }
        }
        declared
    }

    /// The region inside of this one where a node stands.
    fn inner(&self, id: Id) -> Option<Side> {
        let guard = self.guard(id).filter(|guard| Some(*guard) != self.region)?;
        Some(self.target.step(self.region, guard))
    }

    /// The nodes of a region inside of this one. What is used behind them is declared in front; the others are forgotten.
    fn inside(&mut self, region: Side, run: &[Id], uses: &Uses, out: &mut TokenStream) -> Declared {
        let outer = self.region.replace(region);
        let mut code = TokenStream::new();
        let declared = self.nodes(run, uses, &mut code);
        self.region = outer;
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
        let mut declared = outside(declared);
        declared.retain(|(name, _)| lasting.contains(name));
        let names: Vec<_> = declared.iter().map(|(name, _)| name).collect();
        let nothing = declared.iter().map(|(_, nothing)| nothing);
        let alive = alive(region);
        out.extend(quote! {
            let (#(#names,)*) = if #alive { #code (#(#names,)*) } else { (#(#nothing,)*) };
        });
        declared
    }

    fn uses(&self, targets: &[Id]) -> Uses {
        let mut uses = Uses {
            by: HashMap::new(),
            targets: targets
                .iter()
                .copied()
                .filter(|id| !self.target.keeps(*id))
                .collect(),
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
                    self.hold(id, value, out);
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
            self.hold(id, value, out);
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
        self.hold(id, value, out);
    }

    fn hold(&mut self, id: Id, value: T::Value, out: &mut TokenStream) {
        self.target.write(id, &value, out);
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
            self.hold(id, value, out);
        }
    }
}
