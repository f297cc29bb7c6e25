//! Numbers and what is made of them.

use super::condition::flawed;
use super::table::Element;
use super::{Resolver, Setting, Value, constant};
use crate::ast::{Expr, ExprKind};
use crate::catalogue::{constants, head, shapes};
use crate::diagnostic::Place;
use crate::exact::Rational;
use crate::tree::{Operator, Term, TermKind};

/// The largest exponent: far beyond any formula, and far within what the runtime's powers take.
const MOST_EXPONENT: u32 = 1_000_000;

impl Resolver<'_> {
    /// Resolves an expression that must be a number.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<Value> {
        if !self.allowed(expr) {
            return None;
        }
        match &expr.kind {
            ExprKind::Number(number) => Some(Value {
                term: term(expr.place, TermKind::Number(number.clone())),
                constant: Some(number.clone()),
                moves: false,
            }),
            ExprKind::Name(_) | ExprKind::Index(..) => match self.element(expr)? {
                Element::Number(value) => Some(value),
                Element::Table(table) => {
                    let found = super::table::describe(&table.shape);
                    self.diagnostics
                        .push(shapes::table_as_number(expr.place, &format!("a {found}")));
                    None
                }
            },
            ExprKind::Negate(operand) => {
                let operand = self.value(operand)?;
                Some(Value {
                    term: term(expr.place, TermKind::Negate(Box::new(operand.term))),
                    constant: operand.constant.map(|c| -c),
                    moves: operand.moves,
                })
            }
            ExprKind::Binary(operator, a, b) => {
                let left = self.value(a);
                let right = self.value(b);
                self.binary(expr.place, *operator, (a.place, left?), (b.place, right?))
            }
            ExprKind::Call(name, arguments) => self.call(expr.place, name, arguments),
            ExprKind::Fold(fold) => self.fold(expr.place, fold),
            ExprKind::If(parts) => self.branch(expr.place, parts),
            ExprKind::Block(body) => self.body(body),
            ExprKind::Compare(_, a, b) | ExprKind::Logic(_, a, b) => {
                if !flawed(expr) {
                    self.diagnostics
                        .push(shapes::comparison_as_number(expr.place));
                }
                self.names_in(a);
                self.names_in(b);
                None
            }
            ExprKind::List(parts) => {
                self.diagnostics.push(shapes::list_as_number(expr.place));
                parts.iter().for_each(|part| self.names_in(part));
                None
            }
            ExprKind::Repeat(parts) => {
                self.diagnostics.push(shapes::list_as_number(expr.place));
                parts.iter().for_each(|part| self.names_in(part));
                None
            }
            ExprKind::Error(parts) => {
                parts.iter().for_each(|part| self.names_in(part));
                None
            }
        }
    }

    /// Checks the names inside something that has a mistake already.
    pub(super) fn names_in(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Compare(_, a, b) | ExprKind::Logic(_, a, b) => {
                self.names_in(a);
                self.names_in(b);
            }
            ExprKind::Name(name) if self.names_a_table(&name.text) => {}
            ExprKind::List(entries) => entries.iter().for_each(|entry| self.names_in(entry)),
            _ => {
                self.value(expr);
            }
        }
    }

    /// Reports what a constant cannot be made of.
    fn allowed(&mut self, expr: &Expr) -> bool {
        let constant = !matches!(
            expr.kind,
            ExprKind::Fold(_)
                | ExprKind::If(_)
                | ExprKind::Block(_)
                | ExprKind::Compare(..)
                | ExprKind::Logic(..)
        );
        match self.setting {
            _ if constant => return true,
            Setting::Formula => return true,
            Setting::Default => self.diagnostics.push(head::default_kind(expr.place)),
            Setting::Domain => self.diagnostics.push(head::domain_bound(expr.place)),
        }
        false
    }

    /// A binary operation on two numbers.
    fn binary(
        &mut self,
        place: Place,
        operator: Operator,
        (_, left): (Place, Value),
        (right_place, right): (Place, Value),
    ) -> Option<Value> {
        match operator {
            Operator::Divide => self.division(right_place, &right)?,
            Operator::Power => self.power(place, right_place, &left, &right)?,
            Operator::Add | Operator::Subtract | Operator::Multiply => {}
        }
        let constant = match (&left.constant, &right.constant) {
            (Some(a), Some(b)) => constant::binary(operator, a, b),
            _ => None,
        };
        let kind = TermKind::Binary(operator, Box::new(left.term), Box::new(right.term));
        Some(Value {
            term: term(place, kind),
            constant,
            moves: left.moves || right.moves,
        })
    }

    /// `left - right`, for an equation inside a block.
    pub(super) fn difference(&self, place: Place, left: Value, right: Value) -> Value {
        let constant = match (&left.constant, &right.constant) {
            (Some(a), Some(b)) => constant::binary(Operator::Subtract, a, b),
            _ => None,
        };
        let kind = TermKind::Binary(
            Operator::Subtract,
            Box::new(left.term),
            Box::new(right.term),
        );
        Value {
            term: term(place, kind),
            constant,
            moves: left.moves || right.moves,
        }
    }

    /// A divisor must not be the constant 0.
    pub(super) fn division(&mut self, place: Place, divisor: &Value) -> Option<()> {
        if divisor.constant.as_ref().is_some_and(Rational::is_zero) {
            self.diagnostics.push(constants::division_by_zero(place));
            return None;
        }
        Some(())
    }

    /// What is known to be wrong with a power.
    fn power(
        &mut self,
        place: Place,
        exponent_place: Place,
        base: &Value,
        exponent: &Value,
    ) -> Option<()> {
        let Some(power) = &exponent.constant else {
            return Some(());
        };
        let mistake = if power.abs() > Rational::from(i64::from(MOST_EXPONENT)) {
            constants::exponent_too_large(exponent_place, MOST_EXPONENT)
        } else {
            match &base.constant {
                Some(base) if base.is_zero() && power.is_negative() => {
                    constants::division_by_zero(place)
                }
                Some(base) if base.is_negative() && !power.is_integer() => {
                    constants::power_of_negative(place)
                }
                _ => return Some(()),
            }
        };
        self.diagnostics.push(mistake);
        None
    }
}

/// A term at a place.
pub(super) fn term(place: Place, kind: TermKind) -> Term {
    Term {
        kind,
        source: place.source(),
    }
}
