//! arcsin and arccos on packets: one square root, one polynomial, proved.
//!
//! With m = |x|, arcsin m = m + m·t for m < ½, t = z·b(z), z = m², b of degree 12 by Sollya's `fpminimax`. For m ≥ ½,
//! arcsin m = π/2 − 2·arcsin s with s² = z = (1 − m)/2 exactly, z ≤ ¼: the same polynomial. The root of z is s + σ,
//! σ = (z − s²)/(2s), and arcsin of it is s + (s·t + σ). Multiples of π/4 are added by [`turned`]; arccos m is
//! π/2 − arcsin m or 2·arcsin s, and arccos(−m) is π less that.
//!
//! Errors besides half a unit of the last sum (`runtime/proofs`: `asin.sollya`, `asin.g`), u = 2⁻⁵³, q for m or 2s:
//!
//! * without a multiple of π/4, as multiples of u·q: 0.11 of t, 0.048 for rounding q·t + ρ with |t| ≤ 0.0472 (twice that
//!   without fused operations), 0.009 of the polynomial, 0.05 of σ for σ·(1 + t) with |σ| ≤ u·s, and nothing else
//!   above 2⁻⁵⁰. Together below 0.27. A unit in the last place of v ≥ q is at least u·v, so v errs by less than one unit.
//!   Where v is a power of two, the neighbour below is only u·v away, and then the last sum errs by half of that at most.
//! * with one, as multiples of u: 0.24 of all sums before the last one, 0.009 of the polynomial, and 0.05 of σ. Together
//!   below 0.3; v > 0.52, so half a unit in its last place is at least u/2.
//!
//! So the neighbours of v enclose a point, with and without fused operations.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::arctangent::{negate_if, odd_part, turned};
use super::neighbours::{around, with_sign_of};
use super::two_fold::remainder;

/// b, from the constant coefficient on.
const B: [u64; 13] = [
    0x3fc5555555555578,
    0x3fb333333332df3b,
    0x3fa6db6db72289da,
    0x3f9f1c71a8cef866,
    0x3f96e8bdfbb0af7f,
    0x3f91c49e16d4636e,
    0x3f8ca20eab934aa8,
    0x3f8757aa0d824c1f,
    0x3f86178650f68978,
    0x3f6e27f6641a7e2e,
    0x3f964a4dd069bcd3,
    0xbf9596cfbf2af867,
    0x3fa0bb7b2f0e78f4,
];

/// q + tail, which is arcsin |x|, or π/2 less arcsin |x| where `far` is set: where |x| ≥ ½.
struct Arc<P: Lanes> {
    q: P::F,
    tail: P::F,
    far: P::M,
}

#[inline(always)]
fn arc<P: Lanes>(p: P, m: P::F) -> Arc<P> {
    let half = p.splat(0.5);
    let far = p.le(half, m);
    let outer = p.mul_rn(p.sub_rn(p.splat(1.0), m), half);
    let s = p.sqrt_rn(outer);
    let rest = remainder(p, outer, s, s);
    // 2σ; at |x| = 1 0/tiny.
    let sigma = p.div_rn(rest, p.max_f(s, p.splat(f64::MIN_POSITIVE)));
    let q = p.select(far, p.add_rn(s, s), m);
    let rho = p.select(far, sigma, p.splat(0.0));
    let z = p.select(far, outer, p.mul_rn(m, m));
    Arc {
        q,
        tail: p.fma_rn(q, odd_part(p, z, &B), rho),
        far,
    }
}

/// arcsin x to within a unit in the last place, for |x| ≤ 1; 0 for 0 only.
#[inline(always)]
fn sine_of<P: Lanes>(p: P, x: P::F) -> P::F {
    let Arc { q, tail, far } = arc(p, p.abs_f(x));
    let c = p.select(far, p.splat(2.0), p.splat(0.0));
    let v = turned(p, c, negate_if(p, far, q), negate_if(p, far, tail));
    with_sign_of(p, v, x)
}

/// arccos x to within a unit in the last place, for |x| ≤ 1; 0 for 1 only.
#[inline(always)]
fn cosine_of<P: Lanes>(p: P, x: P::F) -> P::F {
    let Arc { q, tail, far } = arc(p, p.abs_f(x));
    let left = p.lt(x, p.splat(0.0));
    let beyond = p.select(left, p.splat(4.0), p.splat(0.0));
    let c = p.select(far, beyond, p.splat(2.0));
    // π/2 − arcsin x, 2 arcsin s, π − 2 arcsin s.
    let minus = p.or(p.and_not(p.not(far), left), p.and(far, left));
    turned(p, c, negate_if(p, minus, q), negate_if(p, minus, tail))
}

/// arcsin a over [−1, 1], increasing; ±π/2 where there is no such number. At a point at most two units wide in the last
/// place, on every back-end.
#[inline(always)]
pub fn asin<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    Interval {
        lo: around(p, sine_of(p, inside(p, a.lo)), 1).lo,
        hi: around(p, sine_of(p, inside(p, a.hi)), 1).hi,
    }
}

/// arccos a over [−1, 1], decreasing; 0 or π where there is no such number. At a point at most two units wide in the last
/// place, on every back-end.
#[inline(always)]
pub fn acos<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    Interval {
        lo: around(p, cosine_of(p, inside(p, a.hi)), 1).lo,
        hi: around(p, cosine_of(p, inside(p, a.lo)), 1).hi,
    }
}

/// arcsin x to within a unit in the last place; NaN beyond ±1 and of NaN.
#[inline(always)]
pub fn near_sine<P: Lanes>(p: P, x: P::F) -> P::F {
    within(p, x, sine_of(p, inside(p, x)))
}

/// arccos x to within a unit in the last place; NaN beyond ±1 and of NaN.
#[inline(always)]
pub fn near_cosine<P: Lanes>(p: P, x: P::F) -> P::F {
    within(p, x, cosine_of(p, inside(p, x)))
}

/// x, or the nearest number in [−1, 1].
#[inline(always)]
fn inside<P: Lanes>(p: P, x: P::F) -> P::F {
    p.max_f(p.min_f(x, p.splat(1.0)), p.splat(-1.0))
}

/// v where |x| ≤ 1, else NaN.
#[inline(always)]
fn within<P: Lanes>(p: P, x: P::F, v: P::F) -> P::F {
    p.select(p.le(p.abs_f(x), p.splat(1.0)), v, p.splat(f64::NAN))
}
