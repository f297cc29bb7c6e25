//! The flags of partial functions: where an operand leaves the domain, partly or wholly.

use super::super::{Flags, Interval, Lanes};

/// Domain x ≠ 0.
#[inline(always)]
pub fn nonzero<P: Lanes>(p: P, a: Interval<P::F>) -> Flags<P> {
    let zero = p.splat(0.0);
    let undefined = p.and(p.le(a.lo, zero), p.le(zero, a.hi));
    let empty = p.and(p.eq(a.lo, zero), p.eq(a.hi, zero));
    Flags {
        empty,
        undefined,
        ..Flags::none(p)
    }
}

/// Domain x ≥ bound.
#[inline(always)]
pub fn at_least<P: Lanes>(p: P, a: Interval<P::F>, bound: f64) -> Flags<P> {
    let bound = p.splat(bound);
    Flags {
        empty: p.lt(a.hi, bound),
        undefined: p.lt(a.lo, bound),
        ..Flags::none(p)
    }
}

/// Domain x > bound.
#[inline(always)]
pub fn above<P: Lanes>(p: P, a: Interval<P::F>, bound: f64) -> Flags<P> {
    let bound = p.splat(bound);
    Flags {
        empty: p.le(a.hi, bound),
        undefined: p.le(a.lo, bound),
        ..Flags::none(p)
    }
}

/// Domain least ≤ x ≤ greatest.
#[inline(always)]
pub fn between<P: Lanes>(p: P, a: Interval<P::F>, least: f64, greatest: f64) -> Flags<P> {
    let (least, greatest) = (p.splat(least), p.splat(greatest));
    Flags {
        empty: p.or(p.lt(a.hi, least), p.lt(greatest, a.lo)),
        undefined: p.or(p.lt(a.lo, least), p.lt(greatest, a.hi)),
        ..Flags::none(p)
    }
}

/// Domain least < x < greatest.
#[inline(always)]
pub fn inside<P: Lanes>(p: P, a: Interval<P::F>, least: f64, greatest: f64) -> Flags<P> {
    let (least, greatest) = (p.splat(least), p.splat(greatest));
    Flags {
        empty: p.or(p.le(a.hi, least), p.le(greatest, a.lo)),
        undefined: p.or(p.le(a.lo, least), p.le(greatest, a.hi)),
        ..Flags::none(p)
    }
}

/// The domain of aᵇ: a > 0, or a = 0 and b > 0.
#[inline(always)]
pub fn power<P: Lanes>(p: P, a: Interval<P::F>, b: Interval<P::F>) -> Flags<P> {
    let zero = p.splat(0.0);
    let at_zero = p.and(p.le(a.lo, zero), p.le(b.lo, zero));
    let only_zero = p.and(p.le(a.hi, zero), p.le(b.hi, zero));
    Flags {
        empty: p.or(p.lt(a.hi, zero), only_zero),
        undefined: p.or(p.lt(a.lo, zero), at_zero),
        ..Flags::none(p)
    }
}

/// The angle of (x, y): undefined at the origin; it jumps by 2π where y changes sign at x < 0.
#[inline(always)]
pub fn angle<P: Lanes>(p: P, y: Interval<P::F>, x: Interval<P::F>) -> Flags<P> {
    let zero = p.splat(0.0);
    let on_axis = p.and(p.le(y.lo, zero), p.le(zero, y.hi));
    let origin = p.and(on_axis, p.and(p.le(x.lo, zero), p.le(zero, x.hi)));
    let point = p.and(
        p.and(p.eq(x.lo, zero), p.eq(x.hi, zero)),
        p.and(p.eq(y.lo, zero), p.eq(y.hi, zero)),
    );
    // On the axis itself the angle is π, above it less: only points below it are a jump away.
    let cut = p.and(p.and(on_axis, p.lt(y.lo, zero)), p.lt(x.lo, zero));
    Flags {
        empty: point,
        undefined: origin,
        jump: cut,
        kink: cut,
    }
}
