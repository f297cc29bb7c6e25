//! Every arithmetic operation on every back-end against exact arithmetic.

use zeroset::interval::Interval;
use zeroset_enclosures::backend::{Backend, Operands};
use zeroset_enclosures::fixture::steps;
use zeroset_enclosures::operand::Source;
use zeroset_enclosures::operation::Operation;
use zeroset_enclosures::truth::holds;

const CASES: usize = if cfg!(miri) { 20 } else { 6_000 };

/// The operations under test. `true`: the operation rounds, so the unrounded back-ends must be caught.
const OPERATIONS: [(Operation, bool); 16] = [
    (Operation::Neg, false),
    (Operation::Abs, false),
    (Operation::Min, false),
    (Operation::Max, false),
    (Operation::Add, true),
    (Operation::Sub, true),
    (Operation::Mul, true),
    (Operation::MulPos, true),
    (Operation::MulPosPos, true),
    (Operation::Sqr, true),
    (Operation::Div, true),
    (Operation::Recip, true),
    (Operation::Sqrt, true),
    (Operation::Powi(3), true),
    (Operation::Powi(4), true),
    (Operation::Powi(7), true),
];

/// Random operands for the operation, cut to where it may be used.
fn operands(operation: Operation, count: usize, seed: u64) -> Vec<Operands> {
    let mut source = Source(seed);
    let nonneg = |a: Interval| {
        let (lo, hi) = (a.lo.abs().min(a.hi.abs()), a.lo.abs().max(a.hi.abs()));
        Interval {
            lo: if lo.is_finite() { lo } else { 0.0 },
            hi,
        }
    };
    (0..count)
        .map(|_| {
            let (mut a, mut b) = (source.interval(), source.interval());
            if matches!(operation, Operation::MulPos | Operation::MulPosPos) {
                a = nonneg(a);
            }
            if operation == Operation::MulPosPos {
                b = nonneg(b);
            }
            Operands { a, b }
        })
        .collect()
}

/// How often the enclosure misses an exact value, and the first miss in words.
fn violations(backend: Backend, operation: Operation, count: usize) -> (usize, Option<String>) {
    let operands = operands(operation, count, 0x5eed);
    let mut source = Source(0xface);
    let (mut misses, mut first) = (0, None);
    for (pair, outcome) in operands.iter().zip(backend.run(operation, &operands)) {
        for _ in 0..3 {
            let (x, y) = (source.member(pair.a), source.member(pair.b));
            if holds(operation, x, y, outcome.range) == Some(false) {
                misses += 1;
                first.get_or_insert_with(|| {
                    format!(
                        "{operation:?} of {x:e} ∈ {:?} and {y:e} ∈ {:?} is not in {:?}",
                        pair.a, pair.b, outcome.range
                    )
                });
            }
        }
    }
    (misses, first)
}

#[test]
fn every_enclosure_holds() {
    for backend in Backend::rounded() {
        for (operation, _) in OPERATIONS {
            let (misses, first) = violations(backend, operation, CASES);
            assert_eq!(
                misses,
                0,
                "{}: {}",
                backend.name(),
                first.unwrap_or_default()
            );
        }
        println!(
            "{}: {} operations, {CASES} operands each, 3 points in each",
            backend.name(),
            OPERATIONS.len()
        );
    }
}

#[test]
fn negative_control_rounding_off_is_caught_in_every_operation() {
    for backend in Backend::unrounded() {
        for (operation, rounds) in OPERATIONS {
            let (misses, _) = violations(backend, operation, CASES);
            println!("{} {operation:?}: {misses} violations", backend.name());
            assert_eq!(misses > 0, rounds, "{} {operation:?}", backend.name());
        }
    }
}

/// Instructions of AVX-512 round by themselves: it has no bound in arithmetic that could be too tight.
#[test]
fn negative_control_bounds_ten_times_too_tight_are_caught_in_every_operation() {
    for backend in Backend::too_tight() {
        for (operation, rounds) in OPERATIONS {
            let (misses, _) = violations(backend, operation, CASES);
            println!("{} {operation:?}: {misses} violations", backend.name());
            let widens = rounds && !backend.name().starts_with("avx512");
            assert_eq!(misses > 0, widens, "{} {operation:?}", backend.name());
        }
    }
}

/// Products whose bounds are no numbers, and those that are and still miss.
fn unguarded_products(backend: Backend) -> (usize, usize) {
    let operands = operands(Operation::Mul, CASES, 0x5eed);
    let (mut overflows, mut underflows) = (0, 0);
    for (pair, outcome) in operands.iter().zip(backend.run(Operation::Mul, &operands)) {
        let r = outcome.range;
        let (x, y) = (pair.a.mid(), pair.b.mid());
        if r.lo.is_nan() || r.hi.is_nan() {
            overflows += 1;
        } else if holds(Operation::Mul, x, y, r) == Some(false) {
            underflows += usize::from(r.hi.abs() < 1e-300);
        }
    }
    (overflows, underflows)
}

/// Operations whose result may overflow, or lose bits in subnormals. (Roots and sums of what is no overflow do not.)
#[test]
fn negative_control_missing_guards_are_caught() {
    for backend in Backend::unguarded() {
        for (operation, rounds) in OPERATIONS {
            let (misses, _) = violations(backend, operation, CASES);
            println!("{} {operation:?}: {misses} violations", backend.name());
            let safe = !rounds || operation == Operation::Sqrt;
            assert_eq!(misses > 0, !safe, "{} {operation:?}", backend.name());
        }
        let (overflows, underflows) = unguarded_products(backend);
        println!(
            "{}: {overflows} of them by overflow, {underflows} by underflow",
            backend.name()
        );
        assert!(overflows > 0 && underflows > 0, "{}", backend.name());
    }
}

#[test]
fn bounds_obey_the_invariants() {
    for backend in Backend::rounded() {
        for (operation, _) in OPERATIONS {
            let operands = operands(operation, CASES, 0xbead);
            for (pair, outcome) in operands.iter().zip(backend.run(operation, &operands)) {
                let r = outcome.range;
                assert!(
                    Interval::try_new(r.lo, r.hi).is_ok() || outcome.empty,
                    "{} {operation:?} of {:?}, {:?} is {r:?}",
                    backend.name(),
                    pair.a,
                    pair.b
                );
            }
        }
    }
}

/// On points, an optimal back-end gives two neighbours at most; the others two units on each side, and the smallest
/// subnormal.
#[test]
fn enclosures_of_points_are_tight() {
    let mut source = Source(7);
    let pairs: Vec<Operands> = (0..CASES)
        .map(|_| {
            let (x, y) = (source.unit() * 10.0 + 1e-3, source.unit() * 10.0 + 1e-3);
            Operands {
                a: Interval::point(x),
                b: Interval::point(y),
            }
        })
        .collect();
    let one_rounding = [
        Operation::Add,
        Operation::Sub,
        Operation::Mul,
        Operation::MulPos,
        Operation::MulPosPos,
        Operation::Sqr,
        Operation::Div,
        Operation::Recip,
        Operation::Sqrt,
    ];
    for backend in Backend::rounded() {
        for operation in one_rounding {
            let mut worst = 0;
            for outcome in backend.run(operation, &pairs) {
                worst = worst.max(steps(outcome.range));
            }
            println!(
                "{} {operation:?}: at most {worst} units wide",
                backend.name()
            );
            assert!(
                worst <= if backend.is_optimal() { 1 } else { 4 },
                "{} {operation:?}",
                backend.name()
            );
        }
    }
}
