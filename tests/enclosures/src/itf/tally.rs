//! What became of the cases, counted.

use std::collections::BTreeMap;

use zeroset::interval::Interval;

use super::exception::Exception;
use super::plan::{Plan, plan};
use super::{Case, Set};
use crate::backend::Backend;
use crate::fixture::steps;

/// A range may be this many doubles wider than the tightest one, on either side, without a listed reason.
pub const EXCESS: u64 = 4;

/// What became of the cases of one operation on one back-end.
#[derive(Debug, Default)]
pub struct Tally {
    /// How many were run.
    pub run: usize,
    /// Those whose range does not hold the tightest one.
    pub wrong: Vec<String>,
    /// The most doubles by which a range was wider, exceptions aside.
    pub excess: u64,
    /// Those that were wider than [`EXCESS`] without a reason.
    pub too_wide: Vec<String>,
    /// The others that were, by reason: how many, and by how much at most.
    pub excepted: BTreeMap<&'static str, (usize, u64)>,
}

/// The cases of each operation on one back-end.
pub fn tally(backend: Backend, cases: &[Case]) -> BTreeMap<&str, Tally> {
    let mut all: BTreeMap<&str, Tally> = BTreeMap::new();
    for case in cases {
        all.entry(&case.name).or_default().run(backend, case);
    }
    all
}

impl Tally {
    fn run(&mut self, backend: Backend, case: &Case) {
        match plan(case) {
            Plan::Skip(_) => return,
            Plan::Run(operation, a, b) => {
                let outcome = backend.one(operation, a, b);
                let found = (!outcome.empty).then_some(outcome.range);
                self.compare(backend, case, &case.results[0], found);
            }
            Plan::Divide(num, den) => {
                let q = backend.divide(num, den);
                let first = (!q.empty).then_some(q.first);
                // One piece may stand for both.
                let second = if q.two { Some(q.second) } else { first };
                let none = Set::Empty;
                let expected = case.results.get(1).unwrap_or(&none);
                self.compare(backend, case, &case.results[0], first);
                self.compare(backend, case, expected, second);
            }
        }
        self.run += 1;
    }

    /// Takes note of one expected set; `found` is None for no number.
    fn compare(&mut self, backend: Backend, case: &Case, expected: &Set, found: Option<Interval>) {
        let (tight, found) = match (expected, found) {
            // Everything holds the empty set.
            (Set::Empty, _) => return,
            (Set::Some(tight), Some(found)) if found.encloses(tight) => (*tight, found),
            _ => {
                let what = format!(
                    "{}: {} gave {found:?}, not {expected:?}",
                    case.place, case.name
                );
                return self.wrong.push(what);
            }
        };
        let between = |lo, hi| steps(Interval { lo, hi });
        let excess = between(found.lo, tight.lo).max(between(tight.hi, found.hi));
        if excess <= EXCESS {
            self.excess = self.excess.max(excess);
        } else if let Some(exception) = Exception::find(backend.name(), case, tight, excess) {
            let entry = self.excepted.entry(exception.reason).or_default();
            *entry = (entry.0 + 1, entry.1.max(excess));
        } else {
            self.too_wide.push(format!(
                "{}: {} gave {found:?}, {excess} ulp wider than {tight:?}",
                case.place, case.name
            ));
        }
    }
}

/// A back-end and its tallies.
pub type Column<'a> = (Backend, BTreeMap<&'a str, Tally>);

/// Parsed, run and skipped per operation, the excess on each back-end, and why cases were skipped; then the exceptions.
pub fn table(cases: &[Case], columns: &[Column]) -> String {
    let mut text = format!(
        "{:<18}{:>7}{:>7}{:>8}",
        "excess in ulp", "parsed", "run", "skipped"
    );
    for (backend, _) in columns {
        text += &format!("{:>10}", backend.name());
    }
    let (mut parsed, mut run) = (0, 0);
    for (name, first) in &columns[0].1 {
        let of: Vec<&Case> = cases.iter().filter(|case| case.name == *name).collect();
        let skipped = of.len() - first.run;
        text += &format!("\n{name:<18}{:>7}{:>7}{skipped:>8}", of.len(), first.run);
        for (_, tallies) in columns {
            text += &format!("{:>10}", shown(&tallies[name]));
        }
        text += &skips(&of);
        (parsed, run) = (parsed + of.len(), run + first.run);
    }
    text += &format!("\n{:<18}{parsed:>7}{run:>7}{:>8}", "all", parsed - run);
    text + &exceptions(columns)
}

/// The excess; with a `+` if there were exceptions.
fn shown(tally: &Tally) -> String {
    match tally.run {
        0 => "-".to_owned(),
        _ if tally.excepted.is_empty() => tally.excess.to_string(),
        _ => format!("{}+", tally.excess),
    }
}

fn skips(cases: &[&Case]) -> String {
    let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
    for case in cases {
        if let Plan::Skip(reason) = plan(case) {
            *reasons.entry(reason).or_default() += 1;
        }
    }
    let each = |(reason, count)| format!("  {count}: {reason}");
    reasons.into_iter().map(each).collect()
}

fn exceptions(columns: &[Column]) -> String {
    let mut found: BTreeMap<(&str, &str), String> = BTreeMap::new();
    for (backend, tallies) in columns {
        for (name, tally) in tallies {
            for (reason, (count, most)) in &tally.excepted {
                let most = if *most < 1 << 20 {
                    format!(" by {most} at most")
                } else {
                    String::new()
                };
                let line = format!(" {} {count}{most};", backend.name());
                *found.entry((name, reason)).or_default() += &line;
            }
        }
    }
    let each =
        |((name, reason), counts)| format!("\nwider than {EXCESS} ulp: {name}:{counts} {reason}");
    found.into_iter().map(each).collect()
}
