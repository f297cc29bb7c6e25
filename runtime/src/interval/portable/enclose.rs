//! Interval operations that widen once per bound, out of line.

use super::super::enclose::Enclose;
use super::super::{Interval, Lanes, Rounding, functions};
use super::{F, Portable, down_one, up_one};

/// Forwards interval operations to functions that are not inlined: in long formulas eight-lane loops inlined hundreds
/// of times take minutes to compile and run no faster.
macro_rules! not_inlined {
    ($($name:ident($($operand:ident: $kind:ty),*) = $body:expr;)*) => {
        $(#[inline(always)]
        fn $name(self, $($operand: $kind),*) -> Interval<F> {
            #[inline(never)]
            fn inner<R: Rounding>(p: Portable<R>, $($operand: $kind),*) -> Interval<F> {
                $body(p, $($operand),*)
            }
            inner(self, $($operand),*)
        })*
    };
}

impl<R: Rounding> Enclose for Portable<R> {
    not_inlined! {
        i_add(a: Interval<F>, b: Interval<F>) = add;
        i_sub(a: Interval<F>, b: Interval<F>) = sub;
        i_mul(a: Interval<F>, b: Interval<F>) = mul;
        i_powi(a: Interval<F>, n: u32) = functions::power::powi;
        i_exp(a: Interval<F>) = functions::exp::exp;
        i_ln(a: Interval<F>) = functions::ln::ln;
        i_exp_m1(a: Interval<F>) = functions::hyperbolic::exp_m1;
        i_sinh(a: Interval<F>) = functions::hyperbolic::sinh;
        i_tanh(a: Interval<F>) = functions::hyperbolic::tanh;
        i_sin(a: Interval<F>) = functions::circular::sin;
        i_cos(a: Interval<F>) = functions::circular::cos;
        i_tan(a: Interval<F>) = functions::tangent::tan;
        i_atan(a: Interval<F>) = functions::arctangent::atan;
        i_asin(a: Interval<F>) = functions::arcsine::asin;
        i_acos(a: Interval<F>) = functions::arcsine::acos;
        i_atan2(y: Interval<F>, x: Interval<F>) = functions::angle::atan2;
        i_cbrt(a: Interval<F>) = functions::cbrt::cbrt;
        i_hypot(a: Interval<F>, b: Interval<F>) = functions::hypot::hypot;
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
    Interval {
        lo: map!(i => down_one::<R>(lo[i])),
        hi: map!(i => up_one::<R>(hi[i])),
    }
}
