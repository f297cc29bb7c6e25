//! A position in a group of tokens.

use super::token::{Token, TokenKind, tokens};
use crate::diagnostic::Place;
use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream};
use std::cell::Cell;
use std::rc::Rc;

/// The tokens of one group, taken from the front.
#[derive(Debug)]
pub struct Cursor {
    /// What is left, last token first.
    rest: Vec<Token>,
    /// How many tokens of the whole input were taken.
    taken: Rc<Cell<u32>>,
    /// The token taken last, and its text if it is an operator.
    last: Option<(Place, &'static str)>,
    /// The token taken last, if it is a number's digits alone.
    digits: Option<String>,
    /// The end of the group.
    close: Span,
    /// The closing bracket, or an empty text for the whole input.
    pub closing: &'static str,
    /// Inside how many bars `|…|` the parser is: a bar then closes.
    pub bars: u32,
    /// In a condition `==` gets another message.
    pub condition: bool,
    /// In a `let` without a `;` to come, two values in a row mean that it was forgotten.
    pub unended: bool,
}

impl Cursor {
    /// The whole input.
    pub fn new(stream: TokenStream) -> Cursor {
        let mut rest = tokens(stream);
        rest.reverse();
        let close = rest.first().map_or(Span::call_site(), |t| t.end);
        let mut cursor = Cursor {
            rest,
            taken: Rc::default(),
            last: None,
            digits: None,
            close,
            closing: "",
            bars: 0,
            condition: false,
            unended: false,
        };
        // An input that is one macro variable is that variable's tokens.
        if cursor.rest.len() == 1 {
            cursor.open();
        }
        cursor
    }

    /// The inside of a group.
    pub fn inside(&self, group: &Group) -> Cursor {
        let mut rest = tokens(group.stream());
        rest.reverse();
        let (close, closing) = match group.delimiter() {
            Delimiter::Parenthesis => (group.span_close(), ")"),
            Delimiter::Brace => (group.span_close(), "}"),
            Delimiter::Bracket => (group.span_close(), "]"),
            Delimiter::None => (rest.first().map_or(group.span(), |t| t.end), ""),
        };
        Cursor {
            rest,
            taken: Rc::clone(&self.taken),
            last: None,
            digits: None,
            close,
            closing,
            bars: 0,
            condition: self.condition,
            unended: false,
        }
    }

    /// Replaces an invisible group at the front by its tokens. For places where an expression cannot stand.
    pub fn open(&mut self) {
        while let Some(TokenKind::Group(group)) = self.peek(0) {
            if group.delimiter() != Delimiter::None {
                break;
            }
            let mut inner = tokens(group.stream());
            inner.reverse();
            self.rest.pop();
            self.rest.append(&mut inner);
        }
    }

    /// The token that is `n` tokens ahead.
    pub fn peek(&self, n: usize) -> Option<&TokenKind> {
        self.token(n).map(|t| &t.kind)
    }

    /// The token that is `n` tokens ahead, with its spans.
    pub fn token(&self, n: usize) -> Option<&Token> {
        let index = self.rest.len().checked_sub(n + 1)?;
        self.rest.get(index)
    }

    /// The word that is `n` tokens ahead.
    pub fn word(&self, n: usize) -> Option<&Ident> {
        match self.peek(n) {
            Some(TokenKind::Word(ident)) => Some(ident),
            _ => None,
        }
    }

    /// The operator that is `n` tokens ahead, or an empty text.
    pub fn operator(&self, n: usize) -> &'static str {
        match self.peek(n) {
            Some(TokenKind::Operator(text)) => text,
            _ => "",
        }
    }

    /// The group with this delimiter that is `n` tokens ahead.
    pub fn group(&self, n: usize, delimiter: Delimiter) -> Option<&Group> {
        match self.peek(n) {
            Some(TokenKind::Group(group)) if group.delimiter() == delimiter => Some(group),
            _ => None,
        }
    }

    /// Is the next token this word?
    pub fn at_word(&self, word: &str) -> bool {
        self.word(0).is_some_and(|ident| ident == word)
    }

    /// Is nothing left?
    pub fn at_end(&self) -> bool {
        self.rest.is_empty()
    }

    /// Takes the next token.
    pub fn take(&mut self) -> Option<(TokenKind, Place)> {
        let place = self.place();
        let token = self.rest.pop()?;
        self.taken.set(self.taken.get().saturating_add(1));
        let text = match token.kind {
            TokenKind::Operator(text) => text,
            _ => "",
        };
        let last = match &token.kind {
            // Behind a group its closing bracket is the last token.
            TokenKind::Group(group) if group.delimiter() != Delimiter::None => Place {
                start: group.span_close(),
                end: group.span_close(),
                ..place
            },
            _ => place,
        };
        self.last = Some((last, text));
        self.digits = digits(&token.kind);
        Some((token.kind, place))
    }

    /// Takes the next token if it is this operator.
    pub fn eat(&mut self, operator: &str) -> Option<Place> {
        if self.operator(0) != operator {
            return None;
        }
        self.take().map(|(_, place)| place)
    }

    /// Takes the next token if it is this word.
    pub fn eat_word(&mut self, word: &str) -> Option<Place> {
        if !self.at_word(word) {
            return None;
        }
        self.take().map(|(_, place)| place)
    }

    /// Where the next token stands, or the end of the group.
    pub fn place(&self) -> Place {
        let (start, end) = match self.token(0) {
            Some(token) => (token.start, token.end),
            None => (self.close, self.close),
        };
        Place {
            start,
            end,
            order: self.taken.get(),
        }
    }

    /// Where the token taken last stands.
    pub fn last(&self) -> Place {
        self.last.map_or(self.place(), |(place, _)| place)
    }

    /// The operator taken last, or an empty text if it was another token.
    pub fn last_operator(&self) -> &'static str {
        self.last.map_or("", |(_, text)| text)
    }

    /// The digits taken last, if the last token was nothing else.
    pub fn last_digits(&self) -> Option<&str> {
        self.digits.as_deref()
    }

    /// Skips to the next `separator` (which stays) or to the end.
    pub fn skip_to(&mut self, separators: &[&str]) {
        while !self.at_end() && !separators.contains(&self.operator(0)) {
            self.take();
        }
    }

    /// Puts what is left of a group in front.
    pub fn prepend(&mut self, mut group: Cursor) {
        self.rest.append(&mut group.rest);
    }

    /// Is there a `;` ahead, before any `let`?
    pub fn semicolon_ahead(&self) -> bool {
        for token in self.rest.iter().rev() {
            match &token.kind {
                TokenKind::Word(ident) if ident == "let" => return false,
                TokenKind::Operator(";") => return true,
                _ => {}
            }
        }
        false
    }
}

/// The digits that a number consists of, if it has neither point nor exponent.
pub fn digits(token: &TokenKind) -> Option<String> {
    match token {
        TokenKind::Literal(literal) => {
            let text = literal.to_string();
            text.bytes().all(|b| b.is_ascii_digit()).then_some(text)
        }
        _ => None,
    }
}
