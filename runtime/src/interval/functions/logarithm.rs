//! The logarithm of a two-fold number as a two-fold number: for powers, ln(1 + x) and the inverse hyperbolic functions.
//!
//! x = 2ᵉ·(m + m′) with m ∈ [2/3, 4/3), |m′| ≤ u, u = 2⁻⁵³; f + f′ = m + m′ − 1, s = (f + f′)/(2 + f + f′), |s| ≤ 0.2001,
//! z = s². Then ln x = e·ln 2 + s·(2 + A), A = ⅔·z + z²·p(z), p of degree 7 by Sollya's `fpminimax`; the sum errs by
//! 2⁻⁶⁹ relatively (`runtime/proofs/logarithm.sollya`). In doubles every number is a pair, but for p:
//!
//! * s + s′, |s′| < 4.5u·|s|, by [`quotient`]: to 2⁻¹⁰⁰ relatively (the divisor's second part is up to 1.2u of the first).
//! * z + z′ and a + a′ near A, with first-order terms of s′. Gappa proves |a + a′ − A| < 1.7·10⁻¹⁹ with fused operations
//!   and < 2.26·10⁻¹⁹ without (`logarithm.g`), but for what it leaves out: the square of s′, and s′ in the terms of z³ and
//!   above, together below 2.5·10⁻²⁰.
//! * s·(2 + A): the product s·a is exact, the rest below 10u·|s| and rounded at most eight times.
//! * e·ln 2 as in [`ln`](super::ln): e·L1 is exact, and e = 0 or |e·L1| > 0.69 > |ln(m + m′)|.
//!
//! So the result errs by |s|·1.95·10⁻¹⁹ with fused operations, by |s|·2.51·10⁻¹⁹ without, and by 2⁻⁶⁹ and a few 2⁻⁹⁹
//! relatively. If e = 0, |s| ≤ |ln x|/2; else |ln x| > 0.2876 > 1.437·|s|. Together **the relative error is less than
//! 1.4·10⁻¹⁹, without fused operations 1.82·10⁻¹⁹**: 2⁻⁶²·⁶ and 2⁻⁶²·². It is relative near x = 1 too, where s is as small as
//! ln x.

use super::super::Lanes;
use super::ln::{L1, L2};
use super::two_fold::{Sum, fast_two_sum, quotient, two_product};

/// ⅔ in two parts, then p from the constant coefficient on.
const COEFFICIENTS: [u64; 10] = [
    0x3fe5555555555555,
    0x3c85555555555555,
    0x3fd9999999999968,
    0x3fd2492492498d52,
    0x3fcc71c71bc74e2e,
    0x3fc745d1bc4529ae,
    0x3fc3b1298b92491e,
    0x3fc113a108f0f870,
    0x3fbdad1294cd100e,
    0x3fc017bae1e02fd1,
];

/// ln(2ᵉ·(m + m′)), the second part at most half a unit in the last place of the first; 0 + 0 for 1.
#[inline(always)]
pub fn near<P: Lanes>(p: P, m: Sum<P::F>, e: P::F) -> Sum<P::F> {
    let two = p.splat(2.0);
    // f = 0 or |f| ≥ |m′|.
    let f = fast_two_sum(p, p.sub_rn(m.high, p.splat(1.0)), m.low);
    let d = fast_two_sum(p, two, f.high);
    let low = p.add_rn(d.low, f.low);
    let s = quotient(p, f, Sum { low, ..d });
    let a = tail(p, s);

    // s·(2 + A)
    let (product, low) = two_product(p, s.high, a.high);
    let low = p.fma_rn(s.low, p.add_rn(two, a.high), low);
    let low = p.fma_rn(s.high, a.low, low);
    let sum = fast_two_sum(p, p.add_rn(s.high, s.high), product);
    let low = p.add_rn(sum.low, low);

    let whole = p.mul_rn(e, p.splat(f64::from_bits(L1)));
    let low = p.fma_rn(e, p.splat(f64::from_bits(L2)), low);
    let sum = fast_two_sum(p, whole, sum.high);
    fast_two_sum(p, sum.high, p.add_rn(sum.low, low))
}

/// A = ⅔·z + z²·p(z), z = s².
#[inline(always)]
fn tail<P: Lanes>(p: P, s: Sum<P::F>) -> Sum<P::F> {
    let (z, z1) = two_product(p, s.high, s.high);
    let z1 = p.fma_rn(p.add_rn(s.high, s.high), s.low, z1);
    let mut w = constant(p, 9);
    let mut i = 9;
    while i > 2 {
        i -= 1;
        w = p.fma_rn(z, w, constant(p, i));
    }
    let w = p.mul_rn(z, w);
    let (a, a1) = two_product(p, z, constant(p, 0));
    let a1 = p.fma_rn(z, constant(p, 1), a1);
    // The slope of A, times what z lacks.
    let slope = p.add_rn(w, p.add_rn(w, constant(p, 0)));
    let a1 = p.fma_rn(z1, slope, a1);
    fast_two_sum(p, a, p.fma_rn(z, w, a1))
}

#[inline(always)]
fn constant<P: Lanes>(p: P, i: usize) -> P::F {
    p.splat(f64::from_bits(COEFFICIENTS[i]))
}
