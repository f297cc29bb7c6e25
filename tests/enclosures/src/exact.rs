//! Exact numbers: m·2ᵉ with whole m. Every finite double is one, and sums and products of them are.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// m·2ᵉ
#[derive(Clone, Debug)]
pub struct Exact {
    m: BigInt,
    e: i64,
}

impl Exact {
    /// A finite double, exactly.
    ///
    /// # Panics
    /// On NaN and infinities.
    pub fn from(x: f64) -> Exact {
        assert!(x.is_finite(), "{x} is not a number with an exact value");
        let bits = x.to_bits();
        let biased = (bits >> 52 & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let m = if biased == 0 {
            fraction
        } else {
            fraction | 1 << 52
        };
        let m = BigInt::from(if x.is_sign_negative() { -m } else { m });
        Exact {
            m,
            e: biased.max(1) - 1075,
        }
    }

    /// The sum.
    pub fn add(&self, other: &Exact) -> Exact {
        let e = self.e.min(other.e);
        let at = |x: &Exact| &x.m << (x.e - e) as usize;
        Exact {
            m: at(self) + at(other),
            e,
        }
    }

    /// The negative.
    pub fn neg(&self) -> Exact {
        Exact {
            m: -&self.m,
            e: self.e,
        }
    }

    /// The product.
    pub fn mul(&self, other: &Exact) -> Exact {
        Exact {
            m: &self.m * &other.m,
            e: self.e + other.e,
        }
    }

    /// The n-th power.
    pub fn powi(&self, n: u32) -> Exact {
        Exact {
            m: self.m.pow(n),
            e: self.e * n as i64,
        }
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i32 {
        if self.m.is_zero() {
            0
        } else if self.m.is_negative() {
            -1
        } else {
            1
        }
    }

    /// The order of two numbers.
    pub fn order(&self, other: &Exact) -> Ordering {
        self.add(&other.neg()).sign().cmp(&0)
    }

    /// Is lo ≤ self ≤ hi? Bounds may be infinite.
    pub fn is_in(&self, lo: f64, hi: f64) -> bool {
        let above = lo == f64::NEG_INFINITY
            || (lo.is_finite() && Exact::from(lo).order(self) != Ordering::Greater);
        let below = hi == f64::INFINITY
            || (hi.is_finite() && self.order(&Exact::from(hi)) != Ordering::Greater);
        above && below
    }
}
