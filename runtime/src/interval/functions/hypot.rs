//! √(a² + b²) on packets, without overflow or underflow on the way.
//!
//! Both operands are multiplied by a power of two where the larger one is above 2⁵⁰⁰ or below 2⁻⁴⁵⁰, so that the larger
//! square is a normal number, and the root is multiplied back. With directed instructions each operation rounds outward.
//! Otherwise all round to nearest, and one step outward follows: the squares and the sum err by u = 2⁻⁵³ each, which is
//! u together in the root, and the root by another u; what underflows is below 2⁻¹⁷⁰ of the sum. At a point each bound is
//! within 2u of the root with directed instructions, within 5u without, relatively (2u + the step of 3u): at most 4 or 10
//! units wide in the last place.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::outward::{above, below};

/// 2ⁿ
const fn power(n: i32) -> f64 {
    f64::from_bits(((1023 + n) as u64) << 52)
}

/// √(a² + b²)
#[inline(always)]
pub fn hypot<P: Enclose>(p: P, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
    let (a, b) = (p.i_abs(a), p.i_abs(b));
    Interval {
        lo: lower(p, a.lo, b.lo),
        hi: upper(p, a.hi, b.hi),
    }
}

/// The factor, and its inverse.
#[inline(always)]
fn scale<P: Lanes>(p: P, a: P::F, b: P::F) -> (P::F, P::F) {
    let size = p.max_f(a, b);
    let large = p.lt(p.splat(power(500)), size);
    let small = p.lt(size, p.splat(power(-450)));
    let one = p.splat(1.0);
    let (up, down) = (p.splat(power(600)), p.splat(power(-600)));
    (
        p.select(large, down, p.select(small, up, one)),
        p.select(large, up, p.select(small, down, one)),
    )
}

/// A lower bound for finite a, b ≥ 0.
#[inline(always)]
fn lower<P: Lanes>(p: P, a: P::F, b: P::F) -> P::F {
    if !P::OPTIMAL {
        return below(p, nearest(p, a, b), 2);
    }
    let (factor, inverse) = scale(p, a, b);
    let (a, b) = (p.mul_rd(a, factor), p.mul_rd(b, factor));
    let root = p.sqrt_rd(p.fma_rd(a, a, p.mul_rd(b, b)));
    p.mul_rd(root, inverse)
}

/// An upper bound for a, b ≥ 0.
#[inline(always)]
fn upper<P: Lanes>(p: P, a: P::F, b: P::F) -> P::F {
    if !P::OPTIMAL {
        return above(p, nearest(p, a, b), 2);
    }
    let (factor, inverse) = scale(p, a, b);
    let (a, b) = (p.mul_ru(a, factor), p.mul_ru(b, factor));
    let root = p.sqrt_ru(p.fma_ru(a, a, p.mul_ru(b, b)));
    p.mul_ru(root, inverse)
}

/// To nearest, for a, b ≥ 0.
#[inline(always)]
fn nearest<P: Lanes>(p: P, a: P::F, b: P::F) -> P::F {
    let (factor, inverse) = scale(p, a, b);
    let (a, b) = (p.mul_rn(a, factor), p.mul_rn(b, factor));
    let root = p.sqrt_rn(p.fma_rn(a, a, p.mul_rn(b, b)));
    p.mul_rn(root, inverse)
}
