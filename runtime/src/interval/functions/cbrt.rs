//! ∛x on packets: a polynomial as seed, one step without division, and a residual in twice the precision.
//!
//! |x| = m·2³ᵏ with m = f·2ʲ, f ∈ [⅔, 4⁄3), j ∈ {−1, 0, 1}, all exact. Then
//!
//! * r₀ = 2^(−j/3)·p(f) with p of degree 3 near f^(−1/3), relatively to 2⁻¹¹·⁹ (`runtime/proofs/cbrt.sollya`), so
//!   e = 1 − m·r₀³ is below 2⁻¹⁰·³;
//! * r = r₀·(1 + e/3 + 2e²/9), the series of (1 − e)^(−1/3) up to its third term: r is m^(−1/3) to 0.18·e³ < 2⁻³³,
//!   and y = m·r² is ∛m to 2⁻³²;
//! * δ = (m − y³)·r²/3, with y³ in two pieces (`runtime/proofs/cbrt.g`), and v = y + δ.
//!
//! ∛m is y·(1 + ε)^(1/3) with m = y³·(1 + ε), |ε| < 2⁻³⁰, and δ is y·ε/3 to 2⁻⁶¹·y: so is y + δ to ∛m within
//! (2⁻⁶¹ + ε²/9)·y < 2⁻⁶⁰·y. The last sum errs by half a unit in the last place, and the rest is less than a hundredth of
//! one: the neighbours of v enclose the root, also where v is a power of two. Scaling by 2ᵏ is exact, for no root of a
//! double is subnormal.

use super::super::enclose::Enclose;
use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes};
use super::neighbours::{around, with_sign_of};
use super::two_fold::two_product;

/// p, from the constant coefficient on.
const SEED: [u64; 4] = [
    0x3ffc3d96239bb127,
    0xbff640b88ea781c7,
    0x3fea30c1c52f1aef,
    0xbfc8b21d909d63de,
];
/// 2^(1/3) and 2^(−1/3)
const UP: u64 = 0x3ff428a2f98d728b;
const DOWN: u64 = 0x3fe965fea53d6e3d;

/// ∛a, increasing: at a point at most two units wide in the last place, on every back-end.
#[inline(always)]
pub fn cbrt<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let (infinity, minus) = (p.splat(f64::INFINITY), p.splat(f64::NEG_INFINITY));
    let lo = around(p, of_number(p, a.lo), 1).lo;
    let hi = around(p, of_number(p, a.hi), 1).hi;
    Interval {
        lo: p.select(p.eq(a.lo, minus), minus, lo),
        hi: p.select(p.eq(a.hi, infinity), infinity, hi),
    }
}

/// ∛x to within a unit in the last place; what is infinite or NaN stays it.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F) -> P::F {
    let finite = p.lt(p.abs_f(x), p.splat(f64::INFINITY));
    p.select(finite, of_number(p, x), x)
}

/// ∛x to within a unit in the last place, for finite x.
#[inline(always)]
fn of_number<P: Lanes>(p: P, x: P::F) -> P::F {
    let size = p.abs_f(x);
    // Subnormal numbers have no exponent of their own: they are multiplied by 2⁵⁴, which adds 18 to k.
    let small = p.lt(size, p.splat(f64::MIN_POSITIVE));
    let normal = p.mul_rn(size, p.splat(18_014_398_509_481_984.0));
    let (f, e) = p.decompose(p.select(small, normal, size));
    let shift = p.splat(WHOLE);
    let third = p.splat(1.0 / 3.0);
    let k = p.sub_rn(p.fma_rn(e, third, shift), shift);
    let j = p.sub_rn(e, p.mul_rn(p.splat(3.0), k));
    let k = p.select(small, p.sub_rn(k, p.splat(18.0)), k);
    let v = p.scale(of_reduced(p, f, j), k);
    with_sign_of(p, p.select(p.eq(x, p.splat(0.0)), size, v), x)
}

/// ∛(f·2ʲ) to within 0.51 units in the last place.
#[inline(always)]
fn of_reduced<P: Lanes>(p: P, f: P::F, j: P::F) -> P::F {
    let (zero, one, third) = (p.splat(0.0), p.splat(1.0), p.splat(1.0 / 3.0));
    let seed = p.fma_rn(
        f,
        p.splat(f64::from_bits(SEED[3])),
        p.splat(f64::from_bits(SEED[2])),
    );
    let seed = p.fma_rn(f, seed, p.splat(f64::from_bits(SEED[1])));
    let seed = p.fma_rn(f, seed, p.splat(f64::from_bits(SEED[0])));
    let (less, more) = (p.lt(j, zero), p.lt(zero, j));
    let (down, up) = (p.splat(f64::from_bits(DOWN)), p.splat(f64::from_bits(UP)));
    let r = p.mul_rn(seed, p.select(more, down, p.select(less, up, one)));
    let m = p.mul_rn(
        f,
        p.select(more, p.splat(2.0), p.select(less, p.splat(0.5), one)),
    );
    let cube = p.mul_rn(p.mul_rn(r, r), r);
    let e = p.sub_rn(one, p.mul_rn(m, cube));
    let series = p.fma_rn(e, p.splat(2.0 / 9.0), third);
    let r = p.fma_rn(p.mul_rn(r, e), series, r);
    let square = p.mul_rn(r, r);
    let y = p.mul_rn(m, square);
    // m − y³, y² = h + l, h·y = g + i
    let (h, l) = two_product(p, y, y);
    let (g, i) = two_product(p, h, y);
    let rest = p.sub_rn(p.sub_rn(p.sub_rn(m, g), i), p.mul_rn(l, y));
    p.fma_rn(rest, p.mul_rn(square, third), y)
}
