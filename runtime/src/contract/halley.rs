//! The interval Halley step.

use super::{Around, Contractor, Pieces, middle, newton, sealed::Sealed, tightened};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, differentiable, excluded, twice_differentiable};
use crate::surface::Surface;

/// Halley's step: what the quadratics f(m) + f'(m)δ + ½f''(T)δ² leave of T, with Newton's step for the proof that a root
/// is the only one. It removes a neighbourhood of m even where 0 ∈ f'(T).
#[derive(Clone, Copy, Debug, Default)]
pub struct Halley;

impl Sealed for Halley {}

impl Contractor for Halley {
    const NAME: &'static str = "halley";
    const ORDER: u8 = 2;

    #[inline(always)]
    fn contract<S: Surface, P: Packet>(
        field: &mut Field<'_, S, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Pieces<P> {
        let p = field.p;
        let f = field.curvature(t, live);
        let gone = excluded(p, &f.d[0], &f.flags, live);
        let rest = p.and_not(live, gone);
        let mut pieces = Pieces::all(p, t);
        let usable = differentiable(p, &f.flags, rest);
        if p.any(usable) {
            let m = middle(p, t);
            let at_m = field.slope(&Interval { lo: m, hi: m }, usable);
            let d = tightened::slope_over(p, t, m, &f, &at_m.d[1], usable);
            let mut around = newton::step(p, t, m, &at_m.d[0], &d, usable);
            let smooth = twice_differentiable(p, &f.flags, usable);
            step(p, m, &at_m.d, &f.d[2], smooth, &mut around);
            pieces = around.pieces(p);
        }
        pieces.none = p.or(pieces.none, gone);
        pieces.halve_slow(p, t, live);
        pieces
    }
}

/// By Taylor's theorem a root r = m + δ of T satisfies 0 ∈ f(m) + f'(m)δ + ½f''(T)δ². For δ ≥ 0 this says that the
/// quadratic of the lower coefficients is ≤ 0 and that of the upper ones is ≥ 0; for δ ≤ 0 the same with −δ and −f'(m).
/// Where f(m) > 0 (else mirror the signs), the first removes all δ before [`reach`] of the lower quadratic.
///
/// With D = f'(m)² − 2f(m)f''(T) this is Halley's m − 2f(m)/(f'(m) ± √D).
///
/// Narrows `around` where f is twice differentiable on T.
#[inline(always)]
pub(crate) fn step<P: Packet>(
    p: P,
    m: P::F,
    fm: &[Interval<P::F>; 2],
    dd: &Interval<P::F>,
    smooth: P::M,
    around: &mut Around<P>,
) {
    let zero = p.splat(0.0);
    let negative = p.lt(fm[0].hi, zero);
    let c = p.select(negative, p.neg_f(fm[0].hi), fm[0].lo);
    let b_lo = p.select(negative, p.neg_f(fm[1].hi), fm[1].lo);
    let b_hi = p.select(negative, p.neg_f(fm[1].lo), fm[1].hi);
    let a = p.mul_rd(p.select(negative, p.neg_f(dd.hi), dd.lo), p.splat(0.5));
    let usable = p.and(smooth, p.lt(zero, c));
    let right = p.add_rd(m, reach(p, c, b_lo, a));
    let left = p.sub_ru(m, reach(p, c, p.neg_f(b_hi), a));
    around.right = p.select(usable, p.max_f(right, around.right), around.right);
    around.left = p.select(usable, p.min_f(left, around.left), around.left);
}

/// A lower bound of the smallest δ > 0 with c + bδ + aδ² ≤ 0, for c > 0; +∞ if there is none.
///
/// It is 2c/(−b + √(b² − 4ac)), the form without cancellation for b < 0. There is none if the discriminant is negative,
/// or if the denominator is not positive (a ≥ 0 and b ≥ 0).
#[inline(always)]
pub(crate) fn reach<P: Packet>(p: P, c: P::F, b: P::F, a: P::F) -> P::F {
    let zero = p.splat(0.0);
    let four = p.splat(4.0);
    // −4ac from above: the factor 4c is exact unless it overflows.
    let four_c = p.select(p.lt(a, zero), p.mul_ru(four, c), p.mul_rd(four, c));
    let discriminant = p.sub_ru(p.mul_ru(b, b), p.mul_rd(four_c, a));
    let below = p.sub_ru(p.sqrt_ru(p.max_f(discriminant, zero)), b);
    let none = p.or(p.lt(discriminant, zero), p.le(below, zero));
    let root = p.select(
        none,
        p.splat(f64::INFINITY),
        p.div_rd(p.add_rd(c, c), below),
    );
    // No claim where an overflow made a NaN.
    p.max_f(root, zero)
}
