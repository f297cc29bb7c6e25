//! Elementary functions on every back-end against brackets by arb.

use zeroset::interval::{Interval, UNPROVED};
use zeroset_enclosures::backend::{Backend, Operands, Outcome};
use zeroset_enclosures::fixture::{Bracket, brackets};
use zeroset_enclosures::operand::Source;
use zeroset_enclosures::operation::Operation;
use zeroset_enclosures::promise::width;
use zeroset_enclosures::survey::survey;

const UNARY: [&str; 36] = [
    "sqr",
    "recip",
    "sqrt",
    "exp",
    "exp2",
    "exp_m1",
    "ln",
    "log2",
    "log10",
    "ln_1p",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "sinh",
    "cosh",
    "tanh",
    "asinh",
    "acosh",
    "atanh",
    "cbrt",
    "powi_3",
    "powi_4",
    "powi_5",
    "powi_6",
    "powi_7",
    "powi_12",
    "powi_17",
    "powi_64",
    "powi_1000",
    "powi_-1",
    "powi_-2",
    "powi_-3",
    "powi_-8",
];
const BINARY: [&str; 7] = ["add", "sub", "mul", "div", "hypot", "pow", "atan2"];

/// Made of operations whose bounds are instructions on AVX-512, without a step of their own.
const ARITHMETIC: [&str; 8] = ["sqr", "recip", "sqrt", "add", "sub", "mul", "div", "hypot"];

fn operation(name: &str) -> Operation {
    Operation::named(name).unwrap_or_else(|| panic!("no operation is named {name}"))
}

fn points(brackets: &[Bracket]) -> Vec<Operands> {
    let at = |x: f64| Interval { lo: x, hi: x };
    brackets
        .iter()
        .map(|bracket| Operands {
            a: at(bracket.at[0]),
            b: at(bracket.at[1]),
        })
        .collect()
}

/// Points whose enclosure misses the value.
fn misses(backend: Backend, name: &str) -> Vec<String> {
    let brackets = brackets(name);
    assert!(
        cfg!(miri) || brackets.len() > 200,
        "{name}: {} fixtures",
        brackets.len()
    );
    let outcomes = backend.run(operation(name), &points(&brackets));
    let miss = |(bracket, outcome): (&Bracket, Outcome)| {
        let missed = !outcome.range.encloses(&bracket.value);
        missed.then(|| {
            format!(
                "{name}{:?} = {:?}, not in {:?}",
                bracket.at, bracket.value, outcome.range
            )
        })
    };
    brackets.iter().zip(outcomes).filter_map(miss).collect()
}

#[test]
fn every_point_is_enclosed() {
    for backend in Backend::rounded() {
        for name in UNARY.iter().chain(&BINARY) {
            let misses = misses(backend, name);
            assert!(
                misses.is_empty(),
                "{}: {} misses, first {}",
                backend.name(),
                misses.len(),
                misses[0]
            );
        }
    }
}

/// With rounding off, and with error bounds a tenth of the proved ones.
#[test]
fn negative_control_points_are_missed() {
    for backend in Backend::unrounded().into_iter().chain(Backend::too_tight()) {
        for name in UNARY.iter().chain(&BINARY) {
            let count = misses(backend, name).len();
            println!("{} {name}: {count} misses", backend.name());
            let instructions = ARITHMETIC.contains(name) || name.starts_with("powi_");
            let exact = backend.name() == "avx512-too-tight" && instructions;
            assert_eq!(count > 0, !exact, "{} {name}", backend.name());
        }
    }
}

#[test]
fn points_are_enclosed_tightly() {
    for backend in Backend::rounded() {
        for name in UNARY.iter().chain(&BINARY) {
            let found = survey(backend, operation(name), &brackets(name), false);
            let widest = found.width.last().copied().unwrap_or_default();
            println!("{} {name}: at most {widest} units wide", backend.name());
            let promised = width(name, backend.name());
            assert!(
                widest <= promised,
                "{} {name}: {widest}, not {promised}",
                backend.name()
            );
        }
    }
}

/// The range over [x_i, x_j] holds the values at all fixtures between: monotone pieces, extrema and poles.
#[test]
fn segments_are_enclosed() {
    let mut source = Source(42);
    for name in UNARY {
        let brackets = brackets(name);
        let mut pairs = Vec::new();
        for _ in 0..800 {
            let i = source.below(brackets.len() as u64) as usize;
            let reach = if source.below(2) == 0 {
                6
            } else {
                brackets.len() as u64
            };
            let j = (i + source.below(reach) as usize).min(brackets.len() - 1);
            pairs.push((i, j));
        }
        let operands: Vec<Operands> = pairs
            .iter()
            .map(|&(i, j)| Operands {
                a: Interval {
                    lo: brackets[i].at[0],
                    hi: brackets[j].at[0],
                },
                b: Interval::ONE,
            })
            .collect();
        for backend in Backend::rounded() {
            for (&(i, j), outcome) in pairs.iter().zip(backend.run(operation(name), &operands)) {
                for bracket in &brackets[i..=j] {
                    assert!(
                        outcome.range.encloses(&bracket.value),
                        "{} {name} over [{:e}, {:e}] is {:?}, at {:e} it is {:?}",
                        backend.name(),
                        brackets[i].at[0],
                        brackets[j].at[0],
                        outcome.range,
                        bracket.at[0],
                        bracket.value
                    );
                }
            }
        }
    }
}

#[test]
fn exp_at_the_ends() {
    let at = |lo: f64, hi: f64| Interval { lo, hi };
    for backend in Backend::rounded() {
        let exp = |a: Interval| backend.one(Operation::Exp, a, Interval::ONE).range;
        let all = exp(Interval::ENTIRE);
        assert_eq!((all.lo, all.hi), (0.0, f64::INFINITY), "{}", backend.name());
        let tiny = exp(at(-1e300, -750.0));
        assert!(
            tiny.lo == 0.0 && tiny.hi > 0.0 && tiny.hi < 1e-300,
            "{}: {tiny:?}",
            backend.name()
        );
        let huge = exp(at(710.0, 1e300));
        assert!(
            huge.lo > 1e308 && huge.lo.is_finite() && huge.hi == f64::INFINITY,
            "{}: {huge:?}",
            backend.name()
        );
        let edge = exp(at(709.782712893384, 709.782712893384));
        assert!(
            edge.lo > 1.797e308 && edge.hi <= f64::MAX,
            "{}: {edge:?}",
            backend.name()
        );
    }
}

#[test]
fn domains_set_flags() {
    let at = |lo: f64, hi: f64| Interval { lo, hi };
    // operation, operand, empty, undefined
    let cases = [
        (Operation::Sqrt, at(-1.0, 4.0), false, true),
        (Operation::Sqrt, at(0.0, 4.0), false, false),
        (Operation::Sqrt, at(-2.0, -1.0), true, true),
        (Operation::Ln, at(0.0, 1.0), false, true),
        (Operation::Ln, at(-1.0, 0.0), true, true),
        (Operation::Ln, at(1e-300, 1.0), false, false),
        (Operation::Recip, at(0.0, 1.0), false, true),
        (Operation::Recip, at(0.0, 0.0), true, true),
        (Operation::Recip, at(-2.0, -1.0), false, false),
        (Operation::Asin, at(0.5, 1.5), false, true),
        (Operation::Acos, at(1.5, 2.0), true, true),
        (Operation::Acosh, at(0.0, 0.5), true, true),
        (Operation::Atanh, at(0.0, 1.0), false, true),
        (Operation::Tan, at(1.0, 2.0), false, true),
        (Operation::Tan, at(-1.5, 1.5), false, false),
        (Operation::Log2, at(-3.0, 8.0), false, true),
        (Operation::Ln1p, at(-1.0, 8.0), false, true),
    ];
    for backend in Backend::rounded() {
        for (operation, operand, empty, undefined) in cases {
            let outcome = backend.one(operation, operand, Interval::ONE);
            assert_eq!(
                (outcome.empty, outcome.undefined),
                (empty, undefined),
                "{} {operation:?} {operand:?}",
                backend.name()
            );
        }
        let zero = at(-1.0, 1.0);
        let angle = |y, x| backend.one(Operation::Atan2, y, x);
        assert!(angle(zero, at(-2.0, -1.0)).jump && !angle(zero, at(1.0, 2.0)).jump);
        assert!(angle(zero, zero).undefined && !angle(at(0.0, 1.0), at(-2.0, -1.0)).jump);
        let slope = backend.one(Operation::AbsSlope, zero, Interval::ONE);
        assert!(slope.kink && (slope.range.lo, slope.range.hi) == (-1.0, 1.0));
        assert!(
            !backend
                .one(Operation::AbsSlope, at(0.0, 1.0), Interval::ONE)
                .kink
        );
    }
}

#[test]
fn unproved_functions_are_operations() {
    for name in UNPROVED {
        assert!(Operation::named(name).is_some(), "{name}");
    }
    assert!(!UNPROVED.contains(&"exp"), "exp is proved");
}
