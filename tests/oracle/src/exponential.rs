//! eˣ in whole numbers, with a bound for the error: the last word on the sign of a sum.

use num_bigint::BigInt;
use num_traits::Zero;

use crate::dyadic::Dyadic;

/// Bits behind the binary point.
pub const BITS: i64 = 320;
/// How often the argument is halved.
const HALVINGS: u32 = 20;

/// eˣ·2^BITS for −250 ≤ x ≤ 30, with an error of at most 2⁸⁰.
///
/// e^x = (e^y)^(2^20) with y = x/2^20, |y| < 2⁻¹². All numbers are multiples of u = 2^−BITS, and each product is rounded
/// down: an error of at most u. y has an error of at most 2u. Term n of Taylor's series is below 2^(−12n), so that
/// 27 terms reach u; their errors together, and the rest behind them, stay below 100u. With e^y ≤ 1.0003 a squaring
/// takes an error ε to at most 2.001·e^y·ε + u: after 20 of them, it is at most 2^21·eˣ·101u + the roundings' 2^21·eˣ·u
/// < 2^29·e^30·u < 2^73·u.
///
/// # Panics
/// If x is out of range.
pub fn exp(x: &Dyadic) -> BigInt {
    let x = x.floor_shifted(BITS);
    let unit = BigInt::from(1) << BITS;
    assert!(x >= &unit * -250 && x <= &unit * 30, "out of range");
    let y = x >> HALVINGS;
    let mut sum = unit.clone();
    let mut term = unit;
    for n in 1.. {
        term = ((term * &y) >> BITS) / n;
        // −1 is what rounding down makes of almost 0.
        if term.is_zero() || term == BigInt::from(-1) {
            break;
        }
        sum += &term;
    }
    for _ in 0..HALVINGS {
        sum = (&sum * &sum) >> BITS;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::Signed;

    fn close(a: &BigInt, b: &BigInt) -> bool {
        (a - b).abs() < BigInt::from(1) << 160
    }

    #[test]
    fn digits_of_e() {
        // 60 decimals of e.
        let e: BigInt = "2718281828459045235360287471352662497757247093699959574966967"
            .parse()
            .unwrap();
        let ten = BigInt::from(10).pow(60);
        let expected = (e << BITS) / ten;
        let error = (exp(&Dyadic::whole(1)) - expected).abs();
        // 10⁻⁶⁰ > 2⁻²⁰⁰
        assert!(error < BigInt::from(1) << (BITS - 198));
    }

    #[test]
    fn powers_multiply() {
        for (a, b) in [(3.5, -7.25), (-90.0, 20.125), (0.1, 0.2), (-1e-9, 1e-9)] {
            let (a, b) = (Dyadic::float(a), Dyadic::float(b));
            let product = (exp(&a) * exp(&b)) >> BITS;
            assert!(close(&product, &exp(&a.add(&b))));
        }
        assert!(close(&exp(&Dyadic::whole(0)), &(BigInt::from(1) << BITS)));
    }
}
