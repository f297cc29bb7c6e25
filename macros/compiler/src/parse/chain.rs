//! Chains of operators of one precedence: `a + b - c + …`.
//!
//! Written out left to right a sum of 1,000 terms is a tree 1,000 levels high, and every later pass recurses. Beyond
//! [`LONGEST`] operands a chain is therefore halved. Over the real numbers that changes nothing: sums associate, and
//! `a - b + c - d` is `(a - b) + (c - d)`; when the right half begins with a subtraction its signs are turned around,
//! `a - (b - c)`. Products associate too; around a division they do not as far as domains go (`a/(b/c)` needs `c ≠ 0`),
//! so only runs of `*` between divisions are halved.

use super::{Parser, error};
use crate::ast::{Comparison, Expr, ExprKind, Logic};
use crate::diagnostic::Place;
use crate::tree::Operator;

/// Longer chains become balanced trees.
const LONGEST: usize = 32;

/// What joins two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Join {
    /// Arithmetic.
    Arithmetic(Operator),
    /// A comparison.
    Compare(Comparison),
    /// `&&`, `||`
    Logic(Logic),
    /// Not an operator of the language; reported.
    Mistake,
}

/// An operand with the operator before it.
type Link = (Join, Expr);

impl Parser<'_> {
    /// Builds the tree of `first` and the operands that follow it.
    pub(super) fn chain(&mut self, first: Expr, rest: Vec<Link>) -> Expr {
        if rest.len() < LONGEST {
            return self.left_to_right(first, rest);
        }
        match rest.first().map(|(join, _)| *join) {
            Some(Join::Arithmetic(Operator::Add | Operator::Subtract)) if sound(&rest) => {
                self.halved(first, rest)
            }
            Some(Join::Arithmetic(_)) if sound(&rest) => self.product(first, rest),
            _ => self.left_to_right(first, rest),
        }
    }

    /// `((a ∘ b) ∘ c) ∘ d`
    fn left_to_right(&mut self, first: Expr, rest: Vec<Link>) -> Expr {
        let mut left = first;
        for (join, right) in rest {
            left = self.join(join, left, right);
        }
        left
    }

    /// One operator with its operands.
    fn join(&mut self, join: Join, left: Expr, right: Expr) -> Expr {
        let place = left.place.to(right.place);
        let kind = match join {
            Join::Arithmetic(operator) => {
                ExprKind::Binary(operator, Box::new(left), Box::new(right))
            }
            Join::Compare(comparison) => {
                ExprKind::Compare(comparison, Box::new(left), Box::new(right))
            }
            Join::Logic(logic) => ExprKind::Logic(logic, Box::new(left), Box::new(right)),
            Join::Mistake => return self.mistake(place, vec![left, right]),
        };
        self.expr(kind, place)
    }

    /// A reported mistake as an expression; a long chain of mistakes stays flat.
    fn mistake(&mut self, place: Place, mut parts: Vec<Expr>) -> Expr {
        if let Some(ExprKind::Error(inner)) = parts.first_mut().map(|p| &mut p.kind) {
            let mut all = std::mem::take(inner);
            all.extend(parts.into_iter().skip(1));
            return error(place, all);
        }
        error(place, parts)
    }

    /// Halves a chain of one associative operator and its inverse.
    fn halved(&mut self, first: Expr, mut rest: Vec<Link>) -> Expr {
        if rest.len() < LONGEST {
            return self.left_to_right(first, rest);
        }
        let mut upper = rest.split_off(rest.len() / 2);
        let (join, head) = upper.remove(0);
        if join == Join::Arithmetic(Operator::Subtract) {
            for (join, _) in &mut upper {
                *join = turned(*join);
            }
        }
        let left = self.halved(first, rest);
        let right = self.halved(head, upper);
        self.join(join, left, right)
    }

    /// Halves the runs of `*` between divisions.
    fn product(&mut self, first: Expr, rest: Vec<Link>) -> Expr {
        let mut left = first;
        let mut run: Vec<Link> = Vec::new();
        for (join, right) in rest {
            if join == Join::Arithmetic(Operator::Divide) {
                left = self.halved(left, std::mem::take(&mut run));
                left = self.join(join, left, right);
            } else {
                run.push((join, right));
            }
        }
        self.halved(left, run)
    }
}

/// Are all joins arithmetic?
fn sound(rest: &[Link]) -> bool {
    rest.iter()
        .all(|(join, _)| matches!(join, Join::Arithmetic(_)))
}

/// `+` for `-` and the reverse.
fn turned(join: Join) -> Join {
    match join {
        Join::Arithmetic(Operator::Add) => Join::Arithmetic(Operator::Subtract),
        Join::Arithmetic(Operator::Subtract) => Join::Arithmetic(Operator::Add),
        other => other,
    }
}
