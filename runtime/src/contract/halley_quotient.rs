//! The interval Halley step in the form of the paper.

use super::{Around, Contractor, Pieces, middle, newton, sealed::Sealed, tightened};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, differentiable, excluded, twice_differentiable};

/// Halley's step as a quotient, X' = m − 2f(m)/(f'(m) ± √D) ∩ X with D = f'(m)² − 2f(m)f''(X), and Newton's step for the
/// proof that a root is the only one. [`Halley`](super::Halley) solves the same inclusion by two quadratic inequalities.
#[derive(Clone, Copy, Debug, Default)]
pub struct HalleyQuotient;

impl Sealed for HalleyQuotient {}

impl Contractor for HalleyQuotient {
    const NAME: &'static str = "halley, as a quotient";
    const ORDER: u8 = 2;

    type Memory<P: Packet> = ();

    fn memory<P: Packet>(_: P) {}

    #[inline(always)]
    fn contract<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
        (): &mut (),
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

/// By Taylor's theorem a root m + δ of T satisfies f(m) + f'(m)δ + ½hδ² = 0 for some h ∈ f''(T). If f(m) ≠ 0 then δ ≠ 0,
/// and u = 1/δ satisfies f(m)u² + f'(m)u + ½h = 0: u = −(f'(m) ± √D)/2f(m) with D = f'(m)² − 2f(m)h. So
///
/// - where D < 0 for all values there is no root;
/// - else δ = −2f(m)/(f'(m) ± √D), one of the two. Let f(m) > 0 (else mirror the signs): a denominator in [a, b] has a
///   positive part (0, b], which leaves 2f(m)/b ≤ −δ ≤ 2f(m)/a, and a negative part, which leaves the same on the other side.
///
/// Narrows `around`, the remainder of a step from m in T, for lanes in `smooth`, where f is twice differentiable on T;
/// `fm` holds f(m) and f'(m), `dd` ⊇ f''(T).
#[inline(always)]
pub fn step<P: Packet>(
    p: P,
    m: P::F,
    fm: &[Interval<P::F>; 2],
    dd: &Interval<P::F>,
    smooth: P::M,
    around: &mut Around<P>,
) {
    let zero = p.splat(0.0);
    let negative = p.lt(fm[0].hi, zero);
    let mirrored = |x: &Interval<P::F>| p.select_interval(negative, p.neg(*x), *x);
    let (c, b, h) = (mirrored(&fm[0]), mirrored(&fm[1]), mirrored(dd));
    let usable = p.and(smooth, p.lt(zero, c.lo));
    let twice = Interval {
        lo: p.add_rd(c.lo, c.lo),
        hi: p.add_ru(c.hi, c.hi),
    };
    let discriminant = p.sub(p.sqr(b), p.mul(twice, h));
    let root = Interval {
        lo: p.sqrt_rd(p.max_f(discriminant.lo, zero)),
        hi: p.sqrt_ru(p.max_f(discriminant.hi, zero)),
    };
    let real = p.le(zero, discriminant.hi);
    let denominators = [p.add(b, root), p.sub(b, root)];
    let left = distances(p, &twice, &denominators, real);
    let right = distances(p, &twice, &denominators.map(|d| p.neg(d)), real);
    let narrowed = Around {
        lo: p.max_f(p.sub_rd(m, left.hi), around.lo),
        left: p.min_f(p.sub_ru(m, left.lo), around.left),
        right: p.max_f(p.add_rd(m, right.lo), around.right),
        hi: p.min_f(p.add_ru(m, right.hi), around.hi),
        ..*around
    };
    around.lo = p.select(usable, narrowed.lo, around.lo);
    around.left = p.select(usable, narrowed.left, around.left);
    around.right = p.select(usable, narrowed.right, around.right);
    around.hi = p.select(usable, narrowed.hi, around.hi);
}

/// The hull of n/d over the positive parts of the denominators d, for n > 0: from +∞ to 0 if there is none.
#[inline(always)]
fn distances<P: Packet>(
    p: P,
    n: &Interval<P::F>,
    denominators: &[Interval<P::F>; 2],
    real: P::M,
) -> Interval<P::F> {
    let (zero, infinite) = (p.splat(0.0), p.splat(f64::INFINITY));
    let mut hull = Interval {
        lo: infinite,
        hi: zero,
    };
    for d in denominators {
        let some = p.and(real, p.lt(zero, d.hi));
        let near = p.div_rd(n.lo, d.hi);
        // A NaN, of two infinities, is no claim.
        let near = p.select(p.lt(zero, near), near, zero);
        let far = p.select(p.lt(zero, d.lo), p.div_ru(n.hi, d.lo), infinite);
        let far = p.select(p.lt(zero, far), far, infinite);
        hull.lo = p.select(some, p.min_f(near, hull.lo), hull.lo);
        hull.hi = p.select(some, p.max_f(far, hull.hi), hull.hi);
    }
    hull
}
