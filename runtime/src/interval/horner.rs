//! Bounds of c₀ + c₁t and c₀ + c₁t + c₂t² at t ≥ 0 by Horner's scheme, for lower bounds of the coefficients (none is +∞) and
//! upper ones (none is −∞).
//!
//! With instructions that round by themselves, each of the two fused operations rounds outward. Where bounds are widened,
//! one step does for both. Let s₁ and s be c₂t + c₁ and s₁t + c₀, fused and rounded to nearest, u = 2⁻⁵³:
//! * s errs by u|s| for the second rounding;
//! * the first one is off by u|s₁|, which counts t times, and |s₁t| ≤ |s|(1 + u) + |c₀|;
//! * the last step rounds too: another u|s|.
//!
//! Together u(3|s| + |c₀|), to which u(1 + 2⁻²⁰) has room for what is of second order. In subnormals a rounding errs by
//! 2⁻¹⁰⁷⁵: s₁ counts t times, but if t ≥ 2⁵² it is a whole number, and then nothing is lost below 2⁻¹⁰⁷⁴. So 2⁻¹⁰²² is
//! enough, and u·2⁻⁹⁶⁸ is twice that. The step grows with s more slowly than s does, so it follows the minimum.
//!
//! An overflow makes s infinite, or a NaN beside another infinity; 0·∞ is a NaN too. Each time the bound is infinite.
//! An s₁ that overflowed upward is too large for a lower bound: c₂ > 0 then, so s grows on the whole segment, and its
//! value at the first end, infinite or not, is the least.

use super::{Packet, Rounding};

/// u·(1 + 2⁻²⁰)
const UNIT: f64 = f64::from_bits(((1023 - 53) << 52) | 1 << 32);
/// 2⁻⁹⁶⁸
const GUARD: f64 = f64::from_bits((1023 - 968) << 52);

/// A lower bound of c₀ + c₁t.
#[inline(always)]
pub fn line_rd<P: Packet>(p: P, c0: P::F, c1: P::F, t: P::F) -> P::F {
    // 0·∞ is no number, and no bound.
    p.max_f(p.mul_add_rd(c1, t, c0), p.splat(f64::NEG_INFINITY))
}

/// An upper bound of c₀ + c₁t.
#[inline(always)]
pub fn line_ru<P: Packet>(p: P, c0: P::F, c1: P::F, t: P::F) -> P::F {
    p.min_f(p.mul_add_ru(c1, t, c0), p.splat(f64::INFINITY))
}

/// A lower bound of c₀ + c₁t + c₂t² at `start` and `end`, 0 ≤ start ≤ end < ∞.
#[inline(always)]
pub fn least<P: Packet>(p: P, c: [P::F; 3], start: P::F, end: P::F) -> P::F {
    let minus = p.splat(f64::NEG_INFINITY);
    if P::OPTIMAL || !P::FUSED {
        let [c0, c1, c2] = c;
        let first = p.mul_add_rd(p.mul_add_rd(c2, start, c1), start, c0);
        let last = p.mul_add_rd(p.mul_add_rd(c2, end, c1), end, c0);
        return p.max_f(p.min_f(first, last), minus);
    }
    let s = p.min_f(nearest(p, c, start), nearest(p, c, end));
    if !P::Rounding::ON {
        return s;
    }
    let step = p.splat(-UNIT * P::Rounding::SCALE);
    p.max_f(p.fma_rn(size(p, s, c[0]), step, s), minus)
}

/// An upper bound, likewise.
#[inline(always)]
pub fn most<P: Packet>(p: P, c: [P::F; 3], start: P::F, end: P::F) -> P::F {
    let plus = p.splat(f64::INFINITY);
    if P::OPTIMAL || !P::FUSED {
        let [c0, c1, c2] = c;
        let first = p.mul_add_ru(p.mul_add_ru(c2, start, c1), start, c0);
        let last = p.mul_add_ru(p.mul_add_ru(c2, end, c1), end, c0);
        return p.min_f(p.max_f(first, last), plus);
    }
    let s = p.max_f(nearest(p, c, start), nearest(p, c, end));
    if !P::Rounding::ON {
        return s;
    }
    let step = p.splat(UNIT * P::Rounding::SCALE);
    p.min_f(p.fma_rn(size(p, s, c[0]), step, s), plus)
}

#[inline(always)]
fn nearest<P: Packet>(p: P, [c0, c1, c2]: [P::F; 3], t: P::F) -> P::F {
    p.fma_rn(p.fma_rn(c2, t, c1), t, c0)
}

/// 3|s| + |c₀|, raised.
#[inline(always)]
fn size<P: Packet>(p: P, s: P::F, c0: P::F) -> P::F {
    let c0 = p.abs_f(c0);
    let raised = if P::Rounding::GUARDED {
        p.add_rn(c0, p.splat(GUARD))
    } else {
        c0
    };
    p.fma_rn(p.splat(3.0), p.abs_f(s), raised)
}
