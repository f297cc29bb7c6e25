//! One interval of `f64`: the form in which constants and results are handed about.

use super::Interval;

/// Why two numbers are not the bounds of an interval.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "[{lo}, {hi}] is not an interval: bounds must be numbers with lo ≤ hi, lo < +∞ and hi > −∞"
)]
pub struct IntervalError {
    /// The lower bound as given.
    pub lo: f64,
    /// The upper bound as given.
    pub hi: f64,
}

impl Interval<f64> {
    /// The real line.
    pub const ENTIRE: Interval = Interval {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
    };
    /// Just 0.
    pub const ZERO: Interval = Interval { lo: 0.0, hi: 0.0 };
    /// Just 1.
    pub const ONE: Interval = Interval { lo: 1.0, hi: 1.0 };

    /// [lo, hi].
    ///
    /// # Errors
    /// If a bound is NaN, `lo > hi`, `lo` is +∞ or `hi` is −∞.
    pub fn try_new(lo: f64, hi: f64) -> Result<Interval, IntervalError> {
        // A NaN fails the first comparison.
        if lo <= hi && lo < f64::INFINITY && hi > f64::NEG_INFINITY {
            Ok(Interval { lo, hi })
        } else {
            Err(IntervalError { lo, hi })
        }
    }

    /// [lo, hi].
    ///
    /// # Panics
    /// Where [`try_new`](Self::try_new) returns an error.
    #[track_caller]
    pub fn new(lo: f64, hi: f64) -> Interval {
        match Self::try_new(lo, hi) {
            Ok(interval) => interval,
            Err(error) => panic!("{error}"),
        }
    }

    /// [x, x].
    ///
    /// # Panics
    /// If `x` is NaN or infinite.
    #[track_caller]
    #[inline]
    pub fn point(x: f64) -> Interval {
        Self::new(x, x)
    }

    /// Is `x` in the interval? NaN is in none; an infinite bound contains the infinity.
    pub fn contains(&self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// Is every point of `other` in this interval?
    pub fn encloses(&self, other: &Interval) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// hi − lo, rounded up; +∞ for an unbounded interval.
    pub fn width(&self) -> f64 {
        use super::{Lanes, Scalar};
        Scalar.sub_ru(self.hi, self.lo)
    }

    /// A finite number in the interval, near the middle if both bounds are finite.
    #[inline]
    pub fn mid(&self) -> f64 {
        match (self.lo.is_finite(), self.hi.is_finite()) {
            // Halves first: the sum of the bounds may overflow. The clamp mends the rounding of subnormals.
            (true, true) => (0.5 * self.lo + 0.5 * self.hi).clamp(self.lo, self.hi),
            (true, false) => f64::MAX.max(self.lo),
            (false, true) => f64::MIN.min(self.hi),
            (false, false) => 0.0,
        }
    }

    /// The smallest interval that contains both.
    pub fn hull(&self, other: &Interval) -> Interval {
        Interval {
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
        }
    }

    /// What both contain, if anything.
    pub fn intersect(&self, other: &Interval) -> Option<Interval> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Interval { lo, hi })
    }
}

impl std::fmt::Display for Interval<f64> {
    /// `[lo, hi]`, each bound with as many digits as identify it.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let bound = |f: &mut std::fmt::Formatter<'_>, x: f64| match f.precision() {
            Some(digits) => write!(f, "{x:.digits$}"),
            None => write!(f, "{x:?}"),
        };
        f.write_str("[")?;
        bound(f, self.lo)?;
        f.write_str(", ")?;
        bound(f, self.hi)?;
        f.write_str("]")
    }
}
