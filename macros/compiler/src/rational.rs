//! Exact numbers and their enclosures in `f64`.

use crate::exact::{Natural, Rational};

/// The tightest `f64` bounds of a number: equal if it is an `f64`. Beyond the largest `f64` the outer bound is infinite.
pub fn bounds(r: &Rational) -> (f64, f64) {
    let (low, high) = magnitude(r.numerator(), r.denominator());
    if r.is_negative() {
        (-high, -low)
    } else {
        (low, high)
    }
}

/// The nearest `f64`, ties downward.
pub fn nearest(r: &Rational) -> f64 {
    let (low, high) = bounds(r);
    match (Rational::from_f64(low), Rational::from_f64(high)) {
        (Some(a), Some(b)) if &b - r < r - &a => high,
        _ => low,
    }
}

/// Bounds of n/d. With q = ⌊n/d · 2⁻ᵏ⌋ of at most 53 bits and k ≥ −1074, both q·2ᵏ and (q + 1)·2ᵏ are `f64`s.
fn magnitude(n: &Natural, d: &Natural) -> (f64, f64) {
    if n.is_zero() {
        return (0.0, 0.0);
    }
    // 2^(e−1) < n/d < 2^(e+1)
    let e = n.bits() as i64 - d.bits() as i64;
    let mut k = (e - 53).max(-1074);
    let (mut q, mut exact) = quotient(n, d, k);
    if q.bits() > 53 {
        k += 1;
        (q, exact) = quotient(n, d, k);
    }
    let low = scale(&q, k);
    let high = if exact {
        low
    } else {
        scale(&q.plus(&Natural::from(1)), k)
    };
    if low.is_infinite() {
        (f64::MAX, high)
    } else {
        (low, high)
    }
}

fn quotient(n: &Natural, d: &Natural, k: i64) -> (Natural, bool) {
    let (q, r) = if k >= 0 {
        n.divided(&d.shifted(k as u64))
    } else {
        n.shifted(k.unsigned_abs()).divided(d)
    };
    (q, r.is_zero())
}

/// q·2ᵏ for q ≤ 2⁵³ and k ≥ −1074: exact, or infinite. In two factors, because 2ᵏ alone may be subnormal.
fn scale(q: &Natural, k: i64) -> f64 {
    let q = q.to_u64().map_or(f64::INFINITY, |q| q as f64);
    let k = k.clamp(-1074, 2000) as i32;
    let half = k / 2;
    q * 2f64.powi(half) * 2f64.powi(k - half)
}

#[cfg(test)]
// Tests may stop at a failure; the compiler may not.
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> Rational {
        Rational::from(n).over(&Rational::from(d)).unwrap()
    }

    #[test]
    fn a_double_is_its_own_bounds() {
        for x in [
            0.0,
            1.0,
            -1.5,
            5e-324,
            2.2250738585072014e-308,
            f64::MAX,
            1e-310,
            0.1,
            3e300,
        ] {
            let r = Rational::from_f64(x).unwrap();
            assert_eq!(bounds(&r), (x, x));
            assert_eq!(nearest(&r), x);
        }
    }

    #[test]
    fn bounds_are_neighbours_around_the_number() {
        for (n, d) in [(1, 10), (1, 3), (-2, 3), (7, 1_000_003), (-1, 10)] {
            let r = ratio(n, d);
            let (low, high) = bounds(&r);
            assert_eq!(low.next_up(), high);
            assert!(Rational::from_f64(low).unwrap() < r && r < Rational::from_f64(high).unwrap());
            assert_eq!(nearest(&r), n as f64 / d as f64);
        }
    }

    #[test]
    fn extremes_are_enclosed() {
        let tiny = &Rational::from_f64(5e-324).unwrap() * &ratio(1, 3);
        assert_eq!(bounds(&tiny), (0.0, 5e-324));
        let huge = &Rational::from_f64(f64::MAX).unwrap() * &ratio(2, 1);
        assert_eq!(bounds(&huge), (f64::MAX, f64::INFINITY));
        assert_eq!(bounds(&-huge), (f64::NEG_INFINITY, -f64::MAX));
    }
}
