//! Which rows are left out of what is told.

use super::told::{Candidate, Term};
use super::*;
use crate::interval::{Arithmetic, Interval, Scalar};
use crate::surface::{Choice, Regions, Row};

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
    let active = Active::everything(&[rows], 2, 0, &Regions::NONE);
    thin.measure(|thin| terms.iter().for_each(|term| thin.add_measure(term)));
    thin.weigh(&active, &Regions::NONE, |thin| thin.terms.extend(terms));
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
    let (active, mut thin) = told(100);
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

#[test]
fn a_minimum_keeps_what_may_be_least() {
    let active = Active::everything(&[4], 0, 0, &Regions::NONE);
    let numbers = [[0.0, 1.0], [0.5, 3.0], [1.5, 2.0], [2.0, 2.5]];
    let mut thin = Thin::default();
    thin.weigh(&active, &Regions::NONE, |thin| {
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
    let mut rows = |lane| {
        let mut chosen = Active::default();
        thin.choose(&active, lane, &mut chosen);
        chosen.rows[0].clone()
    };
    assert_eq!(rows(0), [0, 1]);
    assert_eq!(rows(7), [0, 1, 2, 3]);
}

#[test]
fn of_a_sign_what_is_positive_is_left_out() {
    let active = Active::everything(&[4], 0, 1, &Regions::NONE);
    // In the last beam all are positive; the third row is defined nowhere for certain.
    let lows = [[-1.0, 1.0], [0.5, 0.7], [0.5, 0.7], [0.9, 0.8]];
    let mut thin = Thin::default();
    thin.look_at(0..8, 0b10);
    thin.weigh(&active, &Regions::NONE, |thin| {
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
            first: 0b110,
            second: 0xff,
            by_sign: true,
        });
    });
    let mut chosen = |lane| {
        let mut chosen = Active::default();
        thin.choose(&active, lane, &mut chosen);
        (chosen.rows[0].clone(), chosen.choice(0), chosen.by_sign)
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
    let (active, mut thin) = (
        Active::everything(&[5], 1, 0, &Regions::NONE),
        Thin::default(),
    );
    thin.weigh(&active, &Regions::NONE, |_| ());
    let mut chosen = Active::default();
    thin.choose(&active, 0, &mut chosen);
    assert_eq!(chosen, active);
}
