//! Numbers m·2ᵉ with whole m and e: every `f64` is one, and sums and products of them are exact.

use num_bigint::{BigInt, Sign};
use num_traits::{Signed, ToPrimitive, Zero};

/// m·2ᵉ, exactly.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    /// mantissa·2^exponent
    pub fn new(mantissa: BigInt, exponent: i64) -> Self {
        Dyadic { mantissa, exponent }
    }

    /// A whole number.
    pub fn whole(n: i64) -> Self {
        Dyadic::new(n.into(), 0)
    }

    /// The exact value of a float.
    ///
    /// # Panics
    /// If it is not finite.
    pub fn float(x: f64) -> Self {
        assert!(x.is_finite(), "{x} is no number");
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        // Subnormal numbers share the exponent of the smallest normal ones, and have no hidden bit.
        let (mut m, mut e) = if field == 0 {
            (fraction, -1074)
        } else {
            (fraction | 1 << 52, field - 1075)
        };
        if m == 0 {
            e = 0;
        } else {
            e += i64::from(m.trailing_zeros());
            m >>= m.trailing_zeros();
        }
        Dyadic::new(if x < 0.0 { -m } else { m }.into(), e)
    }

    /// The exponent e.
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The whole number m·2^(e − exponent).
    ///
    /// # Panics
    /// If `exponent` is above the number's own.
    pub fn scaled(&self, exponent: i64) -> BigInt {
        let shift = u64::try_from(self.exponent - exponent).expect("scaling down is not exact");
        &self.mantissa << shift
    }

    /// Its greatest whole number at most, after a multiplication by 2^bits.
    pub fn floor_shifted(&self, bits: i64) -> BigInt {
        let shift = self.exponent + bits;
        // A right shift of a BigInt rounds towards −∞.
        if shift >= 0 {
            &self.mantissa << shift.unsigned_abs()
        } else {
            &self.mantissa >> shift.unsigned_abs()
        }
    }

    /// self + other
    pub fn add(&self, other: &Self) -> Self {
        let e = self.exponent.min(other.exponent);
        Dyadic::new(self.scaled(e) + other.scaled(e), e)
    }

    /// −self
    pub fn neg(&self) -> Self {
        Dyadic::new(-&self.mantissa, self.exponent)
    }

    /// self − other
    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// self·other
    pub fn mul(&self, other: &Self) -> Self {
        Dyadic::new(
            &self.mantissa * &other.mantissa,
            self.exponent + other.exponent,
        )
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i32 {
        sign(&self.mantissa)
    }
}

/// −1, 0 or 1.
pub fn sign(n: &BigInt) -> i32 {
    match n.sign() {
        Sign::Minus => -1,
        Sign::NoSign => 0,
        Sign::Plus => 1,
    }
}

/// A rational number: num/(den·2^shift), den > 0.
#[derive(Clone, Debug)]
pub struct Rational {
    /// The numerator.
    pub num: BigInt,
    /// The denominator without its power of two.
    pub den: BigInt,
    /// Powers of two in the denominator.
    pub shift: u64,
}

impl Rational {
    /// a/b
    ///
    /// # Panics
    /// If b is 0.
    pub fn quotient(a: &Dyadic, b: &Dyadic) -> Self {
        assert!(!b.mantissa.is_zero(), "division by zero");
        let num = &a.mantissa * sign(&b.mantissa);
        let den = b.mantissa.abs();
        let e = a.exponent - b.exponent;
        if e >= 0 {
            Rational {
                num: num << e.unsigned_abs(),
                den,
                shift: 0,
            }
        } else {
            Rational {
                num,
                den,
                shift: e.unsigned_abs(),
            }
        }
    }

    /// A dyadic number.
    pub fn dyadic(x: &Dyadic) -> Self {
        Rational::quotient(x, &Dyadic::whole(1))
    }

    /// The sign of self − other.
    pub fn compare(&self, other: &Rational) -> std::cmp::Ordering {
        let left = (&self.num * &other.den) << other.shift;
        let right = (&other.num * &self.den) << self.shift;
        left.cmp(&right)
    }

    /// self − x
    pub fn minus(&self, x: &Dyadic) -> Self {
        let e = (-(self.shift as i64)).min(x.exponent);
        let shift = e.unsigned_abs();
        Rational {
            num: (&self.num << (shift - self.shift)) - x.scaled(e) * &self.den,
            den: self.den.clone(),
            shift,
        }
    }

    /// A float at or above, within a few ulp.
    pub fn above(&self) -> f64 {
        if self.num.is_zero() {
            return 0.0;
        }
        // About a hundred bits of the quotient, n·2^−k.
        let k = 100 + self.den.bits() as i64 + self.shift as i64 - self.num.bits() as i64;
        let (up, down) = (k.max(0).unsigned_abs(), (-k).max(0).unsigned_abs());
        let n: BigInt = (&self.num << up) / (&self.den << (self.shift + down));
        let float = n.to_f64().expect("a hundred bits are finite");
        // In two steps: 2^−k alone may be out of range. Truncation, conversion and an underflow lose an ulp each.
        let half = k / 2;
        let near = float * (-half as f64).exp2() * ((half - k) as f64).exp2();
        (0..3).fold(near, |x, _| x.next_up())
    }

    /// A float at or below.
    pub fn below(&self) -> f64 {
        let mirrored = Rational {
            num: -&self.num,
            den: self.den.clone(),
            shift: self.shift,
        };
        -mirrored.above()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_exact() {
        for x in [0.0, 1.0, -0.1, 1e300, 5e-324, -3.5e-310, 123456.789] {
            let d = Dyadic::float(x);
            let back = Rational::dyadic(&d);
            assert!(back.below() <= x && x <= back.above(), "{x}");
        }
        let tenth = Rational::quotient(&Dyadic::whole(1), &Dyadic::whole(10));
        let float = Rational::dyadic(&Dyadic::float(0.1));
        // The float 0.1 is above the number 1/10.
        assert_eq!(float.compare(&tenth), std::cmp::Ordering::Greater);
        assert!(tenth.above() >= 0.1 && tenth.above() < 0.1 + 1e-15);
        let rest = tenth.minus(&Dyadic::float(0.1));
        assert_eq!(sign(&rest.num), -1);
        assert!(rest.below() < -5.5e-18 && rest.above() > -5.6e-18);
    }

    #[test]
    fn floor_goes_down() {
        let x = Dyadic::float(-0.75);
        assert_eq!(x.floor_shifted(0), BigInt::from(-1));
        assert_eq!(x.floor_shifted(2), BigInt::from(-3));
    }
}
