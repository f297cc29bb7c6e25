//! Which rows of a surface's tables matter in a beam.
//!
//! A row is left out where its terms are lost beside the others', or where another row's number is certainly less than its
//! own. What the rows that are left out add is enclosed, and added wherever the list is used. Where only the sign of a minimum
//! matters, a row is left out where its number is certainly positive: of a union of a thousand balls, what is near a beam.

mod sum;
#[cfg(test)]
mod tests;
mod told;

use std::ops::Range;

use crate::surface::{Active, Regions, Rest};
use sum::Sum;
use told::{Candidate, Decided, Term};

/// Terms that together are less than this part of the greatest at the front are not visited, and in rough looks those
/// below that part: in ascending order.
const LOST: [f64; 2] = [1.0 / (1u64 << 46) as f64, 1.0 / (1u64 << 12) as f64];

/// The terms of all active rows over eight beams.
pub(crate) struct Thin {
    /// The beams that are looked at.
    own: Range<usize>,
    /// Are terms measured only, at the front on the middle ray, to know how large they are where roots are?
    measuring: bool,
    terms: Vec<Term>,
    candidates: Vec<Candidate>,
    choices: Vec<Decided>,
    /// For each choice, the beams in which the first number may be less, and the second.
    may: Vec<[u8; 2]>,
    /// The beams in which a choice was decided that was open, …
    decided: u8,
    /// … and for each region, those in which it is alive then.
    alive: Vec<u8>,
    /// For each sum, the greatest magnitude of a term in each beam, at the front.
    greatest: Vec<[f64; 8]>,
    /// For each minimum, an upper bound of it in each beam, …
    least: Vec<[f64; 8]>,
    /// … and the beams in which a candidate is not certainly positive.
    doubtful: Vec<u8>,
    /// The beams in which f itself is asked for, not only its sign.
    strict: u8,
    /// Those in which a row or a side was left out because of its sign.
    signed: u8,
    /// For each row of each list, how much it matters in each beam: its greatest part of a sum.
    weights: Vec<Vec<[f64; 8]>>,
    /// The steps of each list's rows from which on they are left out in a beam, and in rough looks.
    cuts: Vec<[u32; 2]>,
    /// What the rows of each sum that are left out add, likewise.
    sums: Vec<[Sum; 2]>,
}

impl Default for Thin {
    fn default() -> Self {
        Thin {
            own: 0..8,
            measuring: false,
            terms: Vec::new(),
            candidates: Vec::new(),
            choices: Vec::new(),
            may: Vec::new(),
            decided: 0,
            alive: Vec::new(),
            greatest: Vec::new(),
            least: Vec::new(),
            doubtful: Vec::new(),
            strict: 0,
            signed: 0,
            weights: Vec::new(),
            cuts: Vec::new(),
            sums: Vec::new(),
        }
    }
}

/// The entry of `values` with this index, which is made if it is not there.
fn entry(values: &mut Vec<[f64; 8]>, index: usize, start: f64) -> &mut [f64; 8] {
    if values.len() <= index {
        values.resize(index + 1, [start; 8]);
    }
    &mut values[index]
}

/// Does something for each of these beams: in a loop of known length where they are all eight, as they mostly are.
#[inline(always)]
fn each(own: &Range<usize>, work: impl FnMut(usize)) {
    if *own == (0..8) {
        (0..8).for_each(work);
    } else {
        own.clone().for_each(work);
    }
}

impl Thin {
    /// Looks at these beams from now on; in some f itself is asked for, not only its sign.
    pub fn look_at(&mut self, own: Range<usize>, strict: u8) {
        self.own = own;
        self.strict = strict;
    }

    fn add_measure(&mut self, term: &Term) {
        let greatest = entry(&mut self.greatest, term.sum, 0.0);
        each(&self.own, |lane| {
            greatest[lane] = greatest[lane].max(term.magnitude(lane));
        });
    }

    fn add_candidate(&mut self, candidate: Candidate, hi: [f64; 8]) {
        // An upper bound holds where the number is defined; where it may not be, the row stays.
        let least = entry(&mut self.least, candidate.minimum, f64::INFINITY);
        each(&self.own, |lane| least[lane] = least[lane].min(hi[lane]));
        if self.doubtful.len() <= candidate.minimum {
            self.doubtful.resize(candidate.minimum + 1, 0);
        }
        self.doubtful[candidate.minimum] |= !candidate.positive;
        self.candidates.push(candidate);
    }

    /// Learns how large terms are at the front.
    pub fn measure(&mut self, tell: impl FnOnce(&mut Self)) {
        self.greatest.clear();
        self.measuring = true;
        tell(self);
        self.measuring = false;
    }

    /// Learns how much each row of `active` matters over a piece, and which sides of its choices and regions do.
    pub fn weigh(&mut self, active: &Active, regions: &Regions, tell: impl FnOnce(&mut Self)) {
        self.terms.clear();
        self.candidates.clear();
        self.choices.clear();
        self.least.clear();
        self.doubtful.clear();
        self.signed = 0;
        tell(self);
        self.weigh_rows(active);
        self.decide(active, regions);
    }

    /// What of `active` is still active over this piece of a beam.
    pub fn choose(&mut self, active: &Active, lane: usize, to: &mut Active) {
        to.start_from(active);
        self.cuts.clear();
        for (list, (rows, weights)) in active.rows.iter().zip(&self.weights).enumerate() {
            // Without sums, rows matter or they do not.
            let [lost, rough] = if self.terms.is_empty() {
                [1, 1]
            } else {
                cuts(weights, lane)
            };
            let kept = &mut to.rows[list];
            let steps = || {
                rows.iter()
                    .zip(weights)
                    .map(|(row, w)| (row, step(w[lane])))
            };
            kept.extend(steps().filter(|(_, s)| *s < rough).map(|(row, _)| row));
            to.rough[list] = kept.len();
            if rough < lost {
                let more = steps().filter(|(_, s)| (rough..lost).contains(s));
                kept.extend(more.map(|(row, _)| row));
            }
            self.cuts.push([lost, rough]);
        }
        self.add_rests(lane, &mut to.rest);
        to.by_sign |= self.signed >> lane & 1 != 0;
        if self.decided >> lane & 1 != 0 {
            to.decide(lane, &self.may, &self.alive);
        }
    }

    /// The choices that were open and are decided.
    fn decide(&mut self, active: &Active, regions: &Regions) {
        active.tell_sides(&mut self.may);
        self.decided = 0;
        for decided in &self.choices {
            let may = &mut self.may[decided.choice];
            let strict = if decided.by_sign { self.strict } else { 0 };
            let open = may[0] & may[1] & !strict;
            let first = decided.first & open;
            let second = decided.second & open & !first;
            may[0] &= !second;
            may[1] &= !first;
            self.decided |= first | second;
            if decided.by_sign {
                self.signed |= first | second;
            }
        }
        if self.decided != 0 {
            regions.find(&self.may, &mut self.alive);
        }
    }

    /// What the rows behind the cuts add.
    fn add_rests(&mut self, lane: usize, rests: &mut [Rest]) {
        self.sums.clear();
        self.sums.resize(rests.len(), [Sum::default(); 2]);
        for term in &self.terms {
            let cut = self.cuts[term.row.list];
            let step = step(self.weights[term.row.list][term.row.at][lane]);
            for (sum, cut) in self.sums[term.sum].iter_mut().zip(cut) {
                if step >= cut {
                    sum.add(term.lo[lane], term.hi[lane]);
                }
            }
        }
        for (rest, [all, rough]) in rests.iter_mut().zip(&self.sums) {
            // What was left out before is not visited by a rough look either.
            rest.rough = rough.beside(rest.all);
            rest.all = all.beside(rest.all);
        }
    }

    /// Infinite is what cannot be left out, and 0 what has no part in anything.
    fn weigh_rows(&mut self, active: &Active) {
        self.weights.resize(active.rows.len(), Vec::new());
        for (weights, rows) in self.weights.iter_mut().zip(&active.rows) {
            weights.clear();
            weights.resize(rows.len(), [-1.0; 8]);
        }
        for term in &self.terms {
            let greatest = &self.greatest[term.sum];
            let weights = &mut self.weights[term.row.list][term.row.at];
            each(&self.own, |lane| {
                let part = term.magnitude(lane) / greatest[lane];
                let sure = term.sure >> lane & 1 != 0 && greatest[lane] < f64::INFINITY;
                let nothing = term.magnitude(lane) == 0.0;
                weights[lane] = weights[lane].max(match (sure, nothing) {
                    (true, true) => 0.0,
                    (true, false) if part < f64::INFINITY => part,
                    _ => f64::INFINITY,
                });
            });
        }
        for candidate in &self.candidates {
            let least = &self.least[candidate.minimum];
            let weights = &mut self.weights[candidate.row.list][candidate.row.at];
            let mut beaten = 0;
            each(&self.own, |lane| {
                beaten |= u8::from(least[lane] < candidate.lo[lane]) << lane;
            });
            beaten &= candidate.sure;
            // One whose sign is open stays.
            let spare = candidate.positive & self.doubtful[candidate.minimum] & !self.strict;
            self.signed |= spare & !beaten;
            beaten |= spare;
            each(&self.own, |lane| {
                let part = if beaten >> lane & 1 != 0 {
                    0.0
                } else {
                    f64::INFINITY
                };
                weights[lane] = weights[lane].max(part);
            });
        }
        // Nothing was told about these: all of them stay.
        for weights in self.weights.iter_mut().flatten() {
            each(&self.own, |lane| {
                if weights[lane] < 0.0 {
                    weights[lane] = f64::INFINITY;
                }
            });
        }
    }
}

/// How many steps there are.
const STEPS: usize = 64;

/// The powers of two from 1 down to a weight: up to [`STEPS`].
fn step(weight: f64) -> u32 {
    let exponent = (weight.to_bits() >> 52) as u32;
    1023u32.saturating_sub(exponent).min(STEPS as u32 - 1)
}

/// The first step of those whose weights together are at most each part of [`LOST`].
fn cuts(weights: &[[f64; 8]], lane: usize) -> [u32; 2] {
    let mut sums = [0.0; STEPS];
    for weight in weights {
        sums[step(weight[lane]) as usize] += weight[lane];
    }
    let (mut together, mut first) = (0.0, STEPS);
    LOST.map(|part| {
        while first > 0 && together + sums[first - 1] <= part {
            first -= 1;
            together += sums[first];
        }
        first as u32
    })
}
