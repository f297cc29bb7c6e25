//! Plain floating point on packets, for guesses that an enclosure then checks.

use super::functions;
use super::{Arithmetic, Flags, Interval, Packet, Truth, Undecided};

/// Approximate arithmetic on the lanes of a packet: no bounds, no flags, NaN where a function is not defined.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<P>(pub P);

/// `f` on each lane.
#[inline(always)]
fn each<P: Packet>(p: P, x: P::F, f: fn(f64) -> f64) -> P::F {
    let mut x = p.to_array(x);
    for lane in &mut x[..P::LANES] {
        *lane = f(*lane);
    }
    p.lanes(x)
}

/// `f` on each lane of two operands.
#[inline(always)]
fn each2<P: Packet>(p: P, x: P::F, y: P::F, f: fn(f64, f64) -> f64) -> P::F {
    let (mut x, y) = (p.to_array(x), p.to_array(y));
    for (lane, other) in x[..P::LANES].iter_mut().zip(y) {
        *lane = f(*lane, other);
    }
    p.lanes(x)
}

/// Operations that are one call per lane of `f64`'s method of the same name; the second list are those that are partial.
macro_rules! per_lane {
    (total: $($total:ident)*; partial: $($partial:ident)*) => {
        $(#[inline(always)]
        fn $total(self, a: P::F) -> P::F {
            each(self.0, a, f64::$total)
        })*
        $(#[inline(always)]
        fn $partial(self, a: P::F) -> (P::F, Flags<P>) {
            (each(self.0, a, f64::$partial), self.clear())
        })*
    };
}

impl<P: Packet> Arithmetic for Nearest<P> {
    type Packet = P;
    type Value = P::F;

    #[inline(always)]
    fn constant(self, c: &Interval) -> P::F {
        self.0.splat(c.mid())
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
    fn neg(self, a: P::F) -> P::F {
        self.0.neg_f(a)
    }
    #[inline(always)]
    fn add(self, a: P::F, b: P::F) -> P::F {
        self.0.add_rn(a, b)
    }
    #[inline(always)]
    fn sub(self, a: P::F, b: P::F) -> P::F {
        self.0.sub_rn(a, b)
    }
    #[inline(always)]
    fn mul(self, a: P::F, b: P::F) -> P::F {
        self.0.mul_rn(a, b)
    }
    #[inline(always)]
    fn mul_pos(self, a: P::F, b: P::F) -> P::F {
        self.0.mul_rn(a, b)
    }
    #[inline(always)]
    fn mul_pos_pos(self, a: P::F, b: P::F) -> P::F {
        self.0.mul_rn(a, b)
    }
    #[inline(always)]
    fn sqr(self, a: P::F) -> P::F {
        self.0.mul_rn(a, a)
    }
    #[inline(always)]
    fn powi(self, a: P::F, n: u32) -> P::F {
        let p = self.0;
        let (mut power, mut square, mut n) = (p.splat(1.0), a, n);
        while n > 0 {
            if n & 1 == 1 {
                power = p.mul_rn(power, square);
            }
            square = p.mul_rn(square, square);
            n >>= 1;
        }
        power
    }
    #[inline(always)]
    fn nonneg(self, a: P::F) -> P::F {
        // Zero first, so that a NaN stays one.
        self.0.max_f(self.0.splat(0.0), a)
    }
    #[inline(always)]
    fn abs(self, a: P::F) -> P::F {
        self.0.abs_f(a)
    }
    #[inline(always)]
    fn abs_slope(self, a: P::F) -> (P::F, Flags<P>) {
        let p = self.0;
        (
            p.select(p.lt(a, p.splat(0.0)), p.splat(-1.0), p.splat(1.0)),
            self.clear(),
        )
    }
    #[inline(always)]
    fn min(self, a: P::F, b: P::F) -> P::F {
        self.0.min_f(a, b)
    }
    #[inline(always)]
    fn max(self, a: P::F, b: P::F) -> P::F {
        self.0.max_f(a, b)
    }
    #[inline(always)]
    fn less(self, a: P::F, b: P::F) -> Truth<P> {
        let yes = self.0.lt(a, b);
        Truth {
            yes,
            no: self.0.not(yes),
        }
    }
    #[inline(always)]
    fn less_or_equal(self, a: P::F, b: P::F) -> Truth<P> {
        let yes = self.0.le(a, b);
        Truth {
            yes,
            no: self.0.not(yes),
        }
    }
    #[inline(always)]
    fn both(self, a: Truth<P>, b: Truth<P>) -> Truth<P> {
        a.both(self.0, b)
    }
    #[inline(always)]
    fn either(self, a: Truth<P>, b: Truth<P>) -> Truth<P> {
        a.either(self.0, b)
    }
    #[inline(always)]
    fn choose(self, c: Truth<P>, yes: P::F, no: P::F) -> P::F {
        self.0.select(c.yes, yes, no)
    }
    #[inline(always)]
    fn branch(self, _c: Truth<P>, yes: Flags<P>, _no: Flags<P>, _undecided: Undecided) -> Flags<P> {
        yes
    }
    #[inline(always)]
    fn div(self, a: P::F, b: P::F) -> (P::F, Flags<P>) {
        (self.0.div_rn(a, b), self.clear())
    }
    #[inline(always)]
    fn recip(self, a: P::F) -> (P::F, Flags<P>) {
        (self.0.div_rn(self.0.splat(1.0), a), self.clear())
    }
    #[inline(always)]
    fn sqrt(self, a: P::F) -> (P::F, Flags<P>) {
        (self.0.sqrt_rn(a), self.clear())
    }
    #[inline(always)]
    fn exp(self, a: P::F) -> P::F {
        functions::exp::anywhere(self.0, a)
    }
    #[inline(always)]
    fn ln(self, a: P::F) -> (P::F, Flags<P>) {
        (functions::ln::anywhere(self.0, a), self.clear())
    }
    #[inline(always)]
    fn sin(self, a: P::F) -> P::F {
        functions::circular::near(self.0, a, 0.0)
    }
    #[inline(always)]
    fn cos(self, a: P::F) -> P::F {
        functions::circular::near(self.0, a, 1.0)
    }
    #[inline(always)]
    fn tan(self, a: P::F) -> (P::F, Flags<P>) {
        (functions::tangent::near(self.0, a), self.clear())
    }
    #[inline(always)]
    fn asin(self, a: P::F) -> (P::F, Flags<P>) {
        (functions::arcsine::near_sine(self.0, a), self.clear())
    }
    #[inline(always)]
    fn acos(self, a: P::F) -> (P::F, Flags<P>) {
        (functions::arcsine::near_cosine(self.0, a), self.clear())
    }
    #[inline(always)]
    fn atan(self, a: P::F) -> P::F {
        functions::arctangent::near(self.0, a)
    }
    #[inline(always)]
    fn cbrt(self, a: P::F) -> P::F {
        functions::cbrt::near(self.0, a)
    }
    #[inline(always)]
    fn pow(self, a: P::F, b: P::F) -> (P::F, Flags<P>) {
        (each2(self.0, a, b, f64::powf), self.clear())
    }
    #[inline(always)]
    fn atan2(self, a: P::F, b: P::F) -> (P::F, Flags<P>) {
        (functions::angle::near(self.0, a, b), self.clear())
    }
    #[inline(always)]
    fn hypot(self, a: P::F, b: P::F) -> P::F {
        self.0.sqrt_rn(self.0.fma_rn(a, a, self.0.mul_rn(b, b)))
    }

    per_lane! {
        total: exp2 exp_m1 sinh cosh tanh asinh;
        partial: ln_1p log2 log10 acosh atanh
    }
}
