//! Functions whose inverses are polynomials, on every back-end against exact arithmetic: hypot and the cube root.

use std::cmp::Ordering;

use zeroset::interval::Interval;
use zeroset_enclosures::backend::{Backend, Operands};
use zeroset_enclosures::exact::Exact;
use zeroset_enclosures::fixture::steps;
use zeroset_enclosures::operand::Source;
use zeroset_enclosures::operation::Operation;

const CASES: usize = 5_000;
const OPERATIONS: [Operation; 2] = [Operation::Hypot, Operation::Cbrt];

/// Is the value at (x, y) in the range? By powers of the bounds, which are monotone.
fn holds(operation: Operation, x: f64, y: f64, range: Interval) -> bool {
    let (power, value) = match operation {
        Operation::Hypot => (2, Exact::from(x).powi(2).add(&Exact::from(y).powi(2))),
        Operation::Cbrt => (3, Exact::from(x)),
        other => panic!("no exact value for {other:?}"),
    };
    let order = |bound: f64| Exact::from(bound).powi(power).order(&value);
    let trivial = |bound: f64| power == 2 && bound <= 0.0;
    let above = range.lo == f64::NEG_INFINITY
        || trivial(range.lo)
        || (range.lo.is_finite() && order(range.lo) != Ordering::Greater);
    let below = range.hi == f64::INFINITY
        || (range.hi.is_finite() && range.hi >= 0.0 && order(range.hi) != Ordering::Less)
        || (range.hi.is_finite() && power == 3 && order(range.hi) != Ordering::Less);
    above && below
}

fn operands(seed: u64) -> Vec<Operands> {
    let mut source = Source(seed);
    (0..CASES)
        .map(|_| Operands {
            a: source.interval(),
            b: source.interval(),
        })
        .collect()
}

fn misses(backend: Backend, operation: Operation) -> Vec<String> {
    let operands = operands(0x5eed);
    let mut source = Source(0xface);
    let mut misses = Vec::new();
    for (pair, outcome) in operands.iter().zip(backend.run(operation, &operands)) {
        let (x, y) = (source.member(pair.a), source.member(pair.b));
        if !holds(operation, x, y, outcome.range) {
            misses.push(format!(
                "{operation:?} of {x:e} in {:?} and {y:e} in {:?} is not in {:?}",
                pair.a, pair.b, outcome.range
            ));
        }
    }
    misses
}

#[test]
fn every_enclosure_holds() {
    for backend in Backend::rounded() {
        for operation in OPERATIONS {
            let misses = misses(backend, operation);
            assert!(
                misses.is_empty(),
                "{}: {}",
                backend.name(),
                misses.join("\n")
            );
        }
    }
}

#[test]
fn negative_control_bounds_that_do_not_hold_are_caught() {
    for backend in Backend::unrounded() {
        for operation in OPERATIONS {
            let count = misses(backend, operation).len();
            println!("{} {operation:?}: {count} misses", backend.name());
            assert!(count > 0, "{} {operation:?}", backend.name());
        }
    }
}

/// Nothing overflows or underflows on the way: enclosures of points are as tight at the ends of the range of doubles as
/// elsewhere.
#[test]
fn enclosures_of_points_are_tight() {
    let mut source = Source(11);
    let pairs: Vec<Operands> = (0..CASES)
        .map(|_| Operands {
            a: Interval::point(source.number()),
            b: Interval::point(source.number()),
        })
        .collect();
    for backend in Backend::rounded() {
        for operation in OPERATIONS {
            let mut worst = 0;
            for outcome in backend.run(operation, &pairs) {
                assert!(Interval::try_new(outcome.range.lo, outcome.range.hi).is_ok());
                if outcome.range.hi.is_finite() {
                    worst = worst.max(steps(outcome.range));
                }
            }
            println!(
                "{} {operation:?}: at most {worst} units wide",
                backend.name()
            );
            let promised = match operation {
                Operation::Cbrt => 2,
                _ if backend.is_optimal() => 4,
                _ => 10,
            };
            assert!(
                worst <= promised,
                "{} {operation:?}: {worst} units",
                backend.name()
            );
        }
        let ends = [
            (3e307, 4e307, 5e307),
            (3e-323, 4e-323, 5e-323),
            (1e-320, 0.0, 1e-320),
        ];
        for (x, y, root) in ends {
            let at = |x: f64| Interval { lo: x, hi: x };
            let range = backend.one(Operation::Hypot, at(x), at(y)).range;
            assert!(
                range.lo <= 1.01 * root && range.hi >= 0.99 * root && steps(range) <= 10,
                "{}: {range:?}",
                backend.name()
            );
        }
    }
}
