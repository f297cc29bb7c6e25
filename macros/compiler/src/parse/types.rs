//! Types of fields.

use super::Parser;
use super::cursor::Cursor;
use super::number::{Number, number};
use super::token::{Token, TokenKind};
use crate::ast::Type;
use crate::catalogue::head;
use crate::diagnostic::Place;
use crate::tree::Shape;
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

/// The most rows of a table: beyond, the struct would not fit on a stack by far.
const MOST_ROWS: usize = 1 << 24;

impl Parser<'_> {
    /// The type of a field.
    pub(super) fn ty(&mut self, cursor: &mut Cursor) -> Type {
        cursor.open();
        self.ty_of_level(cursor, true)
    }

    fn ty_of_level(&mut self, cursor: &mut Cursor, outermost: bool) -> Type {
        cursor.open();
        if let Some(word) = cursor.word(0).filter(|word| *word == "f64").cloned() {
            cursor.take();
            if let Some(length) = cursor.group(0, Delimiter::Bracket).cloned() {
                let place = cursor.place();
                cursor.take();
                self.report(head::table_form(place, &length.stream().to_string()));
                return number_type();
            }
            return Type {
                shape: Shape::Number,
                sound: true,
                tokens: primitive(word),
            };
        }
        match cursor.group(0, Delimiter::Bracket).cloned() {
            Some(group) => {
                cursor.take();
                let table = self.deeper(cursor, |parser, cursor| {
                    parser.table(cursor, &group, outermost)
                });
                table.unwrap_or_else(number_type)
            }
            None => self.wrong_type(cursor),
        }
    }

    /// `[ty; n]` or `[ty]`
    fn table(&mut self, cursor: &mut Cursor, group: &Group, outermost: bool) -> Type {
        let span = group.span();
        let place = cursor.last();
        let mut inner = cursor.inside(group);
        let row = self.ty_of_level(&mut inner, false);
        if inner.at_end() {
            if !outermost {
                self.report(head::ragged(place));
            }
            let row_tokens = &row.tokens;
            return Type {
                shape: Shape::Vec(Box::new(row.shape)),
                sound: row.sound && outermost,
                tokens: quote_spanned!(span=> ::std::vec::Vec<#row_tokens>),
            };
        }
        if inner.eat(";").is_none() {
            let comma = inner.place();
            let length = inner.token(1).map(Token::text);
            self.report(match length {
                Some(length) if inner.operator(0) == "," => head::table_form(comma, &length),
                _ => head::table_length(comma),
            });
            return number_type();
        }
        let Some((length, literal)) = self.table_length(&mut inner) else {
            return number_type();
        };
        let row_tokens = &row.tokens;
        let mut array = Group::new(Delimiter::Bracket, quote!(#row_tokens; #literal));
        array.set_span(span);
        Type {
            shape: Shape::Array(Box::new(row.shape), length),
            sound: row.sound,
            tokens: TokenTree::from(array).into(),
        }
    }

    /// The number after `;`, with the user's token.
    fn table_length(&mut self, cursor: &mut Cursor) -> Option<(usize, TokenTree)> {
        cursor.open();
        let place = cursor.place();
        let Some((TokenKind::Literal(literal), _)) = cursor.take() else {
            cursor.skip_to(&[]);
            self.report(head::table_length(place.to(cursor.last())));
            return None;
        };
        let text = literal.to_string();
        let length = match number(&text) {
            Number::Exact(value)
                if value.is_integer() && cursor.at_end() && !text.contains(['.', 'e', 'E']) =>
            {
                let length = value.to_i64().and_then(|n| usize::try_from(n).ok());
                length.unwrap_or(usize::MAX)
            }
            _ => {
                cursor.skip_to(&[]);
                self.report(head::table_length(place.to(cursor.last())));
                return None;
            }
        };
        if length == 0 {
            self.report(head::table_empty(place));
            return None;
        }
        if length > MOST_ROWS {
            self.report(head::table_too_long(place, MOST_ROWS));
            return None;
        }
        Some((length, literal.into()))
    }

    /// A type that a field cannot have. The struct keeps it, so that nothing else breaks.
    fn wrong_type(&mut self, cursor: &mut Cursor) -> Type {
        let start = cursor.place();
        let mut tokens = TokenStream::new();
        let mut words = 0;
        while !cursor.at_end() && !matches!(cursor.operator(0), "=" | "," | ";") {
            if let Some((kind, place)) = cursor.take() {
                words += 1;
                tokens.extend(trees(kind, place));
            }
        }
        if words == 0 {
            self.report(head::field_type(start));
            return number_type();
        }
        let place = start.to(cursor.last());
        let primitive = matches!(
            tokens.to_string().as_str(),
            "f16"
                | "f32"
                | "f128"
                | "i8"
                | "i16"
                | "i32"
                | "i64"
                | "i128"
                | "isize"
                | "u8"
                | "u16"
                | "u32"
                | "u64"
                | "u128"
                | "usize"
                | "bool"
                | "float"
                | "double"
                | "real"
                | "number"
                | "F64"
        );
        self.report(if primitive {
            head::field_type(place)
        } else {
            head::field_vec(place)
        });
        // A reference would lack its lifetime.
        if tokens.to_string().contains('&') {
            return number_type();
        }
        Type {
            shape: Shape::Number,
            sound: false,
            tokens,
        }
    }
}

/// The primitive, by a path that nobody can shadow; the last token is the user's.
pub fn primitive(word: Ident) -> TokenStream {
    quote!(::core::primitive::#word)
}

/// What stands in for a type after a mistake.
fn number_type() -> Type {
    Type {
        shape: Shape::Number,
        sound: false,
        tokens: quote!(::core::primitive::f64),
    }
}

/// The trees that a token was made of.
fn trees(kind: TokenKind, place: Place) -> Vec<TokenTree> {
    use proc_macro2::{Punct, Spacing};
    match kind {
        TokenKind::Word(ident) => vec![ident.into()],
        TokenKind::Literal(literal) => vec![literal.into()],
        TokenKind::Group(group) => vec![group.into()],
        TokenKind::Operator(text) => {
            let last = text.chars().count().saturating_sub(1);
            let punct = |(i, c)| {
                let mut punct = Punct::new(
                    c,
                    if i < last {
                        Spacing::Joint
                    } else {
                        Spacing::Alone
                    },
                );
                punct.set_span(place.start);
                TokenTree::from(punct)
            };
            text.chars().enumerate().map(punct).collect()
        }
    }
}
