//! Any text that is tokens: the compiler answers with code or with messages, and never panics.

#![no_main]

use libfuzzer_sys::fuzz_target;
use proc_macro2::TokenStream;
use zeroset_compiler::expand;
use zeroset_compiler::front::front;

/// Deeper groups overflow the stack of the lexer itself, which is not the compiler's.
const DEEPEST: usize = 200;

fuzz_target!(|text: &str| {
    if text.matches(['(', '[', '{']).count() > DEEPEST {
        return;
    }
    let Ok(input) = text.parse::<TokenStream>() else {
        return;
    };
    let front = front(input.clone());
    let mistakes = front.diagnostics.in_order().len();
    assert_eq!(front.formula.is_some(), mistakes == 0);
    let root: TokenStream = "zeroset".parse().expect("a name");
    let code = expand(root.into_iter().chain(input).collect()).to_string();
    assert!(mistakes == 0 || code.contains("compile_error"));
});
