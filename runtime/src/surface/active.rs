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
    /// Two bits for each choice between two sides: may the first number be less, and may the second?
    sides: Vec<u32>,
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
            sides: both_sides(choices),
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
        let alive = self.in_space.get_or_init(|| {
            let (mut may, mut alive) = (Vec::new(), Vec::new());
            self.tell_sides(&mut may);
            regions.find(&may, &mut alive);
            words(&alive, 0).collect()
        });
        alive.first_chunk().expect(FOREIGN)
    }

    /// What is known of a choice.
    pub(crate) fn choice(&self, number: usize) -> Choice {
        match self.sides[number / CHOICES] >> (2 * (number % CHOICES)) & 0b11 {
            0b01 => Choice::First,
            0b10 => Choice::Second,
            _ => Choice::Open,
        }
    }

    /// In which of eight lists like this one the first number of each choice may be less, and the second: in all or none.
    pub(crate) fn tell_sides(&self, may: &mut Vec<[u8; 2]>) {
        may.clear();
        may.resize(self.sides.len() * CHOICES, [0; 2]);
        let all = |bit: u32| if bit & 1 != 0 { !0 } else { 0 };
        for (may, word) in may.chunks_exact_mut(CHOICES).zip(&self.sides) {
            for (k, may) in may.iter_mut().enumerate() {
                *may = [all(word >> (2 * k)), all(word >> (2 * k + 1))];
            }
        }
    }

    /// How many choices are decided, and how many are open.
    pub(crate) fn choices(&self) -> [u32; 2] {
        let count = |known: fn(u32, u32) -> u32| {
            let first = |word: &u32| known(*word, word >> 1) & FIRST;
            self.sides.iter().map(|word| first(word).count_ones()).sum()
        };
        [
            count(|first, second| first ^ second),
            count(|first, second| first & second),
        ]
    }

    /// Takes over what is known of choices, and of the regions along rays, in this one of eight lists: as
    /// [`tell_sides`](Self::tell_sides) and [`Regions::find`] tell.
    pub(crate) fn decide(&mut self, list: usize, may: &[[u8; 2]], alive: &[u8]) {
        self.sides.clear();
        self.sides.extend(words(may.as_flattened(), list));
        self.alive.clear();
        self.alive.extend(words(alive, list));
        self.in_space.take();
    }

    /// Takes over what is asked for along rays.
    pub fn load(&mut self, from: &Active) {
        self.rows.clone_from(&from.rows);
        self.rough.clone_from(&from.rough);
        self.rest.clone_from(&from.rest);
        self.alive.clone_from(&from.alive);
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
        self.sides.clone_from(&other.sides);
        self.alive.clone_from(&other.alive);
        self.in_space.take();
        self.by_sign = other.by_sign;
    }

    /// Are there fewer rows, or fewer open choices?
    pub(crate) fn is_less_than(&self, other: &Active) -> bool {
        let rows = |active: &Active| active.rows.iter().map(Vec::len).sum::<usize>();
        let open = |active: &Active| active.choices()[1];
        rows(self) < rows(other) || open(self) < open(other)
    }

    /// Is there anything to choose?
    pub(crate) fn is_open(&self) -> bool {
        self.rows.iter().any(|rows| rows.len() > 1) || self.choices()[1] > 0
    }
}

impl Clone for Active {
    fn clone(&self) -> Self {
        Active {
            rows: self.rows.clone(),
            rough: self.rough.clone(),
            rest: self.rest.clone(),
            sides: self.sides.clone(),
            alive: self.alive.clone(),
            in_space: OnceLock::new(),
            by_sign: self.by_sign,
        }
    }
    /// Keeps the room.
    fn clone_from(&mut self, from: &Self) {
        self.load(from);
        self.sides.clone_from(&from.sides);
        self.in_space.take();
        self.by_sign = from.by_sign;
    }
}

/// How many choices a word tells of, …
const CHOICES: usize = u32::BITS as usize / 2;
/// … and their first bits.
const FIRST: u32 = 0x5555_5555;

/// Both sides of so many choices.
fn both_sides(choices: usize) -> Vec<u32> {
    let mut sides = vec![!0; choices.div_ceil(CHOICES)];
    if let Some(last) = sides.last_mut() {
        *last >>= 2 * (choices.next_multiple_of(CHOICES) - choices);
    }
    sides
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
