//! The compiler behind `implicit!`.
pub mod functions;
pub mod tree;

/// Expands.
pub fn expand(input: proc_macro2::TokenStream) -> proc_macro2::TokenStream { input }
