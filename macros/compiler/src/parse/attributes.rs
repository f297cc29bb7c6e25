//! Attributes, the domain among them, and visibility.

use super::Parser;
use super::cursor::Cursor;
use super::token::TokenKind;
use crate::ast::{Expr, Over};
use crate::catalogue::head;
use crate::diagnostic::Place;
use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};

/// What attributes say.
#[derive(Default)]
pub(super) struct Attributes {
    /// Those that pass through.
    pub(super) tokens: TokenStream,
    /// The bounds in `#[domain]`.
    pub(super) domain: Option<[[Expr; 2]; 3]>,
    /// Where `#[domain]` stands.
    pub(super) domain_seen: Option<Place>,
    /// Was there any attribute?
    pub(super) any: bool,
}

impl Parser<'_> {
    /// All attributes that stand here.
    pub(super) fn attributes(&mut self, cursor: &mut Cursor) -> Attributes {
        let mut attributes = Attributes::default();
        cursor.open();
        while cursor.operator(0) == "#" {
            attributes.any = true;
            let place = cursor.place();
            cursor.take();
            if cursor.operator(0) == "!" {
                cursor.take();
                self.report(head::inner_attribute(place.to(cursor.last())));
                cursor.take();
                cursor.open();
                continue;
            }
            let Some(group) = cursor.group(0, Delimiter::Bracket).cloned() else {
                break;
            };
            cursor.take();
            if !self.domain_attribute(cursor, &group, &mut attributes) {
                let mut hash = Punct::new('#', Spacing::Alone);
                hash.set_span(place.start);
                attributes
                    .tokens
                    .extend([TokenTree::from(hash), TokenTree::from(group)]);
            }
            cursor.open();
        }
        attributes
    }

    /// Is this attribute the domain?
    fn domain_attribute(
        &mut self,
        cursor: &Cursor,
        group: &Group,
        attributes: &mut Attributes,
    ) -> bool {
        let mut inner = cursor.inside(group);
        inner.open();
        if !inner.at_word("domain") {
            return false;
        }
        let place = inner.place();
        if attributes.domain_seen.replace(place).is_some() {
            self.report(head::domain_twice(place));
            return true;
        }
        inner.take();
        match inner.group(0, Delimiter::Parenthesis).cloned() {
            Some(axes) => {
                let mut axes = inner.inside(&axes);
                attributes.domain = self.domain(&mut axes, place);
            }
            None => self.report(head::domain_axes(place)),
        }
        true
    }

    /// `x in -1..1, y in -1..1, z in -1..1`, in any order.
    fn domain(&mut self, cursor: &mut Cursor, attribute: Place) -> Option<[[Expr; 2]; 3]> {
        let mistakes = self.diagnostics.len();
        let mut axes = [None, None, None];
        while !cursor.at_end() {
            let axis = cursor
                .word(0)
                .and_then(|word| match word.to_string().as_str() {
                    "x" => axes.get_mut(0),
                    "y" => axes.get_mut(1),
                    "z" => axes.get_mut(2),
                    _ => None,
                });
            let Some(axis) = axis.filter(|axis| axis.is_none()) else {
                self.report(head::domain_axes(attribute));
                return None;
            };
            cursor.take();
            if cursor.eat_word("in").is_none() {
                self.report(head::domain_axes(attribute));
                return None;
            }
            let (over, closed) = self.interval(cursor);
            if let Some(dots) = closed {
                self.report(head::domain_closed(dots));
            }
            match over {
                Over::Range(lower, upper) => *axis = Some([lower, upper]),
                Over::Table(value) => self.report(head::domain_interval(value.place)),
            }
            self.leftover(cursor, &[","]);
            cursor.eat(",");
        }
        match axes {
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => {
                if self.diagnostics.len() == mistakes {
                    self.report(head::domain_axes(attribute));
                }
                None
            }
        }
    }
}

/// `pub`, `pub(crate)` or nothing.
pub(super) fn visibility(cursor: &mut Cursor) -> TokenStream {
    let mut tokens = TokenStream::new();
    cursor.open();
    let Some(word) = cursor.word(0).filter(|word| *word == "pub").cloned() else {
        return tokens;
    };
    cursor.take();
    tokens.extend([TokenTree::from(word)]);
    if let Some(TokenKind::Group(group)) = cursor.peek(0).cloned()
        && group.delimiter() == Delimiter::Parenthesis
    {
        cursor.take();
        tokens.extend([TokenTree::from(group)]);
    }
    cursor.open();
    tokens
}
