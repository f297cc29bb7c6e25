//! Sphere tracing: |f| over the Lipschitz bound of the box is a distance without a root.

use super::Search;
use zeroset::interval::Packet;

#[inline(always)]
pub(super) fn trace<P: Packet>(p: P, search: &Search<P>, most: u32) -> P::F {
    let zero = p.splat(0.0);
    let mut live = p.le(zero, search.end);
    let mut found = p.none();
    let mut t = zero;
    let mut number = 0;
    while number < most && p.any(live) {
        let f = search.probe.value(p, t, live);
        let step = p.mul_rn(p.abs_f(f), search.reach);
        let hit = p.and(live, p.le(step, search.tolerance));
        found = p.or(found, hit);
        t = p.select(live, p.add_rn(t, step), t);
        live = p.and(p.and_not(live, hit), p.le(t, search.end));
        number += 1;
    }
    p.select(found, t, p.splat(f64::NAN))
}
