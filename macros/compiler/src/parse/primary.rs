//! Values: numbers, names, groups, and what may follow them.

use super::cursor::Cursor;
use super::number::{MOST_DIGITS, Number, number};
use super::token::{Token, TokenKind};
use super::{Parser, error, keyword, name};
use crate::ast::{Expr, ExprKind};
use crate::catalogue::{syntax, tokens};
use crate::diagnostic::Place;
use crate::exact::Rational;
use proc_macro2::{Delimiter, Group};

impl Parser<'_> {
    /// A value with its indexes and methods.
    pub(super) fn postfix(&mut self, cursor: &mut Cursor) -> Expr {
        let mut value = self.primary(cursor);
        loop {
            if let Some(group) = cursor.group(0, Delimiter::Bracket).cloned() {
                let place = value.place.to(cursor.place());
                cursor.take();
                let mistakes = self.diagnostics.len();
                let index = self.inside(cursor, &group);
                value = if self.diagnostics.len() == mistakes {
                    self.expr(ExprKind::Index(Box::new(value), Box::new(index)), place)
                } else {
                    error(place, vec![value, index])
                };
            } else if cursor.operator(0) == "." {
                value = self.member(cursor, value);
            } else if cursor.operator(0) == "?" {
                value = self.ternary(cursor, value);
            } else if cursor.at_word("as") {
                value = self.cast(cursor, value);
            } else {
                return value;
            }
        }
    }

    /// A value by itself.
    fn primary(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        match cursor.peek(0).cloned() {
            None => self.no_value(cursor),
            Some(TokenKind::Literal(literal)) => {
                cursor.take();
                self.literal(cursor, &literal.to_string(), place)
            }
            Some(TokenKind::Group(group)) => {
                cursor.take();
                self.grouped(cursor, &group, place)
            }
            Some(TokenKind::Operator(operator)) => self.operator_as_value(cursor, operator),
            Some(TokenKind::Word(word)) => match word.to_string().as_str() {
                "if" => self.branch(cursor),
                "for" | "while" | "loop" => self.loop_statement(cursor),
                "match" => self.match_statement(cursor),
                "self" if cursor.operator(1) != "::" => self.this(cursor),
                "mod" if cursor.group(1, Delimiter::Parenthesis).is_some() => {
                    cursor.take();
                    self.named(cursor, name(word, place))
                }
                text if keyword(text) && cursor.operator(1) != "::" => self.found_instead(cursor),
                _ => {
                    cursor.take();
                    self.named(cursor, name(word, place))
                }
            },
        }
    }

    /// The end of the input or of a group where a value should be.
    fn no_value(&mut self, cursor: &Cursor) -> Expr {
        if matches!(cursor.last_operator(), "" | ";") {
            let place = cursor.place();
            let closing = if cursor.closing.is_empty() {
                "nothing"
            } else {
                cursor.closing
            };
            self.report(syntax::value_found(place, closing));
            return error(place, Vec::new());
        }
        let place = cursor.last();
        self.report(syntax::value_after(place));
        error(place, Vec::new())
    }

    /// A token where a value should be. It is skipped, unless something further out waits for it.
    pub(super) fn found_instead(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        let text = cursor.token(0).map_or(String::new(), Token::text);
        self.report(syntax::value_found(place, &text));
        match text.as_str() {
            ";" | "," | "let" | "in" | "else" => return error(place, Vec::new()),
            _ => {}
        }
        let stray = !cursor.operator(0).is_empty();
        cursor.take();
        if !stray || cursor.at_end() {
            return error(place, Vec::new());
        }
        // What stands after a stray operator is read as the value.
        let operand = self.deeper(cursor, Self::operand);
        error(place, operand.into_iter().collect())
    }

    /// What stands after a stray operator.
    fn operand(&mut self, cursor: &mut Cursor) -> Expr {
        match cursor.operator(0) {
            ";" | "," => error(cursor.place(), Vec::new()),
            _ => self.postfix(cursor),
        }
    }

    /// A number, or what was written in its place.
    fn literal(&mut self, cursor: &mut Cursor, text: &str, place: Place) -> Expr {
        let mistake = match number(text) {
            Number::Exact(value) => return self.expr(ExprKind::Number(value), place),
            Number::Other if text.starts_with('"') || text.starts_with('r') => {
                tokens::quoted(place)
            }
            Number::Other => syntax::value_found(place, text),
            Number::Suffixed(digits, suffix) if typed(suffix) => {
                tokens::typed_number(place, digits)
            }
            Number::Suffixed(digits, suffix) => {
                tokens::number_runs_into_name(place, digits, suffix)
            }
            Number::Radix(Some(value)) => tokens::radix(place, &value.to_string()),
            Number::Radix(None) => syntax::value_found(place, text),
            Number::TooLarge => tokens::number_too_large(place),
            Number::TooSmall => tokens::number_too_small(place),
            Number::TooLong => tokens::number_too_long(place, MOST_DIGITS),
        };
        self.report(mistake);
        let mut parts = Vec::new();
        // `2sin(x)` is one mistake.
        if let (Number::Suffixed(..), Some(group)) = (
            number(text),
            cursor.group(0, Delimiter::Parenthesis).cloned(),
        ) {
            cursor.take();
            parts = self.arguments(cursor, &group);
        }
        error(place, parts)
    }

    /// `.5`, whose dot is a token of its own. The dot is taken.
    pub(super) fn leading_dot(&mut self, cursor: &mut Cursor, dot: Place) -> Option<Expr> {
        let Some(TokenKind::Literal(literal)) = cursor.peek(0) else {
            return None;
        };
        let text = literal.to_string();
        if !text.starts_with(|c: char| c.is_ascii_digit()) || text.contains('.') {
            return None;
        }
        let place = dot.to(cursor.place());
        cursor.take();
        Some(self.literal(cursor, &format!("0.{text}"), place))
    }

    /// `(…)`, `{…}`, `[…]`, or the tokens of a macro variable.
    fn grouped(&mut self, cursor: &mut Cursor, group: &Group, place: Place) -> Expr {
        match group.delimiter() {
            Delimiter::Bracket => self.list(cursor, group, place),
            Delimiter::Brace => {
                let mut inner = cursor.inside(group);
                let body = self.deeper(&mut inner, Self::body);
                match body {
                    Some(body) => self.expr(ExprKind::Block(Box::new(body)), place),
                    None => error(place, Vec::new()),
                }
            }
            Delimiter::Parenthesis | Delimiter::None => {
                let inner = self.inside(cursor, group);
                // The value stands where its brackets stand.
                Expr { place, ..inner }
            }
        }
    }

    /// The one value inside a group.
    pub(super) fn inside(&mut self, cursor: &Cursor, group: &Group) -> Expr {
        let mut inner = cursor.inside(group);
        let value = self.expression(&mut inner);
        self.leftover(&mut inner, &[]);
        value
    }

    /// `[a, b, c]` or `[a; n]`
    fn list(&mut self, cursor: &mut Cursor, group: &Group, place: Place) -> Expr {
        let mut inner = cursor.inside(group);
        let mut values = Vec::new();
        while !inner.at_end() {
            values.push(self.expression(&mut inner));
            if values.len() == 1 && inner.eat(";").is_some() {
                let length = self.expression(&mut inner);
                self.leftover(&mut inner, &[]);
                let value = values.pop().unwrap_or_else(|| error(place, Vec::new()));
                return self.expr(ExprKind::Repeat(Box::new([value, length])), place);
            }
            self.leftover(&mut inner, &[","]);
            inner.eat(",");
        }
        self.expr(ExprKind::List(values), place)
    }
}

/// Is this the suffix of a typed Rust number?
fn typed(suffix: &str) -> bool {
    matches!(suffix, "f16" | "f32" | "f64" | "f128")
        || suffix
            .strip_prefix(['i', 'u'])
            .is_some_and(|size| matches!(size, "8" | "16" | "32" | "64" | "128" | "size"))
}

/// A whole number that stands for itself, for messages.
pub(super) fn whole(expr: &Expr) -> Option<&Rational> {
    match &expr.kind {
        ExprKind::Number(value) if value.is_integer() && !value.is_negative() => Some(value),
        _ => None,
    }
}
