//! Natural numbers of any size.
//!
//! The algorithms are those of Knuth, *The Art of Computer Programming*, volume 2, section 4.3.1, on digits of 32 bits.
//! The tests compare them with `num-bigint`, which would do as well, but whose compilation took 2.9 of the 6.8 s of the
//! macro's.

use std::cmp::Ordering;
use std::fmt;

/// A natural number: its digits to the base 2³², the lowest first, the highest not 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Natural {
    digits: Vec<u32>,
}

const BASE: u64 = 1 << 32;

impl Natural {
    /// From digits of which the highest may be 0.
    fn new(mut digits: Vec<u32>) -> Natural {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        Natural { digits }
    }

    /// What the text spells in this base, if it is digits alone.
    pub fn parse(text: &str, radix: u32) -> Option<Natural> {
        let mut value = Natural::default();
        for c in text.chars() {
            value.step(radix, c.to_digit(radix)?);
        }
        (!text.is_empty()).then_some(value)
    }

    /// self·factor + carry, in place.
    fn step(&mut self, factor: u32, carry: u32) {
        let mut carry = u64::from(carry);
        for digit in &mut self.digits {
            let sum = u64::from(*digit) * u64::from(factor) + carry;
            *digit = sum as u32;
            carry = sum >> 32;
        }
        if carry > 0 {
            self.digits.push(carry as u32);
        }
    }

    /// Is it 0?
    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// Is it 1?
    pub fn is_one(&self) -> bool {
        self.digits == [1]
    }

    /// The number of bits; 0 has none.
    pub fn bits(&self) -> u64 {
        match self.digits.last() {
            Some(top) => self.digits.len() as u64 * 32 - u64::from(top.leading_zeros()),
            None => 0,
        }
    }

    /// The number, if it is below 2⁶⁴.
    pub fn to_u64(&self) -> Option<u64> {
        match *self.digits.as_slice() {
            [] => Some(0),
            [low] => Some(low.into()),
            [low, high] => Some(u64::from(high) << 32 | u64::from(low)),
            _ => None,
        }
    }

    /// self + other
    pub fn plus(&self, other: &Natural) -> Natural {
        let length = self.digits.len().max(other.digits.len());
        let mut digits = Vec::with_capacity(length + 1);
        let mut carry = 0;
        for i in 0..length {
            let sum = self.digit(i) + other.digit(i) + carry;
            digits.push(sum as u32);
            carry = sum >> 32;
        }
        digits.push(carry as u32);
        Natural::new(digits)
    }

    /// self − other; 0 if that is negative.
    pub fn minus(&self, other: &Natural) -> Natural {
        if *self < *other {
            return Natural::default();
        }
        let mut digits = Vec::with_capacity(self.digits.len());
        let mut borrow = 0;
        for i in 0..self.digits.len() {
            let difference = BASE + self.digit(i) - other.digit(i) - borrow;
            digits.push(difference as u32);
            borrow = u64::from(difference < BASE);
        }
        Natural::new(digits)
    }

    /// self·other
    pub fn times(&self, other: &Natural) -> Natural {
        let mut digits = vec![0u32; self.digits.len() + other.digits.len()];
        for (i, &a) in self.digits.iter().enumerate() {
            let mut carry = 0;
            // The row of `a`, and its carry in the place after it.
            for (place, j) in digits.iter_mut().skip(i).zip(0..=other.digits.len()) {
                let sum = u64::from(*place) + u64::from(a) * other.digit(j) + carry;
                *place = sum as u32;
                carry = sum >> 32;
            }
        }
        Natural::new(digits)
    }

    /// selfⁿ
    pub fn power(&self, n: u32) -> Natural {
        let (mut power, mut square, mut n) = (Natural::from(1), self.clone(), n);
        while n > 0 {
            if n % 2 == 1 {
                power = power.times(&square);
            }
            n /= 2;
            if n > 0 {
                square = square.times(&square);
            }
        }
        power
    }

    /// self·2ᵏ
    pub fn shifted(&self, k: u64) -> Natural {
        let mut digits = vec![0; (k / 32) as usize];
        let mut carry = 0;
        for &digit in &self.digits {
            let wide = u64::from(digit) << (k % 32) | carry;
            digits.push(wide as u32);
            carry = wide >> 32;
        }
        digits.push(carry as u32);
        Natural::new(digits)
    }

    /// ⌊self/2ᵏ⌋ for k < 32.
    fn unshifted(&self, k: u32) -> Natural {
        let digit = |i| (self.digit(i) | self.digit(i + 1) << 32) >> k;
        Natural::new((0..self.digits.len()).map(|i| digit(i) as u32).collect())
    }

    /// The quotient, rounded down, and the remainder; (0, self) if `other` is 0.
    pub fn divided(&self, other: &Natural) -> (Natural, Natural) {
        if other.is_zero() || *self < *other {
            return (Natural::default(), self.clone());
        }
        match *other.digits.as_slice() {
            [digit] => {
                let (quotient, rest) = self.divided_by_digit(digit);
                (quotient, Natural::from(u64::from(rest)))
            }
            _ => self.divided_by_digits(other),
        }
    }

    fn divided_by_digit(&self, digit: u32) -> (Natural, u32) {
        let mut digits = self.digits.clone();
        let mut rest = 0;
        for place in digits.iter_mut().rev() {
            let wide = rest << 32 | u64::from(*place);
            *place = (wide / u64::from(digit)) as u32;
            rest = wide % u64::from(digit);
        }
        (Natural::new(digits), rest as u32)
    }

    /// Knuth's algorithm D, for divisors of two digits and more that are not greater.
    fn divided_by_digits(&self, other: &Natural) -> (Natural, Natural) {
        // Shifted so that the divisor's highest bit is set, a guessed digit is at most two too large.
        let shift = other.digits.last().map_or(0, |top| top.leading_zeros());
        let divisor = other.shifted(shift.into()).digits;
        let mut rest = self.shifted(shift.into()).digits;
        rest.resize(self.digits.len() + 1, 0);
        let n = divisor.len();
        let (top, second) = (u64::from(divisor[n - 1]), u64::from(divisor[n - 2]));
        let mut quotient = vec![0; rest.len() - n];
        for j in (0..quotient.len()).rev() {
            let digit = |i: usize| u64::from(rest[j + i]);
            let wide = digit(n) << 32 | digit(n - 1);
            let (mut guess, mut left) = (wide / top, wide % top);
            while left < BASE && (guess >= BASE || guess * second > (left << 32 | digit(n - 2))) {
                guess -= 1;
                left += top;
            }
            if subtract(&mut rest[j..=j + n], &divisor, guess) {
                guess -= 1;
                add_back(&mut rest[j..=j + n], &divisor);
            }
            quotient[j] = guess as u32;
        }
        (Natural::new(quotient), Natural::new(rest).unshifted(shift))
    }

    /// The greatest common divisor; that with 0 is the number itself.
    pub fn gcd(&self, other: &Natural) -> Natural {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.is_zero() {
            let rest = a.divided(&b).1;
            a = std::mem::replace(&mut b, rest);
        }
        a
    }

    /// The root, if it is a whole number. (Newton's method from above descends to ⌊√self⌋.)
    pub fn exact_root(&self) -> Option<Natural> {
        let mut root = Natural::from(1).shifted(self.bits().div_ceil(2));
        loop {
            let next = root.plus(&self.divided(&root).0).unshifted(1);
            if next >= root {
                return (root.times(&root) == *self).then_some(root);
            }
            root = next;
        }
    }

    fn digit(&self, i: usize) -> u64 {
        self.digits.get(i).copied().unwrap_or(0).into()
    }
}

/// rest ← rest − guess·divisor, modulo the base's power; was that negative?
fn subtract(rest: &mut [u32], divisor: &[u32], guess: u64) -> bool {
    let (mut carry, mut borrow) = (0, 0);
    for (i, place) in rest.iter_mut().enumerate() {
        let product = guess * u64::from(divisor.get(i).copied().unwrap_or(0)) + carry;
        carry = product >> 32;
        let difference = BASE + u64::from(*place) - (product % BASE) - borrow;
        *place = difference as u32;
        borrow = u64::from(difference < BASE);
    }
    borrow > 0
}

/// rest ← rest + divisor, modulo the base's power.
fn add_back(rest: &mut [u32], divisor: &[u32]) {
    let mut carry = 0;
    for (i, place) in rest.iter_mut().enumerate() {
        let digit = u64::from(divisor.get(i).copied().unwrap_or(0));
        let sum = u64::from(*place) + digit + carry;
        *place = sum as u32;
        carry = sum >> 32;
    }
}

impl From<u64> for Natural {
    fn from(n: u64) -> Natural {
        Natural::new(vec![n as u32, (n >> 32) as u32])
    }
}

impl PartialOrd for Natural {
    fn partial_cmp(&self, other: &Natural) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Natural {
    fn cmp(&self, other: &Natural) -> Ordering {
        let lengths = self.digits.len().cmp(&other.digits.len());
        lengths.then_with(|| self.digits.iter().rev().cmp(other.digits.iter().rev()))
    }
}

/// In decimals.
impl fmt::Display for Natural {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut parts = Vec::new();
        let mut rest = self.clone();
        while !rest.is_zero() {
            let (quotient, part) = rest.divided_by_digit(1_000_000_000);
            parts.push(part);
            rest = quotient;
        }
        write!(f, "{}", parts.pop().unwrap_or(0))?;
        parts
            .iter()
            .rev()
            .try_for_each(|part| write!(f, "{part:09}"))
    }
}
