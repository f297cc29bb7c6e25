//! Small pictures of every surface on every processor path: no answer may be wrong. The same at 512² is the program of
//! this package.

#![forbid(unsafe_code)]

use zeroset_oracle::claims::broken;
use zeroset_oracle::gallery;
use zeroset_oracle::picture::{Outcome, Picture, paths};

/// Pixels along each side.
const SIZE: u32 = 48;

fn check(pictures: &[Picture]) -> Vec<Outcome> {
    let paths = paths();
    let outcomes: Vec<Outcome> = pictures.iter().map(|p| p.check(SIZE, &paths)).collect();
    let mut wrong = Vec::new();
    for outcome in &outcomes {
        let faults = broken(outcome);
        for (path, tally) in &outcome.paths {
            println!("{}; {path}: {tally}", outcome.name);
            // A picture without hits or without misses proves little.
            let hits = tally.roots + tally.tangents;
            assert!(tally.misses > 100 && hits > 20, "{}", outcome.name);
            if !faults.is_empty() {
                wrong.extend(tally.examples.clone());
            }
        }
        wrong.extend(faults);
        wrong.extend(outcome.differences.clone());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    outcomes
}

#[test]
fn polynomials() {
    let outcomes = check(&gallery::polynomial_pictures());
    for outcome in &outcomes {
        if outcome.name.contains("doubled") {
            for (path, tally) in &outcome.paths {
                assert_eq!(
                    tally.roots, 0,
                    "{path}: a double root is called a simple one"
                );
            }
        }
    }
}

#[test]
fn sums_of_exponentials() {
    check(&gallery::sums(1..=8));
}
