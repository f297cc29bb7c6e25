//! Equal steps until the sign changes, then Newton's iteration without any safeguard.

use super::Search;
use super::march::bracket;
use zeroset::interval::Packet;

#[inline(always)]
pub(super) fn trace<P: Packet>(p: P, search: &Search<P>, steps: u32) -> P::F {
    let brackets = bracket(p, search, steps);
    let [a, b] = brackets.t;
    let mut t = p.mul_rn(p.splat(0.5), p.add_rn(a, b));
    let mut live = brackets.found;
    let mut number = 0;
    while number < 50 && p.any(live) {
        let [f, slope] = search.probe.slope(p, t, live);
        let step = p.div_rn(f, slope);
        t = p.select(live, p.sub_rn(t, step), t);
        live = p.and_not(live, p.le(p.abs_f(step), search.tolerance));
        number += 1;
    }
    p.select(brackets.found, t, p.splat(f64::NAN))
}
