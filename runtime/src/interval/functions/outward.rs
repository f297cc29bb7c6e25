//! One step outward for several roundings.
//!
//! Where a back-end rounds to nearest and then widens, a chain of operations on numbers ≥ 0 is cheaper, and no less tight,
//! if the chain is computed to nearest and its result widened once, by as many units as it has roundings.
//!
//! Let x = y·Θ with (1 − u)ⁿ ≤ Θ ≤ (1 + u)ⁿ, u = 2⁻⁵³, and m = n + 1 ≤ 2³². With φ = m·u·(1 + 2⁻²⁰)
//! * x·(1 − φ), rounded, is at most y·(1 + u)ᵐ·(1 − φ) ≤ y, for 1 − φ ≤ (1 + u)⁻ᵐ;
//! * x·(1 + φ), rounded, is at least y·(1 − u)ᵐ·(1 + φ) ≥ y, for (1 − u)⁻ᵐ ≤ 1 + m·u·(1 + 2⁻²⁰) as m·u ≤ 2⁻²¹.
//!
//! Below 2⁻¹⁰²¹ each rounding errs by 2⁻¹⁰⁷⁴ at most, and the step is at least m·2⁻¹⁰⁷⁴. An x that overflowed
//! is infinite; then y ≥ MAX·(1 − u)ⁿ, which the bound of MAX is not above. Without fused operations φ·x is rounded too:
//! 2⁻²⁰·m·u has room for it.

use super::super::{Lanes, Rounding};

/// u·(1 + 2⁻²⁰)
const UNIT: f64 = f64::from_bits(((1023 - 53) << 52) | 1 << 32);
/// 2⁻¹⁰²¹
const GUARD: f64 = f64::from_bits(2 << 52);

/// A lower bound ≥ 0 of what n roundings made x ≥ 0 of.
#[inline(always)]
pub fn below<P: Lanes>(p: P, x: P::F, n: u32) -> P::F {
    if !P::Rounding::ON {
        return x;
    }
    let x = no_overflow(p, x);
    let bound = p.fma_rn(size(p, x), p.splat(-step::<P>(n)), x);
    p.max_f(bound, p.splat(0.0))
}

/// An upper bound of what n roundings made x ≥ 0 of.
#[inline(always)]
pub fn above<P: Lanes>(p: P, x: P::F, n: u32) -> P::F {
    if !P::Rounding::ON {
        return x;
    }
    p.fma_rn(size(p, x), p.splat(step::<P>(n)), x)
}

/// φ
#[inline(always)]
fn step<P: Lanes>(n: u32) -> f64 {
    (f64::from(n) + 1.0) * (UNIT * P::Rounding::SCALE)
}

#[inline(always)]
fn size<P: Lanes>(p: P, x: P::F) -> P::F {
    if P::Rounding::GUARDED {
        p.max_f(x, p.splat(GUARD))
    } else {
        x
    }
}

#[inline(always)]
fn no_overflow<P: Lanes>(p: P, x: P::F) -> P::F {
    if P::Rounding::GUARDED {
        p.min_f(x, p.splat(f64::MAX))
    } else {
        x
    }
}
