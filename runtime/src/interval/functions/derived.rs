//! Functions that are a few interval operations on proved ones, so that their enclosures are proved too.

use super::super::enclose::Enclose;
use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes};
use super::exp::near;

/// ln 2 between two neighbouring doubles.
const LN_2: Interval = Interval {
    lo: f64::from_bits(0x3fe62e42fefa39ef),
    hi: f64::from_bits(0x3fe62e42fefa39f0),
};
/// 1/ln 2
const LOG2_E: Interval = Interval {
    lo: f64::from_bits(0x3ff71547652b82fe),
    hi: f64::from_bits(0x3ff71547652b82ff),
};
/// 1/ln 10
const LOG10_E: Interval = Interval {
    lo: f64::from_bits(0x3fdbcb7b1526e50e),
    hi: f64::from_bits(0x3fdbcb7b1526e50f),
};

#[inline(always)]
fn constant<P: Lanes>(p: P, c: Interval) -> Interval<P::F> {
    Interval {
        lo: p.splat(c.lo),
        hi: p.splat(c.hi),
    }
}

/// log₂ a = ln a/ln 2
#[inline(always)]
pub fn log2<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    p.i_mul_pos(constant(p, LOG2_E), p.i_ln(a))
}

/// log₁₀ a = ln a/ln 10
#[inline(always)]
pub fn log10<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    p.i_mul_pos(constant(p, LOG10_E), p.i_ln(a))
}

/// cosh a = (e + 1/e)/2 with e = exp |a|, increasing in e ≥ 1, so that each bound is that of one e.
#[inline(always)]
pub fn cosh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let e = p.i_exp(p.i_abs(a));
    let (one, half) = (p.splat(1.0), p.splat(0.5));
    let least = p.max_f(e.lo, one);
    // Halves are exact: the sums are above 1.
    let lo = p.mul_rn(half, p.add_rd(least, p.div_rd(one, least)));
    let hi = p.mul_rn(half, p.add_ru(e.hi, p.div_ru(one, e.hi)));
    Interval {
        lo: p.max_f(lo, one),
        hi,
    }
}

/// 2ᵃ
#[inline(always)]
pub fn exp2<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let (least, greatest) = (p.splat(LEAST), p.splat(GREATEST));
    let lo = power_of_two(p, p.max_f(p.min_f(a.lo, greatest), least)).lo;
    let hi = power_of_two(p, p.max_f(p.min_f(a.hi, greatest), least)).hi;
    Interval {
        lo: p.select(p.lt(a.lo, least), p.splat(0.0), lo),
        hi: p.select(p.lt(greatest, a.hi), p.splat(f64::INFINITY), hi),
    }
}

/// Between these 2ˣ and its neighbours are normal numbers.
const LEAST: f64 = -1021.0;
const GREATEST: f64 = 1023.0;

/// 2ˣ = 2ᵏ·exp((x − k)·ln 2) with k = ⌊x⌉: the difference is exact, its product with ln 2 is an interval, and of its
/// power the neighbours are bounds; |(x − k)·ln 2| < 0.34658, the range of the proof of [`near`], where k is 0 for it.
#[inline(always)]
fn power_of_two<P: Enclose>(p: P, x: P::F) -> Interval<P::F> {
    let shift = p.splat(WHOLE);
    let k = p.sub_rn(p.add_rn(x, shift), shift);
    let f = p.sub_rn(x, k);
    let r = p.i_mul_pos(constant(p, LN_2), Interval { lo: f, hi: f });
    Interval {
        lo: p.scale(p.before(near(p, r.lo)), k),
        hi: p.scale(p.after(near(p, r.hi)), k),
    }
}
