//! x modulo π/2, for doubles of any size.

use super::super::lanes::WHOLE;
use super::super::{Lanes, Scalar};
use super::two_fold::two_product;

/// x = k·π/2 + (r + ρ), |r| ≤ 0.7855, |ρ| ≤ 0.52·ulp(r); r + ρ is right to 2⁻¹⁰⁰ of itself, so its sign is too. Beyond
/// 2²⁰ k is what it is modulo 8.
#[derive(Clone, Copy)]
pub struct Reduced<F> {
    /// A whole number.
    pub k: F,
    /// The remainder.
    pub r: F,
    /// What the remainder lacks.
    pub rho: F,
}

impl<F: Copy> Reduced<F> {
    /// Rounds to how many odd multiples of π/2 are below x + `quarters`·π/2, or to one more where that is one itself; modulo
    /// 4 beyond 2²⁰. For whole k, k/2 + ¼ rounds to ⌊(k + 1)/2⌋ and k/2 − ¼ to ⌊k/2⌋.
    #[inline(always)]
    pub fn turns<P: Lanes<F = F>>(&self, p: P, quarters: f64) -> F {
        let half = 0.5 * quarters;
        let negative = p.lt(self.r, p.splat(0.0));
        let beside = p.select(negative, p.splat(half - 0.25), p.splat(half + 0.25));
        p.fma_rn(self.k, p.splat(0.5), beside)
    }
}

/// π/2 in three parts; their sum errs by less than 2⁻¹⁶³.
const P1: u64 = 0x3ff921fb54442d18;
const P2: u64 = 0x3c91a62633145c07;
const P3: u64 = 0xb91f1976b7ed8fbc;
/// 2/π
const I1: u64 = 0x3fe45f306dc9c883;

/// Up to here the three parts do.
const LIMIT: f64 = 1_048_576.0;
/// Remainders below this go the long way too: cancellation may have left them few digits.
const SMALL: f64 = 9.313225746154785e-10;

/// The remainder of x. Infinite x gives 0.
///
/// For |x| ≤ 2²⁰ and |r| ≥ 2⁻³⁰: k·P1 = h + l exactly and r₀ = (x − h) − l, a multiple of 2⁻⁵³ below 1, so a double (x − h by
/// Sterbenz). With fused operations r is r₀ − k·P2, and what it lacks is the rounding of (r₀ − r) − k·P2, whose
/// difference is exact (Sterbenz: |k·P2| < 2⁻³³), less k·P3, rounded again. |k·P3| < 2⁻⁸⁹, so these two roundings err by less
/// than 2⁻¹⁰⁶|r| + 2⁻¹⁴², and the parts of π/2 by less than 2⁻¹⁴³. Without fused operations see [`split`]. For k = 0 all is
/// exact, and |r| = |x|.
#[inline(always)]
pub fn reduce<P: Lanes>(p: P, x: P::F) -> Reduced<P::F> {
    let (near, far) = near(p, x);
    if p.any(far) {
        long_way(p, x, near, far)
    } else {
        near
    }
}

/// [`reduce`] where three parts of π/2 do, and where they do not.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F) -> (Reduced<P::F>, P::M) {
    let shift = p.splat(WHOLE);
    let k = p.sub_rn(p.fma_rn(x, p.splat(f64::from_bits(I1)), shift), shift);
    let (r, rho) = if P::FUSED {
        let r0 = p.fma_rn(k, p.splat(-f64::from_bits(P1)), x);
        let r = p.fma_rn(k, p.splat(-f64::from_bits(P2)), r0);
        let rho = p.fma_rn(k, p.splat(-f64::from_bits(P2)), p.sub_rn(r0, r));
        (r, p.fma_rn(k, p.splat(-f64::from_bits(P3)), rho))
    } else {
        split(p, x, k)
    };
    // A remainder less than x itself is one of a multiple other than 0.
    let size = p.abs_f(x);
    let cancelled = p.lt(p.abs_f(r), p.min_f(size, p.splat(SMALL)));
    let far = p.or(cancelled, p.lt(p.splat(LIMIT), size));
    (Reduced { k, r, rho }, far)
}

/// r and ρ without fused operations: k·P1 = h + l, r₀ as above; k·P2 = g + m; r₀ − g = a + b (Dekker: |r₀| > |g|). Then
/// r + ρ = a + ((b − m) − k·P3), where only the last two differences round: with |b| ≤ 2⁻⁵³|a|, |m| ≤ 2⁻⁸⁶ and
/// |k·P3| ≤ 2⁻⁸⁸ they err by less than 2⁻¹⁰⁴|a| + 2⁻¹³⁸.
#[inline(always)]
fn split<P: Lanes>(p: P, x: P::F, k: P::F) -> (P::F, P::F) {
    let (h, l) = two_product(p, k, p.splat(f64::from_bits(P1)));
    let r0 = p.sub_rn(p.sub_rn(x, h), l);
    let (g, m) = two_product(p, k, p.splat(f64::from_bits(P2)));
    let a = p.sub_rn(r0, g);
    let b = p.sub_rn(p.sub_rn(r0, a), g);
    let tail = p.sub_rn(p.sub_rn(b, m), p.mul_rn(k, p.splat(f64::from_bits(P3))));
    let r = p.add_rn(a, tail);
    (r, p.sub_rn(tail, p.sub_rn(r, a)))
}

/// Replaces the lanes in `far`, one by one, by exact integer arithmetic.
#[cold]
#[inline(never)]
fn long_way<P: Lanes>(p: P, x: P::F, near: Reduced<P::F>, far: P::M) -> Reduced<P::F> {
    let (x, bits) = (p.to_array(x), p.bits(far));
    let (mut k, mut r, mut rho) = (p.to_array(near.k), p.to_array(near.r), p.to_array(near.rho));
    for lane in 0..8 {
        if bits >> lane & 1 == 1 {
            (k[lane], r[lane], rho[lane]) = payne_hanek(x[lane]);
        }
    }
    Reduced {
        k: p.lanes(k),
        r: p.lanes(r),
        rho: p.lanes(rho),
    }
}

/// 1,280 bits of 2/π below the point.
const TWO_OVER_PI: [u64; 20] = [
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
    0xf0cfbc209af4361d,
];

/// (k, r, ρ) of one x, after Payne and Hanek.
///
/// |x| = m·2ᵉ with 53-bit m. Words of 2/π that contribute multiples of 8 to |x|·2/π are left out; of the rest five
/// suffice: what is cut off is below 2⁻²⁰⁰ of the quotient, whose distance from a whole number is above 2⁻⁶⁵ for every
/// double (there are fewer than 2⁶⁴ of them). The fraction is taken to 192 bits, its leading 106 as two doubles, and
/// multiplied by π/2 in double-double: an error below 2⁻¹⁰⁰ of the remainder.
fn payne_hanek(x: f64) -> (f64, f64, f64) {
    if !x.is_finite() || x == 0.0 {
        return (0.0, 0.0, 0.0);
    }
    let bits = x.to_bits();
    let biased = (bits >> 52 & 0x7ff) as i64;
    let m = bits & ((1 << 52) - 1) | u64::from(biased > 0) << 52;
    let e = biased.max(1) - 1075;

    let first = ((e - 3).max(0) / 64) as usize;
    // The product, least word first; its lowest bit weighs 2^(e − 64·(first + 5)).
    let mut product = [0u64; 7];
    for i in 0..5 {
        let word = TWO_OVER_PI.get(first + 4 - i).copied().unwrap_or(0);
        let sum = u128::from(m) * u128::from(word) + u128::from(product[i]);
        product[i] = sum as u64;
        product[i + 1] = (sum >> 64) as u64;
    }
    // Shifted so that 192 bits are below the point.
    let shift = (64 * (first as i64 + 5) - e - 192) as usize;
    let at = |i: usize| {
        let (word, bit) = (i + shift / 64, shift % 64);
        let low = product.get(word).copied().unwrap_or(0) >> bit;
        let high = product.get(word + 1).copied().unwrap_or(0);
        if bit == 0 {
            low
        } else {
            low | high << (64 - bit)
        }
    };
    let mut fraction = [at(0), at(1), at(2)];
    let mut k = at(3) & 7;
    // To nearest: a fraction of one half or more belongs to the next whole number, from below.
    let beyond = fraction[2] >> 63 == 1;
    if beyond {
        k += 1;
        let mut carry = true;
        for word in &mut fraction {
            let (sum, overflow) = (!*word).overflowing_add(u64::from(carry));
            (*word, carry) = (sum, overflow);
        }
    }
    let (high, low) = two_doubles(fraction);
    // (high + low)·π/2
    let (p1, p2) = (f64::from_bits(P1), f64::from_bits(P2));
    let product = high * p1;
    let tail = high.mul_add(p1, -product) + (high * p2 + low * p1);
    let r = product + tail;
    let rho = tail - (r - product);
    let sign = if beyond != (x < 0.0) { -1.0 } else { 1.0 };
    let k = if x < 0.0 { (8 - k) & 7 } else { k & 7 };
    (k as f64, sign * r, sign * rho)
}

/// The leading 106 bits of a fraction of 192 (most significant word last) as two doubles.
fn two_doubles(fraction: [u64; 3]) -> (f64, f64) {
    let [mut c, mut b, mut a] = fraction;
    let mut exponent = 0;
    while a == 0 && exponent < 192 {
        (a, b, c) = (b, c, 0);
        exponent += 64;
    }
    let zeros = a.leading_zeros();
    if zeros > 0 && zeros < 64 {
        a = a << zeros | b >> (64 - zeros);
        b = b << zeros | c >> (64 - zeros);
    }
    exponent += zeros as i32;
    // The library's powi promises no exact result.
    let power = |n: i32| Scalar.pow2(f64::from(n));
    let high = (a >> 11) as f64 * power(-53 - exponent);
    let low = ((a & 0x7ff) << 42 | b >> 22) as f64 * power(-106 - exponent);
    (high, low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both ways agree where both hold.
    #[test]
    fn the_long_way_agrees_with_the_short_one() {
        let mut x = 0.8;
        while x < LIMIT {
            let short = reduce(Scalar, x);
            let (k, r, rho) = payne_hanek(x);
            assert_eq!(short.k.rem_euclid(8.0), k, "{x}");
            assert_eq!(short.r, r, "{x}");
            assert!((short.rho - rho).abs() <= 1e-30, "{x}: {} {rho}", short.rho);
            // (x + quarters·π/2)/π, to the nearest whole number.
            for quarters in [0.0, 1.0] {
                let turns = (x / core::f64::consts::PI + quarters / 2.0).round();
                assert_eq!(short.turns(Scalar, quarters).round(), turns, "{x}");
            }
            let (minus_k, minus_r, _) = payne_hanek(-x);
            assert_eq!((minus_k + k) % 8.0, 0.0, "{x}");
            assert_eq!(minus_r, -r, "{x}");
            x *= 1.000_737;
        }
    }
}
