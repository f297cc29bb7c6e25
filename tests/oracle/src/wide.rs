//! Unevaluated sums of two floats: about 106 bits, fast, and without a guarantee below 2⁻¹⁰⁰.

use std::ops::{Add, Mul, Neg, Sub};

/// The number hi + lo, |lo| ≤ ulp(hi)/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    /// The nearest float.
    pub hi: f64,
    /// What it lacks.
    pub lo: f64,
}

/// a + b exactly (Knuth).
fn sum(a: f64, b: f64) -> Wide {
    let hi = a + b;
    let part = hi - a;
    let lo = (a - (hi - part)) + (b - part);
    Wide { hi, lo }
}

/// a·b exactly, where it neither overflows nor underflows.
fn product(a: f64, b: f64) -> Wide {
    let hi = a * b;
    Wide {
        hi,
        lo: a.mul_add(b, -hi),
    }
}

impl Wide {
    /// A float.
    pub fn new(x: f64) -> Self {
        Wide { hi: x, lo: 0.0 }
    }

    /// self·x
    pub fn times(self, x: f64) -> Wide {
        self * Wide::new(x)
    }

    /// eˣ for |x| ≤ 300, relatively within 2⁻⁸⁵: x = k·ln 2 + 64·y with |y| ≤ 0.0055; ten terms of Taylor's series leave
    /// y¹¹/11! < 2⁻¹⁰⁷. The rounding of k·ln 2 (k ≤ 433) and of x itself puts at most 2⁻⁹¹ into the exponent, and six
    /// squarings multiply the series' relative error of 2⁻⁹⁶ by 64.
    pub fn exp(self) -> Wide {
        let ln_2 = Wide {
            hi: core::f64::consts::LN_2,
            lo: 2.319_046_813_846_299_6e-17,
        };
        let k = (self.hi / ln_2.hi).round();
        let y = (self - ln_2.times(k)).times(1.0 / 64.0);
        // Horner: 1 + y(1 + y/2(1 + y/3(…)))
        let mut e = Wide::new(1.0);
        for n in (1..=10).rev() {
            e = Wide::new(1.0) + y * e * INVERSE[n];
        }
        for _ in 0..6 {
            e = e * e;
        }
        e.times(k.exp2())
    }
}

/// Relative to |a| + |b| within 2⁻¹⁰⁰.
impl Add for Wide {
    type Output = Wide;
    fn add(self, other: Wide) -> Wide {
        let s = sum(self.hi, other.hi);
        let t = sum(self.lo, other.lo);
        let first = sum(s.hi, s.lo + t.hi);
        sum(first.hi, first.lo + t.lo)
    }
}

impl Neg for Wide {
    type Output = Wide;
    fn neg(self) -> Wide {
        Wide {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Sub for Wide {
    type Output = Wide;
    fn sub(self, other: Wide) -> Wide {
        self + -other
    }
}

/// Relatively within 2⁻¹⁰⁰.
impl Mul for Wide {
    type Output = Wide;
    fn mul(self, other: Wide) -> Wide {
        let p = product(self.hi, other.hi);
        sum(p.hi, p.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

/// 1/n in both parts; the second is the remainder of the division, divided.
const INVERSE: [Wide; 11] = {
    let mut all = [Wide { hi: 1.0, lo: 0.0 }; 11];
    let mut n = 1;
    while n <= 10 {
        let hi = 1.0 / n as f64;
        // 1 − n·hi is exact: n has four bits, and hi's upper and lower halves give exact products.
        let upper = f64::from_bits(hi.to_bits() & !0xff_ffff);
        let rest = (1.0 - n as f64 * upper) - n as f64 * (hi - upper);
        all[n] = Wide {
            hi,
            lo: rest / n as f64,
        };
        n += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dyadic::Dyadic;
    use crate::exponential::{self, BITS};
    use num_bigint::BigInt;
    use num_traits::Signed;

    fn exact(x: Wide) -> Dyadic {
        Dyadic::float(x.hi).add(&Dyadic::float(x.lo))
    }

    #[test]
    fn exponentials_agree_with_whole_numbers() {
        let mut x = -100.0;
        while x < 20.0 {
            let wide = Wide {
                hi: x,
                lo: x * 1e-17,
            };
            let truth = exponential::exp(&exact(wide));
            let error = (exact(wide.exp()).floor_shifted(BITS) - &truth).abs();
            assert!(error << 85 < truth + (BigInt::from(1) << 180), "{x}");
            x += 0.371;
        }
    }

    #[test]
    fn sums_and_products_keep_a_hundred_bits() {
        let a = Wide::new(1.0) + Wide::new(2f64.powi(-90));
        let square = a * a - Wide::new(1.0);
        assert_eq!(square.hi, 2f64.powi(-89));
    }
}
