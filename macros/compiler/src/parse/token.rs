//! Tokens as the grammar sees them: operators joined, invisible groups opened where they hold one token.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

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
