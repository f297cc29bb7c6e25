//! Interval operations that widen once per bound, out of line.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes, Rounding, functions};
use super::{F, Portable, down_one, up_one};

type Bounds = Interval<F>;

/// Forwards interval operations to functions that are not inlined: in long formulas eight-lane loops inlined hundreds
/// of times take minutes to compile and run no faster.
macro_rules! not_inlined {
    ($($name:ident($($operand:ident: $kind:ty),*) -> $out:ty = $body:expr;)*) => {
        $(#[inline(always)]
        fn $name(self, $($operand: $kind),*) -> $out {
            #[inline(never)]
            fn inner<R: Rounding>(p: Portable<R>, $($operand: $kind),*) -> $out {
                $body(p, $($operand),*)
            }
            inner(self, $($operand),*)
        })*
    };
}

impl<R: Rounding> Enclose for Portable<R> {
    not_inlined! {
        i_add(a: Bounds, b: Bounds) -> Bounds = add;
        i_sub(a: Bounds, b: Bounds) -> Bounds = sub;
        i_mul(a: Bounds, b: Bounds) -> Bounds = mul;
        i_powi(a: Bounds, n: u32) -> Bounds = functions::power::powi;
        i_exp(a: Bounds) -> Bounds = functions::exp::exp;
        i_ln(a: Bounds) -> Bounds = functions::ln::ln;
        i_exp_m1(a: Bounds) -> Bounds = functions::hyperbolic::exp_m1;
        i_sinh(a: Bounds) -> Bounds = functions::hyperbolic::sinh;
        i_tanh(a: Bounds) -> Bounds = functions::hyperbolic::tanh;
        i_sin(a: Bounds) -> Bounds = functions::circular::sin;
        i_cos(a: Bounds) -> Bounds = functions::circular::cos;
        i_sin_cos(a: Bounds) -> [Bounds; 2] = functions::circular::sin_cos;
        i_tan(a: Bounds) -> Bounds = functions::tangent::tan;
        i_atan(a: Bounds) -> Bounds = functions::arctangent::atan;
        i_asin(a: Bounds) -> Bounds = functions::arcsine::asin;
        i_acos(a: Bounds) -> Bounds = functions::arcsine::acos;
        i_atan2(y: Bounds, x: Bounds) -> Bounds = functions::angle::atan2;
        i_cbrt(a: Bounds) -> Bounds = functions::cbrt::cbrt;
        i_hypot(a: Bounds, b: Bounds) -> Bounds = functions::hypot::hypot;
    }
}

#[inline(always)]
fn add<R: Rounding>(p: Portable<R>, a: Interval<F>, b: Interval<F>) -> Interval<F> {
    Interval {
        lo: p.add_rd(a.lo, b.lo),
        hi: p.add_ru(a.hi, b.hi),
    }
}

#[inline(always)]
fn sub<R: Rounding>(p: Portable<R>, a: Interval<F>, b: Interval<F>) -> Interval<F> {
    Interval {
        lo: p.sub_rd(a.lo, b.hi),
        hi: p.sub_ru(a.hi, b.lo),
    }
}

/// Four products to nearest; widened once per bound, after the minimum and maximum. See
/// [`Enclose::i_mul`] for the NaN of 0·∞.
#[inline(always)]
fn mul<R: Rounding>(p: Portable<R>, a: Interval<F>, b: Interval<F>) -> Interval<F> {
    let last = p.mend(p.mul_rn(a.hi, b.hi));
    let (x, y, z) = (
        p.mul_rn(a.hi, b.lo),
        p.mul_rn(a.lo, b.hi),
        p.mul_rn(a.lo, b.lo),
    );
    let lo = p.min_f(z, p.min_f(y, p.min_f(x, last)));
    let hi = p.max_f(z, p.max_f(y, p.max_f(x, last)));
    let zero = |a: &Interval<F>, i: usize| (a.lo[i] == 0.0) & (a.hi[i] == 0.0);
    let exact = |i| zero(&a, i) | zero(&b, i);
    Interval {
        lo: map!(i => down_one::<R>(lo[i], exact(i))),
        hi: map!(i => up_one::<R>(hi[i], exact(i))),
    }
}
