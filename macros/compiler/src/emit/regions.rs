//! Where code stands that only some sides of choices need: region in region.
//!
//! A region is what one side guards, or a union of sides. It lies inside of another where it is alive only if that is. So a
//! part of a formula that does not matter costs one test, however many choices are made in it. Which regions are alive is
//! found once for each list of what is active; evaluations look it up.

use super::choices::{Choices, Side};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::collections::HashMap;

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

    /// The array `alive`: which regions are, bit by bit, as a list of what is active knows.
    pub fn known(&self, active: &TokenStream) -> TokenStream {
        if self.is_empty() {
            return TokenStream::new();
        }
        let words = self.words();
        quote!(let alive = #active.alive::<#words>();)
    }

    /// The same in space.
    pub fn known_in_space(&self) -> TokenStream {
        if self.is_empty() {
            return TokenStream::new();
        }
        let (words, table) = (self.words(), self.table());
        quote! {
            const REGIONS: __zeroset::Regions = #table;
            let alive = active.alive_in_space::<#words>(&REGIONS);
        }
    }

    /// How many words tell of them.
    fn words(&self) -> Literal {
        Literal::usize_unsuffixed(self.regions().div_ceil(WORD))
    }

    /// The table by which the runtime finds out which regions are alive.
    pub fn table(&self) -> TokenStream {
        if self.is_empty() {
            return quote!(__zeroset::Regions::NONE);
        }
        let count = Literal::usize_unsuffixed(self.regions());
        let choices = self.in_order().into_iter().map(|(choice, inside)| {
            let number = |of: usize| Literal::usize_unsuffixed(of);
            let within = match self.within.get(choice).copied().flatten().map(number) {
                Some(region) => quote!(__zeroset::Option::Some(#region)),
                None => quote!(__zeroset::Option::None),
            };
            let parts_of = [0, 1].map(|side| {
                let unions = self.unions.iter().zip(2 * self.pairs.len()..);
                let unions = unions.filter(|(of, _)| of.contains(&(2 * choice + side)));
                let unions = unions.map(|(_, union)| number(union));
                quote!(&[#(#unions),*])
            });
            let (choice, inside) = (number(choice), number(inside));
            quote! {
                __zeroset::Place {
                    choice: #choice,
                    within: #within,
                    inside: #inside,
                    parts_of: [#(#parts_of),*],
                }
            }
        });
        quote!(__zeroset::Regions { count: #count, choices: &[#(#choices),*] })
    }

    /// The choices, each with the number of those inside of its sides: these come right behind it, as far as all sides of a
    /// union come before what stands in it.
    fn in_order(&self) -> Vec<(usize, usize)> {
        let mut flat: Vec<usize> = (0..self.pairs.len()).collect();
        flat.sort_by_cached_key(|choice| self.depth(*choice));
        let rank: HashMap<usize, usize> = flat.iter().copied().zip(0..).collect();
        // From the outermost choice around one to itself.
        let path = |choice: &usize| {
            let outward =
                std::iter::successors(Some(*choice), |choice| self.choice_around(*choice));
            let ranks = outward
                .take(flat.len())
                .filter_map(|choice| rank.get(&choice));
            let mut path: Vec<usize> = ranks.copied().collect();
            path.reverse();
            path
        };
        let mut nested: Vec<(Vec<usize>, usize)> = flat.iter().map(|k| (path(k), *k)).collect();
        nested.sort_unstable();
        let order: HashMap<usize, usize> = nested.iter().map(|(_, k)| *k).zip(0..).collect();
        let follows = |choice: usize| {
            let sides = self
                .within
                .get(choice)
                .copied()
                .flatten()
                .map(|region| self.sides(region));
            let mut outer = sides.into_iter().flatten().map(|side| side / 2);
            outer.all(|outer| order.get(&outer) < order.get(&choice))
        };
        if !flat.iter().all(|choice| follows(*choice)) {
            return flat.into_iter().map(|choice| (choice, 0)).collect();
        }
        let inside = |path: &Vec<usize>| {
            let all = nested.iter().filter(|(other, _)| other.starts_with(path));
            all.count().saturating_sub(1)
        };
        let order = nested.iter().map(|(path, choice)| (*choice, inside(path)));
        order.collect()
    }

    /// The choice of the innermost side around one.
    fn choice_around(&self, choice: usize) -> Option<usize> {
        let outward = |region: &Side| self.around.get(*region).copied().flatten();
        let regions = std::iter::successors(outward(&(2 * choice)), outward);
        let mut regions = regions.take(self.regions());
        regions
            .find(|region| *region < 2 * self.pairs.len())
            .map(|side| side / 2)
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
