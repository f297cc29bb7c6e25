//! tan on packets: the quotient of sin and cos before their last sums, proved; poles counted exactly.
//!
//! With S + S′ and C + C′ for the unrounded sums r + (r·t + ρ·w) and w + d of [`circular`](super::circular) (Dekker), tan x
//! is (S + S′)/(C + C′), or −(C + C′)/(S + S′) where k is odd: q + ρ of [`quotient`], and v = q + ρ.
//!
//! Errors, relatively, in units of u = 2⁻⁵³: of S + S′ 0.45, or 0.6 without fused operations, of r for sin r ≥ 0.9·r; of
//! C + C′ 0.38 of 1 for cos r ≥ 0.707. Together below 1.05, or 1.21; the quotient adds 2⁻⁴⁸. A unit in the last
//! place of v is at least u·v, the last sum errs by half of one: together less than two units, also below a power of two,
//! where the last sum errs by half of the smaller unit. So the second neighbours of v enclose a point.

use super::super::enclose::Enclose;
use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes, Routine};
use super::circular::quarter_wave;
use super::neighbours::{over, under};
use super::remainder::{self, Reduced, reduce};
use super::two_fold::{Sum, fast_two_sum, quotient};

/// tan a: increasing between its poles; the line across one. At a point at most four units wide in the last place, on
/// every back-end.
#[inline(always)]
pub fn tan<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let (start, start_far) = remainder::near(p, a.lo);
    let (end, end_far) = remainder::near(p, a.hi);
    if p.any(p.or(start_far, end_far)) {
        return far_tan(p, &a);
    }
    tan_of(p, a, [start, end])
}

/// As for the sine, a function of its own.
#[cold]
#[inline(never)]
fn far_tan<P: Lanes>(p: P, a: &Interval<P::F>) -> Interval<P::F> {
    p.call(Far { a })
}

struct Far<'a, P: Lanes> {
    a: &'a Interval<P::F>,
}

impl<P: Lanes> Routine<P> for Far<'_, P> {
    type Output = Interval<P::F>;
    #[inline(always)]
    fn call(self, p: P) -> Interval<P::F> {
        let ends = [reduce(p, self.a.lo), reduce(p, self.a.hi)];
        tan_of(p, *self.a, ends)
    }
}

/// tan a, whose ends are reduced.
#[inline(always)]
fn tan_of<P: Lanes>(p: P, a: Interval<P::F>, [start, end]: [Reduced<P::F>; 2]) -> Interval<P::F> {
    let whole = p.splat(WHOLE);
    let (first, last) = (start.turns(p, 0.0), end.turns(p, 0.0));
    let poles = p.sub_rn(p.add_rn(last, whole), p.add_rn(first, whole));
    let count = p.add_rn(poles, whole);
    // The count is right modulo 4, and below 3π there are less than 4.
    let wide = p.le(p.splat(9.0), p.sub_ru(a.hi, a.lo));
    let pole = p.or(wide, p.or(p.bit::<0>(count), p.bit::<1>(count)));
    let lo = under(p, tangent_of(p, start), 2);
    let hi = over(p, tangent_of(p, end), 2);
    Interval {
        lo: p.select(pole, p.splat(f64::NEG_INFINITY), lo),
        hi: p.select(pole, p.splat(f64::INFINITY), hi),
    }
}

/// tan x to within two units in the last place; NaN of NaN and of infinities.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F) -> P::F {
    let finite = p.lt(p.abs_f(x), p.splat(f64::INFINITY));
    p.select(finite, tangent_of(p, reduce(p, x)), p.splat(f64::NAN))
}

/// The tangent of a reduced x: sin/cos, or −cos/sin in odd quadrants; 0 for 0 only.
#[inline(always)]
fn tangent_of<P: Lanes>(p: P, reduced: Reduced<P::F>) -> P::F {
    let swap = p.bit::<0>(p.add_rn(reduced.k, p.splat(WHOLE)));
    let (s, c) = quarter_wave(p, reduced);
    let s = fast_two_sum(p, s.high, s.low);
    let c = fast_two_sum(p, c.high, c.low);
    // No double but 0 is a multiple of π/2, so a divisor is not 0.
    let ratio = quotient(p, select(p, swap, c, s), select(p, swap, s, c));
    let v = p.add_rn(ratio.high, ratio.low);
    p.select(swap, p.neg_f(v), v)
}

#[inline(always)]
fn select<P: Lanes>(p: P, mask: P::M, yes: Sum<P::F>, no: Sum<P::F>) -> Sum<P::F> {
    Sum {
        high: p.select(mask, yes.high, no.high),
        low: p.select(mask, yes.low, no.low),
    }
}
