//! sin and cos on packets: a reduction by π/2, two polynomials, proved; extrema counted exactly.
//!
//! With k = ⌊x·2/π⌉, x = k·π/2 + (r + ρ), |r| ≤ 0.7855, |ρ| ≤ 0.52·ulp(r) (see [`reduce`]). In doubles,
//!
//! * cos: v = w + d, w = 1 − r²/2, d = r⁴·c(r²) + (((1 − w) − r²/2) − r·ρ);
//! * sin: v = r + (r·t + ρ·w), t = r²·s(r²).
//!
//! Errors, besides half a unit of the last sum (`runtime/proofs`: `sincos.sollya`, `sin_*.g`, `cos_*.g`), u = 2⁻⁵³:
//!
//! * sin, as multiples of u·r: 0.28 of t (0.32 without fused operations), 0.104 for rounding r·t + ρ′ with
//!   |t| ≤ 0.104 (twice that without fused operations), 0.035 of the polynomial, 0.017 of ρ·w for ρ·cos r. Together below
//!   0.45 with fused operations, below 0.6 without. A unit in the last place of v is at least u·v ≥ 0.9·u·r, so v errs by
//!   less than one unit with fused operations and less than two without. Where v is a power of two, the neighbour below
//!   is only u·v away, and then the last sum errs by half of that at most.
//! * cos, as multiples of u: 0.33 of the sum before its last rounding, 0.04 of r·ρ for ρ·sin r, 0.001 of the polynomial;
//!   doubles in [½, 1] are u apart, so v errs by less than one unit.
//!
//! So the neighbours of v (the second neighbours without fused operations) enclose a point. The proofs are for r ≥ 0; a
//! negative r gives the same numbers, for roundings to nearest are symmetric. Signs and the swap of sin and cos are exact.
//!
//! Over an interval the bounds are those at its ends, or ±1 where there is an extremum between: [`Reduced::turns`] counts
//! them.

use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes, Routine};
use super::neighbours::{over, under};
use super::remainder::{Reduced, near, reduce};
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
    let (start, start_far) = near(p, a.lo, quarters);
    let (end, end_far) = near(p, a.hi, quarters);
    if p.any(p.or(start_far, end_far)) {
        return far_wave(p, &a, quarters);
    }
    wave_of(p, a, [start, end], quarters)
}

/// A function of its own, from the start: nothing that is at hand in [`wave`] need be kept for it.
#[cold]
#[inline(never)]
fn far_wave<P: Lanes>(p: P, a: &Interval<P::F>, quarters: f64) -> Interval<P::F> {
    p.call(Far { a, quarters })
}

struct Far<'a, P: Lanes> {
    a: &'a Interval<P::F>,
    quarters: f64,
}

impl<P: Lanes> Routine<P> for Far<'_, P> {
    type Output = Interval<P::F>;
    #[inline(always)]
    fn call(self, p: P) -> Interval<P::F> {
        let ends = [
            reduce(p, self.a.lo, self.quarters),
            reduce(p, self.a.hi, self.quarters),
        ];
        wave_of(p, *self.a, ends, self.quarters)
    }
}

/// The sine of a + `quarters`·π/2, whose ends are reduced.
#[inline(always)]
fn wave_of<P: Lanes>(
    p: P,
    a: Interval<P::F>,
    [start, end]: [Reduced<P::F>; 2],
    quarters: f64,
) -> Interval<P::F> {
    let (first, last) = (
        p.add_rn(start.turns, p.splat(WHOLE)),
        p.add_rn(end.turns, p.splat(WHOLE)),
    );
    // How many extrema lie between, modulo 4: never more than 2 unless the segment is about a period wide or wider.
    let odd = p.bit::<0>(last);
    let count = p.add_rn(p.sub_rn(last, first), p.splat(WHOLE));
    let wide = p.le(p.splat(6.25), p.sub_ru(a.hi, a.lo));
    let both = p.or(wide, p.bit::<1>(count));
    let single = p.and_not(p.bit::<0>(count), p.bit::<1>(count));
    // The last extremum before b is a maximum if its number is odd: the first one above 0 is π/2.
    let has_max = p.or(both, p.and(single, odd));
    let has_min = p.or(both, p.and_not(single, odd));
    let (u, v) = (sine_of(p, start, quarters), sine_of(p, end, quarters));
    let (one, minus) = (p.splat(1.0), p.splat(-1.0));
    let steps = if P::FUSED { 1 } else { 2 };
    let lo = under(p, p.min_f(u, v), steps);
    let hi = over(p, p.max_f(u, v), steps);
    Interval {
        lo: p.select(has_min, minus, p.max_f(lo, minus)),
        hi: p.select(has_max, one, p.min_f(hi, one)),
    }
}

/// The sine of x + `quarters`·π/2 to a few units in the last place; NaN of NaN.
#[inline(always)]
pub fn anywhere<P: Lanes>(p: P, x: P::F, quarters: f64) -> P::F {
    p.select(p.eq(x, x), sine_of(p, reduce(p, x, quarters), quarters), x)
}

/// The sine of x + `quarters`·π/2, where x is reduced.
#[inline(always)]
fn sine_of<P: Lanes>(p: P, reduced: Reduced<P::F>, quarters: f64) -> P::F {
    let shifted = p.add_rn(reduced.k, p.splat(WHOLE + quarters));
    let (s, c) = quarter_wave(p, reduced);
    let (s, c) = (p.add_rn(s.high, s.low), p.add_rn(c.high, c.low));
    let v = p.select(p.bit::<0>(shifted), c, s);
    p.select(p.bit::<1>(shifted), p.neg_f(v), v)
}

/// sin(r + ρ) = r + (r·t + ρ·w) and cos(r + ρ) = w + d, before their last sums.
#[inline(always)]
pub fn quarter_wave<P: Lanes>(p: P, reduced: Reduced<P::F>) -> (Sum<P::F>, Sum<P::F>) {
    let (r, rho) = (reduced.r, reduced.rho);
    let (one, minus_half) = (p.splat(1.0), p.splat(-0.5));
    let z = p.mul_rn(r, r);
    let w = p.fma_rn(z, minus_half, one);
    let t = p.mul_rn(z, horner(p, z, S));
    let sine = Sum {
        high: r,
        low: p.fma_rn(t, r, p.mul_rn(rho, w)),
    };
    // What w lacks, exactly.
    let rest = p.fma_rn(z, minus_half, p.sub_rn(one, w));
    let rest = p.fma_rn(p.neg_f(r), rho, rest);
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
