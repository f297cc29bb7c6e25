//! Whole powers.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes};
use super::outward::{above, below};

/// aⁿ. Even powers are the power of |a|, monotone in its bounds; odd powers are monotone in those of a.
#[inline(always)]
pub fn powi<P: Enclose>(p: P, a: Interval<P::F>, n: u32) -> Interval<P::F> {
    match n {
        0 => Interval {
            lo: p.splat(1.0),
            hi: p.splat(1.0),
        },
        1 => a,
        2 => p.i_sqr(a),
        _ if n.is_multiple_of(2) => {
            let m = p.i_abs(a);
            Interval {
                lo: lower(p, m.lo, n),
                hi: upper(p, m.hi, n),
            }
        }
        _ => {
            let zero = p.splat(0.0);
            let (l, h) = (p.abs_f(a.lo), p.abs_f(a.hi));
            Interval {
                lo: p.select(p.lt(a.lo, zero), p.neg_f(upper(p, l, n)), lower(p, l, n)),
                hi: p.select(p.le(a.hi, zero), p.neg_f(lower(p, h, n)), upper(p, h, n)),
            }
        }
    }
}

/// Where a product is rounded to.
#[derive(Clone, Copy)]
enum Toward {
    Below,
    Nearest,
    Above,
}

/// A lower bound of xⁿ for x ≥ 0. All factors are ≥ 0, so rounding each product down bounds the power from below; where
/// that means widening it, one step outward does for the n − 1 roundings (a square doubles those of its root: they count
/// as x's factors do).
#[inline(always)]
fn lower<P: Lanes>(p: P, x: P::F, n: u32) -> P::F {
    if P::OPTIMAL {
        power(p, x, n, Toward::Below)
    } else {
        below(p, power(p, x, n, Toward::Nearest), n - 1)
    }
}

/// An upper bound, likewise. A power that underflows has x < 1: what follows makes its error smaller.
#[inline(always)]
fn upper<P: Lanes>(p: P, x: P::F, n: u32) -> P::F {
    if P::OPTIMAL {
        power(p, x, n, Toward::Above)
    } else {
        above(p, power(p, x, n, Toward::Nearest), n - 1)
    }
}

/// xⁿ for x ≥ 0 and n ≥ 1 by repeated squaring, from the highest bit of n down.
#[inline(always)]
fn power<P: Lanes>(p: P, x: P::F, n: u32, toward: Toward) -> P::F {
    let mut y = x;
    let mut bit = (31 - n.leading_zeros()) as i32 - 1;
    while bit >= 0 {
        y = times(p, y, y, toward);
        if (n >> bit) & 1 == 1 {
            y = times(p, y, x, toward);
        }
        bit -= 1;
    }
    y
}

#[inline(always)]
fn times<P: Lanes>(p: P, a: P::F, b: P::F, toward: Toward) -> P::F {
    match toward {
        Toward::Below => p.mul_rd(a, b),
        Toward::Nearest => p.mul_rn(a, b),
        Toward::Above => p.mul_ru(a, b),
    }
}
