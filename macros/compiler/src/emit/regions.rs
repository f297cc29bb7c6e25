//! Where code stands that only some sides of choices need: region in region.
//!
//! A region is what one side guards, or a union of sides. It lies inside of another where it is alive only if that is. So a
//! part of a formula that does not matter costs one test, however many choices are made in it. Where all numbers that are
//! compared are asked for, code stands in a row, behind variables that tell which sides are alive.

use super::choices::{Choices, Side};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeSet, HashSet};

/// The variable of a side.
pub fn side(side: Side) -> Ident {
    format_ident!("g{side}")
}

impl Choices {
    /// The array `sides`: what `active` knows of each choice.
    pub fn known(&self, active: &TokenStream) -> TokenStream {
        if self.is_empty() {
            return TokenStream::new();
        }
        let count = Literal::usize_unsuffixed(self.count());
        quote!(let sides = #active.known::<#count>();)
    }

    /// Declares the sides and their unions, each a `bool`: whether it is alive, as the array `sides` says.
    pub(super) fn declare(&self) -> TokenStream {
        if self.is_empty() {
            return TokenStream::new();
        }
        let mut declared = HashSet::new();
        let mut out = TokenStream::new();
        for k in self.order() {
            let (first, second) = (side(2 * k), side(2 * k + 1));
            let number = Literal::usize_unsuffixed(k);
            let outer = self.within[k].map(|s| {
                self.declare_union(s, &mut declared, &mut out);
                let s = side(s);
                quote!(let (#first, #second) = (#s & #first, #s & #second);)
            });
            out.extend(quote! {
                let (#first, #second) = (sides[#number].first(), sides[#number].second());
                #outer
            });
        }
        let guards: BTreeSet<Side> = self
            .guards
            .values()
            .chain(self.shapes.values())
            .copied()
            .collect();
        for guard in guards {
            self.declare_union(guard, &mut declared, &mut out);
        }
        out
    }

    /// Declares a union, if it is one and not declared yet, behind its sides.
    fn declare_union(&self, of: Side, declared: &mut HashSet<Side>, out: &mut TokenStream) {
        if of >= 2 * self.pairs.len() && declared.insert(of) {
            let name = side(of);
            let sides = self.sides(of).into_iter().map(side);
            out.extend(quote!(let #name = #(#sides)|*;));
        }
    }

    /// The choices, each behind those that guard it.
    fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.pairs.len()).collect();
        order.sort_by_cached_key(|k| self.depth(*k));
        order
    }

    /// The innermost region around each side and each union.
    pub(super) fn nested(&self) -> Vec<Option<Side>> {
        let mut around: Vec<Option<Side>> = (0..2 * self.pairs.len())
            .map(|side| self.within.get(side / 2).copied().flatten())
            .collect();
        for number in 0..self.unions.len() {
            let of = 2 * self.pairs.len() + number;
            let parts = self.sides(of);
            let holds = |region: &Side| {
                let region = self.sides(*region);
                parts.iter().all(|part| self.covers(&region, *part))
            };
            // Unions around the first part may not have got their region yet: one that holds all parts is found by its sides.
            let first = parts.first().copied();
            let outward = std::iter::successors(first, |side| self.outward(*side));
            let region = outward.skip(1).take(2 * around.len()).find(holds);
            around.push(region.filter(|region| *region != of));
        }
        around
    }

    /// What guards a side's choice; of a union, what guards the first of its sides.
    fn outward(&self, of: Side) -> Option<Side> {
        let side = self.sides(of).first().copied()?;
        self.within.get(side / 2).copied().flatten()
    }

    /// The region inside of `from` that `to` is, or lies in.
    pub fn step(&self, from: Option<Side>, to: Side) -> Side {
        let mut region = to;
        while let Some(outer) = self.around.get(region).copied().flatten()
            && Some(outer) != from
        {
            region = outer;
        }
        region
    }

    /// Is a side or a union alive, as the array `sides` says? `inside` is known to be.
    pub fn alive(&self, of: Side, inside: Option<Side>) -> TokenStream {
        let inside = inside.map(|region| self.sides(region));
        self.told(of, inside.as_ref())
    }

    fn told(&self, of: Side, inside: Option<&BTreeSet<Side>>) -> TokenStream {
        let parts = self.sides(of).into_iter().map(|side| {
            let number = Literal::usize_unsuffixed(side / 2);
            let own = if side % 2 == 0 {
                quote!(sides[#number].first())
            } else {
                quote!(sides[#number].second())
            };
            match self.within.get(side / 2).copied().flatten() {
                Some(outer) if !self.follows(outer, inside) => {
                    let outer = self.told(outer, inside);
                    quote!((#own & #outer))
                }
                _ => own,
            }
        });
        quote!((#(#parts)|*))
    }

    /// Is a region alive wherever one of these sides is?
    fn follows(&self, region: Side, from: Option<&BTreeSet<Side>>) -> bool {
        let region = self.sides(region);
        from.is_some_and(|sides| sides.iter().all(|side| self.covers(&region, *side)))
    }
}
