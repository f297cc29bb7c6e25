//! eˣ − 1, sinh and tanh on packets, from one reduction, proved.
//!
//! With k, r₁ and t as in [`exp`], eˣ = 2ᵏ·(1 + s) with s near r₁ + t. Everything here is made of
//! g = 2⁻ᵏ and w = 2⁻ᵏ·(eˣ − 1) = (1 − g) + s, which in doubles is
//!
//! * c = 1 − g, h + l = c + r₁ exactly (|c| ≥ ½ or c = 0), w + w′ = h + (l + t).
//!
//! | | as a real number | in doubles |
//! |---|---|---|
//! | eˣ − 1 | 2ᵏ·w | w alone |
//! | sinh x, x ≥ 0 | 2ᵏ⁻¹·(w + g·w/(w + g)), for w + g = 1 + s | all pairs, the quotient too; then their sum |
//! | tanh (x/2), x ≥ 0 | w/(w + 2g) | the same |
//!
//! Gappa bounds the error of t, absolutely and, for k = 0, relatively (`runtime/proofs/exp_m1.g`, `exp_m1_zero.g`).
//! `exp_m1.sollya` bounds the polynomial's and then goes through all k and r₁ in small pieces: what t, l + t and c err by is
//! less than 1.5 units in the last place of each result, with and without fused operations. Pairs err by less than 2⁻⁹⁵
//! besides (g·q is exact). The last operation errs by half a unit, scaling not at all: the result is either x itself, or
//! normal. So two steps outward do.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::exp::{self, L2};
use super::neighbours::{around, with_sign_of};
use super::two_fold::{Sum, fast_two_sum, quotient};

/// Below this x, eˣ − 1 is −1 to less than half a unit.
const LEAST: f64 = -40.0;
/// The greatest double below arsinh(MAX). Its sinh is 10⁻¹⁴ below MAX, relatively.
const GREATEST_SINH: u64 = 0x408633ce8fb9f87d;
/// Above this x, tanh(x/2) is 1 to less than half a unit.
const GREATEST_TANH: f64 = 44.0;

/// g = 2⁻ᵏ (2⁻⁶⁰ where that is less), w + w′ ≈ 2⁻ᵏ·(eˣ − 1), and k, for LEAST ≤ x ≤ 710.5.
#[inline(always)]
fn reduce<P: Lanes>(p: P, x: P::F) -> (P::F, Sum<P::F>, P::F) {
    let (k, r1) = exp::reduce(p, x);
    let t = exp::tail(p, r1, p.mul_rn(k, p.splat(f64::from_bits(L2))));
    // Above k = 53 the difference rounds to 1, also with a power that is too large.
    let g = p.pow2(p.max_f(p.neg_f(k), p.splat(-60.0)));
    let c = p.sub_rn(p.splat(1.0), g);
    let sum = fast_two_sum(p, c, r1);
    (g, fast_two_sum(p, sum.high, p.add_rn(sum.low, t)), k)
}

/// w/(w + c) for w ≥ 0 and c > 0.
#[inline(always)]
fn share<P: Lanes>(p: P, w: Sum<P::F>, c: P::F) -> Sum<P::F> {
    let d = fast_two_sum(p, p.max_f(w.high, c), p.min_f(w.high, c));
    let low = p.add_rn(d.low, w.low);
    quotient(p, w, Sum { low, ..d })
}

/// eᵃ − 1: two units in the last place on either side (see the head of this file).
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
    p.scale(w.high, k)
}

/// sinh a: two units in the last place on either side (see the head of this file).
#[inline(always)]
pub fn sinh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let greatest = p.splat(f64::from_bits(GREATEST_SINH));
    let lo = around(p, near_sinh(p, a.lo), 2).lo;
    let hi = around(p, near_sinh(p, a.hi), 2).hi;
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
    let q = share(p, w, g);
    let sum = fast_two_sum(p, w.high, p.mul_rn(g, q.high));
    let low = p.add_rn(sum.low, p.fma_rn(g, q.low, w.low));
    let y = p.scale(p.add_rn(sum.high, low), p.sub_rn(k, p.splat(1.0)));
    with_sign_of(p, y, x)
}

/// tanh a: two units in the last place on either side (see the head of this file), and not beyond ±1.
#[inline(always)]
pub fn tanh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let lo = around(p, near_tanh(p, a.lo), 2).lo;
    let hi = around(p, near_tanh(p, a.hi), 2).hi;
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
    let q = share(p, w, p.add_rn(g, g));
    with_sign_of(p, p.add_rn(q.high, q.low), x)
}
