//! Many enclosures against brackets: how many miss, and how wide the others are.

use zeroset::interval::Interval;

use crate::backend::{Backend, Operands, Outcome};
use crate::fixture::{Bracket, steps};
use crate::operation::Operation;

/// What was found of one operation on one back-end.
#[derive(Debug, Default)]
pub struct Survey {
    /// Points, each with its exact value.
    pub pairs: usize,
    /// Enclosures of points that do not hold the value.
    pub misses: Vec<String>,
    /// By how many doubles each enclosure of a point reaches beyond the bracket, on the side where it is more.
    pub excess: Vec<u64>,
    /// How many doubles wide each is.
    pub width: Vec<u64>,
    /// Points whose value, or the enclosure of it, overflows or is subnormal: they are in neither list.
    pub tails: usize,
    /// Intervals, each with the values at all points of the sample that are in it.
    pub segments: usize,
    /// Those whose range lacks one of the values.
    pub segment_misses: Vec<String>,
}

/// Is this value, and what was found for it, away from overflow and subnormals? So is its reciprocal, for negative powers.
fn is_ordinary(value: Interval, outcome: &Outcome) -> bool {
    let (least, most) = (
        value.lo.abs().min(value.hi.abs()),
        value.lo.abs().max(value.hi.abs()),
    );
    let finite = outcome.range.lo.is_finite() && outcome.range.hi.is_finite();
    least > 1e-307 && most < 1e307 && finite
}

/// The enclosures of all points; `brackets` in order of their arguments.
pub fn survey(backend: Backend, operation: Operation, brackets: &[Bracket], unary: bool) -> Survey {
    let point = |x| Interval { lo: x, hi: x };
    let operands: Vec<Operands> = brackets
        .iter()
        .map(|b| Operands {
            a: point(b.at[0]),
            b: point(b.at[1]),
        })
        .collect();
    let mut found = Survey {
        pairs: brackets.len(),
        ..Survey::default()
    };
    for (bracket, outcome) in brackets.iter().zip(backend.run(operation, &operands)) {
        let (range, value) = (outcome.range, bracket.value);
        if outcome.empty || !range.encloses(&value) {
            found
                .misses
                .push(format!("{:?}: {value:?} not in {range:?}", bracket.at));
        } else if is_ordinary(value, &outcome) {
            let between = |lo, hi| steps(Interval { lo, hi });
            found
                .excess
                .push(between(range.lo, value.lo).max(between(value.hi, range.hi)));
            found.width.push(steps(range));
        } else {
            found.tails += 1;
        }
    }
    found.excess.sort_unstable();
    found.width.sort_unstable();
    if unary {
        found.survey_segments(backend, operation, brackets);
    }
    found
}

impl Survey {
    /// Every third point starts a segment that ends up to twenty points later.
    fn survey_segments(&mut self, backend: Backend, operation: Operation, brackets: &[Bracket]) {
        let ends = |i: usize| (i, (i + i * 7 % 20).min(brackets.len() - 1));
        let pairs: Vec<(usize, usize)> = (0..brackets.len()).step_by(3).map(ends).collect();
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
        self.segments = pairs.len();
        for (&(i, j), outcome) in pairs.iter().zip(backend.run(operation, &operands)) {
            let missed = |b: &&Bracket| !outcome.range.encloses(&b.value);
            if let Some(b) = brackets[i..=j].iter().find(missed) {
                self.segment_misses.push(format!(
                    "over [{:e}, {:e}]: {:?} at {:e} is not in {:?}",
                    brackets[i].at[0], brackets[j].at[0], b.value, b.at[0], outcome.range
                ));
            }
        }
    }
}

/// The middle one of a sorted list.
pub fn median(sorted: &[u64]) -> u64 {
    sorted.get(sorted.len() / 2).copied().unwrap_or_default()
}
