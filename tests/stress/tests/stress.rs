//! Every hard ray gets its verdict, on every processor path, within the budget.

#![forbid(unsafe_code)]

use zeroset::interval::{Interval, Isa};
use zeroset::verdict::Verdict;
use zeroset_stress::cases::cases;

#[test]
fn every_case_gets_its_verdict_within_the_budget() {
    let mut complaints = Vec::new();
    for case in cases() {
        for isa in Isa::available() {
            let trail = case.run(isa);
            let name = format!("{} on {isa}, {}", case.what, case.formula);
            if let Some(complaint) = case.complaint(&trail) {
                complaints.push(format!("{name}: {complaint}"));
            }
            let spent = trail.evaluations.total();
            if spent > 10_000 {
                complaints.push(format!("{name}: {spent} evaluations"));
            }
        }
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// The control: answers that say less, more or something else are noticed.
#[test]
fn other_answers_are_noticed() {
    let isa = Isa::available()[0];
    for case in cases() {
        let trail = case.run(isa);
        let mut more = trail.clone();
        let t = Interval { lo: 0.0, hi: 1e9 };
        more.events.push(Verdict::Root { t });
        assert!(case.complaint(&more).is_some(), "{}", case.what);
        if let Some(last) = trail.events.last() {
            let mut other = trail.clone();
            other.events.pop();
            let t = last.t().unwrap_or(t);
            let shifted = |x: f64| x + 0.1 * trail.end.unwrap_or(1.0);
            other.events.push(Verdict::Root {
                t: Interval {
                    lo: shifted(t.lo),
                    hi: shifted(t.hi),
                },
            });
            assert!(case.complaint(&other).is_some(), "{}", case.what);
        }
    }
}
