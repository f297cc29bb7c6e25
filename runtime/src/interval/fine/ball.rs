//! Pairs of doubles with a radius, and their arithmetic.

use crate::interval::{Interval, Lanes, Scalar};

/// All numbers within `radius` of `hi + lo`; an infinite radius says nothing.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub(super) hi: f64,
    pub(super) lo: f64,
    pub(super) radius: f64,
}

/// The relative error of an operation on pairs.
pub(super) const STEP: f64 = f64::from_bits((1023 - 101) << 52);
/// What underflow may lose.
pub(super) const TINY: f64 = 1e-300;
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
    pub(super) const ANY: Ball = Ball {
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

    pub(super) fn new(hi: f64, lo: f64, radius: f64) -> Ball {
        let radius = radius * UP;
        if hi.is_finite() && lo.is_finite() && radius.is_finite() {
            Ball { hi, lo, radius }
        } else {
            Ball::ANY
        }
    }

    pub(super) fn exact(x: f64) -> Ball {
        Ball {
            hi: x,
            lo: 0.0,
            radius: 0.0,
        }
    }

    pub(super) fn from_interval(a: &Interval) -> Ball {
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
    pub(super) fn size(self) -> f64 {
        (self.hi.abs() + self.lo.abs()) * UP
    }

    /// An upper bound of the magnitude of all its numbers.
    pub(super) fn most(self) -> f64 {
        (self.size() + self.radius) * UP
    }

    /// A lower bound of the magnitude of all its numbers; 0 or less if it may hold 0.
    pub(super) fn least(self) -> f64 {
        let slack = self.radius + self.lo.abs();
        self.hi.abs() * (1.0 - 4.0 * f64::EPSILON) - slack * UP
    }

    pub(super) fn negate(self) -> Ball {
        Ball {
            hi: -self.hi,
            lo: -self.lo,
            radius: self.radius,
        }
    }

    #[inline(never)]
    pub(super) fn add(self, other: Ball) -> Ball {
        let (sh, sl) = two_sum(self.hi, other.hi);
        let (th, tl) = two_sum(self.lo, other.lo);
        let (vh, vl) = fast_two_sum(sh, sl + th);
        let (hi, lo) = fast_two_sum(vh, tl + vl);
        let radius = self.radius + other.radius + (hi.abs() + lo.abs()) * STEP;
        Ball::new(hi, lo, radius)
    }

    pub(super) fn subtract(self, other: Ball) -> Ball {
        self.add(other.negate())
    }

    #[inline(never)]
    pub(super) fn multiply(self, other: Ball) -> Ball {
        let high = self.hi * other.hi;
        let error = self.hi.mul_add(other.hi, -high);
        // One fused operation is enough: on many processors it is a call.
        let low = self.lo * other.hi + (self.hi * other.lo + self.lo * other.lo);
        let (hi, lo) = fast_two_sum(high, error + low);
        let spread = self.size() * other.radius + self.radius * other.most();
        Ball::new(hi, lo, spread + (hi.abs() + lo.abs()) * STEP + TINY)
    }

    /// With q near x/y: |x/y − q| ≤ |x − q·y|/|y|.
    #[inline(never)]
    pub(super) fn divide(self, other: Ball) -> Option<Ball> {
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

    /// Divided by a whole number from 1 to 2²⁰. The rest of the first quotient is a double; what is left of it and `lo`
    /// together is at most 2u of `hi`, so that rounding their sum and its quotient loses less than 2⁻¹⁰³ of the result.
    #[inline(never)]
    pub(super) fn over(self, n: f64) -> Ball {
        let first = self.hi / n;
        let rest = (-first).mul_add(n, self.hi);
        let (hi, lo) = fast_two_sum(first, (rest + self.lo) / n);
        Ball::new(
            hi,
            lo,
            self.radius / n + (hi.abs() + lo.abs()) * STEP + TINY,
        )
    }

    /// With s near √x: |√x − s| = |x − s²|/(√x + s) ≤ |x − s²|/s.
    #[inline(never)]
    pub(super) fn sqrt(self) -> Option<Ball> {
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

    pub(super) fn power(self, n: u32) -> Ball {
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
}
