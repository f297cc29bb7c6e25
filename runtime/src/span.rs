//! A piece of each of eight rays, or beams.

use crate::interval::Interval;

/// Segments of a packet's rays; empty where `hi < lo`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span8 {
    pub lo: [f64; 8],
    pub hi: [f64; 8],
}

impl Span8 {
    pub const EMPTY: Span8 = Span8 {
        lo: [f64::INFINITY; 8],
        hi: [f64::NEG_INFINITY; 8],
    };

    /// Whole lines.
    pub const ALL: Span8 = Span8 {
        lo: [f64::NEG_INFINITY; 8],
        hi: [f64::INFINITY; 8],
    };

    /// One ray's.
    pub fn of(&self, lane: usize) -> Interval {
        Interval {
            lo: self.lo[lane],
            hi: self.hi[lane],
        }
    }

    /// Those that are not empty.
    pub fn live(&self) -> u8 {
        let live = (0..8).filter(|k| self.lo[*k] <= self.hi[*k]);
        live.fold(0, |live, k| live | 1 << k)
    }

    pub fn is_empty(&self) -> bool {
        self.live() == 0
    }

    /// What both have.
    pub fn meet(&self, other: &Span8) -> Span8 {
        let mut meet = *self;
        for k in 0..8 {
            meet.lo[k] = meet.lo[k].max(other.lo[k]);
            meet.hi[k] = meet.hi[k].min(other.hi[k]);
        }
        meet
    }

    /// The least segments that hold both.
    pub fn hull(&self, other: &Span8) -> Span8 {
        let mut hull = *self;
        for k in 0..8 {
            hull.add(k, other.of(k));
        }
        hull
    }

    /// Grows one ray's segment by a piece, if that is not empty.
    pub fn add(&mut self, lane: usize, piece: Interval) {
        if piece.lo <= piece.hi {
            self.lo[lane] = self.lo[lane].min(piece.lo);
            self.hi[lane] = self.hi[lane].max(piece.hi);
        }
    }
}
