//! Operands of any bits: arithmetic against exact numbers, and what every operation must obey.

#![no_main]

use libfuzzer_sys::fuzz_target;
use zeroset::interval::Interval;
use zeroset_enclosures::backend::Backend;
use zeroset_enclosures::promise::operations;
use zeroset_enclosures::truth;

/// An interval of two numbers of any size and order; None with a NaN, or with an infinity for a point.
fn interval(x: f64, y: f64) -> Option<Interval> {
    Interval::try_new(x.min(y), x.max(y)).ok()
}

fuzz_target!(|input: (u8, [u64; 4])| {
    let [w, x, y, z] = input.1.map(f64::from_bits);
    let (Some(a), Some(b)) = (interval(w, x), interval(y, z)) else {
        return;
    };
    let all = operations();
    let (name, operation) = &all[input.0 as usize % all.len()];
    if name.starts_with("mul_pos") && (a.lo < 0.0 || b.lo < 0.0) {
        return;
    }
    for backend in Backend::rounded() {
        let outcome = backend.one(*operation, a, b);
        let range = outcome.range;
        let place = format!(
            "{} {operation:?} of {a:?}, {b:?}: {range:?}",
            backend.name()
        );
        assert!(
            outcome.empty || Interval::try_new(range.lo, range.hi).is_ok(),
            "{place}"
        );
        if truth::OPERATIONS.contains(operation) {
            for (x, y) in [(a.lo, b.lo), (a.lo, b.hi), (a.hi, b.lo), (a.hi, b.hi)] {
                if x.is_finite() && y.is_finite() {
                    assert!(
                        truth::holds(*operation, x, y, range) != Some(false),
                        "{place} at {x:e}, {y:e}"
                    );
                }
            }
        }
    }
});
