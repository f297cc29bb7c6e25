//! Segment tracing: as sphere tracing, by a bound of |f'| on the next piece of the ray; a piece is twice the last step.

use super::Search;
use zeroset::interval::{Interval, Packet};

#[inline(always)]
pub(super) fn trace<P: Packet>(p: P, search: &Search<P>, most: u32) -> P::F {
    let zero = p.splat(0.0);
    let mut live = p.le(zero, search.end);
    let mut found = p.none();
    let mut t = zero;
    let mut piece = p.mul_rn(search.end, p.splat(0.25));
    let mut number = 0;
    while number < most && p.any(live) {
        let f = search.probe.value(p, t, live);
        let over = Interval {
            lo: p.max_f(t, zero),
            hi: p.max_f(p.add_rn(t, piece), zero),
        };
        let slope = search.probe.bounds(p, &over, live);
        let steepest = p.max_f(p.abs_f(slope.lo), p.abs_f(slope.hi));
        let safe = p.div_rn(p.abs_f(f), steepest);
        let step = p.min_f(safe, piece);
        let hit = p.and(live, p.le(safe, search.tolerance));
        found = p.or(found, hit);
        t = p.select(live, p.add_rn(t, step), t);
        piece = p.add_rn(step, step);
        live = p.and(p.and_not(live, hit), p.le(t, search.end));
        number += 1;
    }
    p.select(found, t, p.splat(f64::NAN))
}
