//! Twice the precision, one number at a time: for the few rays whose roots `f64` cannot pin down.
//!
//! A [`Ball`] is the unevaluated sum of two doubles and a radius. Sums of such pairs have relative errors below 3u²,
//! u = 2⁻⁵³ (Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
//! 2017, algorithm 6). Of a product the mixed terms are at most u each; rounding these and their sums loses 5u², and
//! joining them with the rest of the leading product, which is at most u too, 3u². 2⁻¹⁰¹ is taken for all. Quotients and
//! roots are guessed and then bounded by their residual, which needs no theorem about the guess. What overflows becomes a
//! ball of infinite radius, and what underflows is covered by an absolute 10⁻³⁰⁰.

mod ball;
mod functions;

use super::{Arithmetic, Flags, Interval, Number, Scalar, Truth, Undecided};
use ball::{STEP, TINY};

pub use ball::Ball;

/// Balls around pairs of doubles. Only + − × ÷ √, `exp`, `sin` and `cos` are finer than `f64`; other
/// functions go through enclosures.
/// Nothing is inlined: it runs for few rays, and generated code should stay small.
#[derive(Clone, Copy, Debug)]
pub struct Fine;

/// A function that is no finer than `f64`.
fn coarse(a: Ball, f: impl Fn(Interval) -> Interval) -> Ball {
    Ball::from_interval(&f(a.interval()))
}

fn coarse_partial(
    a: Ball,
    f: impl Fn(Interval) -> (Interval, Flags<Scalar>),
) -> (Ball, Flags<Scalar>) {
    let (value, flags) = f(a.interval());
    (Ball::from_interval(&value), flags)
}

/// A value, or flags that say that there may be none.
fn partial(value: Option<Ball>) -> (Ball, Flags<Scalar>) {
    match value {
        Some(value) => (value, Scalar.clear()),
        None => (Ball::ANY, Scalar.undefined_if(true)),
    }
}

macro_rules! through_enclosures {
    (total: $($total:ident)*; partial: $($partial:ident)*) => {
        $(fn $total(self, a: Ball) -> Ball {
            coarse(a, |a| Scalar.$total(a))
        })*
        $(fn $partial(self, a: Ball) -> (Ball, Flags<Scalar>) {
            coarse_partial(a, |a| Scalar.$partial(a))
        })*
    };
}

impl Arithmetic for Fine {
    type Packet = Scalar;
    type Value = Ball;

    fn constant(self, c: &Interval) -> Ball {
        Ball::from_interval(c)
    }
    fn literal(self, n: &Number) -> Ball {
        let [hi, lo] = n.leading;
        Ball::new(hi, lo, hi.abs() * STEP + TINY)
    }
    fn stored(self, _: &Interval, fine: &Ball) -> Ball {
        *fine
    }
    fn clear(self) -> Flags<Scalar> {
        Scalar.clear()
    }
    fn join(self, a: Flags<Scalar>, b: Flags<Scalar>) -> Flags<Scalar> {
        Arithmetic::join(Scalar, a, b)
    }
    fn join_derivative(self, a: Flags<Scalar>, d: Flags<Scalar>) -> Flags<Scalar> {
        Scalar.join_derivative(a, d)
    }
    fn undefined_if(self, undefined: bool) -> Flags<Scalar> {
        Scalar.undefined_if(undefined)
    }
    fn neg(self, a: Ball) -> Ball {
        a.negate()
    }
    fn add(self, a: Ball, b: Ball) -> Ball {
        a.add(b)
    }
    fn sub(self, a: Ball, b: Ball) -> Ball {
        a.subtract(b)
    }
    fn mul(self, a: Ball, b: Ball) -> Ball {
        a.multiply(b)
    }
    fn mul_pos(self, a: Ball, b: Ball) -> Ball {
        a.multiply(b)
    }
    fn mul_pos_pos(self, a: Ball, b: Ball) -> Ball {
        a.multiply(b)
    }
    fn sqr(self, a: Ball) -> Ball {
        a.multiply(a)
    }
    fn powi(self, a: Ball, n: u32) -> Ball {
        a.power(n)
    }
    fn nonneg(self, a: Ball) -> Ball {
        a
    }
    fn abs(self, a: Ball) -> Ball {
        // |a| moves no further than a.
        if a.hi < 0.0 { a.negate() } else { a }
    }
    fn abs_slope(self, a: Ball) -> (Ball, Flags<Scalar>) {
        coarse_partial(a, |a| Scalar.abs_slope(a))
    }
    fn min(self, a: Ball, b: Ball) -> Ball {
        // The minimum moves no further than the operand that moves further; the centres' order may be open.
        let distance = b.subtract(a);
        let least = if distance.hi < 0.0 { b } else { a };
        let open = if distance.least() > 0.0 {
            0.0
        } else {
            distance.most()
        };
        Ball::new(least.hi, least.lo, a.radius.max(b.radius) + open)
    }
    fn max(self, a: Ball, b: Ball) -> Ball {
        self.min(a.negate(), b.negate()).negate()
    }
    fn less(self, a: Ball, b: Ball) -> Truth<Scalar> {
        let zero = Interval { lo: 0.0, hi: 0.0 };
        Scalar.less(zero, b.subtract(a).interval())
    }
    fn less_or_equal(self, a: Ball, b: Ball) -> Truth<Scalar> {
        let zero = Interval { lo: 0.0, hi: 0.0 };
        Scalar.less_or_equal(zero, b.subtract(a).interval())
    }
    fn both(self, a: Truth<Scalar>, b: Truth<Scalar>) -> Truth<Scalar> {
        Arithmetic::both(Scalar, a, b)
    }
    fn either(self, a: Truth<Scalar>, b: Truth<Scalar>) -> Truth<Scalar> {
        Arithmetic::either(Scalar, a, b)
    }
    fn choose(self, c: Truth<Scalar>, yes: Ball, no: Ball) -> Ball {
        if c.yes {
            yes
        } else if c.no {
            no
        } else {
            let distance = yes.subtract(no).most();
            Ball::new(yes.hi, yes.lo, yes.radius + no.radius + distance)
        }
    }
    fn branch(
        self,
        c: Truth<Scalar>,
        yes: Flags<Scalar>,
        no: Flags<Scalar>,
        undecided: Undecided,
    ) -> Flags<Scalar> {
        Arithmetic::branch(Scalar, c, yes, no, undecided)
    }
    fn div(self, a: Ball, b: Ball) -> (Ball, Flags<Scalar>) {
        partial(a.divide(b))
    }
    fn recip(self, a: Ball) -> (Ball, Flags<Scalar>) {
        partial(Ball::exact(1.0).divide(a))
    }
    fn sqrt(self, a: Ball) -> (Ball, Flags<Scalar>) {
        partial(a.sqrt())
    }
    fn exp(self, a: Ball) -> Ball {
        a.exp()
    }
    fn sin(self, a: Ball) -> Ball {
        let [sine, _] = a.sin_cos();
        sine
    }
    fn cos(self, a: Ball) -> Ball {
        let [_, cosine] = a.sin_cos();
        cosine
    }
    fn sin_cos(self, a: Ball) -> [Ball; 2] {
        a.sin_cos()
    }
    fn pow(self, a: Ball, b: Ball) -> (Ball, Flags<Scalar>) {
        coarse_partial(a, |a| Scalar.pow(a, b.interval()))
    }
    fn atan2(self, a: Ball, b: Ball) -> (Ball, Flags<Scalar>) {
        coarse_partial(a, |a| Scalar.atan2(a, b.interval()))
    }
    fn hypot(self, a: Ball, b: Ball) -> Ball {
        let square = a.multiply(a).add(b.multiply(b));
        let value = square.sqrt();
        value.unwrap_or_else(|| coarse(a, |a| Scalar.hypot(a, b.interval())))
    }
    through_enclosures! {
        total: cbrt exp2 exp_m1 atan sinh cosh tanh asinh;
        partial: ln ln_1p log2 log10 tan asin acos acosh atanh
    }
}
