//! ln x on packets: a reduction to [2/3, 4/3), one division, one polynomial, proved.
//!
//! x = 2ᵉ·m with m ∈ [2/3, 4/3), f = m − 1 (exact), s = f/(2 + f), z = s². Then
//! ln(1 + f) = f − f²/2 + t with t = s·(f²/2 + z·p(z)), p of degree 7 by Sollya's `fpminimax` (relative error of the
//! whole 2⁻⁶²·⁶), and ln x = e·ln 2 + ln(1 + f). In doubles, with ln 2 = L1 + L2 as in `exp` and q + q′ = f² exactly,
//!
//! * a + b = e·L1 + f exactly (e·L1 is exact, and e = 0 or |e·L1| > |f|),
//! * v = a + ((t + (e·L2 + b − q′/2)) − q/2).
//!
//! Errors in units of u = 2⁻⁵³, besides the last sum's half unit in the last place (`runtime/proofs/ln_*.g`): of t
//! relative 6.5 for f > 0 and 5.5 for f < 0 (9.1 without fused operations); of the difference before the last sum
//! |ln(1 + f) − f|. At f = 1/3 that is 0.33·|f|, at f = −1/3 it is 0.49·|f|; towards 0 both terms fall faster than |f|.
//!
//! * e = 0: half a unit in the last place of v is at least u·|v|/2, which is 0.43·u·|f| for f > 0 and 0.5·u·|f| for f < 0:
//!   v errs by less than one unit. Where |v| is a power of two, its neighbour towards 0 is u·|v| away, the last sum errs
//!   by u·|v|/2 at most, and the rest by less than that.
//! * e ≠ 0: |v| > 0.28, half a unit is at least u/4, and the errors are below 0.17·u.
//!
//! Without fused operations they less than double, and two neighbours on each side are taken.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::neighbours::around;
use super::two_fold::two_product;

/// p, from the constant coefficient on.
const COEFFICIENTS: [u64; 8] = [
    0x3fe555555555554f,
    0x3fd999999999c15b,
    0x3fd24924921e6fe5,
    0x3fcc71c748ce6f3f,
    0x3fc745c4b977115f,
    0x3fc3b35a76777094,
    0x3fc0dcd50a6c0f7c,
    0x3fc1b75928799d54,
];
/// ln 2 to 42 bits, and the rest.
pub const L1: u64 = 0x3fe62e42fefa3800;
pub const L2: u64 = 0x3d2ef35793c76730;

/// ln a over a > 0; the line where there is no such number.
#[inline(always)]
pub fn ln<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let zero = p.splat(0.0);
    let infinity = p.splat(f64::INFINITY);
    let minus = p.splat(f64::NEG_INFINITY);
    let steps = if P::FUSED { 1 } else { 2 };
    let low = around(p, near(p, a.lo), steps);
    let high = around(p, near(p, a.hi), steps);
    // Where a.hi ≤ 0 there is no value; an infinite bound has an infinite logarithm.
    let unbounded = p.or(p.le(a.hi, zero), p.eq(a.hi, infinity));
    Interval {
        lo: p.select(p.le(a.lo, zero), minus, low.lo),
        hi: p.select(unbounded, infinity, high.hi),
    }
}

/// ln x approximately, for every x: −∞ at 0, NaN below and of NaN.
#[inline(always)]
pub fn anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let (zero, infinity) = (p.splat(0.0), p.splat(f64::INFINITY));
    let y = p.select(p.lt(zero, x), near(p, x), p.splat(f64::NAN));
    let y = p.select(p.eq(x, infinity), infinity, y);
    p.select(p.eq(x, zero), p.splat(f64::NEG_INFINITY), y)
}

/// ln x to within a unit in the last place (two without fused operations), for finite x > 0.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F) -> P::F {
    // Subnormal numbers have no exponent of their own.
    let small = p.lt(x, p.splat(f64::MIN_POSITIVE));
    let x = p.select(small, p.mul_rn(x, p.splat(18_014_398_509_481_984.0)), x);
    let (m, e) = p.decompose(x);
    let e = p.select(small, p.sub_rn(e, p.splat(54.0)), e);

    let f = p.sub_rn(m, p.splat(1.0));
    let s = p.div_rn(f, p.add_rn(p.splat(2.0), f));
    let z = p.mul_rn(s, s);
    let mut poly = p.splat(f64::from_bits(COEFFICIENTS[7]));
    let mut i = 7;
    while i > 0 {
        i -= 1;
        poly = p.fma_rn(z, poly, p.splat(f64::from_bits(COEFFICIENTS[i])));
    }
    let (q, rest) = two_product(p, f, f);
    let half = p.splat(0.5);
    let h = p.mul_rn(half, q);
    let big = p.mul_rn(e, p.splat(f64::from_bits(L1)));
    let a = p.add_rn(big, f);
    let b = p.sub_rn(f, p.sub_rn(a, big));
    let small = p.fma_rn(e, p.splat(f64::from_bits(L2)), b);
    let small = p.sub_rn(small, p.mul_rn(half, rest));
    let t = p.fma_rn(s, p.fma_rn(z, poly, h), small);
    p.add_rn(a, p.sub_rn(t, h))
}
