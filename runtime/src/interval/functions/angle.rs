//! The angle of a point on packets (atan2): the extreme angles of a box are those of two of its corners.
//!
//! The angle has no extremum inside a convex set that does not surround the origin, and grows along an edge in one
//! direction. Off the cut, with y ≥ 0, it is least at x.hi (and at y.lo if x.hi > 0, else at y.hi) and greatest at x.lo
//! (y.hi if x.lo ≥ 0, else y.lo); with y ≤ 0 the angle is that of −y, negated; where y has both signs, x ≥ 0 and the
//! greatest angle is that of the upper part, the least that of the lower. So the choice of the corner of the least angle
//! depends on the sign of y.lo alone. Corners that an infinite bound makes are limits along edges; no corner that is
//! chosen has two infinite coordinates, and none is the origin unless the box is.
//!
//! An angle at a corner is that of [`arctangent::angle`](super::arctangent::angle) with the neighbours as bounds: at
//! a point at most two units wide in the last place. Where the result is below 2⁻³⁰⁰ three neighbours are taken: there the
//! remainder of the quotient may be left out, and the quotient itself may be subnormal.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::arctangent::angle;

/// The angles of (x, y) over the box, those of the origin left out; [−π, π] where the box meets the cut and what is
/// below it.
#[inline(always)]
pub fn atan2<P: Enclose>(p: P, y: Interval<P::F>, x: Interval<P::F>) -> Interval<P::F> {
    let zero = p.splat(0.0);
    let flat = p.le(x.hi, zero);
    let right = p.le(zero, x.lo);
    // A box on the axis is part of the upper half plane if it is on the left, at least in part.
    let upper = p.and_not(p.le(zero, y.lo), p.and(p.le(y.hi, zero), flat));
    let least = at(
        p,
        p.select(
            upper,
            p.select(flat, y.hi, y.lo),
            p.select(right, y.lo, y.hi),
        ),
        p.select(upper, x.hi, x.lo),
    );
    let lower = p.or(p.lt(y.hi, zero), p.and(p.le(y.hi, zero), right));
    let greatest = at(
        p,
        p.select(
            lower,
            p.select(flat, y.lo, y.hi),
            p.select(right, y.hi, y.lo),
        ),
        p.select(lower, x.hi, x.lo),
    );
    let cut = p.and(p.and(p.lt(y.lo, zero), p.le(zero, y.hi)), p.lt(x.lo, zero));
    let pi = p.splat(f64::from_bits(PI_ABOVE));
    Interval {
        lo: p.select(cut, p.neg_f(pi), least.lo),
        hi: p.select(cut, pi, greatest.hi),
    }
}

/// The least double above π.
const PI_ABOVE: u64 = 0x400921fb54442d19;

/// Bounds of the angle of (x, y) in (−π, π], one of which may be infinite; π on the cut.
#[inline(always)]
fn at<P: Lanes>(p: P, y: P::F, x: P::F) -> Interval<P::F> {
    let zero = p.splat(0.0);
    let (v, exact) = of_magnitudes(p, y, x);
    let (mut less, mut more) = (p.before(v), p.after(v));
    let small = p.lt(v, p.splat(SMALL));
    less = p.select(small, p.before(p.before(less)), less);
    more = p.select(small, p.after(p.after(more)), more);
    // Before 0 are the NaNs (its bits less a few), which the maximum drops.
    less = p.max_f(less, zero);
    more = p.select(exact, zero, more);
    let below = p.lt(y, zero);
    Interval {
        lo: p.select(below, p.neg_f(more), less),
        hi: p.select(below, p.neg_f(less), more),
    }
}

/// The angle of (x, |y|) in [0, π], and where it is exactly 0.
///
/// Both are scaled by a power of two where they are both tiny or one is huge. What underflows thereby is less than
/// 2⁻¹⁸⁰⁰ of the other. An infinite coordinate is MAX, and the other one 0.
#[inline(always)]
fn of_magnitudes<P: Lanes>(p: P, y: P::F, x: P::F) -> (P::F, P::M) {
    let zero = p.splat(0.0);
    let max = p.splat(f64::MAX);
    let (height, width) = (p.abs_f(y), p.abs_f(x));
    let n = p.select(p.lt(max, width), zero, p.min_f(height, max));
    let d = p.select(p.lt(max, height), zero, p.min_f(width, max));
    let size = p.max_f(n, d);
    let scale = p.select(p.lt(size, p.splat(LITTLE)), p.splat(ENLARGE), p.splat(1.0));
    let scale = p.select(p.lt(p.splat(LARGE), size), p.splat(REDUCE), scale);
    let left = p.lt(x, zero);
    let v = angle(
        p,
        p.mul_rn(n, scale),
        // Raised from 0, it is still less than 2⁻⁴⁰⁰ of the ordinate.
        p.max_f(p.mul_rn(d, scale), p.splat(LEAST)),
        left,
    );
    (v, p.and_not(p.eq(n, zero), left))
}

/// 2ⁿ
const fn power(n: i32) -> f64 {
    f64::from_bits(((1023 + n) as u64) << 52)
}

/// Below 2⁻⁵⁰⁰ both coordinates are multiplied by 2⁵⁰⁰, above 2⁹⁰⁰ by 2⁻¹⁰⁰.
const LITTLE: f64 = power(-500);
const ENLARGE: f64 = power(500);
const LARGE: f64 = power(900);
const REDUCE: f64 = power(-100);
/// The least divisor.
const LEAST: f64 = power(-1000);
/// Below this a result may be the quotient alone.
const SMALL: f64 = power(-300);

/// The angle of (x, y) to within two units in the last place; NaN at the origin and of NaN. On the cut it is π, also for −0.
#[inline(always)]
pub fn near<P: Lanes>(p: P, y: P::F, x: P::F) -> P::F {
    let zero = p.splat(0.0);
    let (v, _) = of_magnitudes(p, y, x);
    let v = p.select(p.lt(y, zero), p.neg_f(v), v);
    // False of a NaN, and of two zeros.
    let some = p.lt(zero, p.add_rn(p.abs_f(y), p.abs_f(x)));
    p.select(some, v, p.splat(f64::NAN))
}
