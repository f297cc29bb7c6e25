//! The interval Newton step.

use super::{Around, Contractor, Pieces, middle, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, differentiable, excluded};

/// Newton's step from the middle of T with f' over T; extended division leaves two pieces where 0 ∈ f'(T).
#[derive(Clone, Copy, Debug, Default)]
pub struct Newton;

impl Sealed for Newton {}

impl Contractor for Newton {
    const NAME: &'static str = "newton";
    const ORDER: u8 = 1;

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
        let f = field.slope(t, live);
        let gone = excluded(p, &f.d[0], &f.flags, live);
        let rest = p.and_not(live, gone);
        let mut pieces = Pieces::all(p, t);
        let usable = differentiable(p, &f.flags, rest);
        if p.any(usable) {
            let m = middle(p, t);
            let fm = field.point(m, usable);
            pieces = step(p, t, m, &fm.d[0], &f.d[1], usable).pieces(p);
        }
        pieces.none = p.or(pieces.none, gone);
        pieces.halve_slow(p, t, live);
        pieces
    }
}

/// By the mean value theorem a root r of T satisfies f(m) + f'(ξ)(r − m) = 0 for some ξ in T, with `fm` ∋ f(m) and
/// `d` ⊇ f'(T). Where f(m) > 0 (else mirror the signs):
///
/// - left of m: m − r ≥ f(m)/sup f' if sup f' > 0, else there is none; and m − r ≤ f(m)/inf f' if inf f' > 0;
/// - right of m: r − m ≥ f(m)/−inf f' if inf f' < 0, else there is none; and r − m ≤ f(m)/−sup f' if sup f' < 0.
///
/// Where f(m) may be 0 and inf f' > 0 (else mirror T): m − r ≤ f(m)/inf f' and r − m ≤ −f(m)/inf f'.
///
/// If 0 ∉ f'(T) and this image lies inside T, T holds exactly one root: f is strictly monotone, and the bounds say that
/// its signs at the ends of T differ.
///
/// For lanes in `usable` only, where f is defined and continuous on T; m lies in T.
#[inline(always)]
pub fn step<P: Packet>(
    p: P,
    t: &Interval<P::F>,
    m: P::F,
    fm: &Interval<P::F>,
    d: &Interval<P::F>,
    usable: P::M,
) -> Around<P> {
    let zero = p.splat(0.0);
    let infinite = p.splat(f64::INFINITY);
    let negative = p.lt(fm.hi, zero);
    let f_lo = p.select(negative, p.neg_f(fm.hi), fm.lo);
    let f_hi = p.select(negative, p.neg_f(fm.lo), fm.hi);
    let d_lo = p.select(negative, p.neg_f(d.hi), d.lo);
    let d_hi = p.select(negative, p.neg_f(d.lo), d.hi);
    let away = p.lt(zero, f_lo);
    let rises = p.lt(zero, d_lo);
    let falls = p.lt(d_hi, zero);
    let monotone = p.and(usable, p.or(rises, falls));

    // Distances from m to the near ends of the pieces, 0 where f(m) may be 0; ∞ where there is no piece.
    let left_near = p.select(p.lt(zero, d_hi), p.div_rd(f_lo, d_hi), infinite);
    let right_near = p.select(p.lt(d_lo, zero), p.div_rd(f_lo, p.neg_f(d_lo)), infinite);
    let left_near = p.select(away, left_near, zero);
    let right_near = p.select(away, right_near, zero);
    // And to the far ends, ∞ where nothing is known. For a monotone lane the slowest slope is positive and finite.
    let slowest = p.select(rises, d_lo, p.neg_f(d_hi));
    let ahead = p.div_ru(p.max_f(f_hi, zero), slowest);
    let against = p.div_ru(p.max_f(p.neg_f(f_lo), zero), slowest);
    let left_far = p.select(monotone, p.select(rises, ahead, against), infinite);
    let right_far = p.select(monotone, p.select(rises, against, ahead), infinite);

    let image = Interval {
        lo: p.sub_rd(m, left_far),
        hi: p.add_ru(m, right_far),
    };
    let inside = p.and(p.lt(t.lo, image.lo), p.lt(image.hi, t.hi));
    let left = p.sub_ru(m, left_near);
    let right = p.add_rd(m, right_near);
    Around {
        lo: p.select(usable, p.max_f(image.lo, t.lo), t.lo),
        left: p.select(usable, left, m),
        right: p.select(usable, right, m),
        hi: p.select(usable, p.min_f(image.hi, t.hi), t.hi),
        one: p.and(monotone, inside),
        slope: *d,
    }
}
