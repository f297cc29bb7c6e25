//! Sums of many small intervals.

use crate::interval::{Arithmetic, Interval, Scalar};

/// A sum of intervals in plain floats: there are many, and they are small.
#[derive(Clone, Copy, Default)]
pub(super) struct Sum {
    lo: f64,
    hi: f64,
    /// The sum of magnitudes.
    size: f64,
    count: u32,
}

impl Sum {
    #[inline(always)]
    pub fn add(&mut self, lo: f64, hi: f64) {
        self.lo += lo;
        self.hi += hi;
        self.size += lo.abs().max(hi.abs());
        self.count += 1;
    }

    /// The sum and another interval. Adding n numbers up loses less than nu of the sum of their magnitudes, u = 2⁻⁵³, and
    /// nothing to underflow; twice that and more covers the roundings of the bound.
    pub fn beside(&self, other: Interval) -> Interval {
        if self.count == 0 {
            return other;
        }
        let lost = self.size * (f64::from(self.count) + 2.0) * f64::EPSILON + f64::MIN_POSITIVE;
        if !lost.is_finite() {
            return Interval {
                lo: f64::NEG_INFINITY,
                hi: f64::INFINITY,
            };
        }
        let lost = Interval {
            lo: -lost,
            hi: lost,
        };
        let (lo, hi) = (self.lo, self.hi);
        Scalar.add(Scalar.add(Interval { lo, hi }, lost), other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 and 1,024 numbers of a quarter of an ulp each: in plain floats they are 1.
    #[test]
    fn what_plain_sums_lose_is_in_their_bounds() {
        let small = 0.25 * f64::EPSILON;
        let mut sum = Sum::default();
        sum.add(1.0, 1.0);
        (0..1024).for_each(|_| sum.add(small, small));
        let exact = 1.0 + 1024.0 * small;
        assert!(sum.lo < exact, "the control: nothing is lost");
        let nothing = Interval { lo: 0.0, hi: 0.0 };
        let bounds = sum.beside(nothing);
        assert!(
            bounds.contains(exact) && bounds.width() < 1e-12,
            "{bounds:?}"
        );
        sum.add(f64::MAX, f64::MAX);
        sum.add(-f64::MAX, f64::MAX);
        let bounds = sum.beside(nothing);
        assert!(bounds.lo == f64::NEG_INFINITY && bounds.hi == f64::INFINITY);
    }
}
