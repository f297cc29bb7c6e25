//! sin and cos on packets: a reduction by π/2, two polynomials, proved; extrema counted exactly.
//!
//! With k = ⌊x·2/π⌉, x = k·π/2 + (r + ρ), |r| ≤ 0.7855, |ρ| ≤ ulp(r)/2 (see [`reduce`]). For r ≥ 0 in doubles,
//!
//! * sin: v = r + (r·t + ρ′), t = r²·s(r²), ρ′ = ρ·(1 − r²/2);
//! * cos: v = w + d, w = 1 − r²/2, d = r⁴·c(r²) + (((1 − w) − r²/2) − r·ρ).
//!
//! Errors, besides half a unit of the last sum (`runtime/proofs`: `sincos.sollya`, `sin_*.g`, `cos_*.g`), u = 2⁻⁵³:
//!
//! * sin, as multiples of u·r: 0.28 of t (0.32 without fused operations), 0.104 for rounding r·t + ρ′ with
//!   |t| ≤ 0.104 (twice that without fused operations), 0.035 of the polynomial, 0.017 of ρ′ for ρ·cos r. Together below
//!   0.45 with fused operations, below 0.6 without. A unit in the last place of v is at least u·v ≥ 0.9·u·r, so v errs by
//!   less than one unit with fused operations and less than two without. Where v is a power of two, the neighbour below
//!   is only u·v away, and then the last sum errs by half of that at most.
//! * cos, as multiples of u: 0.33 of the sum before its last rounding, 0.04 of r·ρ for ρ·sin r, 0.001 of the polynomial;
//!   doubles in [½, 1] are u apart, so v errs by less than one unit.
//!
//! So the neighbours of v (the second neighbours without fused operations) enclose a point. The proofs are for the
//! quarter-wave; signs and the swap of sin and cos are exact.

use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes};
use super::remainder::{Reduced, reduce};
use super::two_fold::Sum;

/// s, from the constant coefficient on.
const S: [u64; 6] = [
    0xbfc5555555555549,
    0x3f8111111110f8a5,
    0xbf2a01a019c15d7d,
    0x3ec71de357ac8440,
    0xbe5ae5e684b6c3b1,
    0x3de5d93879cc78c5,
];
/// c, from the constant coefficient on.
const C: [u64; 6] = [
    0x3fa555555555554c,
    0xbf56c16c16c15221,
    0x3efa01a019cbfa22,
    0xbe927e4f812e2833,
    0x3e21ee9f16b96c82,
    0xbda8fb13a797c552,
];

/// Lower and upper bounds at one point per lane, and n + [`WHOLE`], n being the number of odd multiples of π/2 below it
/// (up to a constant that is a multiple of 4). Between a and b lie n(b) − n(a) of them: extrema of the sine, poles of the
/// tangent.
struct Point<P: Lanes> {
    value: Interval<P::F>,
    n: P::F,
}

/// sin a
#[inline(always)]
pub fn sin<P: Lanes>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    wave(p, a, 0.0)
}

/// cos a = sin(a + π/2)
#[inline(always)]
pub fn cos<P: Lanes>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    wave(p, a, 1.0)
}

/// The sine of a + `quarters`·π/2.
#[inline(always)]
fn wave<P: Lanes>(p: P, a: Interval<P::F>, quarters: f64) -> Interval<P::F> {
    let start = sine_at(p, a.lo, quarters);
    let end = sine_at(p, a.hi, quarters);
    // How many extrema lie between, modulo 4: never more than 2 unless the segment is about a period wide or wider.
    let count = p.add_rn(p.sub_rn(end.n, start.n), p.splat(WHOLE));
    let wide = p.le(p.splat(6.25), p.sub_ru(a.hi, a.lo));
    let both = p.or(wide, p.bit::<1>(count));
    let single = p.and_not(p.bit::<0>(count), p.bit::<1>(count));
    // The last extremum before b is a maximum if its number is odd: the first one above 0 is π/2.
    let odd = p.bit::<0>(end.n);
    let has_max = p.or(both, p.and(single, odd));
    let has_min = p.or(both, p.and_not(single, odd));
    let (one, minus) = (p.splat(1.0), p.splat(-1.0));
    Interval {
        lo: p.select(has_min, minus, p.min_f(start.value.lo, end.value.lo)),
        hi: p.select(has_max, one, p.max_f(start.value.hi, end.value.hi)),
    }
}

/// The sine of x + `quarters`·π/2 to a few units in the last place; NaN of NaN.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F, quarters: f64) -> P::F {
    p.select(p.eq(x, x), sine_at(p, x, quarters).value.lo, x)
}

/// n + [`WHOLE`] for x = k·π/2 + r: n = ⌊k/2⌋, and one more if k is odd and r ≥ 0.
/// To the nearest whole number k/2 − ¼ is ⌊k/2⌋ ± ¼, k/2 + ¼ is ⌊(k + 1)/2⌋ ± ¼.
#[inline(always)]
pub fn odd_multiples_below<P: Lanes>(p: P, k: P::F, negative: P::M) -> P::F {
    let quarter = p.select(negative, p.splat(-0.25), p.splat(0.25));
    p.add_rn(p.fma_rn(k, p.splat(0.5), quarter), p.splat(WHOLE))
}

/// The sine of x + `quarters`·π/2.
#[inline(always)]
fn sine_at<P: Lanes>(p: P, x: P::F, quarters: f64) -> Point<P> {
    let reduced = reduce(p, x);
    let k = p.add_rn(reduced.k, p.splat(quarters));
    let negative = p.lt(reduced.r, p.splat(0.0));
    let shifted = p.add_rn(k, p.splat(WHOLE));
    let (cosine, back) = (p.bit::<0>(shifted), p.bit::<1>(shifted));
    let (s, c) = quarter_wave(p, reduced, negative);
    let (s, c) = (p.add_rn(s.high, s.low), p.add_rn(c.high, c.low));
    let m = p.select(cosine, c, s);
    // sin(r) is odd, cos(r) even.
    let flip = exclusive(p, back, p.and_not(negative, cosine));
    Point {
        value: signed(p, around(p, m), flip),
        n: odd_multiples_below(p, k, negative),
    }
}

/// sin |r + ρ| = r + (r·t + ρ′) and cos(r + ρ) = w + d, before their last sums.
#[inline(always)]
pub fn quarter_wave<P: Lanes>(
    p: P,
    reduced: Reduced<P::F>,
    negative: P::M,
) -> (Sum<P::F>, Sum<P::F>) {
    let r = p.abs_f(reduced.r);
    let rho = p.select(negative, p.neg_f(reduced.rho), reduced.rho);
    let z = p.mul_rn(r, r);
    let h = p.mul_rn(z, p.splat(0.5));
    let t = p.mul_rn(z, horner(p, z, S));
    let tail = p.sub_rn(rho, p.mul_rn(rho, h));
    let sine = Sum {
        high: r,
        low: p.fma_rn(t, r, tail),
    };
    let one = p.splat(1.0);
    let w = p.sub_rn(one, h);
    let rest = p.sub_rn(p.sub_rn(p.sub_rn(one, w), h), p.mul_rn(r, rho));
    let cosine = Sum {
        high: w,
        low: p.fma_rn(p.mul_rn(z, z), horner(p, z, C), rest),
    };
    (sine, cosine)
}

#[inline(always)]
fn horner<P: Lanes>(p: P, z: P::F, coefficients: [u64; 6]) -> P::F {
    let mut q = p.splat(f64::from_bits(coefficients[5]));
    let mut i = 5;
    while i > 0 {
        i -= 1;
        q = p.fma_rn(z, q, p.splat(f64::from_bits(coefficients[i])));
    }
    q
}

/// The neighbours of m ∈ [0, 1], cut to [0, 1].
#[inline(always)]
fn around<P: Lanes>(p: P, m: P::F) -> Interval<P::F> {
    let (mut lo, mut hi) = (p.before(m), p.after(m));
    if !P::FUSED {
        (lo, hi) = (p.before(lo), p.after(hi));
    }
    // Before 0 are the NaNs (its bits less one), which the maximum drops.
    Interval {
        lo: p.max_f(lo, p.splat(0.0)),
        hi: p.min_f(hi, p.splat(1.0)),
    }
}

#[inline(always)]
pub fn exclusive<P: Lanes>(p: P, a: P::M, b: P::M) -> P::M {
    p.or(p.and_not(a, b), p.and_not(b, a))
}

/// −a where `negate` is set.
#[inline(always)]
fn signed<P: Lanes>(p: P, a: Interval<P::F>, negate: P::M) -> Interval<P::F> {
    Interval {
        lo: p.select(negate, p.neg_f(a.hi), a.lo),
        hi: p.select(negate, p.neg_f(a.lo), a.hi),
    }
}
