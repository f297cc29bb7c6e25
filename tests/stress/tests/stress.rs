//! Every hard ray gets its verdict, on every processor path, within the budget.

#![forbid(unsafe_code)]

use zeroset::interval::{Interval, Isa};
use zeroset::solve::Settings;
use zeroset::verdict::{Verdict, Why};
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

/// What a jump over a turn, or a cubic through two places, saves is not lost unnoticed.
#[test]
fn few_evaluations_suffice() {
    let most = [
        ("tangent", 30),
        ("a miss by less than an ulp", 30),
        ("through a node", 30),
        ("a doubled sphere", 60),
    ];
    let (mut seen, mut floats) = (0, 0);
    for case in cases() {
        for isa in Isa::available() {
            let spent = case.run(isa).evaluations;
            if let Some((what, most)) = most.iter().find(|(what, _)| *what == case.what) {
                seen += 1;
                assert!(spent.total() <= *most, "{what} on {isa}: {spent:?}");
            }
            if case.what.starts_with("a shell") {
                floats += 1;
                // For four roots; 12 without the step to a bracket's end, 31 without the cubic.
                assert!(spent.float <= 10, "{} on {isa}: {spent:?}", case.what);
            }
        }
    }
    let paths = Isa::available().len();
    assert_eq!((seen, floats), (most.len() * paths, paths));
}

/// Whatever the budget: it is kept, and what was not searched is open to the end of the ray.
#[test]
fn budgets_are_kept() {
    let isa = Isa::available()[0];
    let mut given_up = 0;
    for budget in [1_000, 1_500, 2_500, 10_000] {
        let settings = Settings {
            budget,
            ..Settings::default()
        };
        for case in cases() {
            let trail = case.run_within(isa, settings);
            let spent = trail.evaluations.total();
            assert!(
                spent <= u64::from(budget),
                "{}: {spent} of {budget}",
                case.what
            );
            let is_rest = |event: &Verdict| {
                matches!(
                    event,
                    Verdict::Unresolved {
                        why: Why::Budget,
                        ..
                    }
                )
            };
            if let Some(at) = trail.events.iter().position(is_rest) {
                given_up += 1;
                assert_eq!(at, trail.events.len() - 1, "{}", case.what);
                let t = trail.events[at].t();
                assert_eq!(t.map(|t| t.hi), trail.end, "{}", case.what);
            }
        }
    }
    assert!(given_up >= 8, "only {given_up} rays were given up");
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
