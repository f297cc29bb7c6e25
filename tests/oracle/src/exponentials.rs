//! The oracle for sums of exponentials.

use zeroset::camera::Ray;
use zeroset::verdict::{Answer, Verdict};

use crate::dyadic::{Dyadic, Rational};
use crate::judge::{Finding, Oracle, judge_each};
use crate::search::{Search, Truth};
use crate::segment::{Corners, clip};
use crate::sum::{Along, Row, Sum};
use crate::wide::Wide;

/// Negative definite quadratic forms around centres; with more terms they are narrower. Always the same for a seed.
pub fn random(seed: u64, terms: usize) -> Sum {
    let mut state = seed;
    let mut number = |from: f64, to: f64| {
        // Knuth's MMIX generator, upper bits.
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        from + (to - from) * (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let narrow = match terms {
        0..=1 => 3.0,
        2..=8 => 8.0,
        _ => 15.0,
    };
    for _ in 0..10 {
        number(0.0, 1.0);
    }
    let mut row = || -> Row {
        let mut row = [0.0; 9];
        row[..3].fill_with(|| number(-0.7, 0.7));
        row[3..6].fill_with(|| narrow * number(1.0, 3.0));
        // The form is diagonally dominant: each row of its matrix has two halves of these.
        row[6..].fill_with(|| narrow * number(-0.5, 0.5));
        row
    };
    Sum {
        rows: (0..terms).map(|_| row()).collect(),
        level: 0.5,
    }
}

impl Oracle for Sum {
    fn judge(&self, ray: &Ray, corners: &Corners, answers: &[Answer]) -> Vec<Finding> {
        let Some((near, far)) = clip(ray, corners) else {
            return judge_each(answers, |answer| match answer.first {
                Verdict::Miss => Finding::Right,
                _ => Finding::Undecided("a ray beside the box".into()),
            });
        };
        let base = near.below();
        let origin = Dyadic::float(base);
        // Both ends are rounded into the segment: what lies within an ulp or two of the box's faces is not judged.
        let (from, to) = (near.minus(&origin).above(), far.minus(&origin).below());
        if from >= to {
            return judge_each(answers, |_| {
                Finding::Undecided("a corner of the box".into())
            });
        }
        let along = self.along(ray, base, to);
        let truth = Search::first_root(&along, from, to);
        let judge = Judge {
            along: &along,
            near: &near,
            ends: [from, to],
            truth,
        };
        judge_each(answers, |answer| judge.answer(answer))
    }
}

struct Judge<'a> {
    along: &'a Along<'a>,
    near: &'a Rational,
    ends: [f64; 2],
    truth: Truth,
}

fn wrong(why: &str) -> Finding {
    Finding::Wrong(why.into())
}

fn undecided(why: &str) -> Finding {
    Finding::Undecided(why.into())
}

impl Judge<'_> {
    fn answer(&self, answer: &Answer) -> Finding {
        let Some(t) = answer.first.t() else {
            return match self.truth {
                Truth::Free => Finding::Right,
                Truth::Root { .. } => wrong("called a miss, has a root"),
                Truth::Open { .. } => undecided("a miss"),
            };
        };
        let entry = Rational::dyadic(&Dyadic::float(answer.entry));
        if entry.compare(self.near).is_gt() {
            return wrong("the entry lies behind the box's face");
        }
        let (lo, hi) = (self.place(answer, t.lo), self.place(answer, t.hi));
        let first = match answer.first {
            Verdict::Root { .. } => self.root(lo, hi),
            Verdict::Crossing { .. } => self.crossing(lo, hi),
            _ => self.nothing_before(lo),
        };
        if first != Finding::Right {
            return first;
        }
        match answer.behind.and_then(|v| v.t()) {
            None => Finding::Right,
            Some(t) => self.behind(self.place(answer, t.lo), self.place(answer, t.hi)),
        }
    }

    /// entry + t − base, exactly: the entry and the base are neighbours, or the same.
    fn place(&self, answer: &Answer, t: f64) -> Wide {
        Wide::new(answer.entry) - Wide::new(self.along.base) + Wide::new(t)
    }

    /// Exactly one root in [lo, hi], none before.
    fn root(&self, lo: Wide, hi: Wide) -> Finding {
        match self.truth {
            Truth::Free if hi.hi >= self.ends[1] || lo.hi <= self.ends[0] => {
                undecided("a root on a face of the box")
            }
            Truth::Free => wrong("called a root, is a miss"),
            Truth::Open { .. } => undecided("a root"),
            Truth::Root {
                lo: from,
                hi: to,
                before,
            } => {
                // Ends that lie outside of the bracket are replaced by the bracket's: f has the same sign there.
                let left = if lo.hi <= from {
                    Some(before)
                } else {
                    self.along.sign(lo)
                };
                let right = self.along.sign(hi);
                match (left, right) {
                    _ if lo.hi > to => wrong("the first root lies before"),
                    _ if hi.hi < from => wrong("no root in the interval"),
                    _ if hi.hi > to => undecided("an interval wider than the oracle's"),
                    (Some(left), Some(right)) if left * right > 0 => wrong(if left == before {
                        "the root lies behind the interval"
                    } else {
                        "the root lies before the interval"
                    }),
                    (Some(_), Some(_)) => Finding::Right,
                    _ => undecided("a sign"),
                }
            }
        }
    }

    /// A change of sign in [lo, hi], no root before.
    fn crossing(&self, lo: Wide, hi: Wide) -> Finding {
        match (self.along.sign(lo), self.along.sign(hi)) {
            (Some(left), Some(right)) if left * right > 0 => wrong("no change of sign"),
            (Some(_), Some(_)) => self.nothing_before(lo),
            _ => undecided("a sign"),
        }
    }

    /// No root before lo.
    fn nothing_before(&self, lo: Wide) -> Finding {
        match self.truth {
            Truth::Free => Finding::Right,
            Truth::Open { from } if lo.hi <= from => Finding::Right,
            Truth::Open { .. } => undecided("what lies before an open piece"),
            Truth::Root { lo: from, .. } if lo.hi <= from => Finding::Right,
            Truth::Root { hi: to, .. } if lo.hi > to => wrong("a root before an open piece"),
            Truth::Root { before, .. } => match self.along.sign(lo) {
                Some(sign) if sign == -before => wrong("a root before an open piece"),
                Some(_) => Finding::Right,
                None => undecided("a sign"),
            },
        }
    }

    /// A certain root behind an open piece: a change of sign.
    fn behind(&self, lo: Wide, hi: Wide) -> Finding {
        match (self.along.sign(lo), self.along.sign(hi)) {
            (Some(left), Some(right)) if left * right > 0 => wrong("no change of sign behind"),
            (Some(_), Some(_)) => Finding::Right,
            _ => undecided("a sign"),
        }
    }
}
