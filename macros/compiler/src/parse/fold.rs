//! Folds: `sum([a, b] in t) { … }`.

use super::cursor::Cursor;
use super::primary::whole;
use super::token::{Token, TokenKind};
use super::{Parser, error, keyword, name};
use crate::ast::{Body, Expr, ExprKind, Fold, Name, Over, Pattern};
use crate::catalogue::syntax;
use crate::diagnostic::Place;
use crate::exact::Rational;
use crate::tree::FoldKind;
use proc_macro2::{Delimiter, Group};

/// The fold of this name.
pub(crate) fn kind(name: &str) -> Option<FoldKind> {
    match name {
        "sum" => Some(FoldKind::Sum),
        "prod" => Some(FoldKind::Product),
        "min" => Some(FoldKind::Minimum),
        "max" => Some(FoldKind::Maximum),
        _ => None,
    }
}

impl Parser<'_> {
    /// Does `pattern in` stand here?
    pub(super) fn fold_ahead(inner: &Cursor) -> bool {
        let pattern = inner.word(0).is_some() || inner.group(0, Delimiter::Bracket).is_some();
        pattern && inner.word(1).is_some_and(|word| word == "in")
    }

    /// A fold. Its name is taken; `group` is next.
    pub(super) fn fold(&mut self, cursor: &mut Cursor, folder: Name, group: &Group) -> Expr {
        let kind = kind(&folder.text);
        if kind.is_none() {
            self.report(syntax::not_a_fold(folder.place, &folder.text));
        }
        cursor.take();
        let mut inner = cursor.inside(group);
        let mut pattern = self.pattern(&mut inner);
        inner.take();
        let over = self.over(&mut inner);
        let value = self.more_patterns(&mut inner, &mut pattern);
        let body = match value {
            Some(comma) if cursor.group(0, Delimiter::Brace).is_none() => {
                self.report(syntax::fold_value(comma, &folder.text));
                let left = self.expression(&mut inner);
                self.leftover(&mut inner, &[]);
                Body {
                    lets: Vec::new(),
                    left: error(left.place, vec![left]),
                    right: None,
                }
            }
            _ => {
                self.leftover(&mut inner, &[]);
                self.block(cursor)
            }
        };
        let place = folder.place.to(cursor.last());
        let fold = Fold {
            kind,
            pattern,
            over,
            body,
        };
        self.expr(ExprKind::Fold(Box::new(fold)), place)
    }

    /// What follows the range or table of a fold. Variables of more patterns are known in the body.
    ///
    /// Returns the comma before something that is not a pattern.
    fn more_patterns(&mut self, cursor: &mut Cursor, pattern: &mut Pattern) -> Option<Place> {
        while let Some(comma) = cursor.eat(",") {
            if !Self::fold_ahead(cursor) {
                return (!cursor.at_end()).then_some(comma);
            }
            self.report(syntax::two_patterns(comma));
            let more = self.pattern(cursor);
            pattern.names.extend(more.names);
            pattern.sound = false;
            cursor.take();
            self.over(cursor);
        }
        None
    }

    /// The variables before `in`.
    pub(super) fn pattern(&mut self, cursor: &mut Cursor) -> Pattern {
        let place = cursor.place();
        let mut names = Vec::new();
        let Some(group) = cursor.group(0, Delimiter::Bracket).cloned() else {
            names.extend(self.variable(cursor));
            return Pattern {
                sound: !names.is_empty(),
                names,
                list: false,
                place,
            };
        };
        cursor.take();
        let mut inner = cursor.inside(&group);
        let first = inner.place();
        let mut sound = true;
        while !inner.at_end() {
            let name = self.variable(&mut inner);
            sound &= name.is_some();
            names.extend(name);
            inner.skip_to(&[","]);
            inner.eat(",");
        }
        let place = match names.last() {
            Some(last) => first.to(last.place),
            None => place,
        };
        Pattern {
            names,
            list: true,
            sound,
            place,
        }
    }

    /// One name, or `_`.
    fn variable(&mut self, cursor: &mut Cursor) -> Option<Name> {
        let place = cursor.place();
        let word = cursor
            .word(0)
            .filter(|w| *w == "_" || !keyword(&w.to_string()))
            .cloned();
        if word.is_none() {
            self.report(syntax::pattern(place));
        }
        cursor.take();
        word.map(|word| name(word, place))
    }

    /// `start..end`, or a table.
    pub(super) fn over(&mut self, cursor: &mut Cursor) -> Over {
        let (over, closed) = self.interval(cursor);
        if let (Over::Range(first, last), Some(dots)) = (&over, closed) {
            let half_open = match (whole(first), whole(last)) {
                (Some(a), Some(b)) => format!("{a}..{}", b + &Rational::from(1)),
                _ => "start..end + 1".to_owned(),
            };
            self.report(syntax::inclusive_range(dots, &half_open));
        }
        over
    }

    /// `start..end`, or a value; with the place of `..=` or `...`.
    pub(super) fn interval(&mut self, cursor: &mut Cursor) -> (Over, Option<Place>) {
        let first = self.expression(cursor);
        let operator = cursor.operator(0);
        let dots = cursor.place();
        if !matches!(operator, ".." | "..=" | "...") {
            return (Over::Table(first), None);
        }
        cursor.take();
        let last = self.expression(cursor);
        (Over::Range(first, last), (operator != "..").then_some(dots))
    }

    /// A block in braces, which must follow.
    pub(super) fn block(&mut self, cursor: &mut Cursor) -> Body {
        let last = cursor.last();
        if cursor.group(0, Delimiter::Brace).is_none() {
            self.report(syntax::block(last));
            cursor.eat_word("then");
        }
        let Some(group) = cursor.group(0, Delimiter::Brace).cloned() else {
            // The value without its braces.
            let left = if self.operand_ahead(cursor) {
                self.expression(cursor)
            } else {
                error(last, Vec::new())
            };
            let part = error(left.place, vec![left]);
            return Body {
                lets: Vec::new(),
                left: part,
                right: None,
            };
        };
        cursor.take();
        let mut inner = cursor.inside(&group);
        inner.condition = false;
        self.deeper(&mut inner, Self::body).unwrap_or_else(|| Body {
            lets: Vec::new(),
            left: error(last, Vec::new()),
            right: None,
        })
    }

    /// `for`, `while` and `loop`, up to and with their block.
    pub(super) fn loop_statement(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        self.report(syntax::loop_statement(place));
        self.statement(cursor, place)
    }

    /// `match`, up to and with its block.
    pub(super) fn match_statement(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        self.report(syntax::match_statement(place));
        self.statement(cursor, place)
    }

    fn statement(&mut self, cursor: &mut Cursor, place: Place) -> Expr {
        let end = |token: &Token| match &token.kind {
            TokenKind::Operator(text) => matches!(*text, ";" | ","),
            _ => false,
        };
        while cursor.token(0).is_some_and(|token| !end(token)) {
            let block = cursor.group(0, Delimiter::Brace).is_some();
            cursor.take();
            if block {
                break;
            }
        }
        error(place, Vec::new())
    }
}
