//! Comparisons and branches.

use super::expression::term;
use super::{Resolver, Value};
use crate::ast::{Comparison, Expr, ExprKind, Logic};
use crate::catalogue::shapes;
use crate::diagnostic::Place;
use crate::tree::{Condition, TermKind};

impl Resolver<'_> {
    /// `if`
    pub(super) fn branch(&mut self, place: Place, parts: &[Expr; 3]) -> Option<Value> {
        let [condition, then, otherwise] = parts;
        let condition = self.condition(condition);
        let then = self.value(then);
        let otherwise = self.value(otherwise);
        let ((condition, tests), then, otherwise) = (condition?, then?, otherwise?);
        let kind = TermKind::If(
            Box::new(condition),
            Box::new(then.term),
            Box::new(otherwise.term),
        );
        Some(Value {
            term: term(place, kind),
            constant: None,
            moves: tests || then.moves || otherwise.moves,
        })
    }

    /// A condition, and whether it depends on the point.
    fn condition(&mut self, expr: &Expr) -> Option<(Condition, bool)> {
        match &expr.kind {
            ExprKind::Compare(comparison, a, b) => {
                let left = self.value(a);
                let right = self.value(b);
                let (left, right) = (left?, right?);
                let moves = left.moves || right.moves;
                let condition = match comparison {
                    Comparison::Less => Condition::Less(left.term, right.term),
                    Comparison::LessOrEqual => Condition::LessOrEqual(left.term, right.term),
                    Comparison::Greater => Condition::Less(right.term, left.term),
                    Comparison::GreaterOrEqual => Condition::LessOrEqual(right.term, left.term),
                };
                Some((condition, moves))
            }
            ExprKind::Logic(logic, a, b) => {
                let left = self.condition(a);
                let right = self.condition(b);
                let ((left, moves), (right, more)) = (left?, right?);
                let (left, right) = (Box::new(left), Box::new(right));
                let condition = match logic {
                    Logic::And => Condition::Both(left, right),
                    Logic::Or => Condition::Either(left, right),
                };
                Some((condition, moves || more))
            }
            ExprKind::Error(_) => {
                self.names_in(expr);
                None
            }
            _ => {
                self.value(expr)?;
                self.diagnostics
                    .push(shapes::number_as_condition(expr.place));
                None
            }
        }
    }

    /// Reports a formula that is a comparison.
    pub(super) fn inequality(&mut self, expr: &Expr) -> bool {
        if !matches!(expr.kind, ExprKind::Compare(..) | ExprKind::Logic(..)) {
            return false;
        }
        if !flawed(expr) {
            self.diagnostics.push(shapes::inequality(expr.place));
        }
        self.names_in(expr);
        true
    }
}

/// Has a comparison a side that was reported already?
pub(super) fn flawed(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Compare(_, a, b) | ExprKind::Logic(_, a, b) => flawed(a) || flawed(b),
        ExprKind::Error(_) => true,
        _ => false,
    }
}
