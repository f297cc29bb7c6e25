//! What is wrong with a formula, where, and how to mend it.
//!
//! Every pass pushes its findings into one [`Diagnostics`] and carries on, so that one build shows every mistake.

extern crate proc_macro;

use crate::tree::Source;
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// A piece of the input: its first and its last token, and its rank in reading order.
///
/// Spans cannot be compared inside a macro, so the parser numbers the tokens as it takes them.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Span of the first token.
    pub start: Span,
    /// Span of the last token.
    pub end: Span,
    /// Rank of the first token.
    pub order: u32,
}

impl Place {
    /// From the start of this place to the end of a later one.
    pub fn to(self, last: Place) -> Place {
        Place {
            end: last.end,
            ..self
        }
    }

    /// The same piece, as the tree holds it.
    pub fn source(self) -> Source {
        Source {
            start: self.start,
            end: self.end,
        }
    }
}

/// The line of a span, where it is known: inside a running macro.
pub fn line(span: Span) -> Option<usize> {
    proc_macro::is_available().then(|| span.unwrap().line())
}

/// One mistake.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// Name of its constructor in the catalogue.
    pub code: &'static str,
    /// What is underlined.
    pub place: Place,
    /// What is wrong.
    pub message: String,
    /// How to mend it.
    pub help: Option<String>,
}

impl Diagnostic {
    /// The message and its help, as rustc will print them.
    pub fn text(&self) -> String {
        match &self.help {
            Some(help) => format!("{}\nhelp: {help}", self.message),
            None => self.message.clone(),
        }
    }

    /// `::core::compile_error! { "…" }`, underlining the place of the mistake.
    ///
    /// rustc underlines a macro call from its first to its last token, so these carry the two ends.
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let Place { start, end, .. } = self.place;
        let punct = |c, spacing| {
            let mut punct = Punct::new(c, spacing);
            punct.set_span(start);
            TokenTree::from(punct)
        };
        let mut text = Literal::string(&self.text());
        text.set_span(end);
        let mut group = Group::new(Delimiter::Brace, TokenTree::from(text).into());
        group.set_span(end);
        tokens.extend([
            punct(':', Spacing::Joint),
            punct(':', Spacing::Alone),
            Ident::new("core", start).into(),
            punct(':', Spacing::Joint),
            punct(':', Spacing::Alone),
            Ident::new("compile_error", start).into(),
            punct('!', Spacing::Alone),
            group.into(),
        ]);
    }
}

/// All mistakes found so far.
#[derive(Debug, Default)]
#[must_use = "mistakes that nobody reports are lost"]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Adds a mistake.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.list.push(diagnostic);
    }

    /// How many were pushed.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Is the formula free of mistakes so far?
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The mistakes in the order of the source, each once.
    pub fn in_order(&self) -> Vec<&Diagnostic> {
        let mut list: Vec<&Diagnostic> = self.list.iter().collect();
        list.sort_by_key(|d| d.place.order);
        list.dedup_by(|b, a| a.place.order == b.place.order && a.text() == b.text());
        list
    }

    /// One `compile_error!` per mistake. They stand where items or statements may stand.
    pub fn to_tokens(&self) -> TokenStream {
        let mut tokens = TokenStream::new();
        for diagnostic in self.in_order() {
            diagnostic.to_tokens(&mut tokens);
        }
        tokens
    }
}
