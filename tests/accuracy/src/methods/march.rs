//! Equal steps until the sign changes, then regula falsi.

use super::Search;
use zeroset::interval::Packet;

/// The first steps with a change of sign.
pub(super) struct Brackets<P: Packet> {
    pub found: P::M,
    pub t: [P::F; 2],
    pub f: [P::F; 2],
}

#[inline(always)]
pub(super) fn bracket<P: Packet>(p: P, search: &Search<P>, steps: u32) -> Brackets<P> {
    let zero = p.splat(0.0);
    let mut live = p.le(zero, search.end);
    let step = p.mul_rn(search.end, p.splat(1.0 / f64::from(steps)));
    let mut t = zero;
    let mut f = search.probe.value(p, t, live);
    let mut brackets = Brackets {
        found: p.none(),
        t: [zero; 2],
        f: [zero; 2],
    };
    let mut number = 1;
    while number <= steps && p.any(live) {
        let next = p.mul_rn(step, p.splat(f64::from(number)));
        let g = search.probe.value(p, next, live);
        let crossed = p.and(live, p.le(p.mul_rn(f, g), zero));
        if p.any(crossed) {
            brackets.found = p.or(brackets.found, crossed);
            brackets.t[0] = p.select(crossed, t, brackets.t[0]);
            brackets.t[1] = p.select(crossed, next, brackets.t[1]);
            brackets.f[0] = p.select(crossed, f, brackets.f[0]);
            brackets.f[1] = p.select(crossed, g, brackets.f[1]);
            live = p.and_not(live, crossed);
        }
        (t, f) = (next, g);
        number += 1;
    }
    brackets
}

/// The Illinois rule: where one end stays twice, its value counts half.
#[inline(always)]
pub(super) fn trace<P: Packet>(p: P, search: &Search<P>, steps: u32) -> P::F {
    let brackets = bracket(p, search, steps);
    let zero = p.splat(0.0);
    let half = p.splat(0.5);
    let ([mut a, mut b], [mut fa, mut fb]) = (brackets.t, brackets.f);
    let mut root = b;
    let mut live = brackets.found;
    let mut number = 0;
    while number < 100 && p.any(live) {
        // f(b) is the newest value.
        let slope = p.div_rn(p.sub_rn(b, a), p.sub_rn(fb, fa));
        let m = p.sub_rn(b, p.mul_rn(fb, slope));
        let m = p.select(p.eq(m, m), m, b);
        let fm = search.probe.value(p, m, live);
        let moved = p.abs_f(p.sub_rn(m, b));
        root = p.select(live, m, root);
        let done = p.or(p.le(moved, search.tolerance), p.eq(fm, zero));
        let opposite = p.le(p.mul_rn(fm, fb), zero);
        a = p.select(opposite, b, a);
        fa = p.select(opposite, fb, p.mul_rn(fa, half));
        (b, fb) = (m, fm);
        live = p.and_not(live, done);
        number += 1;
    }
    p.select(brackets.found, root, p.splat(f64::NAN))
}
