//! From a computed value and its error to bounds.

use super::super::{Interval, Lanes, Rounding};

/// The double `steps` places below v. 0 stays 0: the functions that use this are 0 only where that is exact.
#[inline(always)]
pub fn under<P: Lanes>(p: P, v: P::F, steps: u32) -> P::F {
    let zero = p.splat(0.0);
    if P::OPTIMAL {
        let (mut v, mut i) = (v, 0);
        while i < steps {
            v = p.fma_rd(p.abs_f(v), p.splat(-little::<P>()), v);
            i += 1;
        }
        return v;
    }
    let (nearer, farther) = steps_of(p, v, steps);
    p.select(p.lt(v, zero), farther, p.max_f(nearer, zero))
}

/// The double `steps` places above v; 0 of 0.
#[inline(always)]
pub fn over<P: Lanes>(p: P, v: P::F, steps: u32) -> P::F {
    let zero = p.splat(0.0);
    if P::OPTIMAL {
        let (mut v, mut i) = (v, 0);
        while i < steps {
            v = p.fma_ru(p.abs_f(v), p.splat(little::<P>()), v);
            i += 1;
        }
        return v;
    }
    let (nearer, farther) = steps_of(p, v, steps);
    p.select(p.lt(zero, v), farther, p.min_f(nearer, zero))
}

/// Times |v|, this is less than the distance of two doubles, but something, so that directed rounding goes to the next one.
const fn little<P: Lanes>() -> f64 {
    P::Rounding::STEP as f64 * f64::EPSILON / 256.0
}

/// The doubles `steps` places nearer to 0, and farther from it: bits less, and more. Nearer than 0 are the NaNs, which
/// the extremes above drop.
#[inline(always)]
fn steps_of<P: Lanes>(p: P, v: P::F, steps: u32) -> (P::F, P::F) {
    let (mut nearer, mut farther, mut i) = (v, v, 0);
    while i < steps {
        nearer = p.before(nearer);
        farther = p.after(farther);
        i += 1;
    }
    (nearer, farther)
}

/// The doubles `steps` places before and after v.
#[inline(always)]
pub fn around<P: Lanes>(p: P, v: P::F, steps: u32) -> Interval<P::F> {
    Interval {
        lo: under(p, v, steps),
        hi: over(p, v, steps),
    }
}

/// |v| with the sign of x, for v ≥ 0.
#[inline(always)]
pub fn with_sign_of<P: Lanes>(p: P, v: P::F, x: P::F) -> P::F {
    p.select(p.lt(x, p.splat(0.0)), p.neg_f(v), v)
}
