//! The compiler behind zeroset's `implicit!`: from the tokens of a formula to the code of its enclosures.
//!
//! The stages, in order:
//!
//! 1. [`parse`] reads tokens into an [`ast`], [`resolve`] names into a [`tree`]; mistakes go to [`diagnostic`], worded
//!    by [`catalogue`];
//! 2. [`lower`] makes the computation [`graph`], simplified as it is built;
//! 3. [`differentiate`] adds the derivatives;
//! 4. [`stage`] splits by binding time: literal, surface, ray, segment;
//! 5. [`emit`] writes Rust.

pub mod ast;
pub mod catalogue;
pub mod diagnostic;
pub mod differentiate;
pub mod emit;
pub mod exact;
pub mod form;
pub mod front;
pub mod functions;
pub mod graph;
pub mod lower;
pub mod parse;
pub mod range;
pub mod rational;
pub mod resolve;
pub mod simplify;
pub mod stage;
pub mod tree;

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

/// Expands one `implicit!`. The first token is the path of the runtime's crate, which the user-facing macro passes.
pub fn expand(input: TokenStream) -> TokenStream {
    let mut tokens = input.into_iter();
    let root = crate_path(tokens.next());
    let (form, tokens) = form(tokens.collect());
    let front = front::front(tokens);
    match &front.formula {
        Some(formula) => match emit::surface(formula, &root, form) {
            Ok(code) => code,
            Err(large) => {
                let mut diagnostics = front.diagnostics;
                diagnostics.push(too_many_folds(large.source));
                diagnostics.to_tokens()
            }
        },
        None => {
            let errors = front.diagnostics.to_tokens();
            match &front.head {
                Some(head) => {
                    let placeholder = emit::placeholder(head, &root);
                    quote!(#errors #placeholder)
                }
                // An expression is one block.
                None if front.expression_form => quote!({ #errors }),
                None => errors,
            }
        }
    }
}

/// `@shared` or the like in front of the formula, for benchmarks: no formula begins with `@`.
fn form(input: TokenStream) -> (form::Form, TokenStream) {
    let mut tokens = input.clone().into_iter();
    if let (Some(TokenTree::Punct(at)), Some(TokenTree::Ident(name))) =
        (tokens.next(), tokens.next())
        && at.as_char() == '@'
        && let Some(form) = form::Form::named(&name.to_string())
    {
        return (form, tokens.collect());
    }
    (form::Form::Staged, input)
}

fn too_many_folds(source: tree::Source) -> diagnostic::Diagnostic {
    let place = diagnostic::Place {
        start: source.start,
        end: source.end,
        order: 0,
    };
    catalogue::constants::too_many_folds(place, resolve::fold::MOST_FOLDS)
}

/// `$crate` arrives as one token, inside an invisible group or not.
fn crate_path(token: Option<TokenTree>) -> TokenStream {
    match token {
        Some(TokenTree::Group(group)) => group.stream(),
        Some(token) => token.into(),
        None => quote!(::zeroset),
    }
}
