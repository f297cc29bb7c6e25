//! sin and cos on packets, together where both are asked for: a reduction by π/2, two polynomials, proved; extrema counted exactly.
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
//! Over an interval the bounds are those at its ends, or ±1 where there is an extremum between: [`extrema`].

use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes, Routine};
use super::neighbours::{over, under};
use super::remainder::{Reduced, near, reduce};
use super::thin::{self, unless_exact};
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
    let [sine] = waves(p, &a, [0.0]);
    sine
}

/// cos a = sin(a + π/2)
#[inline(always)]
pub fn cos<P: Lanes>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let [cosine] = waves(p, &a, [1.0]);
    cosine
}

/// sin a and cos a
#[inline(always)]
pub fn sin_cos<P: Lanes>(p: P, a: Interval<P::F>) -> [Interval<P::F>; 2] {
    waves(p, &a, [0.0, 1.0])
}

/// The sines of a + `quarters`·π/2.
#[inline(always)]
fn waves<P: Lanes, const N: usize>(
    p: P,
    a: &Interval<P::F>,
    quarters: [f64; N],
) -> [Interval<P::F>; N] {
    let (middle, radius) = thin::middle(p, a);
    // Not where either is not a number.
    let thin = p.le(radius, p.mul_rn(p.abs_f(middle), p.splat(THIN)));
    if !p.any(p.not(thin)) {
        let (middle, far) = near(p, middle);
        if !p.any(far) {
            return thin_waves(p, &middle, radius, quarters);
        }
    }
    let (start, start_far) = near(p, a.lo);
    let (end, end_far) = near(p, a.hi);
    if p.any(p.or(start_far, end_far)) {
        return far_waves(p, a, quarters);
    }
    waves_of(p, a, [start, end], quarters)
}

/// An interval of less than this part of its middle is hardly more than a point.
const THIN: f64 = 1.0 / (1u64 << 40) as f64;

/// By how many units in the last place a computed sine may err.
const fn steps<P: Lanes>() -> u32 {
    if P::FUSED { 1 } else { 2 }
}

/// Over middle ± radius: sin(m + δ) = sin m + δ·cos ξ, |cos ξ| ≤ |cos m| + |δ|. The computed cosine errs by less than
/// 2⁻⁵².
#[inline(always)]
fn thin_waves<P: Lanes, const N: usize>(
    p: P,
    middle: &Reduced<P::F>,
    radius: P::F,
    quarters: [f64; N],
) -> [Interval<P::F>; N] {
    let sums = sums(p, middle);
    let more = p.add_ru(radius, p.splat(f64::EPSILON));
    let exact = p.eq(radius, p.splat(0.0));
    let steps = steps::<P>();
    let mut waves = [Interval {
        lo: radius,
        hi: radius,
    }; N];
    let mut i = 0;
    while i < N {
        let v = sine_of(p, middle.k, sums, quarters[i]);
        let slope = p.abs_f(sine_of(p, middle.k, sums, quarters[i] + 1.0));
        let beside = p.mul_ru(radius, p.add_ru(slope, more));
        let (under, over) = (under(p, v, steps), over(p, v, steps));
        let lo = unless_exact(p, exact, under, p.sub_rd(under, beside));
        let hi = unless_exact(p, exact, over, p.add_ru(over, beside));
        waves[i] = Interval {
            lo: p.max_f(lo, p.splat(-1.0)),
            hi: p.min_f(hi, p.splat(1.0)),
        };
        i += 1;
    }
    waves
}

/// A function of its own, from the start: nothing that is at hand in [`waves`] need be kept for it.
#[cold]
#[inline(never)]
fn far_waves<P: Lanes, const N: usize>(
    p: P,
    a: &Interval<P::F>,
    quarters: [f64; N],
) -> [Interval<P::F>; N] {
    p.call(Far { a, quarters })
}

struct Far<'a, P: Lanes, const N: usize> {
    a: &'a Interval<P::F>,
    quarters: [f64; N],
}

impl<P: Lanes, const N: usize> Routine<P> for Far<'_, P, N> {
    type Output = [Interval<P::F>; N];
    #[inline(always)]
    fn call(self, p: P) -> [Interval<P::F>; N] {
        let ends = [reduce(p, self.a.lo), reduce(p, self.a.hi)];
        waves_of(p, self.a, ends, self.quarters)
    }
}

/// The sines of a + `quarters`·π/2, whose ends are reduced.
#[inline(always)]
fn waves_of<P: Lanes, const N: usize>(
    p: P,
    a: &Interval<P::F>,
    [start, end]: [Reduced<P::F>; 2],
    quarters: [f64; N],
) -> [Interval<P::F>; N] {
    let (first, last) = (sums(p, &start), sums(p, &end));
    let wide = p.le(p.splat(6.25), p.sub_ru(a.hi, a.lo));
    let steps = steps::<P>();
    let mut waves = [*a; N];
    let mut i = 0;
    while i < N {
        let quarters = quarters[i];
        let [minimum, maximum] = extrema(p, [&start, &end], wide, quarters);
        let u = sine_of(p, start.k, first, quarters);
        let v = sine_of(p, end.k, last, quarters);
        let (one, minus) = (p.splat(1.0), p.splat(-1.0));
        let lo = under(p, p.min_f(u, v), steps);
        let hi = over(p, p.max_f(u, v), steps);
        waves[i] = Interval {
            lo: p.select(minimum, minus, p.max_f(lo, minus)),
            hi: p.select(maximum, one, p.min_f(hi, one)),
        };
        i += 1;
    }
    waves
}

/// Where the sine of x + `quarters`·π/2 has a minimum, and where a maximum, between two reduced ends.
#[inline(always)]
fn extrema<P: Lanes>(
    p: P,
    [start, end]: [&Reduced<P::F>; 2],
    wide: P::M,
    quarters: f64,
) -> [P::M; 2] {
    let whole = p.splat(WHOLE);
    let first = p.add_rn(start.turns(p, quarters), whole);
    let last = p.add_rn(end.turns(p, quarters), whole);
    // How many lie between, modulo 4: never more than 2 unless the segment is about a period wide or wider.
    let odd = p.bit::<0>(last);
    let count = p.add_rn(p.sub_rn(last, first), whole);
    let both = p.or(wide, p.bit::<1>(count));
    let single = p.and_not(p.bit::<0>(count), p.bit::<1>(count));
    // The last one before the end is a maximum if its number is odd: the first one above 0 is π/2.
    [
        p.or(both, p.and_not(single, odd)),
        p.or(both, p.and(single, odd)),
    ]
}

/// The sine and cosine of x to a few units in the last place; NaN of NaN.
#[inline(always)]
pub fn anywhere<P: Lanes>(p: P, x: P::F) -> [P::F; 2] {
    let reduced = reduce(p, x);
    let (sums, known) = (sums(p, &reduced), p.eq(x, x));
    [
        p.select(known, sine_of(p, reduced.k, sums, 0.0), x),
        p.select(known, sine_of(p, reduced.k, sums, 1.0), x),
    ]
}

/// The sine of x + `quarters`·π/2, from the multiple of π/2 in x, and the sine and cosine of the rest.
#[inline(always)]
fn sine_of<P: Lanes>(p: P, k: P::F, [sine, cosine]: [P::F; 2], quarters: f64) -> P::F {
    let shifted = p.add_rn(k, p.splat(WHOLE + quarters));
    let v = p.select(p.bit::<0>(shifted), cosine, sine);
    p.select(p.bit::<1>(shifted), p.neg_f(v), v)
}

/// Sine and cosine of a reduced argument.
#[inline(always)]
fn sums<P: Lanes>(p: P, reduced: &Reduced<P::F>) -> [P::F; 2] {
    let (s, c) = quarter_wave(p, *reduced);
    [p.add_rn(s.high, s.low), p.add_rn(c.high, c.low)]
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
