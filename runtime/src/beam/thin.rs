//! Which rows of a surface's tables matter in a beam.
//!
//! A row is left out where its terms are lost beside the others', or where another row's number is certainly less than its
//! own. What the rows that are left out add is enclosed, and added wherever the list is used. Where only the sign of a minimum
//! matters, a row is left out where its number is certainly positive: of a union of a thousand balls, what is near a beam.

use std::ops::Range;

use crate::interval::{Arithmetic, Flags, Interval, Packet, Scalar, Truth};
use crate::surface::{Active, Choice, Rest, Row, Terms};

/// Terms that together are less than this part of the greatest at the front are not visited, and in rough looks those
/// below that part.
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
    /// For each sum, the greatest magnitude of a term in each beam, at the front.
    greatest: Vec<[f64; 8]>,
    /// For each minimum, an upper bound of it in each beam, …
    least: Vec<[f64; 8]>,
    /// … and the beams in which a candidate is not certainly positive.
    doubtful: Vec<u8>,
    /// The beams in which f itself is asked for, not only its sign.
    strict: u8,
    /// Those in which a row was left out because of its sign.
    signed: u8,
    /// For each row of each list, how much it matters in each beam: its greatest part of a sum.
    weights: Vec<Vec<[f64; 8]>>,
}

impl Default for Thin {
    fn default() -> Self {
        Thin {
            own: 0..8,
            measuring: false,
            terms: Vec::new(),
            candidates: Vec::new(),
            choices: Vec::new(),
            greatest: Vec::new(),
            least: Vec::new(),
            doubtful: Vec::new(),
            strict: 0,
            signed: 0,
            weights: Vec::new(),
        }
    }
}

struct Term {
    row: Row,
    sum: usize,
    lo: [f64; 8],
    hi: [f64; 8],
    /// Beams in which it is certainly defined and smooth.
    sure: u8,
}

struct Candidate {
    row: Row,
    minimum: usize,
    lo: [f64; 8],
    /// Beams in which it is certainly defined, …
    sure: u8,
    /// … and positive, if the sign is all that matters.
    positive: u8,
}

/// A choice, and the beams in which either number is certainly less, or does for the sign.
struct Decided {
    choice: usize,
    sides: [(u8, Choice); 2],
    by_sign: bool,
}

impl Decided {
    fn new<P: Packet>(
        p: P,
        choice: usize,
        [first, second]: [Truth<P>; 2],
        flags: &Flags<P>,
        by_sign: bool,
    ) -> Self {
        // A side that is left out must be defined, for a minimum is undefined where either number is.
        let sure = !p.bits(p.or(flags.undefined, flags.empty));
        let (first, second) = (p.bits(first.yes) & sure, p.bits(second.yes) & sure);
        Decided {
            choice,
            sides: [(first, Choice::First), (second, Choice::Second)],
            by_sign,
        }
    }
}

impl Term {
    fn magnitude(&self, lane: usize) -> f64 {
        self.lo[lane].abs().max(self.hi[lane].abs())
    }
}

impl<P: Packet + Arithmetic<Packet = P, Value = Interval<P::F>>> Terms<P> for (P, &mut Thin) {
    #[inline(always)]
    fn term(&mut self, row: Row, sum: usize, term: Interval<P::F>, flags: Flags<P>) {
        let p = self.0;
        let smooth = p.and_not(flags.sound(p), flags.kink);
        let term = Term {
            row,
            sum,
            lo: p.to_array(term.lo),
            hi: p.to_array(term.hi),
            sure: p.bits(smooth),
        };
        match self.1.measuring {
            true => self.1.add_measure(&term),
            false => self.1.terms.push(term),
        }
    }

    #[inline(always)]
    fn candidate(
        &mut self,
        row: Row,
        minimum: usize,
        number: Interval<P::F>,
        flags: Flags<P>,
        by_sign: bool,
    ) {
        let p = self.0;
        if self.1.measuring {
            return;
        }
        let sure = !p.bits(p.or(flags.undefined, flags.empty));
        let positive = sure & p.bits(p.lt(p.splat(0.0), number.lo));
        let candidate = Candidate {
            row,
            minimum,
            lo: p.to_array(number.lo),
            sure,
            positive: if by_sign { positive } else { 0 },
        };
        self.1.add_candidate(candidate, p.to_array(number.hi));
    }

    #[inline(always)]
    fn choice(&mut self, choice: usize, less: [Truth<P>; 2], flags: Flags<P>) {
        if !self.1.measuring {
            let decided = Decided::new(self.0, choice, less, &flags, false);
            self.1.choices.push(decided);
        }
    }

    #[inline(always)]
    fn by_sign(&mut self, choice: usize, alone: [Truth<P>; 2], flags: Flags<P>) {
        if !self.1.measuring {
            let decided = Decided::new(self.0, choice, alone, &flags, true);
            self.1.choices.push(decided);
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

    /// Learns how much each row of `active` matters over a piece.
    pub fn weigh(&mut self, active: &Active, tell: impl FnOnce(&mut Self)) {
        self.terms.clear();
        self.candidates.clear();
        self.choices.clear();
        self.least.clear();
        self.doubtful.clear();
        self.signed = 0;
        tell(self);
        self.weigh_rows(active);
    }

    /// What of `active` is still active over this piece of a beam.
    pub fn choose(&self, active: &Active, lane: usize, to: &mut Active) {
        to.clone_from(active);
        for rest in &mut to.rest {
            rest.rough = rest.all;
        }
        let mut cuts = Vec::with_capacity(active.rows.len());
        for (list, (rows, weights)) in active.rows.iter().zip(&self.weights).enumerate() {
            let [lost, rough] = LOST.map(|part| cut(weights, lane, part));
            let kept = &mut to.rows[list];
            kept.clear();
            let steps = || {
                rows.iter()
                    .zip(weights)
                    .map(|(row, w)| (row, step(w[lane])))
            };
            kept.extend(steps().filter(|(_, s)| *s < rough).map(|(row, _)| row));
            to.rough[list] = kept.len();
            kept.extend(
                steps()
                    .filter(|(_, s)| (rough..lost).contains(s))
                    .map(|(row, _)| row),
            );
            cuts.push([lost, rough]);
        }
        self.add_rests(lane, &cuts, &mut to.rest);
        to.by_sign |= self.signed >> lane & 1 != 0;
        let strict = self.strict >> lane & 1 != 0;
        for decided in &self.choices {
            if to.choices[decided.choice] != Choice::Open || decided.by_sign && strict {
                continue;
            }
            let mut sides = decided.sides.iter();
            if let Some((_, side)) = sides.find(|(beams, _)| beams >> lane & 1 != 0) {
                to.choices[decided.choice] = *side;
                to.by_sign |= decided.by_sign;
            }
        }
    }

    /// What the rows behind the cuts add.
    fn add_rests(&self, lane: usize, cuts: &[[u32; 2]], rests: &mut [Rest]) {
        let mut sums = vec![[Sum::default(); 2]; rests.len()];
        for term in &self.terms {
            let cut = cuts[term.row.list];
            let step = step(self.weights[term.row.list][term.row.at][lane]);
            for (sum, cut) in sums[term.sum].iter_mut().zip(cut) {
                if step >= cut {
                    sum.add(term.lo[lane], term.hi[lane]);
                }
            }
        }
        for (rest, [all, rough]) in rests.iter_mut().zip(&sums) {
            rest.all = all.beside(rest.all);
            rest.rough = rough.beside(rest.rough);
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

/// A sum of intervals in plain floats: there are many, and they are small.
#[derive(Clone, Copy, Default)]
struct Sum {
    lo: f64,
    hi: f64,
    /// The sum of magnitudes.
    size: f64,
    count: u32,
}

impl Sum {
    #[inline(always)]
    fn add(&mut self, lo: f64, hi: f64) {
        self.lo += lo;
        self.hi += hi;
        self.size += lo.abs().max(hi.abs());
        self.count += 1;
    }

    /// The sum and another interval. Adding n numbers up loses less than nu of the sum of their magnitudes, u = 2⁻⁵³, and
    /// nothing to underflow; twice that and more covers the roundings of the bound.
    fn beside(&self, other: Interval) -> Interval {
        if self.count == 0 {
            return other;
        }
        let lost = self.size * (f64::from(self.count) + 2.0) * f64::EPSILON + f64::MIN_POSITIVE;
        if !lost.is_finite() {
            return Interval {
                lo: f64::NEG_INFINITY,
                hi: f64::INFINITY,
            };
        }
        let lost = Interval {
            lo: -lost,
            hi: lost,
        };
        let (lo, hi) = (self.lo, self.hi);
        Scalar.add(Scalar.add(Interval { lo, hi }, lost), other)
    }
}

/// How many steps there are.
const STEPS: usize = 64;

/// The powers of two from 1 down to a weight: up to [`STEPS`].
fn step(weight: f64) -> u32 {
    let exponent = (weight.to_bits() >> 52) as u32;
    1023u32.saturating_sub(exponent).min(STEPS as u32 - 1)
}

/// The first step of those whose weights together are at most `part`.
fn cut(weights: &[[f64; 8]], lane: usize, part: f64) -> u32 {
    let mut sums = [0.0; STEPS];
    for weight in weights {
        sums[step(weight[lane]) as usize] += weight[lane];
    }
    let mut together = 0.0;
    let fits = |sum: &&f64| {
        together += **sum;
        together <= part
    };
    (STEPS - sums.iter().rev().take_while(fits).count()) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Terms of many sizes over eight beams, always the same; and one whose row may be undefined.
    fn told(rows: usize) -> (Active, Thin) {
        let (mut thin, mut state) = (Thin::default(), 1u64);
        let mut random = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut term = |at: usize, sum: usize| {
            let lo = [0; 8].map(|_| (random() - 0.5) * (-60.0 * random()).exp2());
            Term {
                row: Row { list: 0, at },
                sum,
                lo,
                hi: lo.map(|lo| lo + lo.abs() * random()),
                sure: if at == 3 { 0 } else { !0 },
            }
        };
        let terms: Vec<Term> = (0..rows)
            .flat_map(|at| [term(at, 0), term(at, 1)])
            .collect();
        let active = Active::everything(&[rows], 2, 0);
        thin.measure(|thin| terms.iter().for_each(|term| thin.add_measure(term)));
        thin.weigh(&active, |thin| thin.terms.extend(terms));
        (active, thin)
    }

    /// What the rows of a list, and the rest, say of a sum.
    fn total(thin: &Thin, chosen: &Active, lane: usize, sum: usize, rough: bool) -> Interval {
        let visited = &chosen.rows[0][..chosen.visited(0, rough)];
        let terms = thin
            .terms
            .iter()
            .filter(|term| term.sum == sum && visited.contains(&(term.row.at as u32)));
        let parts = terms.map(|term| Interval {
            lo: term.lo[lane],
            hi: term.hi[lane],
        });
        parts.fold(*chosen.rest(sum, rough), |sum, term| Scalar.add(sum, term))
    }

    #[test]
    fn what_is_left_out_is_in_the_rest() {
        let (active, thin) = told(100);
        let (mut left_out, mut missed) = (0, 0);
        for lane in 0..8 {
            let mut chosen = Active::default();
            thin.choose(&active, lane, &mut chosen);
            assert!(chosen.rows[0].contains(&3), "it may be undefined");
            left_out += 100 - chosen.rows[0].len();
            assert!(chosen.visited(0, true) < chosen.visited(0, false));
            for (sum, rough) in [(0, false), (0, true), (1, false), (1, true)] {
                let (all, some) = (
                    total(&thin, &active, lane, sum, false),
                    total(&thin, &chosen, lane, sum, rough),
                );
                assert!(
                    some.lo <= all.hi && all.lo <= some.hi,
                    "{some:?} and {all:?}"
                );
                let noise = LOST[usize::from(rough)] * thin.greatest[sum][lane] + 1e-14;
                assert!(some.hi - some.lo <= all.hi - all.lo + 2.0 * noise);
                // The control: without the rest rough looks are wrong.
                let mut poor = chosen.clone();
                poor.rest = active.rest.clone();
                let poor = total(&thin, &poor, lane, sum, rough);
                missed += usize::from(rough && (poor.lo > all.lo || poor.hi < all.hi));
            }
        }
        assert!(left_out > 20, "{left_out}");
        assert!(missed > 8, "{missed}");
    }

    /// 1 and 1,024 numbers of a quarter of an ulp each: in plain floats they are 1.
    #[test]
    fn what_plain_sums_lose_is_in_their_bounds() {
        let small = 0.25 * f64::EPSILON;
        let mut sum = Sum::default();
        sum.add(1.0, 1.0);
        (0..1024).for_each(|_| sum.add(small, small));
        let exact = 1.0 + 1024.0 * small;
        assert!(sum.lo < exact, "the control: nothing is lost");
        let nothing = Interval { lo: 0.0, hi: 0.0 };
        let bounds = sum.beside(nothing);
        assert!(
            bounds.contains(exact) && bounds.width() < 1e-12,
            "{bounds:?}"
        );
        sum.add(f64::MAX, f64::MAX);
        sum.add(-f64::MAX, f64::MAX);
        let bounds = sum.beside(nothing);
        assert!(bounds.lo == f64::NEG_INFINITY && bounds.hi == f64::INFINITY);
    }

    #[test]
    fn a_minimum_keeps_what_may_be_least() {
        let active = Active::everything(&[4], 0, 0);
        let numbers = [[0.0, 1.0], [0.5, 3.0], [1.5, 2.0], [2.0, 2.5]];
        let mut thin = Thin::default();
        thin.weigh(&active, |thin| {
            for (at, [lo, hi]) in numbers.into_iter().enumerate() {
                let candidate = Candidate {
                    row: Row { list: 0, at },
                    minimum: 0,
                    lo: [lo; 8],
                    // In the last beam nothing is certainly defined.
                    sure: 0x7f,
                    positive: 0,
                };
                thin.add_candidate(candidate, [hi; 8]);
            }
        });
        let rows = |lane| {
            let mut chosen = Active::default();
            thin.choose(&active, lane, &mut chosen);
            chosen.rows[0].clone()
        };
        assert_eq!(rows(0), [0, 1]);
        assert_eq!(rows(7), [0, 1, 2, 3]);
    }

    #[test]
    fn of_a_sign_what_is_positive_is_left_out() {
        let active = Active::everything(&[4], 0, 1);
        // In the last beam all are positive; the third row is defined nowhere for certain.
        let lows = [[-1.0, 1.0], [0.5, 0.7], [0.5, 0.7], [0.9, 0.8]];
        let mut thin = Thin::default();
        thin.look_at(0..8, 0b10);
        thin.weigh(&active, |thin| {
            for (at, [most, last]) in lows.into_iter().enumerate() {
                let mut lo = [most; 8];
                lo[7] = last;
                let sure = if at == 2 { 0x80 } else { 0xff };
                let positive = (0..8).filter(|k| lo[*k] > 0.0);
                let candidate = Candidate {
                    row: Row { list: 0, at },
                    minimum: 0,
                    lo,
                    sure,
                    positive: sure & positive.fold(0, |bits, k| bits | 1 << k),
                };
                thin.add_candidate(candidate, [2.0; 8]);
            }
            thin.choices.push(Decided {
                choice: 0,
                sides: [(0b110, Choice::First), (0xff, Choice::Second)],
                by_sign: true,
            });
        });
        let chosen = |lane| {
            let mut chosen = Active::default();
            thin.choose(&active, lane, &mut chosen);
            (chosen.rows[0].clone(), chosen.choices[0], chosen.by_sign)
        };
        assert_eq!(chosen(0), (vec![0, 2], Choice::Second, true));
        assert_eq!(chosen(2), (vec![0, 2], Choice::First, true));
        // f itself is asked for here.
        assert_eq!(chosen(1), (vec![0, 1, 2, 3], Choice::Open, false));
        // None is left to tell the sign: all stay.
        assert_eq!(chosen(7), (vec![0, 1, 2, 3], Choice::Second, true));
    }

    #[test]
    fn what_nothing_was_told_about_stays() {
        let (active, mut thin) = (Active::everything(&[5], 1, 0), Thin::default());
        thin.weigh(&active, |_| ());
        let mut chosen = Active::default();
        thin.choose(&active, 0, &mut chosen);
        assert_eq!(chosen, active);
    }
}
