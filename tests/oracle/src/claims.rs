//! What every picture must keep.

use crate::picture::Outcome;
use crate::tally::WIDEST;

/// The claims that a picture breaks, in words; nothing if it keeps them all:
///
/// - no answer is wrong, and the oracle can judge all of them;
/// - at most 1 ray in 10,000 is unresolved;
/// - no root's interval is wider than [`WIDEST`];
/// - no ray is a miss on one path and a root on another, and the paths differ on at most 1 ray in 100,000.
pub fn broken(outcome: &Outcome) -> Vec<String> {
    let mut all = Vec::new();
    for (path, tally) in &outcome.paths {
        let mut claim = |kept: bool, what: String| {
            if !kept {
                all.push(format!("{}; {path}: {what}", outcome.name));
            }
        };
        claim(tally.wrong == 0, format!("{} wrong", tally.wrong));
        claim(
            tally.undecided == 0,
            format!("{} undecided by the oracle", tally.undecided),
        );
        claim(
            tally.unresolved * 10_000 <= tally.rays,
            format!("{} of {} unresolved", tally.unresolved, tally.rays),
        );
        claim(
            tally.wide == 0,
            format!("{} roots wider than {WIDEST:e}", tally.wide),
        );
    }
    if outcome.contradictions > 0 {
        all.push(format!(
            "{}: {} rays are a miss on one path and a root on another",
            outcome.name, outcome.contradictions
        ));
    }
    let rays = outcome.paths.first().map_or(0, |(_, tally)| tally.rays);
    if outcome.differences.len() as u64 * 100_000 > rays {
        all.push(format!(
            "{}: the paths differ on {} of {rays} rays",
            outcome.name,
            outcome.differences.len()
        ));
    }
    all
}
