//! `if a < b { … } else { … }`

use super::cursor::Cursor;
use super::{Parser, error};
use crate::ast::{Expr, ExprKind};
use crate::catalogue::syntax;
use proc_macro2::Delimiter;

impl Parser<'_> {
    /// An `if` and everything that belongs to it.
    pub(super) fn branch(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        cursor.take();
        let condition = self.condition(cursor);
        let then = self.branch_block(cursor);
        let otherwise = if let Some(word) = Self::else_if_ahead(cursor) {
            self.report(syntax::else_if(cursor.place(), &word));
            self.deeper(cursor, Self::branch)
                .unwrap_or_else(|| error(place, Vec::new()))
        } else if cursor.eat_word("else").is_none() {
            // After a missing block the `else` is not looked for.
            if cursor.last().order > condition.place.order && !then.is_error() {
                self.report(syntax::no_else(place));
            }
            error(place, Vec::new())
        } else if cursor.at_word("if") {
            self.deeper(cursor, Self::branch)
                .unwrap_or_else(|| error(place, Vec::new()))
        } else {
            // Braces that lack twice are one mistake.
            let braces = cursor.group(0, Delimiter::Brace).is_some();
            if then.is_error() && !braces {
                self.echo(cursor.last());
            }
            self.branch_block(cursor)
        };
        let place = place.to(cursor.last());
        self.expr(ExprKind::If(Box::new([condition, then, otherwise])), place)
    }

    /// The word of another language for `else if`.
    fn else_if_ahead(cursor: &Cursor) -> Option<String> {
        let word = cursor.word(0)?.to_string();
        matches!(word.as_str(), "elseif" | "elif" | "elsif").then_some(word)
    }

    /// What stands between `if` and its block.
    fn condition(&mut self, cursor: &mut Cursor) -> Expr {
        if cursor.at_end() || cursor.group(0, Delimiter::Brace).is_some() {
            let place = cursor.last();
            self.report(syntax::no_condition(place));
            return error(place, Vec::new());
        }
        let outer = (cursor.condition, cursor.bars, cursor.unended);
        (cursor.condition, cursor.bars, cursor.unended) = (true, 0, false);
        let condition = self.expression(cursor);
        (cursor.condition, cursor.bars, cursor.unended) = outer;
        if cursor.operator(0) == "=" {
            self.report(crate::catalogue::tokens::equality_test(cursor.place(), "="));
            cursor.take();
            let right = self.expression(cursor);
            return error(condition.place, vec![condition, right]);
        }
        condition
    }

    /// A block of an `if`, as an expression.
    fn branch_block(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        let braces = cursor.group(0, Delimiter::Brace).is_some();
        let body = self.block(cursor);
        if !braces {
            return error(place, vec![body.left]);
        }
        self.expr(ExprKind::Block(Box::new(body)), place)
    }
}
