//! eˣ − 1, sinh and tanh on packets, from one reduction, proved.
//!
//! With k, r₁ and t as in [`exp`](super::exp), eˣ = 2ᵏ·(1 + s) with s near r₁ + t. Everything here is made of
//! g = 2⁻ᵏ and w = 2⁻ᵏ·(eˣ − 1) = (1 − g) + s, which in doubles is
//!
//! * c = 1 − g, h + l = c + r₁ exactly (|c| ≥ ½ or c = 0), w = h + (l + t).
//!
//! | | as a real number | steps outward |
//! |---|---|---|
//! | eˣ − 1 | 2ᵏ·w | 2 |
//! | sinh x, x ≥ 0 | 2ᵏ⁻¹·(w + g·w/(w + g)), for w + g = 1 + s | 3 |
//! | tanh (x/2), x ≥ 0 | w/(w + 2g) | 3 |
//!
//! Gappa bounds the error of t, absolutely and, for k = 0, relatively (`runtime/proofs/exp_m1.g`, `exp_m1_zero.g`).
//! `exp_m1.sollya` bounds the polynomial's and then goes through all k and r₁ in small pieces: the errors of t, of the
//! sums and of the quotient that come before the last operation are together less than 1.5 units in the last place of
//! the result for eˣ − 1, and less than 2.5 for the others, with and without fused operations (g·q is exact). The last
//! operation errs by half a unit, scaling not at all: the result of eˣ − 1 and sinh is either x itself, or normal.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::exp::{self, L2};
use super::neighbours::{around, with_sign_of};

/// Below this x, eˣ − 1 is −1 to less than half a unit.
const LEAST: f64 = -40.0;
/// The greatest double below arsinh(MAX). Its sinh is 10⁻¹⁴ below MAX, relatively.
const GREATEST_SINH: u64 = 0x408633ce8fb9f87d;
/// Above this x, tanh(x/2) is 1 to less than half a unit.
const GREATEST_TANH: f64 = 44.0;

/// g = 2⁻ᵏ (2⁻⁶⁰ where that is less), w ≈ 2⁻ᵏ·(eˣ − 1), and k, for LEAST ≤ x ≤ 710.5.
#[inline(always)]
fn reduce<P: Lanes>(p: P, x: P::F) -> (P::F, P::F, P::F) {
    let (k, r1) = exp::reduce(p, x);
    let t = exp::tail(p, r1, p.mul_rn(k, p.splat(f64::from_bits(L2))));
    // Above k = 53 the difference rounds to 1, also with a power that is too large.
    let g = p.pow2(p.max_f(p.neg_f(k), p.splat(-60.0)));
    let c = p.sub_rn(p.splat(1.0), g);
    let h = p.add_rn(c, r1);
    let l = p.sub_rn(r1, p.sub_rn(h, c));
    (g, p.add_rn(h, p.add_rn(l, t)), k)
}

/// eᵃ − 1: two units in the last place on either side.
#[inline(always)]
pub fn exp_m1<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let greatest = p.splat(f64::from_bits(exp::GREATEST));
    let lo = around(p, near_exp_m1(p, a.lo), 2).lo;
    let hi = around(p, near_exp_m1(p, a.hi), 2).hi;
    Interval {
        lo: p.max_f(lo, p.splat(-1.0)),
        hi: p.select(p.lt(greatest, a.hi), p.splat(f64::INFINITY), hi),
    }
}

/// eˣ − 1 to a few units in the last place, for every x; NaN of NaN.
#[inline(always)]
pub fn exp_m1_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let beyond = p.lt(p.splat(f64::from_bits(exp::GREATEST)), x);
    let y = p.select(beyond, p.splat(f64::INFINITY), near_exp_m1(p, x));
    p.select(p.eq(x, x), y, x)
}

/// eˣ − 1 for x up to [`exp::GREATEST`], which stands for all above.
#[inline(always)]
fn near_exp_m1<P: Lanes>(p: P, x: P::F) -> P::F {
    let greatest = p.splat(f64::from_bits(exp::GREATEST));
    let x = p.max_f(p.min_f(x, greatest), p.splat(LEAST));
    let (_, w, k) = reduce(p, x);
    p.scale(w, k)
}

/// sinh a: three units in the last place on either side.
#[inline(always)]
pub fn sinh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let greatest = p.splat(f64::from_bits(GREATEST_SINH));
    let lo = around(p, near_sinh(p, a.lo), 3).lo;
    let hi = around(p, near_sinh(p, a.hi), 3).hi;
    let below = p.lt(a.lo, p.neg_f(greatest));
    let above = p.lt(greatest, a.hi);
    Interval {
        lo: p.select(below, p.splat(f64::NEG_INFINITY), lo),
        hi: p.select(above, p.splat(f64::INFINITY), hi),
    }
}

/// sinh x to a few units in the last place, for every x; NaN of NaN.
#[inline(always)]
pub fn sinh_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let size = p.abs_f(x);
    let beyond = p.lt(p.splat(f64::from_bits(GREATEST_SINH)), size);
    let infinity = with_sign_of(p, p.splat(f64::INFINITY), x);
    let y = p.select(beyond, infinity, near_sinh(p, x));
    p.select(p.eq(x, x), y, x)
}

/// sinh x for |x| up to [`GREATEST_SINH`], which stands for all above.
#[inline(always)]
fn near_sinh<P: Lanes>(p: P, x: P::F) -> P::F {
    let size = p.min_f(p.abs_f(x), p.splat(f64::from_bits(GREATEST_SINH)));
    let (g, w, k) = reduce(p, size);
    let q = p.div_rn(w, p.add_rn(w, g));
    let y = p.scale(p.fma_rn(g, q, w), p.sub_rn(k, p.splat(1.0)));
    with_sign_of(p, y, x)
}

/// tanh a: three units in the last place on either side, and not beyond ±1.
#[inline(always)]
pub fn tanh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let lo = around(p, near_tanh(p, a.lo), 3).lo;
    let hi = around(p, near_tanh(p, a.hi), 3).hi;
    Interval {
        lo: p.max_f(lo, p.splat(-1.0)),
        hi: p.min_f(hi, p.splat(1.0)),
    }
}

/// tanh x to a few units in the last place, for every x; NaN of NaN.
#[inline(always)]
pub fn tanh_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    p.select(p.eq(x, x), near_tanh(p, x), x)
}

/// tanh x
#[inline(always)]
fn near_tanh<P: Lanes>(p: P, x: P::F) -> P::F {
    let size = p.abs_f(x);
    let (g, w, _) = reduce(p, p.min_f(p.add_rn(size, size), p.splat(GREATEST_TANH)));
    let y = p.div_rn(w, p.add_rn(w, p.add_rn(g, g)));
    with_sign_of(p, y, x)
}
