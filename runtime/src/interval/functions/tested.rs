//! Elementary functions by one library call per lane and bound: tested, not proved.
//!
//! What the library returns is widened by [`STEPS`] units in the last place on each side, then cut to the range that
//! the function is known to have. Domains and monotone pieces are exact. See [`UNPROVED`](super::UNPROVED).

use super::super::{Interval, Lanes};

/// Units in the last place by which a library result is widened on each side.
const STEPS: u32 = 4;

/// `f` on each lane; the number that it is given is how many units to widen by.
#[inline(always)]
pub fn per_lane<P: Lanes>(
    p: P,
    a: Interval<P::F>,
    f: fn(Interval, u32) -> Interval,
) -> Interval<P::F> {
    let (lo, hi) = each(
        p.to_array(a.lo),
        p.to_array(a.hi),
        P::LANES,
        if P::DIRECTED { STEPS } else { 0 },
        f,
    );
    Interval {
        lo: p.lanes(lo),
        hi: p.lanes(hi),
    }
}

/// `f` on each lane of two operands.
#[inline(always)]
pub fn per_lane2<P: Lanes>(
    p: P,
    a: Interval<P::F>,
    b: Interval<P::F>,
    f: fn(Interval, Interval, u32) -> Interval,
) -> Interval<P::F> {
    let steps = if P::DIRECTED { STEPS } else { 0 };
    let (a_lo, a_hi) = (p.to_array(a.lo), p.to_array(a.hi));
    let (b_lo, b_hi) = (p.to_array(b.lo), p.to_array(b.hi));
    let (mut lo, mut hi) = ([0.0; 8], [0.0; 8]);
    for i in 0..P::LANES {
        let y = f(
            Interval {
                lo: a_lo[i],
                hi: a_hi[i],
            },
            Interval {
                lo: b_lo[i],
                hi: b_hi[i],
            },
            steps,
        );
        (lo[i], hi[i]) = (y.lo, y.hi);
    }
    Interval {
        lo: p.lanes(lo),
        hi: p.lanes(hi),
    }
}

/// The loop of [`per_lane`], once for all callers.
#[inline(never)]
fn each(
    lo: [f64; 8],
    hi: [f64; 8],
    lanes: usize,
    steps: u32,
    f: fn(Interval, u32) -> Interval,
) -> ([f64; 8], [f64; 8]) {
    let (mut out_lo, mut out_hi) = ([0.0; 8], [0.0; 8]);
    for i in 0..lanes {
        let y = f(
            Interval {
                lo: lo[i],
                hi: hi[i],
            },
            steps,
        );
        (out_lo[i], out_hi[i]) = (y.lo, y.hi);
    }
    (out_lo, out_hi)
}

/// A lower bound from a library result: never +∞.
pub fn down(x: f64, steps: u32) -> f64 {
    let mut x = if steps > 0 { x.min(f64::MAX) } else { x };
    for _ in 0..steps {
        x = x.next_down();
    }
    x
}

/// An upper bound from a library result: never −∞.
pub fn up(x: f64, steps: u32) -> f64 {
    -down(-x, steps)
}

/// An increasing function with range [least, greatest].
fn increasing(a: Interval, steps: u32, f: fn(f64) -> f64, least: f64, greatest: f64) -> Interval {
    Interval {
        lo: down(f(a.lo), steps).max(least),
        hi: up(f(a.hi), steps).min(greatest),
    }
}

/// An increasing function with f(0) = 0 exactly, so the sign of each bound is known.
fn through_zero(a: Interval, steps: u32, f: fn(f64) -> f64, least: f64, greatest: f64) -> Interval {
    let y = increasing(a, steps, f, least, greatest);
    Interval {
        lo: if a.lo >= 0.0 { y.lo.max(0.0) } else { y.lo },
        hi: if a.hi <= 0.0 { y.hi.min(0.0) } else { y.hi },
    }
}

const INF: f64 = f64::INFINITY;

/// A logarithm of x − pole for x > pole; the line where there is no such x.
fn logarithm(a: Interval, steps: u32, f: fn(f64) -> f64, pole: f64) -> Interval {
    if a.hi <= pole {
        return Interval::ENTIRE;
    }
    Interval {
        lo: if a.lo <= pole {
            -INF
        } else {
            down(f(a.lo), steps)
        },
        hi: up(f(a.hi), steps),
    }
}

/// ln(1 + a)
pub fn ln_1p(a: Interval, steps: u32) -> Interval {
    let y = logarithm(a, steps, f64::ln_1p, -1.0);
    Interval {
        lo: if a.lo >= 0.0 { y.lo.max(0.0) } else { y.lo },
        hi: if -1.0 < a.hi && a.hi <= 0.0 {
            y.hi.min(0.0)
        } else {
            y.hi
        },
    }
}

/// The part of `a` in [least, greatest], or the nearest point of it if there is none.
fn clamp(a: Interval, least: f64, greatest: f64) -> Interval {
    Interval {
        lo: a.lo.clamp(least, greatest),
        hi: a.hi.clamp(least, greatest),
    }
}

/// arsinh a
pub fn asinh(a: Interval, steps: u32) -> Interval {
    through_zero(a, steps, asinh_bound, -INF, INF)
}
/// arcosh a
pub fn acosh(a: Interval, steps: u32) -> Interval {
    increasing(clamp(a, 1.0, INF), steps, acosh_bound, 0.0, INF)
}
/// artanh a
pub fn atanh(a: Interval, steps: u32) -> Interval {
    if a.hi <= -1.0 || a.lo >= 1.0 {
        return Interval::ENTIRE;
    }
    through_zero(clamp(a, -1.0, 1.0), steps, atanh_bound, -INF, INF)
}

/// `f64::asinh` is a formula of the standard library's own that overflows above √MAX; there asinh x = ln x + ln 2.
fn asinh_bound(x: f64) -> f64 {
    if x.abs() > 1e150 {
        (x.abs().ln() + std::f64::consts::LN_2).copysign(x)
    } else {
        x.asinh()
    }
}
/// As [`asinh_bound`]; near 1 by ln(1 + z) with z = x − 1 + √((x − 1)(x + 1)), which does not cancel.
fn acosh_bound(x: f64) -> f64 {
    if x > 1e150 {
        return x.ln() + std::f64::consts::LN_2;
    }
    let z = x - 1.0;
    (z + (z * (x + 1.0)).sqrt()).ln_1p()
}
/// artanh x = ½ ln(1 + 2x/(1 − x)), of |x|.
fn atanh_bound(x: f64) -> f64 {
    let m = x.abs();
    (0.5 * (2.0 * m / (1.0 - m)).ln_1p()).copysign(x)
}

/// aᵇ. ln(aᵇ) = b·ln a is bilinear, so the extreme values are those of corners; a corner at 0 or ∞ is the limit along
/// an edge, which the library's value is.
pub fn pow(a: Interval, b: Interval, steps: u32) -> Interval {
    // A power of −0 with a negative exponent would be −∞: adding +0 makes it +0.
    let a = clamp(a, 0.0, INF);
    let a = Interval {
        lo: a.lo + 0.0,
        hi: a.hi + 0.0,
    };
    let corners = [
        a.lo.powf(b.lo),
        a.lo.powf(b.hi),
        a.hi.powf(b.lo),
        a.hi.powf(b.hi),
    ];
    let (mut lo, mut hi) = (INF, 0.0_f64);
    for corner in corners {
        lo = lo.min(corner);
        hi = hi.max(corner);
    }
    Interval {
        lo: down(lo, steps).max(0.0),
        hi: up(hi, steps),
    }
}
