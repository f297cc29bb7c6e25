//! The vectors of ITF1788: every range holds the tightest one. They are read where `ITF1788_DIR` points.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

use zeroset::interval::{Interval, Packet, Scalar};
use zeroset_enclosures::backend::Backend;
use zeroset_enclosures::fixture::steps;
use zeroset_enclosures::itf::{Case, Set, parse};
use zeroset_enclosures::operation::Operation;

/// What became of the cases of one operation.
#[derive(Default)]
struct Tally {
    parsed: usize,
    run: usize,
    skipped: usize,
    wrong: usize,
    excess: u64,
    first: Option<String>,
}

/// The cases, or a skip that is seen.
fn cases(test: &str) -> Option<Vec<Case>> {
    let Some(folder) = std::env::var_os("ITF1788_DIR") else {
        // Straight to the stream: what tests print is hidden when they pass.
        let _ = writeln!(std::io::stderr(), "SKIPPED {test}: ITF1788_DIR is not set");
        return None;
    };
    let mut cases = Vec::new();
    for file in ["libieeep1788_elem.itl", "libieeep1788_mul_rev.itl"] {
        let path = Path::new(&folder).join(file);
        let text = std::fs::read_to_string(&path)
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        cases.extend(parse(&text));
    }
    assert!(cases.len() > 3000, "only {} cases", cases.len());
    Some(cases)
}

/// Our operation for a case, with operands; None if we have none, or an operand is empty.
fn ours(case: &Case) -> Option<(Operation, Interval, Interval)> {
    let operand = |i: usize| match case.operands.get(i) {
        Some(Set::Some(a)) => Some(*a),
        Some(_) => None,
        None => Some(Interval::ONE),
    };
    if case.name == "pown" {
        return match case.operands[..] {
            [Set::Some(a), Set::Number(n)] if n >= 0.0 => Some((Operation::Powi(n as u32), a, a)),
            _ => None,
        };
    }
    let name = if case.name == "log" { "ln" } else { &case.name };
    Some((Operation::named(name)?, operand(0)?, operand(1)?))
}

/// Does the outcome hold the expected set, and by how many doubles is it wider?
fn check(expected: Set, empty: bool, range: Interval) -> Result<u64, ()> {
    match expected {
        Set::Empty => Ok(0),
        Set::Some(tight) if !empty && range.encloses(&tight) => {
            let lower = steps(Interval {
                lo: range.lo,
                hi: tight.lo,
            });
            Ok(lower.max(steps(Interval {
                lo: tight.hi,
                hi: range.hi,
            })))
        }
        _ => Err(()),
    }
}

fn tally(backend: Backend, cases: &[Case]) -> BTreeMap<&str, Tally> {
    let mut all: BTreeMap<&str, Tally> = BTreeMap::new();
    for case in cases {
        let tally = all.entry(&case.name).or_default();
        tally.parsed += 1;
        let Some((operation, a, b)) = ours(case) else {
            tally.skipped += 1;
            continue;
        };
        tally.run += 1;
        let outcome = backend.one(operation, a, b);
        match check(case.results[0], outcome.empty, outcome.range) {
            // Far tails and unbounded ranges are wide on purpose; the report is of roundings.
            Ok(excess) if excess < 1 << 20 => tally.excess = tally.excess.max(excess),
            Ok(_) => {}
            Err(()) => {
                tally.wrong += 1;
                tally
                    .first
                    .get_or_insert_with(|| format!("{case:?}: {outcome:?}"));
            }
        }
    }
    all
}

#[test]
fn ranges_hold_the_tightest_ones() {
    let Some(cases) = cases("ranges_hold_the_tightest_ones") else {
        return;
    };
    for backend in Backend::rounded() {
        let all = tally(backend, &cases);
        for (name, tally) in &all {
            println!(
                "{} {name}: parsed {}, run {}, skipped {}, at most {} units more than the tightest",
                backend.name(),
                tally.parsed,
                tally.run,
                tally.skipped,
                tally.excess
            );
            assert_eq!(
                tally.wrong,
                0,
                "{}: {}",
                backend.name(),
                tally.first.as_deref().unwrap_or_default()
            );
        }
        assert!(all.values().map(|tally| tally.run).sum::<usize>() > 1500);
    }
}

#[test]
fn negative_control_vectors_catch_rounding_to_nearest() {
    let Some(cases) = cases("negative_control_vectors_catch_rounding_to_nearest") else {
        return;
    };
    for backend in Backend::unrounded() {
        let all = tally(backend, &cases);
        for name in ["add", "sub", "mul", "div", "sqrt", "exp", "log", "sin"] {
            println!(
                "{} {name}: {} of {} wrong",
                backend.name(),
                all[name].wrong,
                all[name].run
            );
            assert!(all[name].wrong > 0, "{} {name}", backend.name());
        }
    }
}

/// Newton's division is the standard's `mulRevToPair` with the divisor first.
#[test]
fn newton_division_is_mul_rev_to_pair() {
    let Some(cases) = cases("newton_division_is_mul_rev_to_pair") else {
        return;
    };
    let mut run = 0;
    for case in cases.iter().filter(|case| case.name == "mulRevToPair") {
        let [Set::Some(den), Set::Some(num)] = case.operands[..] else {
            continue;
        };
        let (first, second, two, empty) = Scalar.div_ext(num, den);
        match case.results[..] {
            [Set::Empty, Set::Empty] => assert!(empty, "{case:?}"),
            [Set::Some(one), Set::Empty] => assert!(
                !empty && !two && first.encloses(&one),
                "{case:?}: {first:?}"
            ),
            [Set::Some(left), Set::Some(right)] => {
                assert!(
                    two && first.encloses(&left) && second.encloses(&right),
                    "{case:?}: {first:?} {second:?}"
                );
            }
            _ => panic!("{case:?}"),
        }
        run += 1;
    }
    println!("mulRevToPair: {run} cases");
    assert!(run > 100);
}
