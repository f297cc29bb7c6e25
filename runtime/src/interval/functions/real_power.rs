//! aᵇ for real b, proved: the logarithm and its product with b are two-fold numbers.
//!
//! b·ln a is bilinear, so its extreme values are those of corners. At a corner h + l = b·ln a errs by the logarithm's
//! 1.4·10⁻¹⁹ relatively (1.82·10⁻¹⁹ without fused operations, see [`logarithm`]). Where the power is neither 0 nor ∞ in
//! doubles, |b·ln a| < 745.2, so the power errs by 0.94u relatively, u = 2⁻⁵³ (1.23u). With k, r₁ and t as in
//! [`exp::near`], t₁ = k·L2 − l, the power is 2ᵏ·v, v = 1 + (r₁ + t). The proof there holds for every |t₁| ≤ 2⁻³², so
//! v errs besides by
//!
//! * v < 1: 2⁻⁵⁴ and as much for the last sum, so by less than 1.94u (2.23u); doubles in [½, 1] are u apart;
//! * v ≥ 1: 2⁻⁵³ and as much for the last sum, so by less than 3.4u (3.8u); doubles in [1, 2] are 2u apart.
//!
//! So two steps outward do, three without fused operations. (v = 1 has the first kind of error below, the second above.)
//! A subnormal power is rounded once more, by half a unit; there a unit is at least two of those of 2ᵏ·v, so that the first
//! errors are half as many.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes, Routine};
use super::exp::{self, L2};
use super::logarithm;
use super::two_fold::{Sum, two_product};

/// Below this x, eˣ is less than half the least double; above the other, it is more than the greatest.
const LEAST: f64 = -746.0;
const GREATEST: f64 = 710.0;
/// Exponents are cut to this size: a logarithm is 0 or larger than 2⁻⁵⁴, so such powers are 0, 1 or ∞ in doubles.
const LARGE: f64 = (1u128 << 100) as f64;

/// aᵇ over a > 0, and over a = 0 where b > 0; where there is no such a, [0, 0]. Two units in the last place on either side,
/// three without fused operations (see the head of this file).
#[inline(always)]
pub fn pow<P: Enclose>(p: P, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
    p.call(Power { a: &a, b: &b })
}

/// One function of its own, for it is long.
struct Power<'a, F> {
    a: &'a Interval<F>,
    b: &'a Interval<F>,
}

impl<P: Enclose> Routine<P> for Power<'_, P::F> {
    type Output = Interval<P::F>;

    #[inline(always)]
    fn call(self, p: P) -> Interval<P::F> {
        let (a, b) = (*self.a, *self.b);
        let (zero, one) = (p.splat(0.0), p.splat(1.0));
        let b = Interval {
            lo: exponent(p, b.lo),
            hi: exponent(p, b.hi),
        };
        // With a logarithm below 0, the larger exponent makes the lower product.
        let start = ln(p, a.lo);
        let end = ln(p, a.hi);
        let (start_negative, end_negative) = (p.lt(a.lo, one), p.lt(a.hi, one));
        let lo = least(
            p,
            times(p, p.select(start_negative, b.hi, b.lo), start),
            times(p, p.select(end_negative, b.hi, b.lo), end),
        );
        let hi = least(
            p,
            times(p, p.neg_f(p.select(start_negative, b.lo, b.hi)), start),
            times(p, p.neg_f(p.select(end_negative, b.lo, b.hi)), end),
        );
        let hi = Sum {
            high: p.neg_f(hi.high),
            low: p.neg_f(hi.low),
        };
        let lo = around(p, exp(p, lo)).lo;
        // e^−∞ is 0.
        let none = p.or(p.le(a.hi, zero), p.eq(hi.high, p.splat(f64::NEG_INFINITY)));
        let hi = p.select(none, zero, around(p, exp(p, hi)).hi);
        Interval {
            lo: p.min_f(lo, hi),
            hi,
        }
    }
}

/// xʸ to a unit or two in the last place; NaN for x < 0 and where either is NaN.
#[inline(always)]
pub fn anywhere<P: Lanes>(p: P, x: P::F, y: P::F) -> P::F {
    p.call(PlainPower { x: &x, y: &y })
}

/// One function of its own, too.
struct PlainPower<'a, F> {
    x: &'a F,
    y: &'a F,
}

impl<P: Lanes> Routine<P> for PlainPower<'_, P::F> {
    type Output = P::F;

    #[inline(always)]
    fn call(self, p: P) -> P::F {
        let (x, y) = (*self.x, *self.y);
        let power = exp(p, times(p, exponent(p, y), ln(p, x)));
        let known = p.and(p.le(p.splat(0.0), x), p.eq(y, y));
        p.select(known, power, p.splat(f64::NAN))
    }
}

/// y, or [`LARGE`] with its sign.
#[inline(always)]
fn exponent<P: Lanes>(p: P, y: P::F) -> P::F {
    p.max_f(p.min_f(y, p.splat(LARGE)), p.splat(-LARGE))
}

/// ln x for x > 0, −∞ elsewhere; ln ∞ = ∞.
#[inline(always)]
fn ln<P: Lanes>(p: P, x: P::F) -> Sum<P::F> {
    let (zero, infinity) = (p.splat(0.0), p.splat(f64::INFINITY));
    // Subnormal numbers have no exponent of their own.
    let small = p.lt(x, p.splat(f64::MIN_POSITIVE));
    let scaled = p.select(small, p.mul_rn(x, p.splat(18_014_398_509_481_984.0)), x);
    let (high, e) = p.decompose(scaled);
    let e = p.select(small, p.sub_rn(e, p.splat(54.0)), e);
    let y = logarithm::near(p, Sum { high, low: zero }, e);
    let high = p.select(p.eq(x, infinity), infinity, y.high);
    let high = p.select(p.le(x, zero), p.neg_f(infinity), high);
    Sum { high, ..y }
}

/// b·x, and no second part where the first is beyond all powers; 0·∞ = 0, which is the power 1.
#[inline(always)]
fn times<P: Lanes>(p: P, b: P::F, x: Sum<P::F>) -> Sum<P::F> {
    let (high, low) = two_product(p, b, x.high);
    let low = p.fma_rn(b, x.low, low);
    let near = p.lt(p.abs_f(high), p.splat(1024.0));
    Sum {
        high: p.mend(high),
        low: p.select(near, low, p.splat(0.0)),
    }
}

/// The lesser of two. First parts as near to each other as second parts are large have an exact difference.
#[inline(always)]
fn least<P: Lanes>(p: P, x: Sum<P::F>, y: Sum<P::F>) -> Sum<P::F> {
    let difference = p.add_rn(p.sub_rn(x.high, y.high), p.sub_rn(x.low, y.low));
    let first = p.lt(difference, p.splat(0.0));
    Sum {
        high: p.select(first, x.high, y.high),
        low: p.select(first, x.low, y.low),
    }
}

/// e^(x + x′), 0 below all doubles and ∞ above.
#[inline(always)]
fn exp<P: Lanes>(p: P, x: Sum<P::F>) -> P::F {
    let (least, greatest) = (p.splat(LEAST), p.splat(GREATEST));
    let (k, r1) = exp::reduce(p, p.max_f(p.min_f(x.high, greatest), least));
    let t = exp::tail(p, r1, p.fms_rn(k, p.splat(f64::from_bits(L2)), x.low));
    let v = p.add_rn(p.splat(1.0), p.add_rn(r1, t));
    // First to a normal number, then to a subnormal one where it is.
    let normal = p.max_f(k, p.splat(-1021.0));
    p.mul_rn(p.scale(v, normal), p.pow2(p.sub_rn(k, normal)))
}

/// Two steps outward, three without fused operations, from v ∈ [0, ∞]: a 0 may stand for a positive number.
#[inline(always)]
fn around<P: Lanes>(p: P, v: P::F) -> Interval<P::F> {
    let (mut lo, mut hi) = (p.before(p.before(v)), p.after(p.after(v)));
    if !P::FUSED {
        (lo, hi) = (p.before(lo), p.after(hi));
    }
    // Before 0 and after ∞ are the NaNs, which maximum and minimum drop.
    Interval {
        lo: p.max_f(lo, p.splat(0.0)),
        hi: p.min_f(hi, p.splat(f64::INFINITY)),
    }
}
