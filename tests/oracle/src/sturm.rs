//! Polynomials in one variable with exact coefficients, and how many real roots they have: Sturm's theorem.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::dyadic::{Dyadic, Rational, sign};

/// c₀ + c₁t + c₂t² + …, each cᵢ a whole number times 2^exponent.
#[derive(Clone, Debug)]
pub struct Poly {
    c: Vec<BigInt>,
    exponent: i64,
}

impl Poly {
    /// a + b·t
    pub fn line(a: f64, b: f64) -> Self {
        let (a, b) = (Dyadic::float(a), Dyadic::float(b));
        let e = a.exponent().min(b.exponent());
        Poly {
            c: vec![a.scaled(e), b.scaled(e)],
            exponent: e,
        }
    }

    /// A number.
    pub fn number(x: &Dyadic) -> Self {
        Poly {
            c: vec![x.scaled(x.exponent())],
            exponent: x.exponent(),
        }
    }

    fn scaled(&self, exponent: i64) -> Vec<BigInt> {
        let shift = (self.exponent - exponent).unsigned_abs();
        self.c.iter().map(|c| c << shift).collect()
    }

    /// self + other
    pub fn add(&self, other: &Poly) -> Poly {
        let exponent = self.exponent.min(other.exponent);
        let (mut long, mut short) = (self.scaled(exponent), other.scaled(exponent));
        if long.len() < short.len() {
            std::mem::swap(&mut long, &mut short);
        }
        for (a, b) in long.iter_mut().zip(short) {
            *a += b;
        }
        Poly { c: long, exponent }
    }

    /// self·n
    pub fn times(&self, n: i64) -> Poly {
        Poly {
            c: self.c.iter().map(|c| c * n).collect(),
            exponent: self.exponent,
        }
    }

    /// self − other
    pub fn sub(&self, other: &Poly) -> Poly {
        self.add(&other.times(-1))
    }

    /// self·other
    pub fn mul(&self, other: &Poly) -> Poly {
        let mut c = vec![BigInt::zero(); self.c.len() + other.c.len() - 1];
        for (i, a) in self.c.iter().enumerate() {
            for (j, b) in other.c.iter().enumerate() {
                c[i + j] += a * b;
            }
        }
        Poly {
            c,
            exponent: self.exponent + other.exponent,
        }
    }

    /// self²
    pub fn square(&self) -> Poly {
        self.mul(self)
    }

    /// Sturm's sequence; nothing for the polynomial 0.
    pub fn sturm(&self) -> Option<Sturm> {
        let c = trimmed(self.c.clone());
        if c.is_empty() {
            return None;
        }
        let chain = chain(c.clone());
        // The last one is the greatest common divisor of f and f'. A factor that occurs twice is divided out: f/gcd has
        // the same roots, each once, and Sturm's theorem then holds at roots, too.
        let gcd = chain.last().expect("it begins with f");
        let simple = if gcd.len() > 1 {
            self::chain(quotient(c.clone(), gcd))
        } else {
            chain
        };
        Some(Sturm {
            f: c,
            chain: simple,
        })
    }
}

/// Without leading zeros.
fn trimmed(mut c: Vec<BigInt>) -> Vec<BigInt> {
    while c.last().is_some_and(Zero::is_zero) {
        c.pop();
    }
    c
}

/// f, f', and each time the negative remainder of the last two, times a positive number, until it is 0.
fn chain(f: Vec<BigInt>) -> Vec<Vec<BigInt>> {
    let slope = f.iter().enumerate().skip(1).map(|(i, c)| c * i).collect();
    let mut chain = vec![f, trimmed(slope)];
    while !chain[chain.len() - 1].is_empty() {
        let n = chain.len();
        let rest = remainder(chain[n - 2].clone(), &chain[n - 1]);
        chain.push(rest.into_iter().map(|c| -c).collect());
    }
    chain.pop();
    chain
}

/// The remainder of a/b times a positive number: |lead of b| for each step of the division.
fn remainder(mut a: Vec<BigInt>, b: &[BigInt]) -> Vec<BigInt> {
    while a.len() >= b.len() {
        eliminate(&mut a, b);
        a = trimmed(a);
    }
    a
}

/// a ← |lead of b|·a − (± lead of a)·b·t^…: its leading coefficient is 0 then, and is taken away. Returns the factor of b.
fn eliminate(a: &mut Vec<BigInt>, b: &[BigInt]) -> BigInt {
    let lead = b.last().expect("a divisor is not 0");
    let size = lead.abs();
    let factor = a.last().expect("it is longer than the divisor") * sign(lead);
    let shift = a.len() - b.len();
    for c in a.iter_mut() {
        *c *= &size;
    }
    for (i, b) in b.iter().enumerate() {
        a[shift + i] -= &factor * b;
    }
    a.pop();
    factor
}

/// a/b times a positive number, where b divides a.
fn quotient(mut a: Vec<BigInt>, b: &[BigInt]) -> Vec<BigInt> {
    let size = b.last().expect("a divisor is not 0").abs();
    let mut all = Vec::new();
    while a.len() >= b.len() {
        let factor = eliminate(&mut a, b);
        for c in &mut all {
            *c *= &size;
        }
        // Scaled with the remainder; the new factor already is.
        all.push(factor);
    }
    all.reverse();
    all
}

/// Counts distinct real roots of a polynomial.
#[derive(Clone, Debug)]
pub struct Sturm {
    f: Vec<BigInt>,
    chain: Vec<Vec<BigInt>>,
}

/// The sign of a polynomial at num/den, with the powers of the denominator: Σ cᵢ·numⁱ·denⁿ⁻ⁱ.
fn sign_at(c: &[BigInt], num: &BigInt, powers: &[BigInt]) -> i32 {
    let mut sum = BigInt::zero();
    for (c, power) in c.iter().rev().zip(powers) {
        sum = sum * num + c * power;
    }
    sign(&sum)
}

fn powers(t: &Rational, degree: usize) -> Vec<BigInt> {
    let den = &t.den << t.shift;
    let mut all = vec![BigInt::from(1)];
    for i in 0..degree {
        all.push(&all[i] * &den);
    }
    all
}

impl Sturm {
    /// The sign of f at t.
    pub fn sign(&self, t: &Rational) -> i32 {
        sign_at(&self.f, &t.num, &powers(t, self.f.len()))
    }

    /// Changes of sign along the chain at t; zeros do not count.
    fn changes(&self, t: &Rational) -> usize {
        let powers = powers(t, self.chain[0].len());
        let signs = self.chain.iter().map(|c| sign_at(c, &t.num, &powers));
        let signs: Vec<i32> = signs.filter(|&s| s != 0).collect();
        signs.windows(2).filter(|s| s[0] != s[1]).count()
    }

    /// Distinct roots in (a, b], for a ≤ b.
    fn half_open(&self, a: &Rational, b: &Rational) -> usize {
        self.changes(a) - self.changes(b)
    }

    /// Distinct roots in [a, b]; 0 if a > b.
    pub fn closed(&self, a: &Rational, b: &Rational) -> usize {
        if a.compare(b).is_gt() {
            return 0;
        }
        self.half_open(a, b) + usize::from(self.sign(a) == 0)
    }

    /// Distinct roots in [a, b).
    pub fn before(&self, a: &Rational, b: &Rational) -> usize {
        if a.compare(b).is_ge() {
            return 0;
        }
        self.closed(a, b) - usize::from(self.sign(b) == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64) -> Rational {
        Rational::dyadic(&Dyadic::float(x))
    }

    /// The polynomial with these roots.
    fn with_roots(list: &[f64]) -> Poly {
        let one = Poly::number(&Dyadic::whole(1));
        list.iter().fold(one, |p, &r| p.mul(&Poly::line(-r, 1.0)))
    }

    #[test]
    fn distinct_roots_are_counted() {
        let p = with_roots(&[1.0, 2.0, 2.0, 2.0, 3.5])
            .times(-3)
            .sturm()
            .unwrap();
        assert_eq!(p.closed(&at(0.0), &at(5.0)), 3);
        assert_eq!(p.closed(&at(1.0), &at(2.0)), 2);
        assert_eq!(p.before(&at(1.0), &at(2.0)), 1);
        assert_eq!(p.closed(&at(2.0), &at(2.0)), 1);
        assert_eq!(p.before(&at(2.0), &at(2.0)), 0);
        assert_eq!(p.closed(&at(2.5), &at(3.0)), 0);
        assert_eq!(p.closed(&at(3.0), &at(2.5)), 0);
        assert_eq!(
            (p.sign(&at(0.0)), p.sign(&at(2.0)), p.sign(&at(3.0))),
            (1, 0, 1)
        );
    }

    #[test]
    fn roots_an_ulp_apart_are_two() {
        let r = 0.7f64;
        let p = with_roots(&[r, r.next_up(), -4.0]).sturm().unwrap();
        assert_eq!(p.closed(&at(0.0), &at(1.0)), 2);
        assert_eq!(p.closed(&at(r), &at(r)), 1);
        assert_eq!(p.closed(&at(-5.0), &at(r)), 2);
    }

    #[test]
    fn no_real_roots_and_no_polynomial() {
        let one = Poly::number(&Dyadic::whole(1));
        let p = Poly::line(0.0, 1.0).square().add(&one);
        assert_eq!(p.sturm().unwrap().closed(&at(-9.0), &at(9.0)), 0);
        assert!(p.sub(&p).sturm().is_none());
        let double = p.square().sturm().unwrap();
        assert_eq!(double.closed(&at(-9.0), &at(9.0)), 0);
    }
}
