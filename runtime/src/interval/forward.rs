//! Every packet is an [`Arithmetic`] on intervals.

use super::enclose::Enclose;
use super::functions;
use super::lanes::{operation, operations};
use super::{Arithmetic, Flags, Interval, Lanes, Truth, Undecided};

type Bounds<P> = Interval<<P as Lanes>::F>;
type Flagged<P> = (Bounds<P>, Flags<P>);

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
    fn undefined_if(self, undefined: bool) -> Flags<P> {
        let all = self.mask(if undefined { 0xff } else { 0 });
        Flags {
            undefined: all,
            ..Flags::none(self)
        }
    }

    /// Inlined whatever its length: sums of exponentials are little else.
    #[inline(always)]
    fn exp(self, a: Interval<P::F>) -> Interval<P::F> {
        self.i_exp(a)
    }
    #[inline(always)]
    fn sin(self, a: Interval<P::F>) -> Interval<P::F> {
        if P::INLINES_LONG {
            return self.i_sin(a);
        }
        operation!(<P: Enclose> self, (a: Bounds<P> = &a) -> Bounds<P> = p => p.i_sin(a))
    }
    #[inline(always)]
    fn cos(self, a: Interval<P::F>) -> Interval<P::F> {
        if P::INLINES_LONG {
            return self.i_cos(a);
        }
        operation!(<P: Enclose> self, (a: Bounds<P> = &a) -> Bounds<P> = p => p.i_cos(a))
    }
    #[inline(always)]
    fn sin_cos(self, a: Interval<P::F>) -> [Interval<P::F>; 2] {
        if P::INLINES_LONG {
            return self.i_sin_cos(a);
        }
        operation!(<P: Enclose> self, (a: Bounds<P> = &a) -> [Bounds<P>; 2] = p => p.i_sin_cos(a))
    }

    operations! {
        <P: Enclose> self => self;
        join(a: Flags<P>, b: Flags<P>) -> Flags<P> = p => a.join(p, b);
        join_derivative(a: Flags<P>, d: Flags<P>) -> Flags<P> = p => Flags {
            empty: a.empty,
            undefined: p.or(d.empty, p.or(a.undefined, d.undefined)),
            jump: p.or(a.jump, d.jump),
            kink: p.or(a.kink, d.kink),
        };
        neg(a: Bounds<P>) -> Bounds<P> = p =>
            Interval { lo: p.neg_f(a.hi), hi: p.neg_f(a.lo) };
        add(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p => p.i_add(a, b);
        sub(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p => p.i_sub(a, b);
        mul(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p => p.i_mul(a, b);
        mul_pos(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p => p.i_mul_pos(a, b);
        mul_pos_pos(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p => p.i_mul_pos_pos(a, b);
        sqr(a: Bounds<P>) -> Bounds<P> = p => p.i_sqr(a);
        powi(a: Bounds<P>, n: u32) -> Bounds<P> = p => p.i_powi(a, n);
        nonneg(a: Bounds<P>) -> Bounds<P> = p => {
            let zero = p.splat(0.0);
            Interval {
                lo: p.max_f(a.lo, zero),
                hi: p.max_f(a.hi, zero),
            }
        };
        abs(a: Bounds<P>) -> Bounds<P> = p => p.i_abs(a);
        abs_slope(a: Bounds<P>) -> Flagged<P> = p => {
            // Where a only touches 0, |a| is a or −a over the whole operand: no kink.
            let (zero, one, minus) = (p.splat(0.0), p.splat(1.0), p.splat(-1.0));
            let below = p.lt(a.lo, zero);
            let above = p.lt(zero, a.hi);
            let slope = Interval {
                lo: p.select(below, minus, one),
                hi: p.select(p.and_not(below, above), minus, one),
            };
            (
                slope,
                Flags {
                    kink: p.and(below, above),
                    ..Flags::none(p)
                },
            )
        };
        min(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p =>
            Interval { lo: p.min_f(a.lo, b.lo), hi: p.min_f(a.hi, b.hi) };
        max(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p =>
            Interval { lo: p.max_f(a.lo, b.lo), hi: p.max_f(a.hi, b.hi) };
        less(a: Bounds<P>, b: Bounds<P>) -> Truth<P> = p =>
            Truth { yes: p.lt(a.hi, b.lo), no: p.le(b.hi, a.lo) };
        less_or_equal(a: Bounds<P>, b: Bounds<P>) -> Truth<P> = p =>
            Truth { yes: p.le(a.hi, b.lo), no: p.lt(b.hi, a.lo) };
        both(a: Truth<P>, b: Truth<P>) -> Truth<P> = p => a.both(p, b);
        either(a: Truth<P>, b: Truth<P>) -> Truth<P> = p => a.either(p, b);
        choose(c: Truth<P>, yes: Bounds<P>, no: Bounds<P>) -> Bounds<P> = p => {
            let lo = p.min_f(yes.lo, no.lo);
            let hi = p.max_f(yes.hi, no.hi);
            Interval {
                lo: p.select(c.yes, yes.lo, p.select(c.no, no.lo, lo)),
                hi: p.select(c.yes, yes.hi, p.select(c.no, no.hi, hi)),
            }
        };
        branch(c: Truth<P>, yes: Flags<P>, no: Flags<P>, undecided: Undecided) -> Flags<P> = p =>
            c.branch(p, yes, no, undecided);
        div(a: Bounds<P>, b: Bounds<P>) -> Flagged<P> = p =>
            (p.i_div(a, b), functions::domain::nonzero(p, b));
        recip(a: Bounds<P>) -> Flagged<P> = p => (p.i_recip(a), functions::domain::nonzero(p, a));
        sqrt(a: Bounds<P>) -> Flagged<P> = p =>
            (p.i_sqrt(a), functions::domain::at_least(p, a, 0.0));
        cbrt(a: Bounds<P>) -> Bounds<P> = p => p.i_cbrt(a);
        pow(a: Bounds<P>, b: Bounds<P>) -> Flagged<P> = p =>
            (functions::real_power::pow(p, a, b), functions::domain::power(p, a, b));
        exp2(a: Bounds<P>) -> Bounds<P> = p => functions::derived::exp2(p, a);
        exp_m1(a: Bounds<P>) -> Bounds<P> = p => p.i_exp_m1(a);
        ln(a: Bounds<P>) -> Flagged<P> = p => (p.i_ln(a), functions::domain::above(p, a, 0.0));
        ln_1p(a: Bounds<P>) -> Flagged<P> = p =>
            (functions::inverse_hyperbolic::ln_1p(p, a), functions::domain::above(p, a, -1.0));
        log2(a: Bounds<P>) -> Flagged<P> = p =>
            (functions::derived::log2(p, a), functions::domain::above(p, a, 0.0));
        log10(a: Bounds<P>) -> Flagged<P> = p =>
            (functions::derived::log10(p, a), functions::domain::above(p, a, 0.0));
        tan(a: Bounds<P>) -> Flagged<P> = p => {
            let range = p.i_tan(a);
            // Between its poles the tangent of a double is finite.
            let pole = p.eq(range.lo, p.splat(f64::NEG_INFINITY));
            let flags = Flags {
                undefined: pole,
                ..Flags::none(p)
            };
            (range, flags)
        };
        asin(a: Bounds<P>) -> Flagged<P> = p =>
            (p.i_asin(a), functions::domain::between(p, a, -1.0, 1.0));
        acos(a: Bounds<P>) -> Flagged<P> = p =>
            (p.i_acos(a), functions::domain::between(p, a, -1.0, 1.0));
        atan(a: Bounds<P>) -> Bounds<P> = p => p.i_atan(a);
        atan2(a: Bounds<P>, b: Bounds<P>) -> Flagged<P> = p =>
            (p.i_atan2(a, b), functions::domain::angle(p, a, b));
        sinh(a: Bounds<P>) -> Bounds<P> = p => p.i_sinh(a);
        cosh(a: Bounds<P>) -> Bounds<P> = p => functions::derived::cosh(p, a);
        tanh(a: Bounds<P>) -> Bounds<P> = p => p.i_tanh(a);
        asinh(a: Bounds<P>) -> Bounds<P> = p => functions::inverse_hyperbolic::asinh(p, a);
        acosh(a: Bounds<P>) -> Flagged<P> = p =>
            (functions::inverse_hyperbolic::acosh(p, a), functions::domain::at_least(p, a, 1.0));
        atanh(a: Bounds<P>) -> Flagged<P> = p => (
            functions::inverse_hyperbolic::atanh(p, a),
            functions::domain::inside(p, a, -1.0, 1.0),
        );
        hypot(a: Bounds<P>, b: Bounds<P>) -> Bounds<P> = p => p.i_hypot(a, b);
    }
}
