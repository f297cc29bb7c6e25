//! What must be true of a thread before its numbers mean anything.

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!(
    "the x87 unit rounds twice, so that no bound of zeroset would hold: build for a target with SSE2"
);

use std::hint::black_box;

/// Does this thread compute as IEEE 754 has it by default: to nearest, ties to even, with subnormal numbers?
///
/// Changing that is undefined behaviour in Rust, but libraries in other languages do change it.
pub fn is_ieee() -> bool {
    obeys(
        |a, b| black_box(a) + black_box(b),
        |a, b| black_box(a) * black_box(b),
    )
}

/// A sum and a product as they should be.
fn obeys(add: fn(f64, f64) -> f64, mul: fn(f64, f64) -> f64) -> bool {
    let u = f64::EPSILON / 2.0;
    // Ties: downward would leave −1 − u below −1, upward 1 + u above 1, towards 0 would leave 1 − u/2 below 1.
    let nearest = add(1.0, u) == 1.0 && add(-1.0, -u) == -1.0 && add(1.0, -u / 2.0) == 1.0;
    // Subnormal results, and subnormal operands.
    let least = f64::from_bits(1);
    let half = mul(f64::MIN_POSITIVE, 0.5);
    nearest && half > 0.0 && mul(half, 2.0) == f64::MIN_POSITIVE && add(least, least) > least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_obey() {
        assert!(is_ieee());
        assert!(std::thread::spawn(is_ieee).join().unwrap_or(false));
    }

    /// Arithmetic as it would be with other settings of the processor.
    #[test]
    fn other_arithmetic_is_noticed() {
        let add: fn(f64, f64) -> f64 = |a, b| a + b;
        let mul: fn(f64, f64) -> f64 = |a, b| a * b;
        fn flushed(x: f64) -> f64 {
            if x.is_subnormal() { 0.0 } else { x }
        }
        assert!(obeys(add, mul));
        // Results flushed to 0, operands taken as 0.
        assert!(!obeys(add, |a, b| flushed(a * b)));
        assert!(!obeys(add, |a, b| flushed(a) * b));
        // A unit further in one direction.
        assert!(!obeys(|a, b| (a + b).next_up(), mul));
        assert!(!obeys(|a, b| (a + b).next_down(), mul));
    }
}
