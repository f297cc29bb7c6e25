//! What of a surface is active over a part of space: rows of its tables, and sides of its choices.

use super::regions::words;
use super::{Regions, Surface};
use crate::interval::Interval;
use std::sync::OnceLock;

/// What of its tables a surface visits.
#[derive(Debug, Default, PartialEq)]
pub struct Active {
    /// For each outermost fold, the rows to visit.
    pub rows: Vec<Vec<u32>>,
    /// How many of them, from the first, a rough look visits.
    pub rough: Vec<usize>,
    /// For each sum that may leave out rows: what these add, wherever this list is used.
    pub rest: Vec<Rest>,
    /// What is known of each choice between two sides.
    pub choices: Vec<Choice>,
    /// Which regions of the surface's code along rays are alive, bit by bit.
    alive: Vec<u32>,
    /// The same in space, found when it is asked for.
    in_space: OnceLock<Vec<u32>>,
    /// Were rows or sides left out because their sign is certain? Then f has its sign and its zeros, but elsewhere not its
    /// value: what is proved of it with other rows does not hold for it.
    pub by_sign: bool,
}

/// What is known of a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Nothing.
    Open,
    /// The first number is less.
    First,
    /// The second number is less.
    Second,
}

impl Choice {
    /// May the first number be less?
    #[inline(always)]
    #[must_use]
    pub fn first(self) -> bool {
        self != Choice::Second
    }

    /// May the second number be less?
    #[inline(always)]
    #[must_use]
    pub fn second(self) -> bool {
        self != Choice::First
    }
}

/// What the rows of a sum add that are left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Those that are not in the list.
    pub all: Interval,
    /// Those that a rough look does not visit.
    pub rough: Interval,
}

impl Active {
    /// All rows of folds of these lengths, for a formula with so many sums and choices, and all of these regions.
    #[must_use]
    pub fn everything(lengths: &[usize], sums: usize, choices: usize, regions: &Regions) -> Self {
        let nothing = Interval { lo: 0.0, hi: 0.0 };
        let rest = Rest {
            all: nothing,
            rough: nothing,
        };
        Active {
            rows: lengths.iter().map(|n| (0..*n as u32).collect()).collect(),
            rough: lengths.to_vec(),
            rest: vec![rest; sums],
            choices: vec![Choice::Open; choices],
            alive: regions.all(),
            in_space: OnceLock::new(),
            by_sign: false,
        }
    }

    /// Which regions of the code along rays are alive, in a formula with so many words of them.
    ///
    /// # Panics
    ///
    /// If it has more.
    #[inline(always)]
    #[must_use]
    pub fn alive<const WORDS: usize>(&self) -> &[u32; WORDS] {
        self.alive.first_chunk().expect(FOREIGN)
    }

    /// The same in space, where these are the regions.
    ///
    /// # Panics
    ///
    /// If it has more.
    #[inline]
    #[must_use]
    pub fn alive_in_space<const WORDS: usize>(&self, regions: &Regions) -> &[u32; WORDS] {
        let alive = self.in_space.get_or_init(|| regions.alive(&self.choices));
        alive.first_chunk().expect(FOREIGN)
    }

    /// Marks the regions along rays that are alive in this one of eight lists, of which [`Regions::find`] tells.
    pub(crate) fn mark(&mut self, alive: &[u8], list: usize) {
        self.alive.clear();
        self.alive.extend(words(alive, list));
        self.in_space.take();
    }

    /// The numbers of the regions along rays that are alive; behind them numbers of none may come.
    pub(super) fn regions(&self) -> impl Iterator<Item = usize> {
        let words = self.alive.iter().enumerate();
        words.flat_map(|(number, word)| {
            let rest =
                core::iter::successors(Some(*word), |rest| Some(rest & rest.wrapping_sub(1)));
            let rest = rest.take_while(|rest| *rest != 0);
            rest.map(move |rest| 32 * number + rest.trailing_zeros() as usize)
        })
    }

    /// Do these rows and sides of a surface tell all about f where they hold, along rays and in space? They do without sums:
    /// what they compute has the sign and the zeros of f, and is no smaller; it is the same in both, if what is left out
    /// by its sign is. A sum's derivatives by the active rows do not hold what the others add.
    pub(crate) fn tells_all<S: Surface>(&self) -> bool {
        self.rest.is_empty() && (!self.by_sign || S::SIGNS_IN_SPACE)
    }

    /// How many rows of a list a look visits.
    #[inline(always)]
    #[must_use]
    pub fn visited(&self, list: usize, rough: bool) -> usize {
        if rough {
            self.rough[list]
        } else {
            self.rows[list].len()
        }
    }

    /// What the rows add that it does not visit.
    #[inline(always)]
    #[must_use]
    pub fn rest(&self, sum: usize, rough: bool) -> &Interval {
        let rest = &self.rest[sum];
        if rough { &rest.rough } else { &rest.all }
    }

    /// With the choices and rests of another, and no rows yet.
    pub(crate) fn start_from(&mut self, other: &Active) {
        self.rows.resize_with(other.rows.len(), Vec::new);
        self.rows.iter_mut().for_each(Vec::clear);
        self.rough.resize(other.rows.len(), 0);
        self.rest.clone_from(&other.rest);
        self.choices.clone_from(&other.choices);
        self.alive.clone_from(&other.alive);
        self.in_space.clone_from(&other.in_space);
        self.by_sign = other.by_sign;
    }

    /// Are there fewer rows, or fewer open choices?
    pub(crate) fn is_less_than(&self, other: &Active) -> bool {
        let rows = |active: &Active| active.rows.iter().map(Vec::len).sum::<usize>();
        let open = |active: &Active| {
            active
                .choices
                .iter()
                .filter(|c| **c == Choice::Open)
                .count()
        };
        rows(self) < rows(other) || open(self) < open(other)
    }

    /// Is there anything to choose?
    pub(crate) fn is_open(&self) -> bool {
        self.rows.iter().any(|rows| rows.len() > 1) || self.choices.contains(&Choice::Open)
    }
}

impl Clone for Active {
    fn clone(&self) -> Self {
        Active {
            rows: self.rows.clone(),
            rough: self.rough.clone(),
            rest: self.rest.clone(),
            choices: self.choices.clone(),
            alive: self.alive.clone(),
            in_space: self.in_space.clone(),
            by_sign: self.by_sign,
        }
    }
    /// Keeps the room.
    fn clone_from(&mut self, from: &Self) {
        self.rows.clone_from(&from.rows);
        self.rough.clone_from(&from.rough);
        self.rest.clone_from(&from.rest);
        self.choices.clone_from(&from.choices);
        self.alive.clone_from(&from.alive);
        self.in_space.clone_from(&from.in_space);
        self.by_sign = from.by_sign;
    }
}

/// What asking for the regions of another formula says.
const FOREIGN: &str = "the regions of another formula";

/// A row of a table, in turn.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The fold, as an index of [`Active::rows`].
    pub list: usize,
    /// The row's place in that list.
    pub at: usize,
}
