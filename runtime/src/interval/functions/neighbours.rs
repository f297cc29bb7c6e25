//! From a computed value and its error to bounds.

use super::super::{Interval, Lanes};

/// The doubles `steps` places before and after v. 0 stays 0: the functions that use this are 0 only where that is exact.
#[inline(always)]
pub fn around<P: Lanes>(p: P, v: P::F, steps: u32) -> Interval<P::F> {
    let zero = p.splat(0.0);
    let size = p.abs_f(v);
    let (mut less, mut more) = (size, size);
    let mut i = 0;
    while i < steps {
        less = p.before(less);
        more = p.after(more);
        i += 1;
    }
    // Before 0 are the NaNs (its bits less one), which the maximum drops.
    let less = p.max_f(less, zero);
    let more = p.select(p.lt(zero, size), more, zero);
    let negative = p.lt(v, zero);
    Interval {
        lo: p.select(negative, p.neg_f(more), less),
        hi: p.select(negative, p.neg_f(less), more),
    }
}

/// |v| with the sign of x, for v ≥ 0.
#[inline(always)]
pub fn with_sign_of<P: Lanes>(p: P, v: P::F, x: P::F) -> P::F {
    p.select(p.lt(x, p.splat(0.0)), p.neg_f(v), v)
}
