//! The interval Halley step.

use super::{Around, Contractor, Pieces, middle, newton, sealed::Sealed, tightened};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, differentiable, excluded, twice_differentiable};

/// Halley's step: what the quadratics f(m) + f'(m)δ + ½f''(T)δ² leave of T, with Newton's step for the proof that a root
/// is the only one. It removes a neighbourhood of m even where 0 ∈ f'(T).
#[derive(Clone, Copy, Debug, Default)]
pub struct Halley;

impl Sealed for Halley {}

impl Contractor for Halley {
    const NAME: &'static str = "halley";
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
            step(p, t, m, &at_m.d, &f.d[2], smooth, &mut around);
            pieces = around.pieces(p);
        }
        pieces.none = p.or(pieces.none, gone);
        pieces.halve_slow(p, t, live);
        pieces
    }
}

/// By Taylor's theorem a root r = m + δ of T satisfies 0 ∈ f(m) + f'(m)δ + ½f''(T)δ². For δ ≥ 0 this says that the
/// quadratic of the lower coefficients is ≤ 0 and that of the upper ones is ≥ 0; for δ ≤ 0 the same with −δ and −f'(m).
/// Where f(m) > 0 (else mirror the signs), the first removes all δ before `reach` of the lower quadratic. The second
/// is positive at δ = 0; where it is negative at the end of T, all δ behind its zero are removed (`beyond`).
///
/// With D = f'(m)² − 2f(m)f''(T) the zeros are Halley's m − 2f(m)/(f'(m) ± √D).
///
/// Narrows `around`, the remainder of a step from m in T, for lanes in `smooth`, where f is twice differentiable on T;
/// `fm` holds f(m) and f'(m), `dd` ⊇ f''(T).
#[inline(always)]
pub fn step<P: Packet>(
    p: P,
    t: &Interval<P::F>,
    m: P::F,
    fm: &[Interval<P::F>; 2],
    dd: &Interval<P::F>,
    smooth: P::M,
    around: &mut Around<P>,
) {
    let (zero, half) = (p.splat(0.0), p.splat(0.5));
    let negative = p.lt(fm[0].hi, zero);
    let mirrored = |x: &Interval<P::F>| Interval {
        lo: p.select(negative, p.neg_f(x.hi), x.lo),
        hi: p.select(negative, p.neg_f(x.lo), x.hi),
    };
    let (c, b, d) = (mirrored(&fm[0]), mirrored(&fm[1]), mirrored(dd));
    let (a_lo, a_hi) = (p.mul_rd(d.lo, half), p.mul_ru(d.hi, half));
    let usable = p.and(smooth, p.lt(zero, c.lo));
    let right = p.add_rd(m, reach(p, c.lo, b.lo, a_lo));
    let left = p.sub_ru(m, reach(p, c.lo, p.neg_f(b.hi), a_lo));
    around.right = p.select(usable, p.max_f(right, around.right), around.right);
    around.left = p.select(usable, p.min_f(left, around.left), around.left);

    let ahead = beyond(p, c.hi, b.hi, a_hi, p.sub_ru(t.hi, m));
    let behind = beyond(p, c.hi, p.neg_f(b.lo), a_hi, p.sub_ru(m, t.lo));
    let hi = p.add_ru(m, ahead);
    let lo = p.sub_rd(m, behind);
    around.hi = p.select(usable, p.min_f(hi, around.hi), around.hi);
    around.lo = p.select(usable, p.max_f(lo, around.lo), around.lo);
}

/// For c > 0 and a quadratic q(δ) = c + bδ + aδ² that is negative at `end` > 0: an upper bound of its only zero ρ in
/// (0, end), behind which it stays negative up to `end`. +∞ where q(end) may be ≥ 0.
///
/// There is exactly one such zero: q is positive at 0 and negative at `end`, and a second zero between them would make
/// the signs equal. It is the smallest positive one, 2c/(−b + √(b² − 4ac)).
#[inline(always)]
fn beyond<P: Packet>(p: P, c: P::F, b: P::F, a: P::F, end: P::F) -> P::F {
    let (zero, infinite) = (p.splat(0.0), p.splat(f64::INFINITY));
    let four = p.splat(4.0);
    // Horner's scheme upwards: `end` is not negative.
    let last = p.fma_ru(p.fma_ru(a, end, b), end, c);
    // −4ac from below.
    let four_c = p.select(p.lt(a, zero), p.mul_rd(four, c), p.mul_ru(four, c));
    let square = p.mul_nonneg_rd(p.abs_f(b), p.abs_f(b));
    let discriminant = p.sub_rd(square, p.mul_ru(four_c, a));
    let below = p.sub_rd(p.sqrt_rd(p.max_f(discriminant, zero)), b);
    let root = p.div_ru(p.add_rn(c, c), below);
    // A NaN fails both comparisons.
    let known = p.and(p.lt(last, zero), p.lt(zero, below));
    p.select(known, root, infinite)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interval::Scalar;

    fn point(x: f64) -> Interval {
        Interval { lo: x, hi: x }
    }

    /// What is left of `t` around its middle for f(m), f'(m) and f''(T) as given, side by side.
    fn left(t: Interval, fm: [f64; 2], dd: Interval) -> Vec<Interval> {
        let m = t.mid();
        let mut around = Around::all(Scalar, &t, m);
        step(Scalar, &t, m, &fm.map(point), &dd, true, &mut around);
        let sides = [(around.lo, around.left), (around.right, around.hi)];
        let full = sides.into_iter().filter(|(lo, hi)| lo <= hi);
        full.map(|(lo, hi)| Interval { lo, hi }).collect()
    }

    #[test]
    fn an_exact_second_derivative_leaves_the_roots_of_the_parabola() {
        // t² − 2 on [1, 2]: m = 1.5, f(m) = 1/4, f'(m) = 3.
        let pieces = left(Interval { lo: 1.0, hi: 2.0 }, [0.25, 3.0], point(2.0));
        assert_eq!(pieces.len(), 1);
        assert!(pieces[0].contains(2f64.sqrt()) && pieces[0].width() < 1e-14);
        // t² − 2 on [−4, 4]: m = 0, f(m) = −2, and 0 ∈ f'. Both roots stay.
        let pieces = left(Interval { lo: -4.0, hi: 4.0 }, [-2.0, 0.0], point(2.0));
        assert_eq!(pieces.len(), 2);
        assert!(pieces[0].contains(-2f64.sqrt()) && pieces[0].width() < 1e-14);
        assert!(pieces[1].contains(2f64.sqrt()) && pieces[1].width() < 1e-14);
        // t² + 1: none.
        assert!(left(Interval { lo: -4.0, hi: 4.0 }, [1.0, 0.0], point(2.0)).is_empty());
    }

    /// (t − r)(t − s)(t − u) on [−1, 1]: its value and slope at 0, and the range of its second derivative.
    fn cubic([r, s, u]: [f64; 3]) -> ([f64; 2], Interval) {
        let sum = r + s + u;
        let dd = Interval {
            lo: -6.0 - 2.0 * sum,
            hi: 6.0 - 2.0 * sum,
        };
        ([-r * s * u, r * s + s * u + u * r], dd)
    }

    /// How many of the cubics' roots are lost, where f'' is narrowed by this factor.
    fn lost(factor: f64) -> usize {
        let grid = [-1.9, -0.9, -0.55, -0.3, -0.05, 0.04, 0.2, 0.45, 0.8, 1.7];
        let mut lost = 0;
        for (r, s, u) in grid
            .iter()
            .flat_map(|r| grid.iter().map(move |s| (r, s)))
            .flat_map(|(r, s)| grid.iter().map(move |u| (*r, *s, *u)))
        {
            let (fm, dd) = cubic([r, s, u]);
            let dd = Interval {
                lo: factor * dd.lo,
                hi: factor * dd.hi,
            };
            let pieces = left(Interval { lo: -1.0, hi: 1.0 }, fm, dd);
            let is_left = |x: &f64| {
                pieces
                    .iter()
                    .any(|t| t.lo - 1e-12 <= *x && *x <= t.hi + 1e-12)
            };
            lost += [r, s, u]
                .iter()
                .filter(|x| x.abs() < 1.0 && !is_left(x))
                .count();
        }
        lost
    }

    #[test]
    fn no_root_is_lost_unless_the_second_derivative_is_wrong() {
        assert_eq!(lost(1.0), 0);
        assert!(lost(0.1) > 0);
    }
}
