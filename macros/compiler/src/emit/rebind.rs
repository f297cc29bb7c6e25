//! From leaves to leaves: each leaf of the active rows, in the shape of the storage.

use super::stages::Compiled;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// `rebind`.
pub fn rebind(compiled: &Compiled) -> TokenStream {
    let layout = compiled.layout;
    let active = layout.copy_active(&quote!(to));
    let regions = layout.choices.known(&quote!(active));
    let leaves = |part: u8, kind: &str, leaves: &[usize]| -> Vec<TokenStream> {
        let (part, kind) = (Literal::u8_unsuffixed(part), format_ident!("{kind}"));
        let all = leaves.iter().enumerate().map(|(place, leaf)| {
            let place = Literal::usize_unsuffixed(place);
            let code = quote!(to.#part[#place] = map.#kind(&from.#part[#place]););
            layout.guarded(compiled.staged, *leaf, code)
        });
        all.collect()
    };
    let mut top = leaves(0, "linear", &layout.top.linear);
    top.extend(leaves(1, "quadratic", &layout.top.quadratic));
    let rows = (0..layout.rows.len()).map(|k| rows(compiled, k));
    quote! {
        #[inline(always)]
        fn rebind<R: __zeroset::Rebind>(
            map: &R,
            from: &Self::Bound<R::From>,
            active: &__zeroset::Active,
            to: &mut Self::Bound<R::To>,
        ) -> __zeroset::primitive::bool {
            #regions
            #(#top)*
            #active
            #(#rows)*
            true
        }
    }
}

/// The rows of one scope, loop in loop; `old` is where the loop's rows are in `from`.
fn rows(compiled: &Compiled, k: usize) -> TokenStream {
    let Some((scope, _)) = compiled.layout.rows.get(k) else {
        return TokenStream::new();
    };
    let place = compiled.layout.bound_rows(k);
    let (from, to) = (of("from", &place), of("to", &place));
    let mut code = quote!(__zeroset::rebind_row(map, old));
    let folds: Vec<usize> = scope.folds().collect();
    for (depth, fold) in folds.into_iter().enumerate().rev() {
        // The outermost `Vec` keeps its room from beam to beam.
        let (start, end) = if depth == 0 {
            (
                quote!(let old = &#from; let new = &mut #to; new.clear();),
                quote!(),
            )
        } else {
            (quote!(let mut new = __zeroset::Vec::new();), quote!(new))
        };
        let (header, find) = match compiled.layout.active(fold) {
            Some(list) => (
                quote!(for row in &active.rows[#list]),
                quote!(let old = &old[*row as __zeroset::primitive::usize];),
            ),
            None => (quote!(for old in old), quote!()),
        };
        code = quote!({ #start #header { #find let made = #code; new.push(made); } #end });
    }
    code
}

/// `bound.5` of another variable.
fn of(name: &str, place: &TokenStream) -> TokenStream {
    let name = format_ident!("{name}");
    let mut tokens = place.clone().into_iter();
    tokens.next();
    let rest: TokenStream = tokens.collect();
    quote!(#name #rest)
}
