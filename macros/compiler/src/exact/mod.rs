//! Exact numbers: the values of literals, and of what is computed from them while a formula is compiled.

mod natural;

pub use natural::Natural;

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A rational number in lowest terms. 0 is not negative, and has the denominator 1.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Rational {
    negative: bool,
    numerator: Natural,
    denominator: Natural,
}

impl Rational {
    /// ±numerator/denominator, if the denominator is not 0.
    pub fn new(negative: bool, numerator: Natural, denominator: Natural) -> Option<Rational> {
        if denominator.is_zero() {
            return None;
        }
        let common = numerator.gcd(&denominator);
        let (numerator, denominator) = if common.is_one() {
            (numerator, denominator)
        } else {
            (numerator.divided(&common).0, denominator.divided(&common).0)
        };
        Some(Rational {
            negative: negative && !numerator.is_zero(),
            numerator,
            denominator,
        })
    }

    /// A natural number.
    pub fn whole(n: Natural) -> Rational {
        Rational {
            negative: false,
            numerator: n,
            denominator: Natural::from(1),
        }
    }

    /// The number that a double is, if it is finite.
    pub fn from_f64(x: f64) -> Option<Rational> {
        if !x.is_finite() {
            return None;
        }
        let bits = x.abs().to_bits();
        let (exponent, fraction) = (bits >> 52, bits % (1 << 52));
        // Subnormal numbers have the exponent of the smallest normal ones, without the leading bit.
        let mantissa = Natural::from(fraction | u64::from(exponent > 0) << 52);
        let exponent = exponent.max(1);
        let one = Natural::from(1);
        match exponent.checked_sub(1075) {
            Some(up) => Rational::new(x < 0.0, mantissa.shifted(up), one),
            None => Rational::new(x < 0.0, mantissa, one.shifted(1075 - exponent)),
        }
    }

    /// Without its sign.
    pub fn numerator(&self) -> &Natural {
        &self.numerator
    }

    /// Positive.
    pub fn denominator(&self) -> &Natural {
        &self.denominator
    }

    /// Is it 0?
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Is it 1?
    pub fn is_one(&self) -> bool {
        !self.negative && self.numerator.is_one() && self.denominator.is_one()
    }

    /// Is it below 0?
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// Is it above 0?
    pub fn is_positive(&self) -> bool {
        !self.negative && !self.is_zero()
    }

    /// Is it whole?
    pub fn is_integer(&self) -> bool {
        self.denominator.is_one()
    }

    /// The whole number that it is, if that fits.
    pub fn to_i64(&self) -> Option<i64> {
        let size = i64::try_from(self.numerator.to_u64()?).ok()?;
        let size = if self.negative { -size } else { size };
        self.is_integer().then_some(size)
    }

    /// The number of bits of the longer of numerator and denominator.
    pub fn bits(&self) -> u64 {
        self.numerator.bits().max(self.denominator.bits())
    }

    /// |self|
    pub fn abs(&self) -> Rational {
        Rational {
            negative: false,
            ..self.clone()
        }
    }

    /// 1/self
    pub fn reciprocal(&self) -> Option<Rational> {
        (!self.is_zero()).then(|| Rational {
            negative: self.negative,
            numerator: self.denominator.clone(),
            denominator: self.numerator.clone(),
        })
    }

    /// self/other
    pub fn over(&self, other: &Rational) -> Option<Rational> {
        Some(self * &other.reciprocal()?)
    }

    /// selfⁿ; nothing for 0 to a negative power.
    pub fn power(&self, n: i32) -> Option<Rational> {
        let base = if n < 0 {
            self.reciprocal()?
        } else {
            self.clone()
        };
        let size = n.unsigned_abs();
        Some(Rational {
            negative: base.negative && size % 2 == 1,
            numerator: base.numerator.power(size),
            denominator: base.denominator.power(size),
        })
    }

    /// The root, if it is rational.
    pub fn exact_root(&self) -> Option<Rational> {
        let (n, d) = (self.numerator.exact_root()?, self.denominator.exact_root()?);
        (!self.negative).then(|| Rational::new(false, n, d))?
    }
}

impl From<i64> for Rational {
    fn from(n: i64) -> Rational {
        Rational {
            negative: n < 0,
            ..Rational::whole(Natural::from(n.unsigned_abs()))
        }
    }
}

/// Over the product of the denominators: the sign is that of the greater part.
impl Add for &Rational {
    type Output = Rational;
    fn add(self, other: &Rational) -> Rational {
        let left = self.numerator.times(&other.denominator);
        let right = other.numerator.times(&self.denominator);
        let (negative, sum) = if self.negative == other.negative {
            (self.negative, left.plus(&right))
        } else if left < right {
            (other.negative, right.minus(&left))
        } else {
            (self.negative, left.minus(&right))
        };
        let denominator = self.denominator.times(&other.denominator);
        // The denominator is not 0.
        Rational::new(negative, sum, denominator).unwrap_or_else(|| Rational::from(0))
    }
}

impl Mul for &Rational {
    type Output = Rational;
    fn mul(self, other: &Rational) -> Rational {
        let product = Rational::new(
            self.negative != other.negative,
            self.numerator.times(&other.numerator),
            self.denominator.times(&other.denominator),
        );
        // The denominator is not 0.
        product.unwrap_or_else(|| Rational::from(0))
    }
}

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational {
            negative: !self.negative && !self.is_zero(),
            ..self
        }
    }
}

impl Sub for &Rational {
    type Output = Rational;
    fn sub(self, other: &Rational) -> Rational {
        self + &-other.clone()
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Rational) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Rational) -> Ordering {
        let left = self.numerator.times(&other.denominator);
        let right = other.numerator.times(&self.denominator);
        match (self.negative, other.negative) {
            (false, false) => left.cmp(&right),
            (true, true) => right.cmp(&left),
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
        }
    }
}

/// `3`, `-1/10`
impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        write!(f, "{sign}{}", self.numerator)?;
        if self.is_integer() {
            return Ok(());
        }
        write!(f, "/{}", self.denominator)
    }
}
