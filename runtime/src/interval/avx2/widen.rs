//! Steps outward, and operations on the bits of four lanes.

use std::arch::x86_64::*;

use super::super::lanes::{RADIUS, RADIUS_STEP, TWO_THIRDS};
use super::super::{Interval, Lanes, Rounding};
use super::{Avx2, Pair};

/// φ = 2⁻⁵³(1 + 2⁻⁵²): a little more than half a unit in the last place of 1.
const PHI: f64 = f64::from_bits(((1023 - 53) << 52) | 1);
/// 2⁻¹⁰²¹: below it doubles are 2⁻¹⁰⁷⁴ apart, and |x|·φ is less than half of that.
const GUARD: f64 = f64::from_bits(2 << 52);

impl<R: Rounding> Avx2<R> {
    /// [`Lanes::decompose`] of four lanes.
    #[inline(always)]
    pub(super) fn decompose_half(self, x: __m256d) -> (__m256d, __m256d) {
        cpu!({
            let bits = _mm256_castpd_si256(x);
            let one = _mm256_set1_epi64x(1023 << 52);
            let offset = _mm256_set1_epi64x(TWO_THIRDS as i64 - (1023 << 52));
            let biased = _mm256_srli_epi64::<52>(_mm256_sub_epi64(bits, offset));
            let scale = _mm256_sub_epi64(_mm256_slli_epi64::<52>(biased), one);
            let whole =
                _mm256_castsi256_pd(_mm256_or_si256(biased, _mm256_set1_epi64x(0x4330 << 48)));
            let shift = _mm256_set1_pd(4_503_599_627_370_496.0 + 1023.0);
            (
                _mm256_castsi256_pd(_mm256_sub_epi64(bits, scale)),
                _mm256_sub_pd(whole, shift),
            )
        })
    }

    /// The bits of `a` plus `steps`: as many doubles further on, for positive numbers.
    #[inline(always)]
    pub(super) fn moved(self, a: Pair, steps: i64) -> Pair {
        cpu!({
            let steps = _mm256_set1_epi64x(steps);
            Pair(
                _mm256_castsi256_pd(_mm256_add_epi64(_mm256_castpd_si256(a.0), steps)),
                _mm256_castsi256_pd(_mm256_add_epi64(_mm256_castpd_si256(a.1), steps)),
            )
        })
    }

    /// A lower bound of a number that rounded to `x`, where the rounding was exact in subnormals (sums and roots).
    ///
    /// For normal x, |x|·φ is more than half the distance to the predecessor, so x − |x|·φ, rounded once, is at most
    /// the predecessor. For subnormal x nothing moves, and nothing need. An overflow of finite operands rounded to +∞,
    /// of which ∞ − ∞ would make a NaN: the minimum brings it down to MAX first.
    #[inline(always)]
    pub(super) fn down(self, x: Pair) -> Pair {
        if !R::ON {
            return x;
        }
        let x = self.not_above(x);
        both!(_mm256_fnmadd_pd(
            self.abs_f(x),
            self.splat(PHI * R::SCALE),
            x
        ))
    }
    /// As [`down`](Self::down), above.
    #[inline(always)]
    pub(super) fn up(self, x: Pair) -> Pair {
        if !R::ON {
            return x;
        }
        let x = self.not_below(x);
        both!(_mm256_fmadd_pd(
            self.abs_f(x),
            self.splat(PHI * R::SCALE),
            x
        ))
    }
    /// As [`down`](Self::down), also where the rounding was in subnormals (products and quotients), but for the lanes that
    /// are `exact`: see [`size`](Self::size).
    #[inline(always)]
    pub(super) fn down_guarded(self, x: Pair, exact: Pair) -> Pair {
        if !R::ON {
            return x;
        }
        let x = self.not_above(x);
        both!(_mm256_fnmadd_pd(
            self.size(self.abs_f(x), exact),
            self.splat(PHI * R::SCALE),
            x
        ))
    }
    /// As [`down_guarded`](Self::down_guarded), above.
    #[inline(always)]
    pub(super) fn up_guarded(self, x: Pair, exact: Pair) -> Pair {
        if !R::ON {
            return x;
        }
        let x = self.not_below(x);
        both!(_mm256_fmadd_pd(
            self.size(self.abs_f(x), exact),
            self.splat(PHI * R::SCALE),
            x
        ))
    }

    /// a·b of its bounds to nearest.
    #[inline(always)]
    pub(super) fn outward(
        self,
        lo: Pair,
        hi: Pair,
        a: Interval<Pair>,
        b: Interval<Pair>,
    ) -> Interval<Pair> {
        let exact = self.zeros(self.or(a.lo, a.hi), self.or(b.lo, b.hi));
        Interval {
            lo: self.down_guarded(lo, exact),
            hi: self.up_guarded(hi, exact),
        }
    }

    /// As [`down_guarded`](Self::down_guarded), of x ≥ 0 or NaN, which stays one: the predecessor, by the bits. 0 stays 0;
    /// a step below it would be subnormal, which takes many processors a hundred cycles. An overflow becomes MAX.
    #[inline(always)]
    pub(super) fn down_nonneg(self, x: Pair) -> Pair {
        if R::STEP == 0 {
            return x;
        }
        let positive = self.lt(self.splat(0.0), x);
        cpu!({
            // A true comparison is −1.
            let step = |x, positive| {
                _mm256_add_epi64(_mm256_castpd_si256(x), _mm256_castpd_si256(positive))
            };
            Pair(
                _mm256_castsi256_pd(step(x.0, positive.0)),
                _mm256_castsi256_pd(step(x.1, positive.1)),
            )
        })
    }
    /// As [`up_guarded`](Self::up_guarded), of x ≥ 0 or NaN: there is no overflow on the lower side.
    #[inline(always)]
    pub(super) fn up_nonneg(self, x: Pair, exact: Pair) -> Pair {
        if !R::ON {
            return x;
        }
        both!(_mm256_fmadd_pd(
            self.size(x, exact),
            self.splat(PHI * R::SCALE),
            x
        ))
    }

    /// An upper bound of a·b + c for a, b, c ≥ 0, of which `x` is what two roundings made: see [`RADIUS`].
    #[inline(always)]
    pub(super) fn up_radius(self, x: Pair) -> Pair {
        if !R::ON {
            return x;
        }
        let size = self.max_f(x, self.splat(RADIUS));
        both!(_mm256_fmadd_pd(size, self.splat(RADIUS_STEP * R::SCALE), x))
    }

    /// min(x, MAX). MAX is the first operand so that a NaN stays one.
    #[inline(always)]
    fn not_above(self, x: Pair) -> Pair {
        if R::GUARDED {
            both!(_mm256_min_pd(self.splat(f64::MAX), x))
        } else {
            x
        }
    }
    /// max(x, −MAX), alike.
    #[inline(always)]
    fn not_below(self, x: Pair) -> Pair {
        if R::GUARDED {
            both!(_mm256_max_pd(self.splat(f64::MIN), x))
        } else {
            x
        }
    }
    /// Where is a factor 0? The product with any number is 0, exactly.
    #[inline(always)]
    pub(super) fn zero(self, a: Pair) -> Pair {
        self.eq(a, self.splat(0.0))
    }
    /// Where is either factor 0?
    #[inline(always)]
    pub(super) fn zeros(self, a: Pair, b: Pair) -> Pair {
        self.or(self.zero(a), self.zero(b))
    }
    /// x ≥ 0 raised to 2⁻¹⁰²¹, so that a step is never less than 2⁻¹⁰⁷⁴: a bound of 0 that may have been rounded to 0
    /// moves too. A bound that is exact must not. Directions and constants make many products 0, and the smallest
    /// subnormal takes some processors a hundred cycles for each operation on it.
    #[inline(always)]
    fn size(self, x: Pair, exact: Pair) -> Pair {
        if R::GUARDED {
            self.max_f(x, self.and_not(self.splat(GUARD), exact))
        } else {
            x
        }
    }
}
