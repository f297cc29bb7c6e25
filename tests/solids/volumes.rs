//! Certified volumes against known ones.

use crate::pairs::{Parabola, ball, left};
use std::f64::consts::PI;
use zeroset::Solid;

/// The volume inside a cube of half width 1.5: certain bounds of it, no wider than a share of the cube.
#[track_caller]
fn fills(solid: &Solid, volume: f64, share: f64) {
    let found = solid
        .volume([[-1.5; 3], [1.5; 3]], 6)
        .expect("a valid solid");
    let most = found.inside.hi + found.undecided.hi;
    assert!(
        found.inside.lo <= volume && volume <= most && most - found.inside.lo < share * 27.0,
        "{volume} is not in {found:?}"
    );
    let whole = found.inside.lo + found.outside.lo + found.undecided.lo;
    assert!((whole - 27.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn volumes_hold_the_known_ones() {
    let sphere = 4.0 / 3.0 * PI;
    fills(&!ball(0.0, 1.0), 27.0 - sphere, 0.05);
    fills(&(ball(0.0, 1.0) - ball(0.0, 0.5)), sphere * 0.875, 0.05);
    fills(&(ball(0.0, 1.0) & left(0.0)), sphere / 2.0, 0.05);
    fills(&(left(0.75) - left(-0.75)), 13.5, 0.08);
    // Nothing is left of a set without itself, but its boundary may be.
    fills(&(ball(0.0, 1.0) - ball(0.0, 1.0)), 0.0, 0.09);
}

#[test]
fn what_is_nowhere_defined_is_inside_of_nothing() {
    let found = (Parabola | Parabola)
        .volume([[-2.0; 3], [-1.0; 3]], 2)
        .expect("a valid solid");
    assert_eq!(found.inside.hi, 0.0);
}

#[test]
fn boxes_must_be_boxes() {
    let error = (!left(0.0)).volume([[1.0; 3], [-1.0; 3]], 3);
    assert!(error.expect_err("an empty box").to_string().contains("box"));
}
