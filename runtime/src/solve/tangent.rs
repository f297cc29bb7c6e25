//! Roots that come in pairs: what the second derivative proves.

use super::floor::any_slope;
use super::{Brackets, Enclosed, Field, nonzero, select, twice_differentiable};
use crate::contract::middle;
use crate::interval::{Interval, Packet};

/// f at the two ends of a segment.
#[derive(Clone, Copy)]
pub(crate) struct Ends<P: Packet> {
    pub lo: Interval<P::F>,
    pub hi: Interval<P::F>,
}

impl<P: Packet> Ends<P> {
    /// Opposite certain signs.
    #[inline(always)]
    pub fn change(&self, p: P) -> P::M {
        let zero = p.splat(0.0);
        let falls = p.and(p.lt(zero, self.lo.lo), p.lt(self.hi.hi, zero));
        let rises = p.and(p.lt(self.lo.hi, zero), p.lt(zero, self.hi.lo));
        p.or(falls, rises)
    }

    /// The same certain sign.
    #[inline(always)]
    pub fn same(&self, p: P) -> P::M {
        let zero = p.splat(0.0);
        let positive = p.and(p.lt(zero, self.lo.lo), p.lt(zero, self.hi.lo));
        let negative = p.and(p.lt(self.lo.hi, zero), p.lt(self.hi.hi, zero));
        p.or(positive, negative)
    }
}

/// What the curvature proved about a segment.
pub(crate) struct Found<P: Packet> {
    /// There is no root.
    pub none: P::M,
    /// The first of one or two roots that are apart.
    pub brackets: Brackets<P>,
    /// None, one or two roots, all in `t`.
    pub tangent: P::M,
    pub t: Interval<P::F>,
    /// An upper bound of |f| at the critical point.
    pub residual: P::F,
}

/// Let 0 ∉ f''(T), and f'' > 0 (else mirror the signs). If f has opposite certain signs at the ends of T, it has one root
/// between them; if it is negative at both, none. If f' has the same certain sign at both, f is monotone, and signs that are the
/// same exclude a root.
///
/// Else let f' have opposite certain signs at the ends of T. Then f has exactly one critical point c in T, its minimum. Newton on f' encloses c in C: c ∈ m − f'(m)/f''(T). On C,
/// |f'| ≤ max |f''|·w with w the width of C, so f(C) ⊆ f(m) ± max |f''|·w².
///
/// - f(C) > 0: no root.
/// - f(C) < 0: f falls up to C and rises behind it: one root on each side whose end is positive, none on a side whose
///   end is negative.
/// - 0 ∈ f(C), r = max |f(C)|: at a root t, 0 = f(t) ≥ f(c) + ½·min f''·(t − c)², so |t − c| ≤ √(2r/min f'').
#[inline(always)]
pub(crate) fn tangent<P: Packet>(
    field: &mut Field<'_, P>,
    t: &Interval<P::F>,
    f: &Enclosed<P, 3>,
    ends: &Ends<P>,
    lanes: P::M,
) -> Found<P> {
    let p = field.p;
    let zero = p.splat(0.0);
    let bent = p.and(
        twice_differentiable(p, &f.flags, lanes),
        nonzero(p, &f.d[2]),
    );
    let up = p.lt(zero, f.d[2].lo);
    let mut brackets = Brackets::none(p);
    let any_slope = any_slope(p);
    let one = p.and(bent, ends.change(p));
    let rising = p.lt(ends.lo.hi, zero);
    brackets.put(p, one, t, &any_slope, rising, t.hi);
    let hangs = p.and(up, rising);
    let arches = p.and_not(p.lt(zero, ends.lo.lo), up);
    let same = p.and(bent, ends.same(p));
    let beyond = p.and(same, p.or(hangs, arches));
    let bent = p.and_not(p.and_not(bent, one), beyond);
    if !p.any(bent) {
        return Found {
            none: beyond,
            brackets,
            tangent: p.none(),
            t: *t,
            residual: zero,
        };
    }
    let at_lo = field.slope(&Interval { lo: t.lo, hi: t.lo }, bent);
    let at_hi = field.slope(&Interval { lo: t.hi, hi: t.hi }, bent);
    let turn = Ends {
        lo: at_lo.d[1],
        hi: at_hi.d[1],
    };
    let monotone = p.and(same, turn.same(p));
    let proved = p.and(bent, turn.change(p));

    let mut c = *t;
    let mut m = middle(p, &c);
    let mut round = 0;
    let close = p.mul_rn(t.hi, p.splat(1.0 / (1u64 << 26) as f64));
    let mut wide = proved;
    while round < 3 || round < 12 && p.any(wide) {
        let at_m = field.slope(&Interval { lo: m, hi: m }, proved);
        let (step, _) = p.div(at_m.d[1], f.d[2]);
        let lo = p.max_f(p.sub_rd(m, step.hi), c.lo);
        let hi = p.min_f(p.sub_ru(m, step.lo), c.hi);
        c = select(p, p.and(proved, p.le(lo, hi)), &Interval { lo, hi }, &c);
        m = middle(p, &c);
        wide = p.and(proved, p.lt(close, p.sub_rn(c.hi, c.lo)));
        round += 1;
    }
    let at_m = field.point(m, proved);
    let width = p.sub_ru(c.hi, c.lo);
    let steepest = p.max_f(p.abs_f(f.d[2].lo), p.abs_f(f.d[2].hi));
    let spread = p.mul_ru(steepest, p.mul_ru(width, width));
    let low = Interval {
        lo: p.sub_rd(at_m.d[0].lo, spread),
        hi: p.add_ru(at_m.d[0].hi, spread),
    };

    // Mirrored so that f'' > 0.
    let extreme = select(
        p,
        up,
        &low,
        &Interval {
            lo: p.neg_f(low.hi),
            hi: p.neg_f(low.lo),
        },
    );
    let left = select(
        p,
        up,
        &ends.lo,
        &Interval {
            lo: p.neg_f(ends.lo.hi),
            hi: p.neg_f(ends.lo.lo),
        },
    );
    let right = select(
        p,
        up,
        &ends.hi,
        &Interval {
            lo: p.neg_f(ends.hi.hi),
            hi: p.neg_f(ends.hi.lo),
        },
    );
    let above = p.and(proved, p.lt(zero, extreme.lo));
    let below = p.and(proved, p.lt(extreme.hi, zero));
    let falls_in = p.and(below, p.lt(zero, left.lo));
    let not_left = p.and(below, p.lt(left.hi, zero));
    let climbs_out = p.and(not_left, p.lt(zero, right.lo));
    let before = Interval { lo: t.lo, hi: c.lo };
    let behind = Interval { lo: c.hi, hi: t.hi };
    brackets.put(
        p,
        falls_in,
        &before,
        &any_slope,
        p.and_not(falls_in, up),
        c.hi,
    );
    brackets.put(
        p,
        climbs_out,
        &behind,
        &any_slope,
        p.and(climbs_out, up),
        t.hi,
    );

    let residual = p.max_f(p.abs_f(low.lo), p.abs_f(low.hi));
    let flattest = p.min_f(p.abs_f(f.d[2].lo), p.abs_f(f.d[2].hi));
    let radius = p.sqrt_ru(p.div_ru(p.add_ru(residual, residual), flattest));
    let near = Interval {
        lo: p.max_f(p.sub_rd(c.lo, radius), t.lo),
        hi: p.min_f(p.add_ru(c.hi, radius), t.hi),
    };
    Found {
        none: p.or(above, p.or(beyond, monotone)),
        brackets,
        tangent: p.and_not(p.and_not(proved, above), below),
        t: near,
        residual,
    }
}
