//! Newton with the derivative tightened by the second derivative.

use super::{Contractor, Pieces, middle, newton, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, Field, differentiable, excluded, twice_differentiable};

/// Newton's step with f'(T) ∩ (f'(m) + f''(T)·(T − m)).
#[derive(Clone, Copy, Debug, Default)]
pub struct Tightened;

impl Sealed for Tightened {}

impl Contractor for Tightened {
    const NAME: &'static str = "newton, tightened";
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
            let d = slope_over(p, t, m, &f, &at_m.d[1], usable);
            pieces = newton::step(p, t, m, &at_m.d[0], &d, usable).pieces(p);
        }
        pieces.none = p.or(pieces.none, gone);
        pieces.halve_slow(p, t, live);
        pieces
    }
}

/// f'(T) ∩ (f'(m) + f''(T)·(T − m)) where f is twice differentiable, else f'(T): by the mean value theorem for f'.
#[inline(always)]
pub fn slope_over<P: Packet>(
    p: P,
    t: &Interval<P::F>,
    m: P::F,
    f: &Enclosed<P, 3>,
    dm: &Interval<P::F>,
    usable: P::M,
) -> Interval<P::F> {
    let smooth = twice_differentiable(p, &f.flags, usable);
    let away = Interval {
        lo: p.sub_rd(t.lo, m),
        hi: p.sub_ru(t.hi, m),
    };
    let mean = p.add(*dm, p.mul(f.d[2], away));
    let lo = p.max_f(mean.lo, f.d[1].lo);
    let hi = p.min_f(mean.hi, f.d[1].hi);
    Interval {
        lo: p.select(smooth, lo, f.d[1].lo),
        hi: p.select(smooth, hi, f.d[1].hi),
    }
}
