//! Functions that are a few interval operations on proved ones, so that their enclosures are proved too.

use super::super::enclose::Enclose;
use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes};
use super::exp::{self, near};
use super::ln;

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

/// log₂ x to a few units in the last place; NaN for x < 0 and of NaN.
#[inline(always)]
pub fn log2_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    p.mul_rn(p.splat(LOG2_E.lo), ln::anywhere(p, x))
}

/// log₁₀ x to a few units in the last place; NaN for x < 0 and of NaN.
#[inline(always)]
pub fn log10_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    p.mul_rn(p.splat(LOG10_E.lo), ln::anywhere(p, x))
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

/// cosh x to a few units in the last place; ∞ already where eˣ is, NaN of NaN.
#[inline(always)]
pub fn cosh_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let e = exp::anywhere(p, p.abs_f(x));
    let half = p.splat(0.5);
    p.fma_rn(half, e, p.div_rn(half, e))
}

/// 2ˣ to a few units in the last place; 0 where it is not a normal number, NaN of NaN.
#[inline(always)]
pub fn exp2_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let (least, greatest) = (p.splat(LEAST), p.splat(GREATEST));
    // Constants first: a NaN passes through.
    let (k, f) = whole_part(p, p.max_f(least, p.min_f(greatest, x)));
    let y = p.scale(near(p, p.mul_rn(p.splat(LN_2.lo), f)), k);
    let y = p.select(p.lt(x, least), p.splat(0.0), y);
    p.select(p.lt(greatest, x), p.splat(f64::INFINITY), y)
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

/// Between these 2ˣ and its neighbours are normal numbers; the upper one is the double before 1024.
const LEAST: f64 = -1021.0;
const GREATEST: f64 = f64::from_bits(0x408f_ffff_ffff_ffff);

/// 2ˣ = 2ᵏ·exp((x − k)·ln 2) with k = ⌊x⌉: the difference is exact, its product with ln 2 is an interval, and of its
/// power the neighbours are bounds; |(x − k)·ln 2| < 0.34658, the range of the proof of [`near`], where k is 0 for it.
#[inline(always)]
fn power_of_two<P: Enclose>(p: P, x: P::F) -> Interval<P::F> {
    let (k, f) = whole_part(p, x);
    let r = p.i_mul_pos(constant(p, LN_2), Interval { lo: f, hi: f });
    Interval {
        lo: p.scale(p.before(near(p, r.lo)), k),
        hi: p.scale(p.after(near(p, r.hi)), k),
    }
}

/// k = ⌊x⌉ and x − k.
#[inline(always)]
fn whole_part<P: Lanes>(p: P, x: P::F) -> (P::F, P::F) {
    let shift = p.splat(WHOLE);
    let k = p.sub_rn(p.add_rn(x, shift), shift);
    (k, p.sub_rn(x, k))
}
