//! Small pieces of code.

use crate::exact::Rational;
use crate::graph::Id;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The variable of a node.
pub fn variable(id: Id) -> Ident {
    format_ident!("n{}", id.0)
}

/// The flags of a node.
pub fn flags(id: Id) -> Ident {
    format_ident!("f{}", id.0)
}

/// An `f64`.
pub fn float(x: f64) -> TokenStream {
    if x.is_infinite() {
        let name = if x > 0.0 {
            quote!(INFINITY)
        } else {
            quote!(NEG_INFINITY)
        };
        return quote!(__zeroset::primitive::f64::#name);
    }
    let digits = Literal::f64_suffixed(x.abs());
    if x < 0.0 {
        quote!(-#digits)
    } else {
        quote!(#digits)
    }
}

/// The enclosure of an exact number.
pub fn interval(r: &Rational) -> TokenStream {
    let (lo, hi) = crate::rational::bounds(r);
    let (lo, hi) = (float(lo), float(hi));
    quote!(__zeroset::Interval { lo: #lo, hi: #hi })
}

/// The value of an exact number in the number system `a`.
pub fn number(r: &Rational) -> TokenStream {
    let enclosure = interval(r);
    let (lo, hi) = crate::rational::bounds(r);
    if lo == hi {
        return quote!(a.constant(&#enclosure));
    }
    let near = crate::rational::nearest(r);
    let rest = Rational::from_f64(near).map_or(0.0, |n| crate::rational::nearest(&(r - &n)));
    let (near, rest) = (float(near), float(rest));
    quote!(a.literal(&__zeroset::Number { enclosure: #enclosure, leading: [#near, #rest] }))
}

/// The index of a table's element, in `usize`.
pub fn index(i: &crate::tree::Index) -> TokenStream {
    match i {
        crate::tree::Index::Constant(k) => {
            let k = Literal::usize_unsuffixed(*k);
            quote!([#k])
        }
        crate::tree::Index::Counter(fold, shift) => {
            let counter = format_ident!("i{fold}");
            let shift = Literal::i64_suffixed(*shift);
            quote!([(#counter + #shift) as __zeroset::primitive::usize])
        }
    }
}

/// A count as a literal.
pub fn count(n: usize) -> Literal {
    Literal::u32_unsuffixed(u32::try_from(n).unwrap_or(u32::MAX))
}
