//! Small pictures of every surface on every processor path: no answer may be wrong. The same at 512² is the program of
//! this package.

#![forbid(unsafe_code)]

use zeroset_oracle::gallery;
use zeroset_oracle::picture::{Outcome, Picture, paths};
use zeroset_oracle::tally::WIDEST;

/// Pixels along each side.
const SIZE: u32 = 48;

fn check(pictures: &[Picture]) -> Vec<Outcome> {
    let paths = paths();
    let outcomes: Vec<Outcome> = pictures.iter().map(|p| p.check(SIZE, &paths)).collect();
    for outcome in &outcomes {
        for (path, tally) in &outcome.paths {
            println!("{}; {path}: {tally}", outcome.name);
        }
    }
    for outcome in &outcomes {
        right(outcome);
    }
    outcomes
}

/// Nothing wrong, nothing left open, and the same on all paths.
fn right(outcome: &Outcome) {
    let name = &outcome.name;
    for (path, tally) in &outcome.paths {
        let at = format!("{name}; {path}: {tally}\n{}", tally.examples.join("\n"));
        assert_eq!(tally.wrong, 0, "{at}");
        assert_eq!(tally.undecided, 0, "{at}");
        assert!(tally.unresolved * 10_000 <= tally.rays, "{at}");
        // A picture without hits or without misses proves little.
        assert!(tally.misses > 100, "{at}");
        let hits = tally.roots + tally.tangents;
        assert!(hits > 20, "{at}");
    }
    let differences = outcome.differences.join("\n");
    assert_eq!(outcome.contradictions, 0, "{name}: {differences}");
    let rays = outcome.paths[0].1.rays;
    let few = outcome.differences.len() as u64 * 100_000 <= rays;
    assert!(few, "{name}: {differences}");
}

/// Every interval is as narrow as is promised.
fn narrow(outcomes: &[Outcome]) {
    let mut wide = Vec::new();
    for outcome in outcomes {
        for (path, tally) in &outcome.paths {
            if tally.widest > WIDEST {
                let examples = tally.examples.join("\n");
                wide.push(format!("{}; {path}: {tally}\n{examples}", outcome.name));
            }
        }
    }
    assert!(wide.is_empty(), "{}", wide.join("\n"));
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
    narrow(&outcomes);
}

#[test]
fn sums_of_exponentials() {
    narrow(&check(&gallery::sums(1..=8)));
}
