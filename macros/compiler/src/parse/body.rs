//! `let`s, then a value or an equation.

use super::cursor::{Cursor, digits};
use super::token::{Token, TokenKind};
use super::{Parser, error, keyword, name};
use crate::ast::{Body, Expr, ExprKind, Let, Name};
use crate::catalogue::{syntax, tokens};
use crate::diagnostic::{Diagnostic, Place};
use proc_macro2::Delimiter;

impl Parser<'_> {
    /// Parses everything that is left: the formula, or the inside of a block.
    pub(super) fn body(&mut self, cursor: &mut Cursor) -> Body {
        let mut lets = Vec::new();
        loop {
            self.stray_attributes(cursor);
            while let Some(bindings) = self.binding_or_item(cursor) {
                lets.extend(bindings);
                self.stray_attributes(cursor);
            }
            if self.second_surface(cursor) {
                let left = error(cursor.last(), Vec::new());
                return Body {
                    lets,
                    left,
                    right: None,
                };
            }
            if cursor.at_end() {
                // After a `let` without its `;` one message is enough.
                let reported = !lets.is_empty() && cursor.last_operator() != ";";
                let left = self.no_formula(cursor, reported);
                return Body {
                    lets,
                    left,
                    right: None,
                };
            }
            let mistakes = self.diagnostics.len();
            if let Some(place) = cursor.eat_word("return") {
                self.report(syntax::return_value(place));
            }
            let left = self.expression(cursor);
            let right = self.equation(cursor);
            self.leftover(cursor, &[";"]);
            let Some(semicolon) = cursor.eat(";") else {
                return Body { lets, left, right };
            };
            let sound = self.diagnostics.len() == mistakes;
            if self.second_surface(cursor) {
                return Body { lets, left, right };
            }
            if cursor.at_end() {
                if sound {
                    self.report(syntax::discarded(semicolon));
                }
                return Body { lets, left, right };
            }
            lets.push(self.discard(left, right, sound));
        }
    }

    /// Attributes, which doc comments are too, where a value or a `let` should be.
    fn stray_attributes(&mut self, cursor: &mut Cursor) {
        while cursor.operator(0) == "#" && cursor.group(1, Delimiter::Bracket).is_some() {
            let start = cursor.place();
            cursor.take();
            cursor.take();
            self.report(syntax::attribute_inside(start.to(cursor.last())));
        }
    }

    /// A formula that is not there.
    fn no_formula(&mut self, cursor: &Cursor, reported: bool) -> Expr {
        let place = if cursor.closing.is_empty() {
            cursor.last()
        } else {
            cursor.place()
        };
        if !reported {
            self.report(match cursor.closing {
                "" => syntax::no_formula(place),
                closing => syntax::value_found(place, closing),
            });
        }
        error(place, Vec::new())
    }

    /// A value with something after its `;`. `a = …;` is kept as if it had its `let`.
    fn discard(&mut self, left: Expr, right: Option<Expr>, sound: bool) -> Let {
        let place = left
            .place
            .to(right.as_ref().map_or(left.place, |r| r.place));
        match (left.kind, right) {
            (ExprKind::Name(name), Some(value)) if !coordinate(&name.text) => {
                if sound {
                    self.report(syntax::discarded_binding(place, &name.text));
                }
                Let {
                    name: Some(name),
                    value,
                    written: false,
                }
            }
            (kind, right) => {
                if sound {
                    self.report(syntax::discarded_early(place));
                }
                let left = Expr { kind, ..left };
                let value = error(place, std::iter::once(left).chain(right).collect());
                Let {
                    name: None,
                    value,
                    written: false,
                }
            }
        }
    }

    /// `= right`, if it is there.
    fn equation(&mut self, cursor: &mut Cursor) -> Option<Expr> {
        let place = cursor.place();
        match cursor.operator(0) {
            "=" => {
                cursor.take();
            }
            "+=" | "-=" | "*=" | "/=" | "%=" | "^=" | "|=" | "&=" => {
                self.report(tokens::assignment(place, cursor.operator(0)));
                cursor.take();
                let right = self.expression(cursor);
                return Some(error(place, vec![right]));
            }
            _ => return None,
        }
        let mut right = self.expression(cursor);
        while cursor.operator(0) == "=" {
            self.report(syntax::second_equation(cursor.place()));
            cursor.take();
            let more = self.expression(cursor);
            right = error(right.place, vec![right, more]);
        }
        Some(right)
    }

    /// Reports what stands before the separator, or before the end, and skips it.
    pub(super) fn leftover(&mut self, cursor: &mut Cursor, separators: &[&str]) {
        if separators.contains(&cursor.operator(0)) || self.second_surface(cursor) {
            return;
        }
        let Some(text) = cursor.token(0).map(Token::text) else {
            return;
        };
        let place = cursor.place();
        self.report(match text.as_str() {
            "=" => syntax::equation_inside(place),
            "+=" | "-=" | "*=" | "/=" | "%=" | "^=" | "|=" | "&=" => {
                tokens::assignment(place, cursor.operator(0))
            }
            "{" | "(" | "[" => syntax::juxtaposed(place),
            "," => comma(cursor, place),
            text => syntax::unexpected(place, text),
        });
        cursor.skip_to(separators);
    }

    /// `let name = value;`, or an item in its place.
    fn binding_or_item(&mut self, cursor: &mut Cursor) -> Option<Vec<Let>> {
        if !cursor.at_word("let") {
            return self.item(cursor).map(|item| vec![item]);
        }
        match cursor.peek(1) {
            Some(TokenKind::Group(group)) => {
                let group = group.clone();
                Some(self.let_pattern(cursor, &group))
            }
            _ => Some(vec![self.binding(cursor)]),
        }
    }

    /// `let name = value;`
    fn binding(&mut self, cursor: &mut Cursor) -> Let {
        cursor.take();
        if let Some(place) = cursor.eat_word("mut") {
            self.report(syntax::let_mut(place));
        }
        let name = self.binding_name(cursor);
        if let Some(function) = self.let_function(cursor, &name) {
            return function;
        }
        if cursor.operator(0) == ":" {
            let start = cursor.place();
            cursor.skip_to(&["=", ";"]);
            self.report(syntax::let_type(start.to(cursor.last())));
        }
        if cursor.eat("=").is_none() {
            if let Some(name) = &name {
                self.report(syntax::let_equals(name.place, &name.text));
            }
            cursor.skip_to(&["=", ";"]);
            if cursor.eat("=").is_none() {
                let value = error(cursor.last(), Vec::new());
                cursor.eat(";");
                return Let {
                    name,
                    value,
                    written: true,
                };
            }
        }
        if let Some(closure) = self.closure(cursor, &name) {
            return closure;
        }
        let mistakes = self.diagnostics.len();
        cursor.unended = !cursor.semicolon_ahead();
        let mut value = self.expression(cursor);
        cursor.unended = false;
        while cursor.operator(0) == "=" {
            self.report(syntax::second_equation(cursor.place()));
            cursor.take();
            let more = self.expression(cursor);
            value = error(value.place, vec![value, more]);
        }
        self.binding_end(cursor, self.diagnostics.len() == mistakes);
        Let {
            name,
            value,
            written: true,
        }
    }

    /// The name after `let`.
    fn binding_name(&mut self, cursor: &mut Cursor) -> Option<Name> {
        cursor.open();
        let place = cursor.place();
        let found = match cursor.token(0) {
            Some(token) => token.text(),
            None => cursor.closing.to_owned(),
        };
        let word = cursor
            .word(0)
            .filter(|word| !keyword(&word.to_string()))
            .cloned();
        if word.is_none() {
            self.report(syntax::let_name(place, &found));
        }
        if !matches!(cursor.operator(0), "=" | ";" | ":") {
            cursor.take();
        }
        word.map(|word| name(word, place))
    }

    /// The `;` of a `let`. Where it is missing, what follows is the formula or the next `let`.
    fn binding_end(&mut self, cursor: &mut Cursor, sound: bool) {
        if cursor.eat(";").is_some() {
            return;
        }
        let forgotten = match cursor.peek(0) {
            None | Some(TokenKind::Word(_) | TokenKind::Literal(_) | TokenKind::Group(_)) => true,
            Some(TokenKind::Operator(_)) => false,
        };
        if forgotten {
            if sound {
                self.report(syntax::let_end(cursor.last()));
            }
        } else {
            self.leftover(cursor, &[";"]);
            cursor.eat(";");
        }
    }
}

/// A comma where an operator should be.
fn comma(cursor: &Cursor, place: Place) -> Diagnostic {
    match (cursor.last_digits(), cursor.peek(1).and_then(digits)) {
        _ if cursor.closing == "]" => syntax::index_comma(place),
        (Some(whole), Some(fraction)) => {
            syntax::decimal_comma(place, &format!("{whole}.{fraction}"))
        }
        _ if cursor.token(1).is_none() => syntax::last_comma(place),
        _ => syntax::comma(place),
    }
}

fn coordinate(name: &str) -> bool {
    matches!(name, "x" | "y" | "z")
}
