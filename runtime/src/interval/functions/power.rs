//! Whole powers.

use super::super::Interval;
use super::super::enclose::Enclose;

/// aⁿ. Even powers are the power of |a|, monotone in its bounds; odd powers are monotone in those of a.
#[inline(always)]
pub fn powi<P: Enclose>(p: P, a: Interval<P::F>, n: u32) -> Interval<P::F> {
    match n {
        0 => Interval {
            lo: p.splat(1.0),
            hi: p.splat(1.0),
        },
        1 => a,
        2 => p.i_sqr(a),
        _ if n.is_multiple_of(2) => {
            let m = p.i_abs(a);
            Interval {
                lo: of_nonneg(p, m.lo, n).lo,
                hi: of_nonneg(p, m.hi, n).hi,
            }
        }
        _ => {
            let zero = p.splat(0.0);
            let lo = of_nonneg(p, p.abs_f(a.lo), n);
            let hi = of_nonneg(p, p.abs_f(a.hi), n);
            Interval {
                lo: p.select(p.lt(a.lo, zero), p.neg_f(lo.hi), lo.lo),
                hi: p.select(p.le(a.hi, zero), p.neg_f(hi.lo), hi.hi),
            }
        }
    }
}

/// Bounds of xⁿ for x ≥ 0 and n ≥ 1 by repeated squaring, from the highest bit of n down. All factors are ≥ 0, so
/// rounding each product down (up) bounds the power from below (above).
#[inline(always)]
fn of_nonneg<P: Enclose>(p: P, x: P::F, n: u32) -> Interval<P::F> {
    let (mut lo, mut hi) = (x, x);
    let mut bit = (31 - n.leading_zeros()) as i32 - 1;
    while bit >= 0 {
        lo = p.mul_nonneg_rd(lo, lo);
        hi = p.mul_nonneg_ru(hi, hi);
        if (n >> bit) & 1 == 1 {
            lo = p.mul_nonneg_rd(lo, x);
            hi = p.mul_nonneg_ru(hi, x);
        }
        bit -= 1;
    }
    Interval { lo, hi }
}
