//! Solids against the same solids written with min and max in one formula; coincident, touching and undefined operands;
//! what is skipped; areas, volumes and budgets.

// Documentation of these surfaces stands in their formulas.
#![allow(missing_docs)]

mod areas;
mod budget;
mod compare;
mod pairs;
#[path = "../support/random.rs"]
mod random;
mod rays;
mod volumes;

use compare::{SIZE, Tally};
use pairs::pairs;
use zeroset::{Options, render};

/// Every solid against its formula, in a picture and along whole rays. Then the control: the same operands, put together
/// in another way, must be found out.
#[test]
fn solids_are_what_their_formulas_say() {
    let mut count = 0;
    for pair in pairs() {
        count += 1;
        let pictures = Tally::of_pictures(&pair.solid, &pair.formula);
        let lists = Tally::of_lists(&pair.solid, &pair.formula);
        for (what, tally) in [("picture", &pictures), ("lists", &lists)] {
            println!(
                "{:28} {what:8} certain {:4} (hit {:4}) open {:4}",
                pair.name, tally.certain, tally.hit, tally.open
            );
            assert!(
                tally.refuted.is_empty(),
                "{}, {what}, {} rays:\n{}",
                pair.name,
                tally.refuted.len(),
                tally.refuted[0]
            );
        }
        let picture = render(&pair.solid, &compare::camera(), &Options::new(SIZE, SIZE));
        let statistics = picture.expect("a valid scene").statistics().clone();
        let open = statistics.rays - statistics.root - statistics.miss;
        assert!(open <= u64::from(pair.open), "{}: {statistics}", pair.name);
        assert!(pictures.hit > 40, "{}: {pictures:?}", pair.name);
        let wrong = Tally::of_pictures(&pair.wrong, &pair.formula);
        assert!(wrong.refuted.len() > 20, "control {}: {wrong:?}", pair.name);
    }
    assert!(count >= 10);
}

/// A picture tells what was not searched: two balls in opposite corners matter to few rays. With beams most rays are not
/// even made, and on those that are one operand is spared.
#[test]
fn operands_that_cannot_matter_are_not_searched() {
    let mut options = Options::new(192, 192);
    for beams in [true, false] {
        options.settings.beams = beams;
        let picture = render(&pairs::apart(), &compare::camera(), &options).expect("a valid scene");
        let statistics = picture.statistics();
        let counts = statistics.evaluations;
        let made = statistics.made;
        assert!(
            counts.spared > made / 2 && statistics.root > 500,
            "{statistics}"
        );
        if beams {
            assert!(made < statistics.rays / 4, "{statistics}");
        } else {
            assert!(
                made == statistics.rays && counts.shortened > 0,
                "{statistics}"
            );
        }
    }
}
