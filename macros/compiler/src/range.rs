//! What the compiler knows of a value: bounds that hold wherever it is defined, for all points and all values of the fields.
//!
//! Sums and products of bounds are computed to nearest and moved outward by one double unless they are exact.

use crate::exact::Rational;
use crate::functions::Function;

/// The numbers from `lo` to `hi`, which may be infinite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Range {
    /// No value is less.
    pub lo: f64,
    /// No value is greater.
    pub hi: f64,
}

/// A little more than π.
const PI: f64 = std::f64::consts::PI.next_up();

impl Range {
    /// Nothing is known.
    pub const LINE: Range = Range::new(f64::NEG_INFINITY, f64::INFINITY);
    /// Not negative.
    pub const NONNEGATIVE: Range = Range::new(0.0, f64::INFINITY);

    /// From `lo` to `hi`.
    pub const fn new(lo: f64, hi: f64) -> Range {
        Range { lo, hi }
    }

    /// The number.
    pub fn of(r: &Rational) -> Range {
        let (lo, hi) = crate::rational::bounds(r);
        Range { lo, hi }
    }

    /// Are all values ≥ 0?
    pub fn is_nonnegative(self) -> bool {
        self.lo >= 0.0
    }
    /// Are all values ≤ 0?
    pub fn is_nonpositive(self) -> bool {
        self.hi <= 0.0
    }
    /// Are all values > 0?
    pub fn is_positive(self) -> bool {
        self.lo > 0.0
    }
    /// Is no value 0?
    pub fn is_nonzero(self) -> bool {
        self.lo > 0.0 || self.hi < 0.0
    }
    /// Do all values lie strictly between?
    pub fn is_inside(self, lo: f64, hi: f64) -> bool {
        lo < self.lo && self.hi < hi
    }

    /// −a
    pub fn negated(self) -> Range {
        Range::new(-self.hi, -self.lo)
    }

    /// a + b
    pub fn plus(self, b: Range) -> Range {
        Range::new(
            sum(self.lo, b.lo, f64::next_down),
            sum(self.hi, b.hi, f64::next_up),
        )
    }

    /// a·b
    pub fn times(self, b: Range) -> Range {
        let pairs = [
            (self.lo, b.lo),
            (self.lo, b.hi),
            (self.hi, b.lo),
            (self.hi, b.hi),
        ];
        let least = pairs.map(|(x, y)| product(x, y, f64::next_down));
        let most = pairs.map(|(x, y)| product(x, y, f64::next_up));
        Range::new(
            least.into_iter().fold(f64::INFINITY, f64::min),
            most.into_iter().fold(f64::NEG_INFINITY, f64::max),
        )
    }

    /// 1/a
    pub fn inverse(self) -> Range {
        if !self.is_nonzero() {
            // On one side of 0 the sign is known all the same.
            return match (self.is_nonnegative(), self.is_nonpositive()) {
                (true, _) => Range::NONNEGATIVE,
                (_, true) => Range::NONNEGATIVE.negated(),
                _ => Range::LINE,
            };
        }
        // A quotient that is infinite or 0 by rounding moves back to the last double.
        let [lo, hi] = [1.0 / self.hi, 1.0 / self.lo];
        Range::new(lo.next_down(), hi.next_up()).sided(self)
    }

    /// Without what has the other sign than `of`, which has one.
    fn sided(self, of: Range) -> Range {
        if of.is_nonnegative() {
            Range::new(self.lo.max(0.0), self.hi)
        } else {
            Range::new(self.lo, self.hi.min(0.0))
        }
    }

    /// |a|
    pub fn magnitude(self) -> Range {
        let least = self.lo.max(-self.hi).max(0.0);
        Range::new(least, self.hi.max(-self.lo))
    }

    /// aⁿ
    pub fn power(self, n: u32) -> Range {
        let base = if n.is_multiple_of(2) {
            self.magnitude()
        } else {
            self
        };
        // A high power is hardly ever asked for more than its sign.
        if n > 64 {
            return Range::new(
                if base.is_nonnegative() {
                    0.0
                } else {
                    f64::NEG_INFINITY
                },
                if base.is_nonpositive() {
                    0.0
                } else {
                    f64::INFINITY
                },
            );
        }
        let point = |x: f64| {
            let x = Range::new(x, x);
            (1..n).fold(x, |power, _| power.times(x))
        };
        match n {
            0 => Range::new(1.0, 1.0),
            _ => Range::new(point(base.lo).lo, point(base.hi).hi),
        }
    }

    /// The smallest range that holds both.
    pub fn hull(self, b: Range) -> Range {
        Range::new(self.lo.min(b.lo), self.hi.max(b.hi))
    }

    /// min(a, b)
    pub fn least(self, b: Range) -> Range {
        Range::new(self.lo.min(b.lo), self.hi.min(b.hi))
    }

    /// max(a, b)
    pub fn most(self, b: Range) -> Range {
        Range::new(self.lo.max(b.lo), self.hi.max(b.hi))
    }

    /// f(a) for a function of one argument.
    pub fn mapped(self, f: Function) -> Range {
        let signed = |most: f64| {
            Range::new(
                if self.is_nonnegative() { 0.0 } else { -most },
                if self.is_nonpositive() { 0.0 } else { most },
            )
        };
        match f {
            Function::Abs => self.magnitude(),
            Function::Sin | Function::Cos => Range::new(-1.0, 1.0),
            Function::Tanh => signed(1.0),
            Function::Atan | Function::Asin => signed(PI / 2.0),
            Function::Acos => Range::new(0.0, PI),
            Function::Exp | Function::Exp2 => Range::new(
                if self.is_nonnegative() { 1.0 } else { 0.0 },
                if self.is_nonpositive() {
                    1.0
                } else {
                    f64::INFINITY
                },
            ),
            Function::Cosh => Range::new(1.0, f64::INFINITY),
            // A root is rounded to nearest; of 0 and of ∞ it is itself.
            Function::Sqrt => Range::new(
                self.lo.max(0.0).sqrt().next_down().max(0.0),
                self.hi.max(0.0).sqrt().next_up(),
            ),
            Function::Acosh => Range::NONNEGATIVE,
            Function::ExpM1 => Range::new(
                if self.is_nonnegative() { 0.0 } else { -1.0 },
                if self.is_nonpositive() {
                    0.0
                } else {
                    f64::INFINITY
                },
            ),
            Function::Cbrt
            | Function::Sinh
            | Function::Asinh
            | Function::Atanh
            | Function::Ln1p => signed(f64::INFINITY),
            Function::Ln | Function::Log2 | Function::Log10 => Range::new(
                if self.lo >= 1.0 {
                    0.0
                } else {
                    f64::NEG_INFINITY
                },
                if self.hi <= 1.0 { 0.0 } else { f64::INFINITY },
            ),
            _ => Range::LINE,
        }
    }

    /// f(a, b) for a function of two arguments.
    pub fn mapped_with(self, f: Function, b: Range) -> Range {
        match f {
            Function::Min => self.least(b),
            Function::Max => self.most(b),
            Function::Hypot => {
                let (a, b) = (self.magnitude(), b.magnitude());
                Range::new(a.lo.max(b.lo), f64::INFINITY)
            }
            Function::Atan2 => Range::new(if self.is_nonnegative() { 0.0 } else { -PI }, PI),
            _ => Range::LINE,
        }
    }
}

/// x + y, moved outward unless it is exact.
fn sum(x: f64, y: f64, outward: fn(f64) -> f64) -> f64 {
    let s = x + y;
    let part = s - x;
    let error = (x - (s - part)) + (y - part);
    // An overflow has a NaN for an error.
    if x.is_finite() && y.is_finite() && error != 0.0 {
        outward(s)
    } else {
        s
    }
}

/// x·y, moved outward unless it is exact. 0·∞ is 0: infinite bounds stand for numbers without bound.
fn product(x: f64, y: f64, outward: fn(f64) -> f64) -> f64 {
    if x == 0.0 || y == 0.0 {
        return 0.0;
    }
    let p = x * y;
    // The error of a small product may underflow.
    let exact = p.abs() > 1e-200 && x.mul_add(y, -p) == 0.0;
    if x.is_finite() && y.is_finite() && !exact {
        outward(p)
    } else {
        p
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_move_outward_unless_they_are_exact() {
        let tenth = Range::new(0.1, 0.1);
        let third = Range::new(3.0, 3.0);
        assert_eq!(third.plus(third), Range::new(6.0, 6.0));
        let product = tenth.times(third);
        assert!(product.lo <= 0.1 + 0.2 && 0.1 + 0.2 <= product.hi && product.lo < product.hi);
        assert_eq!(Range::new(-2.0, 3.0).power(2), Range::new(0.0, 9.0));
        assert_eq!(Range::new(-2.0, 3.0).power(3), Range::new(-8.0, 27.0));
        let tiny = Range::new(-1e-300, 1e-300);
        assert!(tiny.times(tiny).lo < 0.0 && tiny.times(tiny).hi > 0.0);
        let above = Range::new(1.0, f64::INFINITY);
        assert!(above.inverse().is_nonnegative() && above.inverse().hi >= 1.0);
        assert_eq!(
            Range::LINE.times(Range::new(0.0, 0.0)),
            Range::new(0.0, 0.0)
        );
        assert_eq!(Range::NONNEGATIVE.inverse(), Range::NONNEGATIVE);
    }
}
