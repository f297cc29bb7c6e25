//! What becomes a leaf: subexpressions of degree ≤ 2 that are as large as sums and products allow.
//!
//! Sums and products are read as lists, so that the low terms of `x^4 - 5*x^2 + y^4 - 5*y^2` make one leaf, wherever they
//! stand. A quadratic leaf costs about two products, and its range is exact; where something cheaper is as exact, that is
//! taken: the square of a linear leaf, and a leaf that is there already, scaled or shifted by a constant.

use super::{MOST, Staged};
use crate::form::Form;
use crate::graph::{Graph, Id, Op, operands};
use std::collections::{HashMap, HashSet};

/// What is known about a formula before it is split.
#[derive(Debug, Default)]
pub(super) struct Survey {
    /// How many operations use a node.
    uses: HashMap<Id, u32>,
    /// The quadratics that are a base scaled or shifted, by base.
    alike: HashMap<Id, HashSet<Id>>,
    settled: bool,
}

impl Survey {
    pub fn new(graph: &Graph, root: Id) -> Survey {
        let mut survey = Survey::default();
        for id in graph.reachable(&[root], |_| false) {
            for operand in operands(graph.op(id)) {
                *survey.uses.entry(operand).or_default() += 1;
            }
        }
        survey
    }

    /// All quadratics were seen.
    pub fn settle(&mut self) {
        self.settled = true;
    }

    /// Is the node part of one operation alone?
    fn is_inner(&self, id: Id) -> bool {
        self.uses.get(&id).is_none_or(|n| *n == 1)
    }

    /// Is the base of a quadratic also that of others?
    fn is_shared(&self, base: Id) -> bool {
        self.settled && self.alike.get(&base).is_some_and(|all| all.len() > 1)
    }
}

/// The quadratic without the constants that it is scaled and shifted by.
fn base(graph: &Graph, id: Id) -> Id {
    match *graph.op(id) {
        Op::Negate(a) => base(graph, a),
        Op::Add(a, b) | Op::Subtract(a, b) | Op::Multiply(a, b) => {
            match (graph.varies(a), graph.varies(b)) {
                (false, true) => base(graph, b),
                (true, false) => base(graph, a),
                _ => id,
            }
        }
        _ => id,
    }
}

/// Is it the square of a linear expression?
fn is_square(graph: &Graph, id: Id) -> bool {
    matches!(*graph.op(id), Op::Power(a, 2) if graph.info(a).degree == Some(1))
}

/// Is it a polynomial of this degree at most?
fn is_low(graph: &Graph, id: Id, most: u32) -> bool {
    graph.info(id).degree.is_some_and(|d| d <= most)
}

impl Staged {
    /// A node of degree 2.
    pub(super) fn quadratic(
        &mut self,
        graph: &mut Graph,
        id: Id,
        memo: &mut HashMap<Id, Id>,
    ) -> Id {
        let base = base(graph, id);
        self.survey.alike.entry(base).or_default().insert(id);
        if is_square(graph, base) || id != base && self.survey.is_shared(base) {
            return self.rebuild_operation(graph, id, memo);
        }
        self.leaf(graph, id)
    }

    /// A sum of higher degree: its low terms together are one leaf, or those that are polynomials one polynomial.
    pub(super) fn sum(&mut self, graph: &mut Graph, id: Id, memo: &mut HashMap<Id, Id>) -> Id {
        let whole = graph.info(id).degree.is_some();
        let most = if self.form == Form::Staged && !whole {
            MOST
        } else {
            2
        };
        let mut terms = Vec::new();
        self.terms(graph, id, (false, most), &mut terms);
        let (low, high): (Vec<_>, Vec<_>) = terms
            .into_iter()
            .partition(|term| is_low(graph, term.1, most));
        let Some(together) = total(graph, &low) else {
            return self.rebuild_operation(graph, id, memo);
        };
        if low.len() < 2 {
            return self.rebuild_operation(graph, id, memo);
        }
        let mut sum = self.rebuild(graph, together, memo);
        for (negative, term) in high {
            let term = self.rebuild(graph, term, memo);
            sum = signed(graph, sum, negative, term);
        }
        sum
    }

    /// The terms of a sum, with a flag for those that are subtracted. A partial sum that is used elsewhere too is a term.
    fn terms(
        &self,
        graph: &Graph,
        id: Id,
        (negative, most): (bool, u32),
        out: &mut Vec<(bool, Id)>,
    ) {
        let inner = |a: Id| self.survey.is_inner(a) && !is_low(graph, a, most);
        let mut next = |a: Id, negative: bool| match graph.op(a) {
            Op::Add(..) | Op::Subtract(..) | Op::Negate(_) if inner(a) => {
                self.terms(graph, a, (negative, most), out);
            }
            _ => out.push((negative, a)),
        };
        match *graph.op(id) {
            Op::Add(a, b) => {
                next(a, negative);
                next(b, negative);
            }
            Op::Subtract(a, b) => {
                next(a, negative);
                next(b, !negative);
            }
            Op::Negate(a) => next(a, !negative),
            _ => next(id, negative),
        }
    }

    /// A product of higher degree: linear factors go in pairs, and constants into a leaf, where they cost nothing.
    pub(super) fn product(&mut self, graph: &mut Graph, id: Id, memo: &mut HashMap<Id, Id>) -> Id {
        let mut factors = Vec::new();
        self.factors(graph, id, &mut factors);
        let degree = |graph: &Graph, a: Id| graph.info(a).degree;
        let (constants, mut rest): (Vec<Id>, Vec<Id>) =
            factors.into_iter().partition(|a| !graph.varies(*a));
        pair(graph, &mut rest);
        let takes = |a: &&mut Id| match degree(graph, **a) {
            Some(1) => true,
            Some(2) => !is_square(graph, base(graph, **a)),
            _ => false,
        };
        match (constants.is_empty(), rest.iter_mut().find(takes)) {
            (true, _) => {}
            (false, Some(place)) => {
                let factor = constants.into_iter().reduce(|a, b| graph.multiply(a, b));
                if let Some(factor) = factor {
                    *place = graph.multiply(factor, *place);
                }
            }
            (false, None) => return self.rebuild_operation(graph, id, memo),
        }
        let rebuilt: Vec<Id> = rest
            .into_iter()
            .map(|a| self.rebuild(graph, a, memo))
            .collect();
        let product = rebuilt.into_iter().reduce(|a, b| graph.multiply(a, b));
        product.unwrap_or(id)
    }

    /// The factors of a product. A partial product that is used elsewhere too is a factor.
    fn factors(&self, graph: &Graph, id: Id, out: &mut Vec<Id>) {
        match *graph.op(id) {
            Op::Multiply(a, b) => {
                for factor in [a, b] {
                    if self.survey.is_inner(factor) {
                        self.factors(graph, factor, out);
                    } else {
                        out.push(factor);
                    }
                }
            }
            _ => out.push(id),
        }
    }
}

/// Multiplies linear factors in pairs.
fn pair(graph: &mut Graph, factors: &mut Vec<Id>) {
    let mut waiting: Option<usize> = None;
    let mut k = 0;
    while let Some(&factor) = factors.get(k) {
        if graph.info(factor).degree == Some(1) {
            match waiting.take() {
                None => waiting = Some(k),
                Some(first) => {
                    if let Some(other) = factors.get(first).copied() {
                        factors[first] = graph.multiply(other, factor);
                        factors.remove(k);
                        continue;
                    }
                }
            }
        }
        k += 1;
    }
}

/// The sum of terms, the first positive one first.
fn total(graph: &mut Graph, terms: &[(bool, Id)]) -> Option<Id> {
    let start = terms.iter().position(|t| !t.0).unwrap_or(0);
    let &(negative, first) = terms.get(start)?;
    let first = if negative { graph.negate(first) } else { first };
    let rest = terms.iter().enumerate().filter(|(k, _)| *k != start);
    Some(rest.fold(first, |sum, (_, t)| signed(graph, sum, t.0, t.1)))
}

fn signed(graph: &mut Graph, sum: Id, negative: bool, term: Id) -> Id {
    if negative {
        graph.subtract(sum, term)
    } else {
        graph.add(sum, term)
    }
}
