//! Where a range may be more than a few units in the last place wider than the tightest one, and why.

use zeroset::interval::Interval;

use super::{Case, Set};

/// A reason for width.
#[derive(Clone, Copy, Debug)]
pub struct Exception {
    /// The operation as the standard names it.
    pub operation: &'static str,
    /// The back-ends; empty for all.
    pub backends: &'static [&'static str],
    /// Of which cases: the first operand, the last one, and the tightest range.
    pub only: fn(Interval, Interval, Interval) -> bool,
    /// How many doubles the range may be wider on a side.
    pub limit: u64,
    /// Why.
    pub reason: &'static str,
}

const TINY: f64 = f64::MIN_POSITIVE;
const WIDENING: &[&str] = &["avx2", "portable"];
/// How far the range may reach where the kernel stops short of an overflow or of subnormals.
const FAR: u64 = u64::MAX;

/// All of them.
pub const EXCEPTIONS: &[Exception] = &[
    Exception {
        operation: "div",
        backends: &[],
        only: |a, b, _| a == Interval::ZERO && b.lo < 0.0 && b.hi > 0.0,
        limit: FAR,
        reason: "0 is inside the divisor: the line, whatever is divided; `undefined` is set",
    },
    Exception {
        operation: "exp",
        backends: &[],
        only: |a, _, _| a.lo < -708.0 || a.hi > 709.0,
        limit: FAR,
        reason: "below −708 the bounds are 0 and the power of −708, above ln MAX they are that power and ∞",
    },
    Exception {
        operation: "exp2",
        backends: &[],
        only: |a, _, _| a.lo < -1021.0 || a.hi > 1023.0,
        limit: FAR,
        reason: "below −1021 the bounds are 0 and 2⁻¹⁰²¹, above 1023 they are 2¹⁰²³ and ∞",
    },
    Exception {
        operation: "log2",
        backends: &["portable"],
        only: |_, _, _| true,
        limit: 6,
        reason: "ln, two units wide on each side without fused operations, times a constant",
    },
    Exception {
        operation: "log10",
        backends: &["portable"],
        only: |_, _, _| true,
        limit: 6,
        reason: "ln, two units wide on each side without fused operations, times a constant",
    },
    Exception {
        operation: "pow",
        backends: &[],
        only: |a, _, _| a.hi <= 0.0,
        limit: FAR,
        reason: "the base is at most 0: the closure of 0ᵇ over all b; `undefined` is set",
    },
    Exception {
        operation: "pown",
        backends: &[],
        only: |_, n, tight| n.hi < 0.0 && (tight.lo.abs() < TINY || tight.hi.abs() < TINY),
        limit: FAR,
        reason: "the positive power overflows, and the reciprocal is that of MAX",
    },
    Exception {
        operation: "pown",
        backends: &["avx512", "scalar"],
        only: |_, _, _| true,
        limit: 6,
        reason: "repeated products, each rounded once",
    },
    Exception {
        operation: "pown",
        backends: WIDENING,
        only: |_, _, _| true,
        limit: 11,
        reason: "repeated products, widened by a unit for each on either side",
    },
];

impl Exception {
    /// The exception that lets this excess pass.
    pub fn find(
        backend: &str,
        case: &Case,
        tight: Interval,
        excess: u64,
    ) -> Option<&'static Exception> {
        let interval = |set: Option<&Set>| match set {
            Some(Set::Some(a)) => *a,
            Some(Set::Number(x)) => Interval { lo: *x, hi: *x },
            _ => Interval::ENTIRE,
        };
        let (a, b) = (
            interval(case.operands.first()),
            interval(case.operands.last()),
        );
        EXCEPTIONS.iter().find(|e| {
            e.operation == case.name
                && (e.backends.is_empty() || e.backends.contains(&backend))
                && (e.only)(a, b, tight)
                && excess <= e.limit
        })
    }
}
