//! Calls, methods, and what looks like them.

use super::cursor::Cursor;
use super::token::TokenKind;
use super::{Parser, error, name};
use crate::ast::{Expr, ExprKind, Name};
use crate::catalogue::{syntax, tokens};
use crate::diagnostic::Place;
use crate::functions::Function;
use proc_macro2::{Delimiter, Group};

impl Parser<'_> {
    /// What begins with a name. The name is taken.
    pub(super) fn named(&mut self, cursor: &mut Cursor, name: Name) -> Expr {
        if cursor.operator(0) == "::" {
            return self.path(cursor, name);
        }
        if cursor.operator(0) == "!" && matches!(cursor.peek(1), Some(TokenKind::Group(_))) {
            cursor.take();
            let place = name.place.to(cursor.last());
            self.report(tokens::macro_call(place));
            cursor.take();
            return error(place, Vec::new());
        }
        if let Some(mistake) = self.habit(cursor, &name) {
            return mistake;
        }
        let Some(group) = cursor.group(0, Delimiter::Parenthesis).cloned() else {
            let place = name.place;
            return self.expr(ExprKind::Name(name), place);
        };
        let inner = cursor.inside(&group);
        if Self::fold_ahead(&inner) {
            return self.fold(cursor, name, &group);
        }
        let place = name.place.to(cursor.place());
        cursor.take();
        let arguments = self.arguments(cursor, &group);
        self.expr(ExprKind::Call(name, arguments), place)
    }

    /// The arguments of a call.
    pub(super) fn arguments(&mut self, cursor: &Cursor, group: &Group) -> Vec<Expr> {
        let mut inner = cursor.inside(group);
        let mut arguments = Vec::new();
        while !inner.at_end() {
            arguments.push(self.expression(&mut inner));
            self.leftover(&mut inner, &[","]);
            inner.eat(",");
        }
        arguments
    }

    /// `.f(…)` after a value.
    pub(super) fn member(&mut self, cursor: &mut Cursor, receiver: Expr) -> Expr {
        let start = receiver.place;
        cursor.take();
        let place = cursor.place();
        let Some(word) = cursor.word(0).cloned() else {
            return match cursor.token(0) {
                Some(token) if matches!(token.kind, TokenKind::Literal(_)) => {
                    self.report(syntax::component(place, &token.text()));
                    cursor.take();
                    error(start.to(place), Vec::new())
                }
                Some(token) => {
                    self.report(syntax::unexpected(
                        cursor.last(),
                        &format!(".{}", token.text()),
                    ));
                    error(start, vec![receiver])
                }
                None => {
                    self.report(syntax::value_after(cursor.last()));
                    error(start, vec![receiver])
                }
            };
        };
        cursor.take();
        let method = name(word, place);
        let Some(group) = cursor.group(0, Delimiter::Parenthesis).cloned() else {
            return self.no_member(start.to(place), &method, receiver);
        };
        let whole = start.to(cursor.place());
        cursor.take();
        let mut arguments = vec![receiver];
        arguments.extend(self.arguments(cursor, &group));
        self.expr(ExprKind::Call(method, arguments), whole)
    }

    /// `c.x`, `x.sqrt`: a member that is not called.
    fn no_member(&mut self, whole: Place, member: &Name, receiver: Expr) -> Expr {
        if matches!(member.text.as_str(), "x" | "y" | "z") {
            self.report(syntax::component(member.place, &member.text));
            // `p.x` is one mistake, even if there is no `p`.
            return error(whole, Vec::new());
        }
        if let ExprKind::Name(surface) = &receiver.kind
            && surface.text.starts_with(|c: char| c.is_uppercase())
            && surface.text.len() > 1
            && Function::find(&member.text).is_none()
        {
            let place = surface.place;
            self.report(tokens::member_of_surface(
                place,
                &surface.text,
                &member.text,
            ));
            return error(whole, Vec::new());
        }
        let method = Function::find(&member.text).map_or("sin", |f| f.entry().name);
        self.report(syntax::member(member.place, &member.text, method));
        error(whole, vec![receiver])
    }

    /// `a::b::c`, called or not. The first name is taken.
    pub(super) fn path(&mut self, cursor: &mut Cursor, first: Name) -> Expr {
        let mut last = first.text;
        let start = first.place;
        while cursor.eat("::").is_some() {
            match cursor.word(0).cloned() {
                Some(word) => {
                    last = word.to_string();
                    cursor.take();
                }
                None => break,
            }
        }
        let place = start.to(cursor.last());
        let mut parts = Vec::new();
        let mut instead = match last.as_str() {
            "PI" => "pi".to_owned(),
            "TAU" => "tau".to_owned(),
            _ => last,
        };
        if let Some(group) = cursor.group(0, Delimiter::Parenthesis).cloned() {
            cursor.take();
            let text = group.stream().to_string();
            instead = if text.len() > 20 {
                format!("{instead}(…)")
            } else {
                format!("{instead}({text})")
            };
            parts = self.arguments(cursor, &group);
        }
        self.report(tokens::path(place, &instead));
        error(place, parts)
    }
}
