//! arctan, and the angle of a point, on packets: one reduction to π/8, one quotient, one polynomial, proved.
//!
//! The angle of (d, n) with n, d ≥ 0 is reflected at the diagonal (n > d) and then turned back by π/4 (n > d·tan π/8):
//! it is c·π/4 ± arctan((n* + n′)/(d* + d′)) with c = 0, 1 or 2, where n*, d* are n, d, or their difference and sum, whose
//! rounding errors n′, d′ are exact (Dekker). The quotient is q + ρ with |q| ≤ 0.4143 (see [`quotient`]), and in doubles
//!
//! * tail = q·t + (ρ − ρ·z), t = z·a(z), z = q², with a of degree 10 by Sollya's `fpminimax`,
//! * v = c·π/4 ± (q + tail), summed by [`turned`].
//!
//! Errors besides half a unit of the last sum (`runtime/proofs`: `atan.sollya`, `atan.g`), u = 2⁻⁵³:
//!
//! * c = 0, as multiples of u·q: 0.14 of t, 0.053 for rounding q·t + (ρ − ρ·z) with |t| ≤ 0.0522 (twice that without
//!   fused operations), 0.013 of the polynomial, and 0.06 of ρ·(1 − z) for ρ/(1 + z) with |ρ| ≤ 2u·q. Together below 0.32.
//!   A unit in the last place of v is at least u·v ≥ 0.94·u·q, so v errs by less than one unit. Where v is a power of two,
//!   the neighbour below is only u·v away, and then the last sum errs by half of that at most.
//! * c > 0, as multiples of u: 0.12 of all sums before the last one, 0.005 of the polynomial, and 0.042 of ρ, which is up
//!   to 4u·q for c = 1. Together below 0.17; v > 0.39, so half a unit in its last place is at least u/4.
//!
//! So the neighbours of v enclose the angle at a point, with and without fused operations.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::neighbours::{around, with_sign_of};
use super::two_fold::{Sum, fast_two_sum, quotient};

/// a, from the constant coefficient on.
const A: [u64; 11] = [
    0xbfd555555555553d,
    0x3fc99999999958a3,
    0xbfc24924922af5f0,
    0x3fbc71c70e6f2620,
    0xbfb745cf8f73170c,
    0x3fb3b111afe94eed,
    0xbfb10ebcd8827dba,
    0x3fadf107a698961b,
    0xbfa9cd7eccbda9a1,
    0x3fa37e25fc43b8bc,
    0xbf9258529a96db99,
];
/// π/4 to 50 bits, so that its products with 1 to 4 are exact, and the rest: their sum errs by less than 2⁻¹¹⁰.
const EIGHTH: u64 = 0x3fe921fb54442d18;
const EIGHTH_REST: u64 = 0x3c81a62633145c07;
/// 0.4142, a little less than tan π/8.
const TURN: u64 = 0x3fda8240b780346e;

/// c·π/4 + (q + tail), |tail| ≤ 2⁻⁴: exact but for the sum of the small parts and the last one.
///
/// c is 0 to 4, and |q| ≤ c·π/4 or c = 0, so that the first sum's error is exact (Dekker).
#[inline(always)]
pub fn turned<P: Lanes>(p: P, c: P::F, q: P::F, tail: P::F) -> P::F {
    let base = p.mul_rn(c, p.splat(f64::from_bits(EIGHTH)));
    let sum = fast_two_sum(p, base, q);
    let rest = p.fma_rn(c, p.splat(f64::from_bits(EIGHTH_REST)), tail);
    p.add_rn(sum.high, p.add_rn(sum.low, rest))
}

/// z·(polynomial of z), coefficients from the constant one on.
#[inline(always)]
pub fn odd_part<P: Lanes, const N: usize>(p: P, z: P::F, coefficients: &[u64; N]) -> P::F {
    let mut sum = p.splat(f64::from_bits(coefficients[N - 1]));
    let mut i = N - 1;
    while i > 0 {
        i -= 1;
        sum = p.fma_rn(z, sum, p.splat(f64::from_bits(coefficients[i])));
    }
    p.mul_rn(z, sum)
}

/// −a where `mask` is set.
#[inline(always)]
pub fn negate_if<P: Lanes>(p: P, mask: P::M, a: P::F) -> P::F {
    p.select(mask, p.neg_f(a), a)
}

/// The angle of (±d, n) in [0, π] to within a unit in the last place, for n ≥ 0 and 2⁻¹⁰⁰⁰ ≤ d, both below 2⁹⁹⁰; to the
/// left where `left` is set.
///
/// Where the smaller one is below 2⁻⁹⁰⁰ the remainder of the quotient may underflow, and is left out: then a result that
/// is as small as the quotient is within two units.
#[inline(always)]
pub fn angle<P: Lanes>(p: P, n: P::F, d: P::F, left: P::M) -> P::F {
    let (zero, one) = (p.splat(0.0), p.splat(1.0));
    let steep = p.lt(d, n);
    let (less, more) = (p.min_f(n, d), p.max_f(n, d));
    let turn = p.lt(p.mul_rn(more, p.splat(f64::from_bits(TURN))), less);
    let difference = fast_two_sum(p, p.neg_f(more), less);
    let sum = fast_two_sum(p, more, less);
    let ratio = quotient(
        p,
        Sum {
            high: p.select(turn, difference.high, less),
            low: p.select(turn, difference.low, zero),
        },
        Sum {
            high: p.select(turn, sum.high, more),
            low: p.select(turn, sum.low, zero),
        },
    );
    let q = ratio.high;
    let rho = p.select(p.lt(less, p.splat(TINY)), zero, ratio.low);
    let z = p.mul_rn(q, q);
    let tail = p.fma_rn(q, odd_part(p, z, &A), p.sub_rn(rho, p.mul_rn(rho, z)));
    // Reflections at the diagonal, then at the vertical axis.
    let c = p.select(turn, one, zero);
    let c = p.select(steep, p.sub_rn(p.splat(2.0), c), c);
    let c = p.select(left, p.sub_rn(p.splat(4.0), c), c);
    let back = p.or(p.and_not(steep, left), p.and_not(left, steep));
    turned(p, c, negate_if(p, back, q), negate_if(p, back, tail))
}

/// Below this the remainder of a quotient is no longer a double.
const TINY: f64 = f64::from_bits((1023 - 900) << 52);
/// From here on arctan is π/2 up to a quarter of a unit in the last place.
const STEEP: f64 = 1_152_921_504_606_846_976.0;

/// arctan x to within a unit in the last place, 0 for 0 only; any number for NaN.
#[inline(always)]
fn of_number<P: Lanes>(p: P, x: P::F) -> P::F {
    let n = p.min_f(p.abs_f(x), p.splat(STEEP));
    with_sign_of(p, angle(p, n, p.splat(1.0), p.none()), x)
}

/// arctan x to within a unit in the last place; NaN of NaN.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F) -> P::F {
    p.select(p.eq(x, x), of_number(p, x), x)
}

/// arctan a, increasing: at a point at most two units wide in the last place, on every back-end.
///
/// From 2⁶⁰ on v is the double below π/2, and its neighbours are bounds there too.
#[inline(always)]
pub fn atan<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    Interval {
        lo: around(p, of_number(p, a.lo), 1).lo,
        hi: around(p, of_number(p, a.hi), 1).hi,
    }
}
