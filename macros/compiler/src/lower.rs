//! From the resolved formula to the computation graph.

use crate::functions::Function;
use crate::graph::{Fold, Graph, Id, Op, Over, Scope, Undecided};
use crate::tree::{self, Condition, Formula, Operator, Source, Term, TermKind};
use std::collections::{HashMap, HashSet};

/// A formula that the graph cannot hold.
#[derive(Debug)]
pub struct TooLarge {
    /// What is too much, and where.
    pub source: Source,
}

/// Lowers terms of one formula into one graph.
pub struct Lowering<'a> {
    formula: &'a Formula,
    /// The graph so far.
    pub graph: Graph,
    lets: HashMap<usize, Id>,
    /// The `let`s that spell rational numbers.
    constants: HashSet<usize>,
    folds: HashMap<usize, usize>,
    depth: usize,
    outermost: Vec<usize>,
}

impl<'a> Lowering<'a> {
    /// An empty graph for `formula`.
    pub fn new(formula: &'a Formula) -> Self {
        Lowering::into_graph(formula, Graph::default())
    }

    /// The same, into this graph: [`Graph::as_written`] keeps what the formula says.
    pub fn into_graph(formula: &'a Formula, graph: Graph) -> Self {
        let (lets, folds) = (HashMap::new(), HashMap::new());
        Lowering {
            formula,
            graph,
            lets,
            constants: HashSet::new(),
            folds,
            depth: 0,
            outermost: Vec::new(),
        }
    }

    /// The formula's value: left − right.
    pub fn root(&mut self) -> Result<Id, TooLarge> {
        // In source order, so that a chain of `let`s is no recursion.
        for index in &self.formula.body {
            self.binding(*index)?;
        }
        let left = self.term(&self.formula.left)?;
        let value = match &self.formula.right {
            None => left,
            Some(right) => {
                let right = self.term(right)?;
                self.graph.subtract(left, right)
            }
        };
        Ok(self.graph.balanced(value))
    }

    /// One term.
    pub fn term(&mut self, term: &Term) -> Result<Id, TooLarge> {
        Ok(match &term.kind {
            TermKind::Number(r) => self.graph.number(r.clone()),
            TermKind::Pi(_) => self.graph.input(Op::Pi),
            TermKind::Tau(_) => {
                let pi = self.graph.input(Op::Pi);
                let two = self.graph.integer(2);
                self.graph.multiply(two, pi)
            }
            TermKind::Coordinate(axis, _) => self.graph.input(Op::Coordinate(*axis)),
            TermKind::Field { field, indices, .. } => {
                let indices = self.indices(indices);
                self.graph.input(Op::Field(*field, indices))
            }
            TermKind::Let(index, _) => return self.binding(*index),
            TermKind::Row { fold, column, .. } => {
                self.graph.input(Op::Row(self.fold_of(*fold), *column))
            }
            TermKind::Counter(fold, _) => self.graph.input(Op::Counter(self.fold_of(*fold))),
            TermKind::Negate(a) => {
                let a = self.term(a)?;
                self.graph.negate(a)
            }
            TermKind::Binary(operator, a, b) => {
                // What an exponent turns out to be must not change the power's domain.
                let real = *operator == Operator::Power && !self.is_constant(b);
                let (a, b) = (self.term(a)?, self.term(b)?);
                if real {
                    self.graph.real_power(a, b)
                } else {
                    self.operator(*operator, a, b)
                }
            }
            TermKind::Call(f, _, arguments) => {
                let arguments = arguments
                    .iter()
                    .map(|a| self.term(a))
                    .collect::<Result<Vec<_>, _>>()?;
                self.call(*f, &arguments)
            }
            TermKind::Fold(kind, fold, body) => return self.fold(*kind, *fold, body, term.source),
            TermKind::Block(_, value) => return self.term(value),
            TermKind::If(condition, yes, no) => {
                let condition = self.condition(condition)?;
                let (yes, no) = (self.term(yes)?, self.term(no)?);
                self.graph.choose(condition, yes, no, Undecided::Jump)
            }
        })
    }

    fn binding(&mut self, index: usize) -> Result<Id, TooLarge> {
        if let Some(&id) = self.lets.get(&index) {
            return Ok(id);
        }
        let formula = self.formula;
        let id = match formula.lets.get(index) {
            Some(binding) => {
                let id = self.term(&binding.value)?;
                if self.is_constant(&binding.value) {
                    self.constants.insert(index);
                }
                id
            }
            None => self.graph.integer(0),
        };
        self.lets.insert(index, id);
        Ok(id)
    }

    /// Is a rational number spelt out?
    fn is_constant(&self, term: &Term) -> bool {
        match &term.kind {
            TermKind::Number(_) => true,
            TermKind::Let(index, _) => self.constants.contains(index),
            TermKind::Negate(a) | TermKind::Block(_, a) => self.is_constant(a),
            TermKind::Binary(_, a, b) => self.is_constant(a) && self.is_constant(b),
            TermKind::Call(
                Function::Abs | Function::Recip | Function::Min | Function::Max,
                _,
                arguments,
            ) => arguments.iter().all(|a| self.is_constant(a)),
            _ => false,
        }
    }

    fn operator(&mut self, operator: Operator, a: Id, b: Id) -> Id {
        match operator {
            Operator::Add => self.graph.add(a, b),
            Operator::Subtract => self.graph.subtract(a, b),
            Operator::Multiply => self.graph.multiply(a, b),
            Operator::Divide => self.graph.divide(a, b),
            Operator::Power => self.graph.raise(a, b),
        }
    }

    fn call(&mut self, f: Function, arguments: &[Id]) -> Id {
        match *arguments {
            [a] => self.graph.unary(f, a),
            [a, b] => self.graph.binary(f, a, b),
            [v, low, high] => {
                let v = self.graph.binary(Function::Min, v, high);
                self.graph.binary(Function::Max, v, low)
            }
            _ => self.graph.integer(0),
        }
    }

    fn condition(&mut self, condition: &Condition) -> Result<Id, TooLarge> {
        let op = match condition {
            Condition::Less(a, b) => Op::Less(self.term(a)?, self.term(b)?),
            Condition::LessOrEqual(a, b) => Op::LessOrEqual(self.term(a)?, self.term(b)?),
            Condition::Both(a, b) => Op::Both(self.condition(a)?, self.condition(b)?),
            Condition::Either(a, b) => Op::Either(self.condition(a)?, self.condition(b)?),
        };
        Ok(self.graph.truth(op))
    }

    fn fold(
        &mut self,
        kind: tree::FoldKind,
        fold: usize,
        body: &Term,
        source: Source,
    ) -> Result<Id, TooLarge> {
        let index = self.enter(fold).ok_or(TooLarge { source })?;
        self.depth += 1;
        let body = self.term(body);
        self.depth -= 1;
        Ok(self.graph.fold(kind, index, vec![body?]))
    }

    /// The graph's fold for one of the formula's. Outermost folds over the same rows share one loop.
    fn enter(&mut self, fold: usize) -> Option<usize> {
        if let Some(&known) = self.folds.get(&fold) {
            return Some(known);
        }
        let over = match &self.formula.folds.get(fold)?.over {
            tree::Over::Range(start, end) => Over::Range(*start, *end),
            tree::Over::Table { field, indices, .. } => Over::Table(*field, self.indices(indices)),
        };
        let same = |known: &&usize| {
            self.graph
                .folds
                .get(**known)
                .is_some_and(|f| f.over == over)
        };
        let index = match self.outermost.iter().find(same) {
            Some(&known) if self.depth == 0 => known,
            _ => {
                let index = self.graph.folds.len();
                if index >= 64 {
                    return None;
                }
                let around = match &over {
                    Over::Range(..) => Scope::default(),
                    Over::Table(_, indices) => self.graph.chain_of(indices),
                };
                self.graph.folds.push(Fold {
                    over,
                    chain: around.union(Scope::of(index)),
                });
                if self.depth == 0 {
                    self.outermost.push(index);
                }
                index
            }
        };
        self.folds.insert(fold, index);
        Some(index)
    }

    fn fold_of(&self, fold: usize) -> usize {
        self.folds.get(&fold).copied().unwrap_or(fold)
    }

    fn indices(&self, indices: &[tree::Index]) -> Vec<tree::Index> {
        let map = |i: &tree::Index| match i {
            tree::Index::Counter(f, k) => tree::Index::Counter(self.fold_of(*f), *k),
            constant => constant.clone(),
        };
        indices.iter().map(map).collect()
    }
}
