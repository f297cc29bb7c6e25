//! Taylor's form of second order.

use super::{Enclosure, first, from_centre, sealed::Sealed};
use crate::contract::middle;
use crate::interval::{Interval, Packet, Parameter, Quadratic};
use crate::solve::{Enclosed, Field, twice_differentiable};

/// f(c) + f'(c)(T − c) + ½f''(T)(T − c)², c the middle of T, with the exact range of this quadratic.
#[derive(Clone, Copy, Debug, Default)]
pub struct Taylor;

impl Sealed for Taylor {}

impl Enclosure for Taylor {
    const NAME: &'static str = "Taylor";

    #[inline(always)]
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1> {
        let p = field.p;
        let f = field.curvature(t, live);
        let mut over = first(&f);
        let smooth = twice_differentiable(p, &f.flags, live);
        if p.any(smooth) {
            let c = middle(p, t);
            let at_c = field.slope(&Interval { lo: c, hi: c }, smooth);
            let range = form(p, t, c, &at_c.d, &f.d[2]);
            over.d[0] = p.select_interval(smooth, range, over.d[0]);
        }
        over
    }
}

/// By Taylor's theorem f(c + δ) = f(c) + f'(c)δ + ½f''(ξ)δ², with `fc` ∋ f(c), f'(c) and `dd` ⊇ f''(T). For δ ≥ 0 the
/// greatest of all quadratics with coefficients in these intervals is that of the upper bounds, and the least that of
/// the lower ones; their extremes on T − c are at its ends or at a vertex. For δ ≤ 0 the same holds of −δ and −f'(c).
/// f must be twice differentiable on T; c lies in T.
#[inline(always)]
pub fn form<P: Packet>(
    p: P,
    t: &Interval<P::F>,
    c: P::F,
    fc: &[Interval<P::F>; 2],
    dd: &Interval<P::F>,
) -> Interval<P::F> {
    let (zero, half) = (p.splat(0.0), p.splat(0.5));
    let away = from_centre(p, t, c);
    let bend = Interval {
        lo: p.mul_rd(dd.lo, half),
        hi: p.mul_ru(dd.hi, half),
    };
    let ahead = Quadratic::new(p, fc[0], fc[1], bend);
    let behind = Quadratic::new(p, fc[0], p.neg(fc[1]), bend);
    let right = Interval {
        lo: zero,
        hi: p.max_f(away.hi, zero),
    };
    let left = Interval {
        lo: zero,
        hi: p.max_f(p.neg_f(away.lo), zero),
    };
    p.hull(right.quadratic(p, &ahead), left.quadratic(p, &behind))
}
