//! The entry of `implicit!`. The compiler itself is the crate `zeroset-compiler`.

use proc_macro::TokenStream;

/// Compiles an implicit surface. Users reach it as `zeroset::implicit!`, which passes the path of the crate.
#[doc(hidden)]
#[proc_macro]
pub fn implicit(input: TokenStream) -> TokenStream {
    zeroset_compiler::expand(input.into()).into()
}
