//! Where code stands that only some sides of choices need: region in region.
//!
//! A region is what one side guards, or a union of sides. It lies inside of another where it is alive only if that is. So a
//! part of a formula that does not matter costs one test, however many choices are made in it. Which regions are alive is
//! found once for each list of what is active; evaluations look it up.

use super::choices::{Choices, Side};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// How many regions a word of the array `alive` tells of.
const WORD: usize = u32::BITS as usize;

impl Choices {
    /// How many regions there are.
    pub fn regions(&self) -> usize {
        if self.is_empty() {
            0
        } else {
            2 * self.pairs.len() + self.unions.len()
        }
    }

    /// The array `alive`: which regions are, bit by bit.
    pub fn known(&self, active: &TokenStream, in_space: bool) -> TokenStream {
        if self.is_empty() {
            return TokenStream::new();
        }
        let words = Literal::usize_unsuffixed(self.regions().div_ceil(WORD));
        let alive = format_ident!("{}", if in_space { "alive_in_space" } else { "alive" });
        quote!(let alive = #active.#alive::<#words>();)
    }

    /// The table by which the runtime finds out which regions are alive.
    pub fn table(&self) -> TokenStream {
        if self.is_empty() {
            return quote!(__zeroset::Regions::NONE);
        }
        let count = Literal::usize_unsuffixed(self.regions());
        let sides = 2 * self.pairs.len();
        let inside = |stands: &dyn Fn(Option<Side>) -> bool| {
            let choices = self.within.iter().enumerate();
            let choices = choices.filter(move |(_, within)| stands(**within));
            let numbers = choices.map(|(number, _)| Literal::usize_unsuffixed(number));
            numbers.collect::<Vec<_>>()
        };
        let of_sides = (0..sides).map(|side| {
            let mut parts_of = BTreeMap::new();
            for (union, number) in self.unions.iter().zip(sides..) {
                if union.contains(&side) {
                    *parts_of.entry(number / WORD).or_insert(0u32) |= 1 << (number % WORD);
                }
            }
            let holds = |of| self.sides(of).contains(&side);
            let choices = inside(&|within| within.is_some_and(holds));
            let parts_of = parts_of.into_iter().map(|(word, bits)| {
                let (word, bits) = (
                    Literal::usize_unsuffixed(word),
                    Literal::u32_unsuffixed(bits),
                );
                quote!((#word, #bits))
            });
            quote!(__zeroset::Region { parts_of: &[#(#parts_of),*], choices: &[#(#choices),*] })
        });
        let outermost = inside(&|within| within.is_none());
        quote! {
            __zeroset::Regions {
                count: #count,
                outermost: &[#(#outermost),*],
                of_sides: &[#(#of_sides),*],
            }
        }
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
}

/// Is a region alive, as the array `alive` says?
pub fn alive(region: Side) -> TokenStream {
    let word = Literal::usize_unsuffixed(region / WORD);
    let bit = Literal::u32_unsuffixed(1 << (region % WORD));
    quote!((alive[#word] & #bit != 0))
}
