//! Folds as loops: what accumulates, and how a row is entered.

use super::layout::Layout;
use super::text::{count, index, interval};
use crate::graph::{Graph, Over, Scope};
use crate::tree::FoldKind;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// A fold's accumulators: declaration and update. Extremes take the first row as it is, because ±∞ on both sides is no
/// interval.
pub fn accumulator(
    name: &Ident,
    kind: FoldKind,
    fold: usize,
    args: &[&Ident],
) -> (TokenStream, TokenStream) {
    let start = |n: i64| {
        let n = interval(&crate::exact::Rational::from(n));
        quote!(a.constant(&#n))
    };
    let (zero, one) = (start(0), start(1));
    let first = format_ident!("j{fold}");
    let part = |k: &str| format_ident!("{name}{k}");
    match (kind, args) {
        (FoldKind::Sum, [b, ..]) => (
            quote!(let mut #name = #zero;),
            quote!(#name = a.add(#name, #b);),
        ),
        (FoldKind::Product, [b]) => (
            quote!(let mut #name = #one;),
            quote!(#name = a.mul(#name, #b);),
        ),
        (FoldKind::Product, [b, d]) => {
            let p = part("p");
            let declare = quote!(let mut #p = #one; let mut #name = #zero;);
            (
                declare,
                quote! { #name = a.add(a.mul(#name, #b), a.mul(#p, #d)); #p = a.mul(#p, #b); },
            )
        }
        (FoldKind::Product, [b, u, v, uv, ..]) => {
            let (p, pu, pv) = (part("p"), part("pu"), part("pv"));
            let declare = quote! {
                let mut #p = #one; let mut #pu = #zero; let mut #pv = #zero; let mut #name = #zero;
            };
            let update = quote! {
                #name = a.add(
                    a.add(a.mul(#name, #b), a.mul(#p, #uv)),
                    a.add(a.mul(#pu, #v), a.mul(#pv, #u)),
                );
                #pu = a.add(a.mul(#pu, #b), a.mul(#p, #u));
                #pv = a.add(a.mul(#pv, #b), a.mul(#p, #v));
                #p = a.mul(#p, #b);
            };
            (declare, update)
        }
        (FoldKind::Minimum | FoldKind::Maximum, [b]) => {
            let f = if kind == FoldKind::Minimum {
                quote!(min)
            } else {
                quote!(max)
            };
            let update = quote!(#name = if #first == 0 { #b } else { a.#f(#name, #b) };);
            (quote!(let mut #name = #zero;), update)
        }
        (FoldKind::Minimum | FoldKind::Maximum, [b, d, ..]) => {
            let m = part("m");
            let chosen = format_ident!("c{}", name.to_string().trim_start_matches('n'));
            let (f, wins) = if kind == FoldKind::Minimum {
                (quote!(min), quote!(a.less(#m, #b)))
            } else {
                (quote!(max), quote!(a.less(#b, #m)))
            };
            let update = quote! {
                if #first == 0 {
                    #m = #b;
                    #name = #d;
                } else {
                    let wins = #wins;
                    #name = a.choose(wins, #name, #d);
                    #chosen = a.branch(wins, a.clear(), a.clear(), __zeroset::Undecided::Kink);
                    #m = a.#f(#m, #b);
                }
            };
            (quote!(let mut #m = #zero; let mut #name = #zero;), update)
        }
        _ => (quote!(let #name = #zero;), quote!()),
    }
}

/// Which rows of the prepared surface a loop visits.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Visit {
    /// All of them.
    All,
    /// The active ones, with their leaves along a ray.
    Bound,
    /// The active ones, without leaves.
    Active,
}

/// A loop over rows of the prepared surface.
pub fn enter_rows(
    graph: &Graph,
    layout: &Layout,
    fold: usize,
    scope: Scope,
    visit: Visit,
) -> (TokenStream, TokenStream) {
    let (j, k) = (format_ident!("j{fold}"), format_ident!("k{fold}"));
    let (header, mut start) = match (layout.active(fold), visit) {
        (Some(list), Visit::Bound) => (
            quote!(for #j in 0..bound.2.visited(#list, t.rough())),
            quote!(let #k = bound.2.rows[#list][#j] as __zeroset::primitive::usize;),
        ),
        (Some(list), Visit::Active) => (
            quote!(for #j in 0..active.rows[#list].len()),
            quote!(let #k = active.rows[#list][#j] as __zeroset::primitive::usize;),
        ),
        _ => {
            let length = layout.length(graph, fold);
            (quote!(for #j in 0..#length), quote!(let #k = #j;))
        }
    };
    for (index, entered) in layout.entered(fold, scope) {
        let (row, leaves) = (format_ident!("row{index}"), format_ident!("leaves{index}"));
        let prepared = in_loops(layout.prepared_rows(index), "k", entered);
        let bound = in_loops(layout.bound_rows(index), "j", entered);
        start.extend(quote!(let #row = &#prepared;));
        if visit == Visit::Bound {
            start.extend(quote!(let #leaves = &#bound;));
        }
    }
    (header, start)
}

/// A loop over the rows of a field, or over a range.
pub fn enter_fields(graph: &Graph, fields: &[Ident], fold: usize) -> (TokenStream, TokenStream) {
    let (j, r, i) = (
        format_ident!("j{fold}"),
        format_ident!("r{fold}"),
        format_ident!("i{fold}"),
    );
    match graph.folds.get(fold).map(|f| &f.over) {
        Some(Over::Table(field, indices)) => {
            let Some(name) = fields.get(*field) else {
                return (quote!(), quote!());
            };
            let indices = indices.iter().map(index);
            let table = quote!(self.#name #(#indices)*);
            (
                quote!(for #j in 0..#table.len()),
                quote!(let #r = #table[#j];),
            )
        }
        Some(Over::Range(start, end)) => {
            let length = count(usize::try_from(end - start).unwrap_or(0));
            let start = Literal::i64_suffixed(*start);
            let counter = quote!(let #i = #start + #j as __zeroset::primitive::i64;);
            (
                quote!(for #j in 0..(#length as __zeroset::primitive::usize)),
                counter,
            )
        }
        None => (quote!(), quote!()),
    }
}

/// The rows in twice the precision of a loop that was entered.
pub fn enter_fine_rows(layout: &Layout, fold: usize, scope: Scope) -> TokenStream {
    let mut start = TokenStream::new();
    for (index, entered) in layout.entered(fold, scope) {
        if let Some(rows) = layout.fine_rows(index) {
            let (fine, row) = (format_ident!("fine{index}"), in_loops(rows, "k", entered));
            start.extend(quote!(let #fine = &#row;));
        }
    }
    start
}

/// The row of nested rows that the counters of these loops say.
fn in_loops(rows: TokenStream, counter: &str, loops: Scope) -> TokenStream {
    loops.folds().fold(rows, |rows, f| {
        let counter = format_ident!("{counter}{f}");
        quote!(#rows[#counter])
    })
}
