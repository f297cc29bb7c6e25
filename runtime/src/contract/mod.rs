//! Contractors: from a segment of a ray to what is left of it.
//!
//! A contractor removes parts of a segment that certainly hold no root. Each has a file of its own, in which the
//! mathematics stands as a plain function of enclosures; the trait [`Contractor`] wraps it with the evaluations that it
//! needs. A solver calls a surface's entry points as an object's: the default one is compiled with this crate, others
//! where they are used.

mod auto;
mod bisection;
mod halley;
mod halley_quotient;
mod newton;
mod tightened;
#[cfg(feature = "unrounded")]
#[doc(hidden)]
pub mod unsound;

pub use auto::Auto;
pub use bisection::Bisection;
pub use halley::{Halley, step as halley_step};
pub use halley_quotient::{HalleyQuotient, step as halley_quotient_step};
pub use newton::{Newton, step as newton_step};
pub use tightened::{Tightened, slope_over as tightened_slope};

use crate::interval::{Interval, Packet};
use crate::solve::Field;

mod sealed {
    use super::Contractor;
    use crate::interval::{Isa, Kernel, Packet};
    use crate::solve::Solver;

    /// A contractor's claims are proofs: they are this crate's own.
    pub trait Sealed {
        /// The search with this contractor.
        fn solver<P: Packet>() -> Solver<P>
        where
            Self: Contractor,
        {
            Solver::of::<Self>()
        }

        /// Runs a kernel of a surface that has this solver.
        fn run<K: Kernel>(isa: Isa, kernel: K) -> K::Output {
            isa.run_surface(kernel)
        }
    }
}

/// A way to shrink segments.
pub trait Contractor: sealed::Sealed + Copy + Send + Sync + 'static {
    /// The name in reports.
    const NAME: &'static str;
    /// The highest derivative that it evaluates.
    const ORDER: u8;

    /// What one search remembers from step to step.
    type Memory<P: Packet>;

    /// Nothing yet.
    fn memory<P: Packet>(p: P) -> Self::Memory<P>;

    /// What is left of the segments `t` of the lanes in `live`.
    fn contract<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
        memory: &mut Self::Memory<P>,
    ) -> Pieces<P>;
}

/// What is left of a segment T.
#[derive(Clone, Copy)]
pub struct Pieces<P: Packet> {
    /// T holds no root.
    pub none: P::M,
    /// `first` holds exactly one root, and T no other; f is continuous on `first`, and strictly monotone.
    pub one: P::M,
    /// f cannot be told from 0 at the front of `first`: no step from there can succeed.
    pub stuck: P::M,
    /// The first piece: all roots of T lie in it or at `next` and behind.
    pub first: Interval<P::F>,
    /// Where the second piece begins; `first.hi` if it follows at once.
    pub next: P::F,
    /// f' over `first`, for the lanes of `one`.
    pub slope: Interval<P::F>,
}

impl<P: Packet> Pieces<P> {
    /// All of T is left.
    #[inline(always)]
    pub(crate) fn all(p: P, t: &Interval<P::F>) -> Self {
        let none = p.mask(0);
        Pieces {
            none,
            one: none,
            stuck: none,
            first: *t,
            next: t.hi,
            slope: *t,
        }
    }

    /// Halves the first piece where a step left more than 60 % of T.
    #[inline(always)]
    pub(crate) fn halve_slow(&mut self, p: P, t: &Interval<P::F>, live: P::M) {
        let before = p.sub_rn(t.hi, t.lo);
        let after = p.sub_rn(self.first.hi, self.first.lo);
        let slow = p.lt(p.mul_rn(before, p.splat(0.6)), after);
        let slow = p.and_not(p.and_not(p.and(slow, live), self.none), self.one);
        let middle = middle(p, &self.first);
        self.next = p.select(slow, middle, self.next);
        self.first.hi = p.select(slow, middle, self.first.hi);
    }
}

/// What steps from an expansion point m leave of a segment: [lo, left] ∪ [right, hi], with left ≤ m ≤ right; a side with
/// crossed ends is empty.
#[derive(Clone, Copy)]
pub struct Around<P: Packet> {
    /// Where the first piece begins.
    pub lo: P::F,
    /// Where the first piece ends.
    pub left: P::F,
    /// Where the second piece begins.
    pub right: P::F,
    /// Where the second piece ends.
    pub hi: P::F,
    /// The segment holds exactly one root, and f is strictly monotone on it.
    pub one: P::M,
    /// f' over the segment.
    pub slope: Interval<P::F>,
}

impl<P: Packet> Around<P> {
    /// All of `t` is left on both sides of `m`.
    #[inline(always)]
    pub fn all(p: P, t: &Interval<P::F>, m: P::F) -> Self {
        Around {
            lo: t.lo,
            left: m,
            right: m,
            hi: t.hi,
            one: p.mask(0),
            slope: *t,
        }
    }

    /// The pieces, the first one foremost.
    #[inline(always)]
    pub fn pieces(&self, p: P) -> Pieces<P> {
        // Without a gap the two sides are one piece.
        let whole = p.le(self.right, self.left);
        let has_left = p.or(whole, p.le(self.lo, self.left));
        let has_right = p.or(whole, p.le(self.right, self.hi));
        let all = p.mask(0xff);
        let lo = p.select(has_left, self.lo, self.right);
        let hi = p.select(p.and_not(has_left, whole), self.left, self.hi);
        let both = p.and(p.and_not(has_left, whole), has_right);
        let none = p.and_not(p.and_not(all, has_left), has_right);
        Pieces {
            none: p.and_not(none, self.one),
            one: self.one,
            stuck: p.mask(0),
            // A lane without pieces keeps an interval that is in order.
            first: Interval {
                lo,
                hi: p.max_f(hi, lo),
            },
            next: p.select(both, self.right, p.max_f(hi, lo)),
            slope: self.slope,
        }
    }
}

/// A point inside, near the middle.
#[inline(always)]
pub(crate) fn middle<P: Packet>(p: P, t: &Interval<P::F>) -> P::F {
    let half = p.splat(0.5);
    // Two products: the sum of the ends may overflow. The clamp keeps it inside whatever the rounding does.
    let m = p.add_rn(p.mul_rn(t.lo, half), p.mul_rn(t.hi, half));
    p.min_f(p.max_f(m, t.lo), t.hi)
}
