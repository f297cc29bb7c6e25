//! Intervals that are hardly more than a point, as points of a ray are: one look at the middle is enough.

use super::super::{Interval, Lanes};

/// The middle of an interval, and how far the ends are from there.
#[inline(always)]
pub fn middle<P: Lanes>(p: P, a: &Interval<P::F>) -> (P::F, P::F) {
    let half = p.mul_rn(p.splat(0.5), p.sub_rn(a.hi, a.lo));
    // Of a point, exactly that.
    let middle = p.add_rn(a.lo, half);
    let radius = p.max_f(p.sub_ru(middle, a.lo), p.sub_ru(a.hi, middle));
    (
        middle,
        unless_exact(p, p.eq(a.lo, a.hi), p.splat(0.0), radius),
    )
}

/// `sum`, or `exact` where nothing was added: there some back-ends widen a sum nevertheless.
#[inline(always)]
pub fn unless_exact<P: Lanes>(p: P, nothing: P::M, exact: P::F, sum: P::F) -> P::F {
    if P::OPTIMAL {
        sum
    } else {
        p.select(nothing, exact, sum)
    }
}
