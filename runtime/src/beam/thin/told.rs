//! What generated code tells about rows and choices over a piece of eight beams.

use super::Thin;
use crate::interval::{Arithmetic, Flags, Interval, Packet, Truth};
use crate::surface::{Row, Terms};

/// A row's term of a sum.
pub(super) struct Term {
    pub row: Row,
    pub sum: usize,
    pub lo: [f64; 8],
    pub hi: [f64; 8],
    /// Beams in which it is certainly defined and smooth.
    pub sure: u8,
}

/// A row's number, where the least of all rows' is taken.
pub(super) struct Candidate {
    pub row: Row,
    pub minimum: usize,
    pub lo: [f64; 8],
    /// Beams in which it is certainly defined, …
    pub sure: u8,
    /// … and positive, if the sign is all that matters.
    pub positive: u8,
}

/// A choice, and the beams in which either number is certainly less, or does for the sign.
pub(super) struct Decided {
    pub choice: usize,
    pub first: u8,
    pub second: u8,
    pub by_sign: bool,
}

impl Decided {
    fn new<P: Packet>(
        p: P,
        choice: usize,
        [first, second]: [Truth<P>; 2],
        flags: &Flags<P>,
        by_sign: bool,
    ) -> Self {
        // A side that is left out must be defined, for a minimum is undefined where either number is.
        let sure = !p.bits(p.or(flags.undefined, flags.empty));
        let (first, second) = (p.bits(first.yes) & sure, p.bits(second.yes) & sure);
        Decided {
            choice,
            first,
            second,
            by_sign,
        }
    }
}

impl Term {
    pub fn magnitude(&self, lane: usize) -> f64 {
        self.lo[lane].abs().max(self.hi[lane].abs())
    }
}

impl<P: Packet + Arithmetic<Packet = P, Value = Interval<P::F>>> Terms<P> for (P, &mut Thin) {
    #[inline(always)]
    fn term(&mut self, row: Row, sum: usize, term: Interval<P::F>, flags: Flags<P>) {
        let p = self.0;
        let smooth = p.and_not(flags.sound(p), flags.kink);
        let term = Term {
            row,
            sum,
            lo: p.to_array(term.lo),
            hi: p.to_array(term.hi),
            sure: p.bits(smooth),
        };
        match self.1.measuring {
            true => self.1.add_measure(&term),
            false => self.1.terms.push(term),
        }
    }

    #[inline(always)]
    fn candidate(
        &mut self,
        row: Row,
        minimum: usize,
        number: Interval<P::F>,
        flags: Flags<P>,
        by_sign: bool,
    ) {
        let p = self.0;
        if self.1.measuring {
            return;
        }
        let sure = !p.bits(p.or(flags.undefined, flags.empty));
        let positive = sure & p.bits(p.lt(p.splat(0.0), number.lo));
        let candidate = Candidate {
            row,
            minimum,
            lo: p.to_array(number.lo),
            sure,
            positive: if by_sign { positive } else { 0 },
        };
        self.1.add_candidate(candidate, p.to_array(number.hi));
    }

    #[inline(always)]
    fn choice(&mut self, choice: usize, less: [Truth<P>; 2], flags: Flags<P>) {
        if !self.1.measuring {
            let decided = Decided::new(self.0, choice, less, &flags, false);
            self.1.choices.push(decided);
        }
    }

    #[inline(always)]
    fn by_sign(&mut self, choice: usize, alone: [Truth<P>; 2], flags: Flags<P>) {
        if !self.1.measuring {
            let decided = Decided::new(self.0, choice, alone, &flags, true);
            self.1.choices.push(decided);
        }
    }
}
