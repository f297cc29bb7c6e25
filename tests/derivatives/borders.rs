//! Derivatives at the borders of branches and at kinks.

use zeroset::implicit;
use zeroset::interval::{Interval, Scalar};
use zeroset::surface::Surface;

use crate::surfaces::{Sample, Wrapped};

implicit! { #[derive(Clone)] struct Branch; if x < 1 { x^2 + y } else { 3*x + 2*y } }
implicit! { #[derive(Clone)] struct Inner; if x^2 < 1 { if y < 0 { 2*x } else { x*y } } else { z } }
implicit! { #[derive(Clone)] struct Corner; max(x, 2*y) + min(x*x, z) + abs(y - z) }
implicit! { #[derive(Clone)] struct Refused; if x > 1 { ln(x - 1) } else { x } }

/// What is known over a box, and along the line in direction x through its middle.
struct Piece {
    space: [Interval; 4],
    undefined: bool,
    jump: bool,
    kink: bool,
    slope: Interval,
}

fn piece<S: Surface>(surface: S, p: [f64; 3], r: f64) -> Piece {
    let b = p.map(|x| Interval {
        lo: x - r,
        hi: x + r,
    });
    let jet = S::gradient(Scalar, &surface.prepare(), b);
    let t = Interval {
        lo: 0.0,
        hi: 2.0 * r,
    };
    let start = [p[0] - r, p[1], p[2]];
    let [_, slope] = Wrapped(surface).along(start, [1.0, 0.0, 0.0], t).slope;
    Piece {
        space: jet.d,
        undefined: jet.flags.undefined,
        jump: jet.flags.jump,
        kink: jet.flags.kink,
        slope,
    }
}

/// Does the enclosure hold these numbers, and little more?
fn spans(a: Interval, lo: f64, hi: f64) -> bool {
    let near = |x: f64, y: f64| (x - y).abs() <= 1e-9;
    a.lo <= lo && hi <= a.hi && near(a.lo, lo) && near(a.hi, hi)
}

#[test]
fn a_branch_has_its_own_derivative() {
    // Left and right of the border, far and near.
    for (x, fx, fy) in [
        (0.0, 0.0, 1.0),
        (0.75, 1.5, 1.0),
        (1.25, 3.0, 2.0),
        (9.0, 3.0, 2.0),
    ] {
        let at = piece(Branch, [x, 0.5, 0.0], 0.0);
        assert!(!at.jump && !at.kink && !at.undefined, "{x}");
        assert!(
            spans(at.space[1], fx, fx) && spans(at.space[2], fy, fy),
            "{x}"
        );
        assert!(spans(at.slope, fx, fx), "{x}: {:?}", at.slope);
    }
    // On the border the second branch is taken, and the condition is decided.
    let at = piece(Branch, [1.0, 0.5, 0.0], 0.0);
    assert!(!at.jump && spans(at.space[1], 3.0, 3.0) && spans(at.space[0], 4.0, 4.0));
    // Over the border: both, and f may jump (it does, from 1.5 to 4).
    let over = piece(Branch, [1.0, 0.5, 0.0], 0.25);
    assert!(over.jump);
    assert!(
        spans(over.space[1], 1.5, 3.0) && spans(over.space[2], 1.0, 2.0),
        "{:?}",
        over.space
    );
    assert!(spans(over.slope, 1.5, 3.0), "{:?}", over.slope);
    assert!(over.space[0].lo <= 1.5 && over.space[0].hi >= 4.0);
}

#[test]
fn a_branch_in_a_branch_counts_only_where_both_are_open() {
    let at = piece(Inner, [0.5, -0.5, 0.0], 0.25);
    assert!(!at.jump && spans(at.space[1], 2.0, 2.0) && spans(at.space[3], 0.0, 0.0));
    // The inner border.
    let at = piece(Inner, [0.5, 0.0, 0.0], 0.25);
    assert!(at.jump && spans(at.space[1], -0.25, 2.0), "{:?}", at.space);
    // Outside of the outer branch the inner border does not matter.
    let at = piece(Inner, [2.0, 0.0, 0.0], 0.25);
    assert!(!at.jump && spans(at.space[1], 0.0, 0.0) && spans(at.space[3], 1.0, 1.0));
    // Both borders.
    let at = piece(Inner, [1.0, 0.0, 0.0], 0.25);
    assert!(at.jump && spans(at.space[1], -0.25, 2.0), "{:?}", at.space);
    assert!(spans(at.space[3], 0.0, 1.0), "{:?}", at.space);
}

#[test]
fn kinks_have_the_hull_of_both_sides() {
    // max(x, 2y), min(x², z), |y − z|: all decided.
    let at = piece(Corner, [3.0, 1.0, 2.0], 0.125);
    assert!(
        !at.kink && !at.jump && spans(at.space[1], 1.0, 1.0),
        "{:?}",
        at.space
    );
    assert!(
        spans(at.space[2], -1.0, -1.0) && spans(at.space[3], 2.0, 2.0),
        "{:?}",
        at.space
    );
    // At a point on the first border, x = 2y, one side is taken; over a box around it there is the hull.
    let at = piece(Corner, [2.0, 1.0, 0.0], 0.0);
    assert!(spans(at.space[1], 0.0, 0.0) && spans(at.space[2], 3.0, 3.0));
    let at = piece(Corner, [2.0, 1.0, 0.0], 0.125);
    assert!(at.kink && !at.jump && !at.undefined);
    assert!(
        spans(at.space[1], 0.0, 1.0) && spans(at.space[2], 1.0, 3.0),
        "{:?}",
        at.space
    );
    // Around (½, ¼, ¼) all three are open, and the slope of x² is 2x.
    let at = piece(Corner, [0.5, 0.25, 0.25], 0.125);
    assert!(at.kink && !at.jump && !at.undefined);
    assert!(spans(at.space[1], 0.0, 2.25), "{:?}", at.space);
    assert!(
        spans(at.space[2], -1.0, 3.0) && spans(at.space[3], -1.0, 2.0),
        "{:?}",
        at.space
    );
    assert!(spans(at.slope, 0.0, 2.25), "{:?}", at.slope);
}

#[test]
fn a_branch_that_is_not_taken_may_be_undefined() {
    let at = piece(Refused, [0.0, 0.0, 0.0], 0.5);
    assert!(!at.undefined && spans(at.space[1], 1.0, 1.0));
    // Over the border ln is undefined somewhere, unless the branch narrowed its operand.
    let over = piece(Refused, [1.0, 0.0, 0.0], 0.5);
    assert!(over.undefined && over.jump);
}
