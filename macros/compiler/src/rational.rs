//! Exact numbers and their enclosures in `f64`.

use num_bigint::BigUint;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// The tightest `f64` bounds of a number: equal if it is an `f64`. Beyond the largest `f64` the outer bound is infinite.
pub fn bounds(r: &BigRational) -> (f64, f64) {
    let (low, high) = magnitude(r.numer().magnitude(), r.denom().magnitude());
    if r.is_negative() {
        (-high, -low)
    } else {
        (low, high)
    }
}

/// The nearest `f64`, ties downward.
pub fn nearest(r: &BigRational) -> f64 {
    let (low, high) = bounds(r);
    match (BigRational::from_float(low), BigRational::from_float(high)) {
        (Some(a), Some(b)) if &b - r < r - &a => high,
        _ => low,
    }
}

/// Bounds of n/d. With q = ⌊n/d · 2⁻ᵏ⌋ of at most 53 bits and k ≥ −1074, both q·2ᵏ and (q + 1)·2ᵏ are `f64`s.
fn magnitude(n: &BigUint, d: &BigUint) -> (f64, f64) {
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
    let high = if exact { low } else { scale(&(q + 1u32), k) };
    if low.is_infinite() {
        (f64::MAX, high)
    } else {
        (low, high)
    }
}

fn quotient(n: &BigUint, d: &BigUint, k: i64) -> (BigUint, bool) {
    let (q, r) = if k >= 0 {
        n.div_rem(&(d << k as u64))
    } else {
        (n << (-k) as u64).div_rem(d)
    };
    (q, r.is_zero())
}

/// q·2ᵏ for q ≤ 2⁵³ and k ≥ −1074: exact, or infinite. In two factors, because 2ᵏ alone may be subnormal.
fn scale(q: &BigUint, k: i64) -> f64 {
    let q = q.to_f64().unwrap_or(f64::INFINITY);
    let k = k.clamp(-1074, 2000) as i32;
    let half = k / 2;
    q * 2f64.powi(half) * 2f64.powi(k - half)
}

#[cfg(test)]
// Tests may stop at a failure; the compiler may not.
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
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
            let r = BigRational::from_float(x).unwrap();
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
            assert!(
                BigRational::from_float(low).unwrap() < r
                    && r < BigRational::from_float(high).unwrap()
            );
            assert_eq!(nearest(&r), n as f64 / d as f64);
        }
    }

    #[test]
    fn extremes_are_enclosed() {
        let tiny = BigRational::from_float(5e-324).unwrap() / ratio(3, 1);
        assert_eq!(bounds(&tiny), (0.0, 5e-324));
        let huge = BigRational::from_float(f64::MAX).unwrap() * ratio(2, 1);
        assert_eq!(bounds(&huge), (f64::MAX, f64::INFINITY));
        assert_eq!(bounds(&-huge), (f64::NEG_INFINITY, -f64::MAX));
    }
}
