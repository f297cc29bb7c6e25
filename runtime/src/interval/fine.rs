//! Twice the precision, one number at a time: for the few rays whose roots `f64` cannot pin down.
//!
//! A [`Ball`] is the unevaluated sum of two doubles and a radius. Sums and products of such pairs have relative errors
//! below 3u² and 5u², u = 2⁻⁵³ (Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic, 2017, algorithms 6 and 12); 2⁻¹⁰¹ is taken for all. Quotients and roots are guessed and then
//! bounded by their residual, which needs no theorem about the guess. What overflows becomes a ball of infinite radius,
//! and what underflows is covered by an absolute 10⁻³⁰⁰.

use super::{Arithmetic, Flags, Interval, Lanes, Number, Scalar, Truth, Undecided};

/// Balls around pairs of doubles. Only + − × ÷ √ and `exp` are finer than `f64`; other functions go through enclosures.
/// Nothing is inlined: it runs for few rays, and generated code should stay small.
#[derive(Clone, Copy, Debug)]
pub struct Fine;

/// All numbers within `radius` of `hi + lo`; an infinite radius says nothing.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    hi: f64,
    lo: f64,
    radius: f64,
}

/// The relative error of an operation on pairs.
const STEP: f64 = f64::from_bits((1023 - 101) << 52);
/// What underflow may lose.
const TINY: f64 = 1e-300;
/// Covers the roundings of a radius: at most ten operations on numbers ≥ 0.
const UP: f64 = 1.0 + f64::EPSILON * 16.0;

fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// For |a| ≥ |b|.
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

impl Ball {
    const ANY: Ball = Ball {
        hi: 0.0,
        lo: 0.0,
        radius: f64::INFINITY,
    };

    /// The sum of two doubles, exactly.
    pub fn sum(a: f64, b: f64) -> Ball {
        let (hi, lo) = two_sum(a, b);
        Ball::new(hi, lo, 0.0)
    }

    /// All of base + t.
    pub(crate) fn span(base: f64, t: &Interval) -> Ball {
        let middle = t.lo + 0.5 * (t.hi - t.lo);
        let radius = Scalar.max_f(Scalar.sub_ru(middle, t.lo), Scalar.sub_ru(t.hi, middle));
        let (hi, lo) = two_sum(base, middle);
        Ball::new(hi, lo, radius)
    }

    /// `origin + self·direction`: a coordinate of a point on a ray.
    pub fn along(self, origin: f64, direction: f64) -> Ball {
        self.multiply(Ball::exact(direction))
            .add(Ball::exact(origin))
    }

    /// The scalar product of a gradient with a direction.
    pub(crate) fn dot(gradient: &[Ball; 3], direction: &[f64; 3]) -> Ball {
        let [x, y, z] = [0, 1, 2].map(|k| gradient[k].multiply(Ball::exact(direction[k])));
        x.add(y).add(z)
    }

    fn new(hi: f64, lo: f64, radius: f64) -> Ball {
        let radius = radius * UP;
        if hi.is_finite() && lo.is_finite() && radius.is_finite() {
            Ball { hi, lo, radius }
        } else {
            Ball::ANY
        }
    }

    fn exact(x: f64) -> Ball {
        Ball {
            hi: x,
            lo: 0.0,
            radius: 0.0,
        }
    }

    fn from_interval(a: &Interval) -> Ball {
        if a.lo == a.hi {
            return Ball::exact(a.lo);
        }
        let (hi, lo) = two_sum(0.5 * a.lo, 0.5 * a.hi);
        Ball::new(hi, lo, 0.5 * (a.hi - a.lo) + TINY)
    }

    /// The two doubles and the radius.
    pub fn parts(self) -> [f64; 3] {
        [self.hi, self.lo, self.radius]
    }

    /// The smallest `f64` interval around the ball, nearly.
    pub fn interval(self) -> Interval {
        if self.radius.is_infinite() {
            return Interval {
                lo: f64::NEG_INFINITY,
                hi: f64::INFINITY,
            };
        }
        let p = Scalar;
        Interval {
            lo: p.add_rd(self.hi, p.add_rd(self.lo, -self.radius)),
            hi: p.add_ru(self.hi, p.add_ru(self.lo, self.radius)),
        }
    }

    /// An upper bound of the magnitude of the centre.
    fn size(self) -> f64 {
        (self.hi.abs() + self.lo.abs()) * UP
    }

    /// An upper bound of the magnitude of all its numbers.
    fn most(self) -> f64 {
        (self.size() + self.radius) * UP
    }

    /// A lower bound of the magnitude of all its numbers; 0 or less if it may hold 0.
    fn least(self) -> f64 {
        let slack = self.radius + self.lo.abs();
        self.hi.abs() * (1.0 - 4.0 * f64::EPSILON) - slack * UP
    }

    fn negate(self) -> Ball {
        Ball {
            hi: -self.hi,
            lo: -self.lo,
            radius: self.radius,
        }
    }

    #[inline(never)]
    fn add(self, other: Ball) -> Ball {
        let (sh, sl) = two_sum(self.hi, other.hi);
        let (th, tl) = two_sum(self.lo, other.lo);
        let (vh, vl) = fast_two_sum(sh, sl + th);
        let (hi, lo) = fast_two_sum(vh, tl + vl);
        let radius = self.radius + other.radius + (hi.abs() + lo.abs()) * STEP;
        Ball::new(hi, lo, radius)
    }

    fn subtract(self, other: Ball) -> Ball {
        self.add(other.negate())
    }

    #[inline(never)]
    fn multiply(self, other: Ball) -> Ball {
        let high = self.hi * other.hi;
        let error = self.hi.mul_add(other.hi, -high);
        let low = self
            .lo
            .mul_add(other.hi, self.hi.mul_add(other.lo, self.lo * other.lo));
        let (hi, lo) = fast_two_sum(high, error + low);
        let spread = self.size() * other.radius + self.radius * other.most();
        Ball::new(hi, lo, spread + (hi.abs() + lo.abs()) * STEP + TINY)
    }

    /// With q near x/y: |x/y − q| ≤ |x − q·y|/|y|.
    #[inline(never)]
    fn divide(self, other: Ball) -> Option<Ball> {
        let least = other.least();
        if least.is_nan() || least <= 0.0 {
            return None;
        }
        let first = self.hi / other.hi;
        let rest = self.subtract(other.multiply(Ball::exact(first)));
        let (hi, lo) = fast_two_sum(first, rest.hi / other.hi);
        // The centres' residual carries the radii of both operands.
        let residual = self.subtract(other.multiply(Ball {
            hi,
            lo,
            radius: 0.0,
        }));
        Some(Ball::new(hi, lo, residual.most() / least * UP + TINY))
    }

    /// With s near √x: |√x − s| = |x − s²|/(√x + s) ≤ |x − s²|/s.
    #[inline(never)]
    fn sqrt(self) -> Option<Ball> {
        if self.hi == 0.0 && self.lo == 0.0 && self.radius == 0.0 {
            return Some(self);
        }
        if self.hi <= 0.0 || self.least() < 0.0 || self.radius.is_infinite() {
            return None;
        }
        let first = self.hi.sqrt();
        let rest = self.subtract(Ball::exact(first).multiply(Ball::exact(first)));
        let (hi, lo) = fast_two_sum(first, rest.hi / (2.0 * first));
        let s = Ball {
            hi,
            lo,
            radius: 0.0,
        };
        let residual = self.subtract(s.multiply(s));
        Some(Ball::new(hi, lo, residual.most() / s.least() * UP + TINY))
    }

    fn power(self, n: u32) -> Ball {
        let (mut result, mut square, mut n) = (Ball::exact(1.0), self, n);
        while n > 0 {
            if n % 2 == 1 {
                result = result.multiply(square);
            }
            n /= 2;
            if n > 0 {
                square = square.multiply(square);
            }
        }
        result
    }

    /// e^x = 2^k · (e^(r/512))^512 with r = x − k·ln 2, |r| ≤ 0.36. Taylor's polynomial of degree 9 at |s| ≤ 0.36/512
    /// has a remainder below |s|¹⁰/10! · e^|s| < 10⁻³⁸.
    #[inline(never)]
    fn exp(self) -> Ball {
        /// ln 2 = 0.6931471805599453 + 2.3190468138462996·10⁻¹⁷ + less than 6·10⁻³⁴.
        const LN_2: Ball = Ball {
            hi: std::f64::consts::LN_2,
            lo: 2.319_046_813_846_299_6e-17,
            radius: 6e-34,
        };
        let whole = (self.hi / std::f64::consts::LN_2).round();
        let near = self.radius < 1e-3 && whole.abs() < 900.0;
        if !near {
            return Ball::from_interval(&Scalar.exp(self.interval()));
        }
        let r = self.subtract(LN_2.multiply(Ball::exact(whole)));
        let s = Ball {
            hi: r.hi / 512.0,
            lo: r.lo / 512.0,
            radius: r.radius / 512.0,
        };
        let mut sum = Ball::exact(1.0);
        for n in (1..=9).rev() {
            // 1 + s/n · (1 + s/(n + 1) · …)
            let Some(step) = s.divide(Ball::exact(f64::from(n))) else {
                return Ball::ANY;
            };
            sum = Ball::exact(1.0).add(step.multiply(sum));
        }
        sum.radius += 1e-38;
        for _ in 0..9 {
            sum = sum.multiply(sum);
        }
        let scale = 2f64.powi(whole as i32);
        Ball::new(sum.hi * scale, sum.lo * scale, sum.radius * scale + TINY)
    }
}

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
        total: cbrt exp2 exp_m1 sin cos atan sinh cosh tanh asinh;
        partial: ln ln_1p log2 log10 tan asin acos acosh atanh
    }
}
