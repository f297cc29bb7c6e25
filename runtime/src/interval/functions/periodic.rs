//! Where extrema and poles of the circular functions lie in an interval.

use super::super::{Flags, Interval, Lanes, Scalar};
use super::tested;

/// 1/2π between two neighbouring doubles.
const TURN: Interval = Interval {
    lo: f64::from_bits(0x3FC4_5F30_6DC9_C882),
    hi: f64::from_bits(0x3FC4_5F30_6DC9_C883),
};

/// May `a`/2π·`halves` − `shift` hold a whole number? (`halves` is 1 or 2, `shift` a dyadic fraction.) Never wrongly
/// false. Beyond 2⁴⁰ the quotient is not known to a fraction, and the answer is yes.
fn may_hold_whole(a: Interval, halves: f64, shift: f64) -> bool {
    let p = Scalar;
    if a.lo < -(2f64.powi(40)) || a.hi > 2f64.powi(40) {
        return true;
    }
    let low = p.mul_rd(a.lo, halves * if a.lo < 0.0 { TURN.hi } else { TURN.lo });
    let high = p.mul_ru(a.hi, halves * if a.hi < 0.0 { TURN.lo } else { TURN.hi });
    p.sub_rd(low, shift).ceil() <= p.sub_ru(high, shift).floor()
}

/// A wave of period 2π with range [−1, 1], its maxima at 2π(k + `peak`), its minima half a period later.
pub fn wave(a: Interval, steps: u32, f: fn(f64) -> f64, peak: f64) -> Interval {
    let hi = may_hold_whole(a, 1.0, peak);
    let lo = may_hold_whole(a, 1.0, peak + 0.5);
    if hi && lo {
        return Interval { lo: -1.0, hi: 1.0 };
    }
    let (start, end) = (f(a.lo), f(a.hi));
    Interval {
        lo: if lo {
            -1.0
        } else {
            tested::down(start.min(end), steps).max(-1.0)
        },
        hi: if hi {
            1.0
        } else {
            tested::up(start.max(end), steps).min(1.0)
        },
    }
}

/// tan a: increasing between its poles at π(k + ½); the line, *undefined*, where there may be one.
#[inline(always)]
pub fn tan<P: Lanes>(p: P, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
    let range = tested::per_lane(p, a, tan_of_one);
    let pole = p.and(
        p.eq(range.lo, p.splat(f64::NEG_INFINITY)),
        p.eq(range.hi, p.splat(f64::INFINITY)),
    );
    (
        range,
        Flags {
            undefined: pole,
            ..Flags::none(p)
        },
    )
}

/// tan of one interval. No double is a pole, so an unbounded result means that one may be inside.
fn tan_of_one(a: Interval, steps: u32) -> Interval {
    if may_hold_whole(a, 2.0, 0.5) {
        return Interval::ENTIRE;
    }
    Interval {
        lo: tested::down(a.lo.tan(), steps),
        hi: tested::up(a.hi.tan(), steps),
    }
}
