//! Every packet is an [`Arithmetic`] on intervals.

use super::enclose::Enclose;
use super::functions;
use super::{Arithmetic, Flags, Interval, Truth, Undecided};

impl<P: Enclose> Arithmetic for P {
    type Packet = P;
    type Value = Interval<P::F>;

    #[inline(always)]
    fn constant(self, c: &Interval) -> Interval<P::F> {
        Interval {
            lo: self.splat(c.lo),
            hi: self.splat(c.hi),
        }
    }

    #[inline(always)]
    fn clear(self) -> Flags<P> {
        Flags::none(self)
    }
    #[inline(always)]
    fn join(self, a: Flags<P>, b: Flags<P>) -> Flags<P> {
        a.join(self, b)
    }
    #[inline(always)]
    fn join_derivative(self, a: Flags<P>, d: Flags<P>) -> Flags<P> {
        Flags {
            empty: a.empty,
            undefined: self.or(d.empty, self.or(a.undefined, d.undefined)),
            jump: self.or(a.jump, d.jump),
            kink: self.or(a.kink, d.kink),
        }
    }
    #[inline(always)]
    fn undefined_if(self, undefined: bool) -> Flags<P> {
        let all = self.mask(if undefined { 0xff } else { 0 });
        Flags {
            undefined: all,
            ..Flags::none(self)
        }
    }

    #[inline(always)]
    fn neg(self, a: Interval<P::F>) -> Interval<P::F> {
        Interval {
            lo: self.neg_f(a.hi),
            hi: self.neg_f(a.lo),
        }
    }
    #[inline(always)]
    fn add(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        self.i_add(a, b)
    }
    #[inline(always)]
    fn sub(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        self.i_sub(a, b)
    }
    #[inline(always)]
    fn mul(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        self.i_mul(a, b)
    }
    #[inline(always)]
    fn mul_pos(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        self.i_mul_pos(a, b)
    }
    #[inline(always)]
    fn mul_pos_pos(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        self.i_mul_pos_pos(a, b)
    }
    #[inline(always)]
    fn sqr(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_sqr(a)
    }
    #[inline(always)]
    fn powi(self, a: Interval<P::F>, n: u32) -> Interval<P::F> {
        self.i_powi(a, n)
    }
    #[inline(always)]
    fn nonneg(self, a: Interval<P::F>) -> Interval<P::F> {
        let zero = self.splat(0.0);
        Interval {
            lo: self.max_f(a.lo, zero),
            hi: self.max_f(a.hi, zero),
        }
    }
    #[inline(always)]
    fn abs(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_abs(a)
    }
    #[inline(always)]
    fn abs_slope(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        // Where a only touches 0, |a| is a or −a over the whole operand: no kink.
        let (zero, one, minus) = (self.splat(0.0), self.splat(1.0), self.splat(-1.0));
        let below = self.lt(a.lo, zero);
        let above = self.lt(zero, a.hi);
        let slope = Interval {
            lo: self.select(below, minus, one),
            hi: self.select(self.and_not(below, above), minus, one),
        };
        (
            slope,
            Flags {
                kink: self.and(below, above),
                ..Flags::none(self)
            },
        )
    }
    #[inline(always)]
    fn min(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        Interval {
            lo: self.min_f(a.lo, b.lo),
            hi: self.min_f(a.hi, b.hi),
        }
    }
    #[inline(always)]
    fn max(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        Interval {
            lo: self.max_f(a.lo, b.lo),
            hi: self.max_f(a.hi, b.hi),
        }
    }
    #[inline(always)]
    fn less(self, a: Interval<P::F>, b: Interval<P::F>) -> Truth<P> {
        Truth {
            yes: self.lt(a.hi, b.lo),
            no: self.le(b.hi, a.lo),
        }
    }
    #[inline(always)]
    fn less_or_equal(self, a: Interval<P::F>, b: Interval<P::F>) -> Truth<P> {
        Truth {
            yes: self.le(a.hi, b.lo),
            no: self.lt(b.hi, a.lo),
        }
    }
    #[inline(always)]
    fn both(self, a: Truth<P>, b: Truth<P>) -> Truth<P> {
        a.both(self, b)
    }
    #[inline(always)]
    fn either(self, a: Truth<P>, b: Truth<P>) -> Truth<P> {
        a.either(self, b)
    }
    #[inline(always)]
    fn choose(self, c: Truth<P>, yes: Interval<P::F>, no: Interval<P::F>) -> Interval<P::F> {
        let lo = self.min_f(yes.lo, no.lo);
        let hi = self.max_f(yes.hi, no.hi);
        Interval {
            lo: self.select(c.yes, yes.lo, self.select(c.no, no.lo, lo)),
            hi: self.select(c.yes, yes.hi, self.select(c.no, no.hi, hi)),
        }
    }
    #[inline(always)]
    fn branch(self, c: Truth<P>, yes: Flags<P>, no: Flags<P>, undecided: Undecided) -> Flags<P> {
        c.branch(self, yes, no, undecided)
    }

    #[inline(always)]
    fn div(self, a: Interval<P::F>, b: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (self.i_div(a, b), functions::domain::nonzero(self, b))
    }
    #[inline(always)]
    fn recip(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (self.i_recip(a), functions::domain::nonzero(self, a))
    }
    #[inline(always)]
    fn sqrt(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (self.i_sqrt(a), functions::domain::at_least(self, a, 0.0))
    }
    #[inline(always)]
    fn cbrt(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_cbrt(a)
    }
    #[inline(always)]
    fn pow(self, a: Interval<P::F>, b: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            functions::real_power::pow(self, a, b),
            functions::domain::power(self, a, b),
        )
    }
    #[inline(always)]
    fn exp(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_exp(a)
    }
    #[inline(always)]
    fn exp2(self, a: Interval<P::F>) -> Interval<P::F> {
        functions::derived::exp2(self, a)
    }
    #[inline(always)]
    fn exp_m1(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_exp_m1(a)
    }
    #[inline(always)]
    fn ln(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (self.i_ln(a), functions::domain::above(self, a, 0.0))
    }
    #[inline(always)]
    fn ln_1p(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            functions::inverse_hyperbolic::ln_1p(self, a),
            functions::domain::above(self, a, -1.0),
        )
    }
    #[inline(always)]
    fn log2(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            functions::derived::log2(self, a),
            functions::domain::above(self, a, 0.0),
        )
    }
    #[inline(always)]
    fn log10(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            functions::derived::log10(self, a),
            functions::domain::above(self, a, 0.0),
        )
    }
    #[inline(always)]
    fn sin(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_sin(a)
    }
    #[inline(always)]
    fn cos(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_cos(a)
    }
    #[inline(always)]
    fn tan(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        let range = self.i_tan(a);
        // Between its poles the tangent of a double is finite.
        let pole = self.eq(range.lo, self.splat(f64::NEG_INFINITY));
        let flags = Flags {
            undefined: pole,
            ..Flags::none(self)
        };
        (range, flags)
    }
    #[inline(always)]
    fn asin(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            self.i_asin(a),
            functions::domain::between(self, a, -1.0, 1.0),
        )
    }
    #[inline(always)]
    fn acos(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            self.i_acos(a),
            functions::domain::between(self, a, -1.0, 1.0),
        )
    }
    #[inline(always)]
    fn atan(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_atan(a)
    }
    #[inline(always)]
    fn atan2(self, a: Interval<P::F>, b: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (self.i_atan2(a, b), functions::domain::angle(self, a, b))
    }
    #[inline(always)]
    fn sinh(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_sinh(a)
    }
    #[inline(always)]
    fn cosh(self, a: Interval<P::F>) -> Interval<P::F> {
        functions::derived::cosh(self, a)
    }
    #[inline(always)]
    fn tanh(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_tanh(a)
    }
    #[inline(always)]
    fn asinh(self, a: Interval<P::F>) -> Interval<P::F> {
        functions::inverse_hyperbolic::asinh(self, a)
    }
    #[inline(always)]
    fn acosh(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            functions::inverse_hyperbolic::acosh(self, a),
            functions::domain::at_least(self, a, 1.0),
        )
    }
    #[inline(always)]
    fn atanh(self, a: Interval<P::F>) -> (Interval<P::F>, Flags<P>) {
        (
            functions::inverse_hyperbolic::atanh(self, a),
            functions::domain::inside(self, a, -1.0, 1.0),
        )
    }
    #[inline(always)]
    fn hypot(self, a: Interval<P::F>, b: Interval<P::F>) -> Interval<P::F> {
        self.i_hypot(a, b)
    }
}
