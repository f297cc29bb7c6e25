//! Elementary functions on every back-end against brackets by arb.

use zeroset::interval::{Interval, Isa, Kernel, Packet, UNPROVED};
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

/// Segments of a few units in the last place to 2⁻⁴¹ of x, on either side of x, whose ranges miss the value there.
fn misses_at_ends(backend: Backend, name: &str) -> Vec<String> {
    let brackets = brackets(name);
    let mut wanted = Vec::new();
    for (i, bracket) in brackets.iter().enumerate() {
        let x = bracket.at[0];
        let length = x.abs() * (-41.0 - (i % 11) as f64).exp2();
        for a in [[x - length, x], [x, x + length]] {
            let a = Interval { lo: a[0], hi: a[1] };
            if a.lo.is_finite() && a.hi.is_finite() {
                let operands = Operands {
                    a,
                    b: Interval::ONE,
                };
                wanted.push((operands, bracket.value));
            }
        }
    }
    let operands: Vec<Operands> = wanted.iter().map(|(operands, _)| *operands).collect();
    let outcomes = backend.run(operation(name), &operands);
    let missed = wanted.iter().zip(outcomes).filter_map(|((at, value), of)| {
        let missed = !of.range.encloses(value);
        missed.then(|| format!("{name}{:?}: {value:?} not in {:?}", at.a, of.range))
    });
    missed.collect()
}

#[test]
fn thin_segments_are_enclosed() {
    for name in UNARY {
        for backend in Backend::rounded() {
            let misses = misses_at_ends(backend, name);
            let count = misses.len();
            assert!(count == 0, "{}: {count}, {}", backend.name(), misses[0]);
        }
    }
    let wrong = || Backend::unrounded().into_iter().chain(Backend::too_tight());
    for (name, backend) in ["sin", "cos"]
        .into_iter()
        .flat_map(|n| wrong().map(move |b| (n, b)))
    {
        let count = misses_at_ends(backend, name).len();
        assert!(count > 0, "the control, {name} on {}", backend.name());
    }
}

/// Both at once.
struct SineAndCosine<'a>(&'a [[Interval; 8]]);

impl Kernel for SineAndCosine<'_> {
    /// Together, and one by one.
    type Output = Vec<[[[f64; 8]; 4]; 2]>;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Self::Output {
        let mut all = Vec::new();
        for a in self.0 {
            let a = p.interval(p.lanes(a.map(|a| a.lo)), p.lanes(a.map(|a| a.hi)));
            let pairs = [p.sin_cos(a), [p.sin(a), p.cos(a)]];
            all.push(pairs.map(|[s, c]| [s.lo, s.hi, c.lo, c.hi].map(|x| p.to_array(x))));
        }
        all
    }
}

#[test]
fn sine_and_cosine_together_are_those_one_by_one() {
    let mut source = Source(7);
    let mut segments = Vec::new();
    for width in [0.0, 1e-15, 1e-13, 1e-9, 0.1, 3.0, 7.0] {
        for size in [1e-300, 1e-8, 1.0, 30.0, 1e7, 1e300] {
            segments.push([0; 8].map(|_| {
                let lo = size * (2.0 * source.unit() - 1.0);
                Interval {
                    lo,
                    hi: lo + width * lo.abs(),
                }
            }));
        }
    }
    for isa in Isa::available() {
        for [together, apart] in isa.run(SineAndCosine(&segments)) {
            assert_eq!(together, apart, "{isa}");
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
