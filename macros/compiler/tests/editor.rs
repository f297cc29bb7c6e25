//! What editors and rustc's lints live on: the scalar evaluator carries the user's own tokens.

use proc_macro2::{LineColumn, TokenStream, TokenTree};
use std::collections::HashSet;

const SOURCE: &str = "pub struct Wavy { depth: f64 = 1, rows: [[f64; 2]; 3] }
let wave = sin(x * depth);
let bump = { let inner = y^2; inner * wave };
bump + sum([a, b] in rows) { a * z.max(b) } = pi";

/// All names in a stream, with where they stand.
fn names(tokens: TokenStream, found: &mut HashSet<(String, usize, usize)>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => names(group.stream(), found),
            TokenTree::Ident(name) => {
                let LineColumn { line, column } = name.span().start();
                found.insert((name.to_string(), line, column));
            }
            _ => {}
        }
    }
}

fn names_in(tokens: TokenStream) -> HashSet<(String, usize, usize)> {
    let mut found = HashSet::new();
    names(tokens, &mut found);
    found
}

/// The body of `fn at`.
fn evaluator(tokens: TokenStream) -> Option<TokenStream> {
    let mut after = false;
    for token in tokens {
        match token {
            TokenTree::Ident(name) => after = after || name == "at",
            TokenTree::Group(group)
                if after && group.delimiter() == proc_macro2::Delimiter::Brace =>
            {
                return Some(group.stream());
            }
            TokenTree::Group(group) => {
                if let Some(found) = evaluator(group.stream()) {
                    return Some(found);
                }
            }
            _ => {}
        }
    }
    None
}

#[test]
fn every_name_of_the_formula_is_in_the_evaluator() {
    let source: TokenStream = SOURCE.parse().expect("tokens");
    let body = source
        .clone()
        .into_iter()
        .skip_while(|t| t.to_string() != "let");
    let mut wanted = names_in(body.collect());
    wanted.retain(|(name, ..)| !["let", "sum", "in"].contains(&name.as_str()));
    assert!(wanted.len() >= 17, "{wanted:?}");
    let mut input: TokenStream = "zeroset".parse().expect("tokens");
    input.extend(source);
    let code = zeroset_compiler::expand(input);
    let found = names_in(evaluator(code.clone()).expect("an evaluator"));
    let missing: Vec<_> = wanted.difference(&found).collect();
    assert!(missing.is_empty(), "{missing:?}");

    // The test can fail: the spans of another source are not there.
    let moved: TokenStream = format!("\n\n{SOURCE}").parse().expect("tokens");
    assert!(!names_in(moved).is_subset(&names_in(code)));
}
