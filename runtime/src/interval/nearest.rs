//! Plain floating point on packets, for guesses that an enclosure then checks.

use super::functions;
use super::lanes::operations;
use super::{Arithmetic, Flags, Interval, Packet, Truth, Undecided};

/// Approximate arithmetic on the lanes of a packet: no bounds, no flags, NaN where a function is not defined.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<P>(pub P);

impl<P: Packet> Arithmetic for Nearest<P> {
    type Packet = P;
    type Value = P::F;

    #[inline(always)]
    fn constant(self, c: &Interval) -> P::F {
        self.0.splat(c.lo + 0.5 * (c.hi - c.lo))
    }
    #[inline(always)]
    fn clear(self) -> Flags<P> {
        Flags::none(self.0)
    }
    #[inline(always)]
    fn join(self, a: Flags<P>, _b: Flags<P>) -> Flags<P> {
        a
    }
    #[inline(always)]
    fn join_derivative(self, a: Flags<P>, _d: Flags<P>) -> Flags<P> {
        a
    }
    #[inline(always)]
    fn undefined_if(self, _undefined: bool) -> Flags<P> {
        self.clear()
    }
    #[inline(always)]
    fn branch(self, _c: Truth<P>, yes: Flags<P>, _no: Flags<P>, _undecided: Undecided) -> Flags<P> {
        yes
    }
    #[inline(always)]
    fn exp(self, a: P::F) -> P::F {
        functions::exp::anywhere(self.0, a)
    }

    operations! {
        <P: Packet> self => self.0;
        neg(a: P::F) -> P::F = p => p.neg_f(a);
        add(a: P::F, b: P::F) -> P::F = p => p.add_rn(a, b);
        sub(a: P::F, b: P::F) -> P::F = p => p.sub_rn(a, b);
        mul(a: P::F, b: P::F) -> P::F = p => p.mul_rn(a, b);
        mul_pos(a: P::F, b: P::F) -> P::F = p => p.mul_rn(a, b);
        mul_pos_pos(a: P::F, b: P::F) -> P::F = p => p.mul_rn(a, b);
        sqr(a: P::F) -> P::F = p => p.mul_rn(a, a);
        powi(a: P::F, n: u32) -> P::F = p => {
            let (mut power, mut square, mut n) = (p.splat(1.0), a, n);
            while n > 0 {
                if n & 1 == 1 {
                    power = p.mul_rn(power, square);
                }
                square = p.mul_rn(square, square);
                n >>= 1;
            }
            power
        };
        nonneg(a: P::F) -> P::F = p => {
            // Zero first, so that a NaN stays one.
            p.max_f(p.splat(0.0), a)
        };
        abs(a: P::F) -> P::F = p => p.abs_f(a);
        abs_slope(a: P::F) -> (P::F, Flags<P>) = p =>
            (p.select(p.lt(a, p.splat(0.0)), p.splat(-1.0), p.splat(1.0)), Flags::none(p));
        min(a: P::F, b: P::F) -> P::F = p => p.min_f(a, b);
        max(a: P::F, b: P::F) -> P::F = p => p.max_f(a, b);
        less(a: P::F, b: P::F) -> Truth<P> = p => {
            let yes = p.lt(a, b);
            Truth {
                yes,
                no: p.not(yes),
            }
        };
        less_or_equal(a: P::F, b: P::F) -> Truth<P> = p => {
            let yes = p.le(a, b);
            Truth {
                yes,
                no: p.not(yes),
            }
        };
        both(a: Truth<P>, b: Truth<P>) -> Truth<P> = p => a.both(p, b);
        either(a: Truth<P>, b: Truth<P>) -> Truth<P> = p => a.either(p, b);
        choose(c: Truth<P>, yes: P::F, no: P::F) -> P::F = p => p.select(c.yes, yes, no);
        div(a: P::F, b: P::F) -> (P::F, Flags<P>) = p => (p.div_rn(a, b), Flags::none(p));
        recip(a: P::F) -> (P::F, Flags<P>) = p => (p.div_rn(p.splat(1.0), a), Flags::none(p));
        sqrt(a: P::F) -> (P::F, Flags<P>) = p => (p.sqrt_rn(a), Flags::none(p));
        ln(a: P::F) -> (P::F, Flags<P>) = p => (functions::ln::anywhere(p, a), Flags::none(p));
        sin(a: P::F) -> P::F = p => functions::circular::anywhere(p, a)[0];
        cos(a: P::F) -> P::F = p => functions::circular::anywhere(p, a)[1];
        sin_cos(a: P::F) -> [P::F; 2] = p => functions::circular::anywhere(p, a);
        tan(a: P::F) -> (P::F, Flags<P>) = p => (functions::tangent::near(p, a), Flags::none(p));
        asin(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::arcsine::near_sine(p, a), Flags::none(p));
        acos(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::arcsine::near_cosine(p, a), Flags::none(p));
        atan(a: P::F) -> P::F = p => functions::arctangent::near(p, a);
        cbrt(a: P::F) -> P::F = p => functions::cbrt::near(p, a);
        pow(a: P::F, b: P::F) -> (P::F, Flags<P>) = p =>
            (functions::real_power::anywhere(p, a, b), Flags::none(p));
        atan2(a: P::F, b: P::F) -> (P::F, Flags<P>) = p =>
            (functions::angle::near(p, a, b), Flags::none(p));
        hypot(a: P::F, b: P::F) -> P::F = p => p.sqrt_rn(p.fma_rn(a, a, p.mul_rn(b, b)));
        exp2(a: P::F) -> P::F = p => functions::derived::exp2_anywhere(p, a);
        exp_m1(a: P::F) -> P::F = p => functions::hyperbolic::exp_m1_anywhere(p, a);
        sinh(a: P::F) -> P::F = p => functions::hyperbolic::sinh_anywhere(p, a);
        cosh(a: P::F) -> P::F = p => functions::derived::cosh_anywhere(p, a);
        tanh(a: P::F) -> P::F = p => functions::hyperbolic::tanh_anywhere(p, a);
        asinh(a: P::F) -> P::F = p => functions::inverse_hyperbolic::asinh_anywhere(p, a);
        ln_1p(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::inverse_hyperbolic::ln_1p_anywhere(p, a), Flags::none(p));
        log2(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::derived::log2_anywhere(p, a), Flags::none(p));
        log10(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::derived::log10_anywhere(p, a), Flags::none(p));
        acosh(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::inverse_hyperbolic::acosh_anywhere(p, a), Flags::none(p));
        atanh(a: P::F) -> (P::F, Flags<P>) = p =>
            (functions::inverse_hyperbolic::atanh_anywhere(p, a), Flags::none(p));
    }
}
