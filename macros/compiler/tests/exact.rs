//! Exact numbers against `num-bigint`: sizes at the borders of digits, and random ones.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use num_bigint::BigUint;
use num_integer::Integer;
use zeroset_compiler::exact::{Natural, Rational};

/// A generator of Lehmer's kind.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 32
    }

    /// A number of up to `most` digits of 32 bits, often with runs of ones or zeros: there the guesses of a division fail.
    fn number(&mut self, most: u64) -> BigUint {
        let digits = (0..self.next() % (most + 1)).map(|_| match self.next() % 4 {
            0 => 0,
            1 => u32::MAX,
            2 => (self.next() % 3) as u32 + 0x7fff_ffff,
            _ => self.next() as u32,
        });
        BigUint::new(digits.collect())
    }
}

fn natural(n: &BigUint) -> Natural {
    Natural::parse(&n.to_string(), 10).unwrap()
}

fn check(ours: &Natural, theirs: &BigUint) {
    assert_eq!(ours.to_string(), theirs.to_string());
}

#[test]
fn natural_numbers_agree_with_num_bigint() {
    let mut random = Random(1);
    for _ in 0..20_000 {
        let (a, b) = (random.number(9), random.number(5));
        let (x, y) = (natural(&a), natural(&b));
        check(&x.plus(&y), &(&a + &b));
        check(&x.times(&y), &(&a * &b));
        assert_eq!(x.cmp(&y), a.cmp(&b));
        assert_eq!(x.bits(), a.bits());
        let k = random.next() % 100;
        check(&x.shifted(k), &(&a << k));
        if a >= b {
            check(&x.minus(&y), &(&a - &b));
        } else {
            assert!(x.minus(&y).is_zero());
        }
        if b != BigUint::ZERO {
            let (quotient, rest) = x.divided(&y);
            check(&quotient, &(&a / &b));
            check(&rest, &(&a % &b));
        }
        check(&x.gcd(&y), &a.gcd(&b));
    }
}

#[test]
fn roots_are_found_where_they_are_whole() {
    let mut random = Random(2);
    for _ in 0..2_000 {
        let a = random.number(4);
        let square = &a * &a;
        check(&natural(&square).exact_root().unwrap(), &a);
        if square > BigUint::from(1u32) {
            assert_eq!(natural(&(&square + 1u32)).exact_root(), None);
            assert_eq!(natural(&(&square - 1u32)).exact_root(), None);
        }
    }
}

#[test]
fn division_by_zero_is_no_number() {
    let (one, zero) = (Rational::from(1), Rational::from(0));
    assert_eq!(one.over(&zero), None);
    assert_eq!(zero.power(-1), None);
    assert_eq!(zero.power(0), Some(one));
    assert_eq!(
        Natural::from(5).divided(&Natural::default()),
        (Natural::default(), Natural::from(5))
    );
}

/// a/b + c/d and so on, by cross-multiplication in machine integers.
#[test]
fn rational_numbers_are_in_lowest_terms_and_in_order() {
    let mut random = Random(3);
    let mut small = || (random.next() % 25) as i64 - 12;
    let fraction = |n: i64, d: i64| Rational::from(n).over(&Rational::from(d));
    for _ in 0..5_000 {
        let (a, b, c, d) = (small(), small(), small(), small());
        let (Some(x), Some(y)) = (fraction(a, b), fraction(c, d)) else {
            assert!(b == 0 || d == 0);
            continue;
        };
        assert_eq!(&x + &y, fraction(a * d + c * b, b * d).unwrap());
        assert_eq!(&x - &y, fraction(a * d - c * b, b * d).unwrap());
        assert_eq!(&x * &y, fraction(a * c, b * d).unwrap());
        assert_eq!(x.over(&y), fraction(a * d, b * c));
        let (left, right) = (a * d * (b * d).signum(), c * b * (b * d).signum());
        assert_eq!(x.cmp(&y), left.cmp(&right));
        assert_eq!(x.is_negative(), a * b.signum() < 0);
        assert_eq!(x.to_i64(), (a % b == 0).then(|| a / b));
        let common = a.gcd(&b) * b.signum();
        let text = match b / common {
            1 => format!("{}", a / common),
            _ => format!("{}/{}", a / common, b / common),
        };
        assert_eq!(x.to_string(), text);
        assert_eq!(x.power(3), Some(&x * &(&x * &x)));
        assert_eq!(x.power(-2), (&x * &x).reciprocal());
    }
}

#[test]
fn doubles_are_what_they_are() {
    for x in [
        1.0,
        -0.1,
        5e-324,
        2.2250738585072014e-308,
        f64::MAX,
        0.75,
        -3.0,
        1e300,
    ] {
        let r = Rational::from_f64(x).unwrap();
        assert_eq!(zeroset_compiler::rational::bounds(&r), (x, x));
    }
    assert_eq!(Rational::from_f64(0.75).unwrap().to_string(), "3/4");
    assert_eq!(Rational::from_f64(-0.0).unwrap(), Rational::from(0));
    assert_eq!(Rational::from_f64(f64::NAN), None);
}
