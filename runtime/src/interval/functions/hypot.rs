//! √(a² + b²) on packets, without overflow or underflow on the way.
//!
//! Both operands are multiplied by a power of two where the larger one is above 2⁵⁰⁰ or below 2⁻⁴⁵⁰, so that the larger
//! square is a normal number. Squares, sum and root are rounded outward, each of them monotone, and the root is scaled back
//! exactly (or rounded outward in subnormals). Roundings of squares and sum count half: at a point each bound is within 4u
//! of the root with directed instructions, within 6u without, relatively, u = 2⁻⁵³. That is at most 8 or 12 units wide in the
//! last place; 3 and 7 were seen.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};

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

/// A lower bound for finite a, b ≥ 0. What underflows when it is scaled down has a square that rounds down to 0.
#[inline(always)]
fn lower<P: Lanes>(p: P, a: P::F, b: P::F) -> P::F {
    let zero = p.splat(0.0);
    let (factor, inverse) = scale(p, a, b);
    let (a, b) = (p.mul_rn(a, factor), p.mul_rn(b, factor));
    let square = p.add_rd(p.mul_nonneg_rd(a, a), p.mul_nonneg_rd(b, b));
    let root = p.max_f(p.sqrt_rd(p.max_f(square, zero)), zero);
    // The product may overflow, or round up in subnormals. Multiplied back it is exact.
    let bound = p.mul_rn(root, inverse);
    p.select(p.lt(root, p.mul_rn(bound, factor)), p.before(bound), bound)
}

/// An upper bound for a, b ≥ 0.
#[inline(always)]
fn upper<P: Lanes>(p: P, a: P::F, b: P::F) -> P::F {
    let (factor, inverse) = scale(p, a, b);
    // What underflows when it is scaled down is replaced by something larger.
    let least = p.splat(power(-1000));
    let a = p.max_f(p.mul_rn(a, factor), p.min_f(a, least));
    let b = p.max_f(p.mul_rn(b, factor), p.min_f(b, least));
    let root = p.sqrt_ru(p.add_ru(p.mul_nonneg_ru(a, a), p.mul_nonneg_ru(b, b)));
    let bound = p.mul_rn(root, inverse);
    p.select(p.lt(p.mul_rn(bound, factor), root), p.after(bound), bound)
}
