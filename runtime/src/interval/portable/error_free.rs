//! a·b + c without a fused operation, as tight as with one.

use super::super::Rounding;
use super::{down_one, down_sum, zeros};

/// Operands below this can be split without overflow.
const SPLITS: f64 = f64::from_bits((1023 + 995) << 52);
/// Products and sums below this leave the transformations room.
const HUGE: f64 = f64::from_bits((1023 + 1020) << 52);
/// Above this the error of a product is a double.
const TINY: f64 = f64::from_bits((1023 - 960) << 52);

/// (s, e) with s + e = a + b exactly (Knuth).
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let bb = s - a;
    (s, (a - (s - bb)) + (b - bb))
}

/// (h, l) with h + l = a exactly, each short enough that products of two are exact (Veltkamp).
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a;
    let h = c - (c - a);
    (h, a - h)
}

/// A lower bound of a·b + c, within two units in the last place of the result, where [`holds`] says so.
///
/// a·b = p + e (Dekker), p + c = t + f, e + f = h + l, t + h = s + w (Knuth), all exact, so the exact result is
/// s + (w + l) and the sign of w + l tells whether s is above it. s's predecessor is then below it:
/// * f ≠ 0 only where p and c do not cancel (Sterbenz), so |t| ≥ |p|/2 and |h| ≤ 3u|t|, |l| ≤ 3u²|t| with u = 2⁻⁵³:
///   |w| is at most half the gap to the predecessor and |l| far less than the other half;
/// * f = 0 makes l = 0.
///
/// It does not hold for operands that cannot be split, sums near overflow, and products whose error is no double. There
/// a product and a sum are rounded one after the other ([`guarded`]).
#[inline(always)]
pub fn tight<R: Rounding>(a: f64, b: f64, c: f64) -> f64 {
    let p = a * b;
    if !R::ON {
        return p + c;
    }
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    let e = al * bl - (((p - ah * bh) - al * bh) - ah * bl);
    let (t, f) = two_sum(p, c);
    let (h, l) = two_sum(e, f);
    let (s, w) = two_sum(t, h);
    if w + l < 0.0 {
        down_one::<R>(s, false)
    } else {
        s
    }
}

/// Does [`tight`] hold for these operands? Bitwise operators, so that eight lanes need no branch.
#[inline(always)]
pub fn holds(a: f64, b: f64, c: f64) -> bool {
    let p = (a * b).abs();
    let exact = zeros(a, b) | (p >= TINY);
    exact & (a.abs() < SPLITS) & (b.abs() < SPLITS) & (p < HUGE) & (c.abs() < HUGE)
}

/// The bound where the transformations do not hold. A zero factor is exact whatever the other is, unless that is
/// infinite: 0·∞ is NaN and stays one, as in the other back-ends.
#[inline(always)]
pub fn guarded<R: Rounding>(a: f64, b: f64, c: f64) -> f64 {
    let p = a * b;
    let zero = zeros(a, b) && !p.is_nan();
    let product = if zero { p } else { down_one::<R>(p, false) };
    down_sum::<R>(product + c)
}
