//! The inclusions of the arithmetic operations, written once over [`Lanes`].

use super::functions;
use super::{Interval, Lanes};

/// Interval operations that a back-end may do better than the provided code, which is sound over any `Lanes`.
///
/// Names start with `i_` so that they do not collide with those of [`Arithmetic`](super::Arithmetic), whose
/// implementation for packets forwards to them. Operands obey the invariants of [`Interval`]; so do results.
pub trait Enclose: Lanes {
    /// a + b. The invariants lo < +∞ and hi > −∞ rule out ∞ − ∞.
    #[inline(always)]
    fn i_add(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        Interval {
            lo: self.add_rd(a.lo, b.lo),
            hi: self.add_ru(a.hi, b.hi),
        }
    }

    /// a − b
    #[inline(always)]
    fn i_sub(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        Interval {
            lo: self.sub_rd(a.lo, b.hi),
            hi: self.sub_ru(a.hi, b.lo),
        }
    }

    /// a·b: the least and the greatest of the products of bounds.
    ///
    /// A product 0·∞ is NaN and means 0. `min_f` and `max_f` drop a NaN in the *first* operand; that is right, because
    /// where one of the four is NaN either another one is 0 or beyond it, or all four are NaN. The last of the chain is
    /// mended, which settles the case that all are.
    #[inline(always)]
    fn i_mul(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        let p = self;
        let lo = p.mend(p.mul_rd(a.hi, b.hi));
        let lo = p.min_f(p.mul_rd(a.hi, b.lo), lo);
        let lo = p.min_f(p.mul_rd(a.lo, b.hi), lo);
        let lo = p.min_f(p.mul_rd(a.lo, b.lo), lo);
        let hi = p.mend(p.mul_ru(a.hi, b.hi));
        let hi = p.max_f(p.mul_ru(a.hi, b.lo), hi);
        let hi = p.max_f(p.mul_ru(a.lo, b.hi), hi);
        let hi = p.max_f(p.mul_ru(a.lo, b.lo), hi);
        Interval { lo, hi }
    }

    /// a·b for a ≥ 0: `lo` is a.lo·b.lo, or a.hi·b.lo where b.lo < 0; `hi` alike.
    ///
    /// NaN comes only from 0·∞ in the second of the two, or from a.lo = 0 in the first, which is then dropped.
    #[inline(always)]
    fn i_mul_pos(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        let p = self;
        Interval {
            lo: p.min_f(p.mul_rd(a.lo, b.lo), p.mend(p.mul_rd(a.hi, b.lo))),
            hi: p.max_f(p.mul_ru(a.lo, b.hi), p.mend(p.mul_ru(a.hi, b.hi))),
        }
    }

    /// a·b for a, b ≥ 0.
    #[inline(always)]
    fn i_mul_pos_pos(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        Interval {
            lo: self.mul_nonneg_rd(a.lo, b.lo),
            hi: self.mul_nonneg_ru(a.hi, b.hi),
        }
    }

    /// a²
    #[inline(always)]
    fn i_sqr(self, a: Interval<Self::F>) -> Interval<Self::F> {
        let m = self.i_abs(a);
        Interval {
            lo: self.mul_nonneg_rd(m.lo, m.lo),
            hi: self.mul_nonneg_ru(m.hi, m.hi),
        }
    }

    /// |a| = [max(lo, −hi, 0), max(−lo, hi)]
    #[inline(always)]
    fn i_abs(self, a: Interval<Self::F>) -> Interval<Self::F> {
        let p = self;
        Interval {
            lo: p.max_f(p.max_f(a.lo, p.neg_f(a.hi)), p.splat(0.0)),
            hi: p.max_f(p.neg_f(a.lo), a.hi),
        }
    }

    /// a/b over b ≠ 0. The whole line where 0 is inside b, and where b = [0, 0] (then there is no value at all).
    ///
    /// Where b ≤ 0 both are negated. Then with b ≥ 0 the extreme quotients are known by the signs of a's bounds, and
    /// two divisions do. A zero lower bound of b must be +0, for x/−0 has the wrong sign.
    #[inline(always)]
    fn i_div(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        let p = self;
        let zero = p.splat(0.0);
        let flip = p.le(b.hi, zero);
        let num_lo = p.select(flip, p.neg_f(a.hi), a.lo);
        let num_hi = p.select(flip, p.neg_f(a.lo), a.hi);
        let den_lo = p.abs_f(p.select(flip, b.hi, b.lo));
        let den_hi = p.select(flip, p.neg_f(b.lo), b.hi);
        let lo = p.div_rd(num_lo, p.select(p.lt(num_lo, zero), den_lo, den_hi));
        // 0/0 here is the upper bound of [x, 0]/(0, d], which is 0. With b = [0, 0] both bounds are set below.
        let hi = p.mend(p.div_ru(num_hi, p.select(p.lt(num_hi, zero), den_hi, den_lo)));
        // Widening must not cost the sign of a quotient that has one.
        let (lo, hi) = if Self::OPTIMAL {
            (lo, hi)
        } else {
            (
                p.select(p.lt(num_lo, zero), lo, p.max_f(lo, zero)),
                p.select(p.lt(zero, num_hi), hi, p.min_f(hi, zero)),
            )
        };
        let inside = p.and(p.lt(b.lo, zero), p.lt(zero, b.hi));
        let none = p.and(p.eq(b.lo, zero), p.eq(b.hi, zero));
        let line = p.or(inside, none);
        Interval {
            lo: p.select(line, p.splat(f64::NEG_INFINITY), lo),
            hi: p.select(line, p.splat(f64::INFINITY), hi),
        }
    }

    /// 1/a over a ≠ 0: [1/hi, 1/lo], a bound that is 0 standing for the infinity on its side.
    #[inline(always)]
    fn i_recip(self, a: Interval<Self::F>) -> Interval<Self::F> {
        let p = self;
        let (zero, one) = (p.splat(0.0), p.splat(1.0));
        let inside = p.and(p.lt(a.lo, zero), p.lt(zero, a.hi));
        let low = p.or(inside, p.eq(a.hi, zero));
        let high = p.or(inside, p.eq(a.lo, zero));
        let (lo, hi) = (p.div_rd(one, a.hi), p.div_ru(one, a.lo));
        let (lo, hi) = if Self::OPTIMAL {
            (lo, hi)
        } else {
            (
                p.select(p.lt(a.lo, zero), lo, p.max_f(lo, zero)),
                p.select(p.lt(zero, a.hi), hi, p.min_f(hi, zero)),
            )
        };
        Interval {
            lo: p.select(low, p.splat(f64::NEG_INFINITY), lo),
            hi: p.select(high, p.splat(f64::INFINITY), hi),
        }
    }

    /// √a over a ≥ 0; [0, 0] where a < 0 throughout.
    #[inline(always)]
    fn i_sqrt(self, a: Interval<Self::F>) -> Interval<Self::F> {
        let p = self;
        let zero = p.splat(0.0);
        Interval {
            lo: p.max_f(p.sqrt_rd(p.max_f(a.lo, zero)), zero),
            hi: p.sqrt_ru(p.max_f(a.hi, zero)),
        }
    }

    /// aⁿ: for even n the power of |a|, for odd n each bound's own power.
    #[inline(always)]
    fn i_powi(self, a: Interval<Self::F>, n: u32) -> Interval<Self::F> {
        functions::power::powi(self, a, n)
    }

    /// eᵃ
    #[inline(always)]
    fn i_exp(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::exp::exp(self, a)
    }

    /// sin a
    #[inline(always)]
    fn i_sin(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::circular::sin(self, a)
    }

    /// cos a
    #[inline(always)]
    fn i_cos(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::circular::cos(self, a)
    }

    /// sin a and cos a
    #[inline(always)]
    fn i_sin_cos(self, a: Interval<Self::F>) -> [Interval<Self::F>; 2] {
        functions::circular::sin_cos(self, a)
    }

    /// arctan a
    #[inline(always)]
    fn i_atan(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::arctangent::atan(self, a)
    }

    /// arcsin a over [−1, 1]
    #[inline(always)]
    fn i_asin(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::arcsine::asin(self, a)
    }

    /// arccos a over [−1, 1]
    #[inline(always)]
    fn i_acos(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::arcsine::acos(self, a)
    }

    /// ∛a
    #[inline(always)]
    fn i_cbrt(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::cbrt::cbrt(self, a)
    }

    /// tan a; the line across a pole
    #[inline(always)]
    fn i_tan(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::tangent::tan(self, a)
    }

    /// The angles of (x, y) over the box, but for the origin
    #[inline(always)]
    fn i_atan2(self, y: Interval<Self::F>, x: Interval<Self::F>) -> Interval<Self::F> {
        functions::angle::atan2(self, y, x)
    }

    /// √(a² + b²)
    #[inline(always)]
    fn i_hypot(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        functions::hypot::hypot(self, a, b)
    }

    /// ln a over a > 0; the line where there is no such number
    #[inline(always)]
    fn i_ln(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::ln::ln(self, a)
    }

    /// eᵃ − 1
    #[inline(always)]
    fn i_exp_m1(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::hyperbolic::exp_m1(self, a)
    }

    /// sinh a
    #[inline(always)]
    fn i_sinh(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::hyperbolic::sinh(self, a)
    }

    /// tanh a
    #[inline(always)]
    fn i_tanh(self, a: Interval<Self::F>) -> Interval<Self::F> {
        functions::hyperbolic::tanh(self, a)
    }
}
