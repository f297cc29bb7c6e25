//! Polynomials with rational coefficients, and how many roots they have: Sturm's theorem.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// The exact value of a float.
///
/// # Panics
/// If it is not finite.
pub fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite numbers are rational")
}

/// A polynomial, coefficients in ascending order, the last one not 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Poly(Vec<BigRational>);

impl Poly {
    /// From coefficients in ascending order.
    pub fn new(mut c: Vec<BigRational>) -> Self {
        while c.last().is_some_and(Zero::is_zero) {
            c.pop();
        }
        Poly(c)
    }

    /// c₀ + c₁t with exact floats.
    pub fn line(c0: f64, c1: f64) -> Self {
        Poly::new(vec![rational(c0), rational(c1)])
    }

    /// A constant.
    pub fn number(c: f64) -> Self {
        Poly::new(vec![rational(c)])
    }

    /// Is it 0?
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// self + other
    pub fn add(&self, other: &Poly) -> Poly {
        let n = self.0.len().max(other.0.len());
        let at = |p: &Poly, i: usize| p.0.get(i).cloned().unwrap_or_else(BigRational::zero);
        Poly::new((0..n).map(|i| at(self, i) + at(other, i)).collect())
    }

    /// −self
    pub fn neg(&self) -> Poly {
        Poly(self.0.iter().map(|c| -c).collect())
    }

    /// self − other
    pub fn sub(&self, other: &Poly) -> Poly {
        self.add(&other.neg())
    }

    /// self·other
    pub fn mul(&self, other: &Poly) -> Poly {
        if self.is_zero() || other.is_zero() {
            return Poly(Vec::new());
        }
        let mut c = vec![BigRational::zero(); self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                c[i + j] += a * b;
            }
        }
        Poly::new(c)
    }

    /// The value at t.
    pub fn at(&self, t: &BigRational) -> BigRational {
        self.0
            .iter()
            .rev()
            .fold(BigRational::zero(), |sum, c| sum * t + c)
    }

    fn derivative(&self) -> Poly {
        let c = self.0.iter().enumerate().skip(1);
        Poly::new(
            c.map(|(i, c)| c * BigRational::from(BigInt::from(i)))
                .collect(),
        )
    }

    /// Quotient and remainder of a division.
    fn divide(&self, by: &Poly) -> (Poly, Poly) {
        let mut rest = self.0.clone();
        let lead = by.0.last().expect("a divisor is not 0");
        let mut quotient = vec![BigRational::zero(); (rest.len() + 1).saturating_sub(by.0.len())];
        while rest.len() >= by.0.len() {
            let shift = rest.len() - by.0.len();
            let factor = rest.last().expect("it is not empty") / lead;
            for (i, b) in by.0.iter().enumerate() {
                rest[shift + i] -= &factor * b;
            }
            quotient[shift] = factor;
            while rest.last().is_some_and(Zero::is_zero) {
                rest.pop();
            }
        }
        (Poly::new(quotient), Poly(rest))
    }

    /// Scaled by a positive number, to keep its coefficients short.
    fn scaled(&self) -> Poly {
        match self.0.last().map(Signed::abs) {
            Some(scale) => Poly(self.0.iter().map(|c| c / &scale).collect()),
            None => self.clone(),
        }
    }

    /// f, f', and the negated remainders: the last one is the greatest common divisor of f and f'.
    fn remainders(&self) -> Vec<Poly> {
        let mut list = vec![self.scaled(), self.derivative().scaled()];
        while !list[list.len() - 1].is_zero() {
            let (_, rest) = list[list.len() - 2].divide(&list[list.len() - 1]);
            list.push(rest.neg().scaled());
        }
        list.pop();
        list
    }

    /// Sturm's sequence of a polynomial that is not 0, after its multiple roots were made simple ones: at a multiple root
    /// the whole sequence would be 0.
    pub fn sturm(&self) -> Sturm {
        let list = self.remainders();
        let (simple, _) = self.divide(&list[list.len() - 1]);
        Sturm(simple.remainders())
    }
}

/// Counts distinct real roots.
#[derive(Clone, Debug)]
pub struct Sturm(Vec<Poly>);

impl Sturm {
    /// Changes of sign at t; zeros do not count.
    fn changes(&self, t: &BigRational) -> usize {
        let mut changes = 0;
        let mut last = 0;
        for p in &self.0 {
            let value = p.at(t);
            let sign = i32::from(value.is_positive()) - i32::from(value.is_negative());
            if sign != 0 {
                changes += usize::from(last != 0 && sign != last);
                last = sign;
            }
        }
        changes
    }

    /// Distinct roots in (a, b].
    fn half_open(&self, a: &BigRational, b: &BigRational) -> usize {
        self.changes(a) - self.changes(b)
    }

    fn is_root(&self, t: &BigRational) -> bool {
        self.0[0].at(t).is_zero()
    }

    /// Distinct roots in [a, b]; 0 if a > b.
    pub fn closed(&self, a: &BigRational, b: &BigRational) -> usize {
        if a > b {
            return 0;
        }
        self.half_open(a, b) + usize::from(self.is_root(a))
    }

    /// Distinct roots in [a, b).
    pub fn before(&self, a: &BigRational, b: &BigRational) -> usize {
        if a >= b {
            return 0;
        }
        self.closed(a, b) - usize::from(self.is_root(b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roots(list: &[f64]) -> Poly {
        list.iter()
            .fold(Poly::number(1.0), |p, &r| p.mul(&Poly::line(-r, 1.0)))
    }

    #[test]
    fn sturm_counts_distinct_roots() {
        let p = roots(&[1.0, 2.0, 2.0, 2.0, 3.5]).sturm();
        let r = rational;
        assert_eq!(p.closed(&r(0.0), &r(5.0)), 3);
        assert_eq!(p.closed(&r(1.0), &r(2.0)), 2);
        assert_eq!(p.before(&r(1.0), &r(2.0)), 1);
        assert_eq!(p.closed(&r(2.0), &r(2.0)), 1);
        assert_eq!(p.closed(&r(2.5), &r(3.0)), 0);
    }

    #[test]
    fn no_real_roots() {
        let p = Poly::new(vec![rational(1.0), rational(0.0), rational(1.0)]).sturm();
        assert_eq!(p.closed(&rational(-9.0), &rational(9.0)), 0);
    }
}
