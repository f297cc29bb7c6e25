//! ln(1 + x), arsinh, arcosh and artanh on packets: logarithms of two-fold numbers, proved.
//!
//! | | is the logarithm of | except |
//! |---|---|---|
//! | ln(1 + x) | 1 + x, exactly | x itself for \|x\| < 2⁻⁵⁴ |
//! | arsinh x, x ≥ 0 | x + √(x² + 1) | x itself below 2⁻²⁷, ln 2x above 2⁶⁰ |
//! | arcosh x | x + √(x² − 1) | ln 2x above 2⁶⁰ |
//! | artanh x, x ≥ 0 | (1 + x)/(1 − x), halved | x itself below 2⁻²⁷ |
//!
//! The arguments err by less than 2⁻¹⁰⁰ relatively (see [`with_root`] and [`quotient`]), so the logarithms by 2⁻¹⁰⁰
//! absolutely; where they are taken they are at least 2⁻²⁷, or 2⁻⁵⁴ with an exact argument. With the 2⁻⁶²·² of
//! [`logarithm`] that is relatively less than 0.01 units in the last place, and its first part, the result, is the nearest
//! double of its sum: half a unit more. Where x itself is taken, |x³|/6, |x³|/3 or x²/2 is less than 0.3 units. So one step
//! outward does on either side.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes, Routine};
use super::logarithm;
use super::neighbours::{around, with_sign_of};
use super::two_fold::{Sum, fast_two_sum, quotient, remainder, two_product};

/// Below this, arsinh x and artanh x are x.
const SMALL: f64 = 1.0 / (1u64 << 27) as f64;
/// Below this, ln(1 + x) is x.
const TINY: f64 = 1.0 / (1u64 << 54) as f64;
/// Above this, x ± √(x² ± 1) is 2x.
const LARGE: f64 = (1u64 << 60) as f64;

/// The argument of a logarithm, (x + x′)·2ⁿ.
#[derive(Clone, Copy)]
struct Argument<F> {
    x: Sum<F>,
    n: F,
}

/// The logarithms of the arguments, such as those at both bounds: one function of its own, for it is long.
struct Logarithms<'a, F, const N: usize>(&'a [Argument<F>; N]);

impl<P: Lanes, const N: usize> Routine<P> for Logarithms<'_, P::F, N> {
    type Output = [P::F; N];

    #[inline(always)]
    fn call(self, p: P) -> [P::F; N] {
        let mut out = [p.splat(0.0); N];
        let mut i = 0;
        while i < N {
            out[i] = ln(p, self.0[i]);
            i += 1;
        }
        out
    }
}

/// The nearest double of ln((x + x′)·2ⁿ), nearly, for x from 2⁻⁵³ on.
#[inline(always)]
fn ln<P: Lanes>(p: P, a: Argument<P::F>) -> P::F {
    let (high, e) = p.decompose(a.x.high);
    // Where 2⁻ᵉ might be no double, x′ is of no account.
    let scale = p.pow2(p.max_f(p.neg_f(e), p.splat(-1000.0)));
    let low = p.mul_rn(a.x.low, scale);
    logarithm::near(p, Sum { high, low }, p.add_rn(e, a.n)).high
}

/// ln(1 + a) over a > −1; the line where there is no such number.
/// One unit in the last place on either side (see the head of this file).
#[inline(always)]
pub fn ln_1p<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let [start, end] = p.call(Logarithms(&[one_plus(p, a.lo), one_plus(p, a.hi)]));
    let tiny = p.splat(TINY);
    let start = p.select(p.lt(p.abs_f(a.lo), tiny), a.lo, start);
    let end = p.select(p.lt(p.abs_f(a.hi), tiny), a.hi, end);
    let pole = p.splat(-1.0);
    let (minus, plus) = infinities(p);
    let unbounded = p.or(p.le(a.hi, pole), p.eq(a.hi, plus));
    Interval {
        lo: p.select(p.le(a.lo, pole), minus, around(p, start, 1).lo),
        hi: p.select(unbounded, plus, around(p, end, 1).hi),
    }
}

/// ln(1 + x) to a unit in the last place, for every x; NaN below −1 and of NaN.
#[inline(always)]
pub fn ln_1p_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let [y] = p.call(Logarithms(&[one_plus(p, x)]));
    let y = p.select(p.lt(p.abs_f(x), p.splat(TINY)), x, y);
    let pole = p.splat(-1.0);
    let (minus, plus) = infinities(p);
    let y = p.select(p.lt(pole, x), y, p.splat(f64::NAN));
    let y = p.select(p.eq(x, plus), plus, y);
    p.select(p.eq(x, pole), minus, y)
}

/// 1 + x exactly.
#[inline(always)]
fn one_plus<P: Lanes>(p: P, x: P::F) -> Argument<P::F> {
    let one = p.splat(1.0);
    // For x < −1 the order is wrong, and the result of no account.
    let x = fast_two_sum(p, p.max_f(x, one), p.min_f(x, one));
    let n = p.splat(0.0);
    Argument { x, n }
}

/// arsinh a. One unit in the last place on either side (see the head of this file).
#[inline(always)]
pub fn asinh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let [start, end] = p.call(Logarithms(&[
        with_root(p, p.abs_f(a.lo), 1.0),
        with_root(p, p.abs_f(a.hi), 1.0),
    ]));
    let lo = around(p, odd(p, start, a.lo), 1).lo;
    let hi = around(p, odd(p, end, a.hi), 1).hi;
    let (minus, plus) = infinities(p);
    Interval {
        lo: p.select(p.eq(a.lo, minus), minus, lo),
        hi: p.select(p.eq(a.hi, plus), plus, hi),
    }
}

/// arsinh x to a unit in the last place, for every x; NaN of NaN.
#[inline(always)]
pub fn asinh_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let [y] = p.call(Logarithms(&[with_root(p, p.abs_f(x), 1.0)]));
    let finite = p.lt(p.abs_f(x), p.splat(f64::INFINITY));
    p.select(finite, odd(p, y, x), x)
}

/// arcosh a over a ≥ 1; [0, 0] where there is no such number.
/// One unit in the last place on either side (see the head of this file).
#[inline(always)]
pub fn acosh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let one = p.splat(1.0);
    let [start, end] = p.call(Logarithms(&[
        with_root(p, p.max_f(a.lo, one), -1.0),
        with_root(p, p.max_f(a.hi, one), -1.0),
    ]));
    let (_, plus) = infinities(p);
    Interval {
        lo: around(p, start, 1).lo,
        hi: p.select(p.eq(a.hi, plus), plus, around(p, end, 1).hi),
    }
}

/// arcosh x to a unit in the last place, for every x; NaN below 1 and of NaN.
#[inline(always)]
pub fn acosh_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let [y] = p.call(Logarithms(&[with_root(p, x, -1.0)]));
    let (_, plus) = infinities(p);
    let y = p.select(p.le(p.splat(1.0), x), y, p.splat(f64::NAN));
    p.select(p.eq(x, plus), plus, y)
}

/// artanh a over −1 < a < 1; the line where there is no such number.
/// One unit in the last place on either side (see the head of this file).
#[inline(always)]
pub fn atanh<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let [start, end] = p.call(Logarithms(&[
        ratio(p, p.abs_f(a.lo)),
        ratio(p, p.abs_f(a.hi)),
    ]));
    let half = p.splat(0.5);
    let lo = around(p, odd(p, p.mul_rn(half, start), a.lo), 1).lo;
    let hi = around(p, odd(p, p.mul_rn(half, end), a.hi), 1).hi;
    let (minus, plus) = infinities(p);
    let one = p.splat(1.0);
    Interval {
        lo: p.select(p.le(one, p.abs_f(a.lo)), minus, lo),
        hi: p.select(p.le(one, p.abs_f(a.hi)), plus, hi),
    }
}

/// artanh x to a unit in the last place, for every x; NaN beyond ±1 and of NaN.
#[inline(always)]
pub fn atanh_anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let size = p.abs_f(x);
    let [y] = p.call(Logarithms(&[ratio(p, size)]));
    let one = p.splat(1.0);
    let y = odd(p, p.mul_rn(p.splat(0.5), y), x);
    let y = p.select(p.lt(size, one), y, p.splat(f64::NAN));
    let (_, plus) = infinities(p);
    p.select(p.eq(size, one), with_sign_of(p, plus, x), y)
}

/// (1 + x)/(1 − x) for 0 ≤ x < 1.
#[inline(always)]
fn ratio<P: Lanes>(p: P, x: P::F) -> Argument<P::F> {
    let one = p.splat(1.0);
    let q = quotient(p, fast_two_sum(p, one, x), fast_two_sum(p, one, p.neg_f(x)));
    Argument {
        x: fast_two_sum(p, q.high, q.low),
        n: p.splat(0.0),
    }
}

/// x + √(x² + `sign`) for x ≥ 0 where that is a number.
///
/// x² + `sign` = y + y′ up to 2⁻¹⁰⁵ relatively (the roots differ by half of that), y′ at most half a unit of y. √(y + y′) is
/// g + (y + y′ − g²)/(2g) up to the square of the second term, over 2g: relatively less than (1.01u)²/2. That term is below
/// 1.01u·g and is rounded four times. The sum adds half of u² for x′, so all of it is below 8u².
#[inline(always)]
fn with_root<P: Lanes>(p: P, x: P::F, sign: f64) -> Argument<P::F> {
    let (square, error) = two_product(p, x, x);
    let sign = p.splat(sign);
    // For −1, x² ≥ 1.
    let (larger, smaller) = (p.max_f(square, sign), p.min_f(square, sign));
    let y = fast_two_sum(p, larger, smaller);
    let y = fast_two_sum(p, y.high, p.add_rn(y.low, error));
    let g = p.sqrt_rn(y.high);
    let rest = p.add_rn(remainder(p, y.high, g, g), y.low);
    // 0/0 at x = 1, where the root is 0.
    let rest = p.mend(p.div_rn(rest, p.add_rn(g, g)));
    let sum = fast_two_sum(p, p.max_f(x, g), p.min_f(x, g));
    let sum = fast_two_sum(p, sum.high, p.add_rn(sum.low, rest));
    let (zero, one) = (p.splat(0.0), p.splat(1.0));
    let large = p.lt(p.splat(LARGE), x);
    Argument {
        x: Sum {
            high: p.select(large, x, sum.high),
            low: p.select(large, zero, sum.low),
        },
        n: p.select(large, one, zero),
    }
}

/// v ≥ 0 at |x| continued as an odd function, x itself where it is small.
#[inline(always)]
fn odd<P: Lanes>(p: P, v: P::F, x: P::F) -> P::F {
    let small = p.lt(p.abs_f(x), p.splat(SMALL));
    p.select(small, x, with_sign_of(p, v, x))
}

#[inline(always)]
fn infinities<P: Lanes>(p: P) -> (P::F, P::F) {
    (p.splat(f64::NEG_INFINITY), p.splat(f64::INFINITY))
}
