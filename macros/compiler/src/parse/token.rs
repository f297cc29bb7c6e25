//! Tokens as the grammar sees them: operators joined, invisible groups opened where they hold one token.

use crate::diagnostic::Place;
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use std::cell::Cell;
use std::rc::Rc;

/// A token.
#[derive(Clone, Debug)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Span of its first character.
    pub start: Span,
    /// Span of its last character.
    pub end: Span,
}

/// The kinds of tokens.
#[derive(Clone, Debug)]
pub enum TokenKind {
    /// A name or keyword.
    Word(Ident),
    /// A literal.
    Literal(Literal),
    /// One or more punctuation characters.
    Operator(&'static str),
    /// A group. Invisible ones come from macro variables and hold more than one token.
    Group(Group),
}

/// Operators, the longest first. Those that the language lacks are here to be named in messages.
const OPERATORS: &[&str] = &[
    "..=", "...", "**", "==", "!=", "<=", ">=", "&&", "||", "+=", "-=", "*=", "/=", "%=", "^=",
    "|=", "&=", "..", "::", "->", "=>", "<<", ">>", "+", "-", "*", "/", "%", "^", "=", "<", ">",
    "!", "|", "&", ".", ",", ";", ":", "?", "@", "#", "$", "~", "'",
];

impl Token {
    /// How messages call it.
    pub fn text(&self) -> String {
        match &self.kind {
            TokenKind::Word(ident) => ident.to_string(),
            TokenKind::Literal(literal) => literal.to_string(),
            TokenKind::Operator(text) => (*text).to_owned(),
            TokenKind::Group(group) => match group.delimiter() {
                Delimiter::Parenthesis => "(".to_owned(),
                Delimiter::Brace => "{".to_owned(),
                Delimiter::Bracket => "[".to_owned(),
                Delimiter::None => group.stream().to_string(),
            },
        }
    }
}

/// Splits a stream into tokens.
pub fn tokens(stream: TokenStream) -> Vec<Token> {
    let trees: Vec<TokenTree> = stream.into_iter().collect();
    let mut tokens = Vec::with_capacity(trees.len());
    let mut at = 0;
    while let Some(tree) = trees.get(at) {
        at += 1;
        match tree.clone() {
            TokenTree::Punct(punct) => {
                let (text, length) = join(&trees[at - 1..], &punct);
                let end = trees
                    .get(at + length - 2)
                    .map_or(punct.span(), TokenTree::span);
                at += length - 1;
                tokens.push(Token {
                    kind: TokenKind::Operator(text),
                    start: punct.span(),
                    end,
                });
            }
            other => tokens.extend(single(other)),
        }
    }
    tokens
}

/// A token that is not punctuation. Empty invisible groups (an absent `$vis`) vanish.
fn single(mut tree: TokenTree) -> Option<Token> {
    loop {
        let span = tree.span();
        let kind = match tree {
            TokenTree::Ident(ident) => TokenKind::Word(ident),
            TokenTree::Literal(literal) => TokenKind::Literal(literal),
            TokenTree::Punct(punct) => TokenKind::Operator(join(&[], &punct).0),
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                let mut inner = group.stream().into_iter();
                let first = inner.next()?;
                if inner.next().is_none() {
                    tree = first;
                    continue;
                }
                let first = first.span();
                let last = group
                    .stream()
                    .into_iter()
                    .last()
                    .map_or(first, |t| t.span());
                return Some(Token {
                    kind: TokenKind::Group(group),
                    start: first,
                    end: last,
                });
            }
            TokenTree::Group(group) => TokenKind::Group(group),
        };
        return Some(Token {
            kind,
            start: span,
            end: span,
        });
    }
}

/// The longest operator at the start of `trees`, whose first character is `first`, and its length.
fn join(trees: &[TokenTree], first: &Punct) -> (&'static str, usize) {
    let mut text = String::from(first.as_char());
    let mut joint = first.spacing() == Spacing::Joint;
    for tree in trees.iter().skip(1).take(2) {
        match tree {
            TokenTree::Punct(punct) if joint => {
                text.push(punct.as_char());
                joint = punct.spacing() == Spacing::Joint;
            }
            _ => break,
        }
    }
    let longest = OPERATORS
        .iter()
        .find(|operator| text.starts_with(**operator));
    longest.map_or(("$", 1), |operator| (operator, operator.len()))
}

/// The tokens of one group, taken from the front.
#[derive(Debug)]
pub struct Cursor {
    /// What is left, last token first.
    rest: Vec<Token>,
    /// How many tokens of the whole input were taken.
    taken: Rc<Cell<u32>>,
    /// The token taken last, and its text if it is an operator.
    last: Option<(Place, &'static str)>,
    /// The end of the group.
    close: Span,
    /// The closing bracket, or an empty text for the whole input.
    pub closing: &'static str,
    /// Inside how many bars `|…|` the parser is: a bar then closes.
    pub bars: u32,
    /// In a condition `==` gets another message.
    pub condition: bool,
    /// In the value of a `let` two values in a row may mean a forgotten `;`.
    pub binding: bool,
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
            close,
            closing: "",
            bars: 0,
            condition: false,
            binding: false,
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
            close,
            closing,
            bars: 0,
            condition: self.condition,
            binding: false,
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

    /// Skips to the next `separator` (which stays) or to the end.
    pub fn skip_to(&mut self, separators: &[&str]) {
        while !self.at_end() && !separators.contains(&self.operator(0)) {
            self.take();
        }
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
