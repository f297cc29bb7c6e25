//! Operators of other languages where a value should be.

use super::cursor::Cursor;
use super::token::TokenKind;
use super::{Parser, error};
use crate::ast::Expr;
use crate::catalogue::tokens;

impl Parser<'_> {
    /// A value that begins with an operator other than `-`.
    pub(super) fn operator_as_value(&mut self, cursor: &mut Cursor, operator: &str) -> Expr {
        match operator {
            "|" | "||" => self.bars(cursor),
            "!" => {
                let place = cursor.place();
                self.report(tokens::not(place, "!"));
                cursor.take();
                let operand = self.deeper(cursor, Self::postfix);
                error(place, operand.into_iter().collect())
            }
            "." => {
                let dot = cursor.place();
                if !matches!(cursor.peek(1), Some(TokenKind::Literal(_))) {
                    return self.found_instead(cursor);
                }
                cursor.take();
                match self.leading_dot(cursor, dot) {
                    Some(value) => value,
                    None => self.found_instead(cursor),
                }
            }
            "::" if cursor.word(1).is_some() => {
                let start = cursor.place();
                cursor.take();
                match cursor.word(0).cloned() {
                    Some(word) => {
                        cursor.take();
                        let first = super::name(word, start);
                        self.path(cursor, first)
                    }
                    None => error(start, Vec::new()),
                }
            }
            _ => self.found_instead(cursor),
        }
    }

    /// `|x|` and `||x||`
    fn bars(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        let bar = cursor.operator(0);
        self.report(tokens::bars(place));
        cursor.take();
        cursor.bars += 1;
        let value = self.expression(cursor);
        cursor.bars -= 1;
        if cursor.operator(0) == bar {
            cursor.take();
        }
        error(place, vec![value])
    }

    /// `self.r`
    pub(super) fn this(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        self.report(tokens::this(place));
        cursor.take();
        if cursor.operator(0) == "." && cursor.word(1).is_some() {
            cursor.take();
            cursor.take();
        }
        error(place, Vec::new())
    }

    /// `x as f64`. The value is taken.
    pub(super) fn cast(&mut self, cursor: &mut Cursor, value: Expr) -> Expr {
        let start = cursor.place();
        cursor.take();
        if cursor.word(0).is_some() {
            cursor.take();
        }
        let place = start.to(cursor.last());
        self.report(tokens::cast(place));
        error(value.place.to(place), vec![value])
    }

    /// `c ? a : b`. The condition is taken.
    pub(super) fn ternary(&mut self, cursor: &mut Cursor, condition: Expr) -> Expr {
        let place = condition.place;
        self.report(tokens::ternary(cursor.place()));
        cursor.take();
        let mut parts = vec![condition];
        if !cursor.at_end() {
            parts.push(self.expression(cursor));
        }
        if cursor.eat(":").is_some() && !cursor.at_end() {
            parts.push(self.expression(cursor));
        }
        error(place, parts)
    }
}
