//! Negative controls: the same pictures with rounding switched off, and by solvers whose proofs lack a condition. If the
//! oracle did not catch them, it would prove nothing about the others.

#![forbid(unsafe_code)]

use zeroset::contract::unsound::{Anywhere, Signless};
use zeroset::contract::{Auto, Contractor, Halley, HalleyQuotient, Newton, Tightened};
use zeroset::interval::Isa;
use zeroset_oracle::gallery;
use zeroset_oracle::picture::paths;

#[test]
fn answers_without_rounding_are_refuted() {
    let paths = Isa::unrounded();
    assert!(!paths.is_empty());
    let mut caught = vec![0; paths.len()];
    for picture in gallery::controls() {
        let outcome = picture.check(96, &paths);
        for (count, (path, tally)) in caught.iter_mut().zip(&outcome.paths) {
            println!("{}; {path}: {tally}", outcome.name);
            *count += tally.wrong;
        }
    }
    for (count, isa) in caught.iter().zip(&paths) {
        println!("{isa}: {count} answers refuted");
        assert!(*count > 0, "{isa}: nothing refuted");
    }
}

/// Answers that are refuted, over all processor paths.
fn refuted<C: Contractor>() -> u64 {
    let outcomes = gallery::by::<C>().into_iter().map(|picture| {
        let outcome = picture.check(64, &paths());
        println!(
            "{}, {}: {} answers refuted",
            C::NAME,
            outcome.name,
            outcome.wrong()
        );
        outcome.wrong()
    });
    outcomes.sum()
}

#[test]
fn sound_solvers_are_not_refuted() {
    assert_eq!(refuted::<Auto>(), 0);
    assert_eq!(refuted::<Newton>(), 0);
    assert_eq!(refuted::<Tightened>(), 0);
    assert_eq!(refuted::<Halley>(), 0);
    assert_eq!(refuted::<HalleyQuotient>(), 0);
}

/// 1/x − 5 falls wherever it is defined, and is negative on both sides of the pole and the root.
#[test]
fn a_derivative_where_f_is_undefined_is_refuted() {
    assert!(refuted::<Anywhere>() > 1000);
}

#[test]
fn a_root_without_opposite_signs_is_refuted() {
    assert!(refuted::<Signless>() > 1000);
}
