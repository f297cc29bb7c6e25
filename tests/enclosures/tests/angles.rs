//! The angles of boxes: which corners are extreme, the cut, the origin, and infinite edges.

use zeroset::interval::Interval;
use zeroset_enclosures::backend::{Backend, Operands};
use zeroset_enclosures::operand::Source;
use zeroset_enclosures::operation::Operation;

const BOXES: usize = 20_000;

/// Bounds that make edges on the axes, boxes that are points or segments, and infinite edges likely.
fn bound(source: &mut Source) -> f64 {
    match source.below(6) {
        0 => 0.0,
        1 => -0.0,
        2 => source.below(5) as f64 - 2.0,
        3 => [f64::INFINITY, f64::NEG_INFINITY][source.below(2) as usize],
        4 => source.number(),
        _ => 4.0 * source.unit() - 2.0,
    }
}

fn side(source: &mut Source) -> Interval {
    loop {
        let (x, y) = (bound(source), bound(source));
        let (lo, hi) = if x <= y { (x, y) } else { (y, x) };
        if let Ok(side) = Interval::try_new(lo, hi) {
            return side;
        }
    }
}

/// A finite number of the side: a bound, 0, or any.
fn member(source: &mut Source, side: Interval) -> f64 {
    let inside = side.lo.max(-1e300) + (side.hi.min(1e300) - side.lo.max(-1e300)) * source.unit();
    let x = match source.below(4) {
        0 => side.lo,
        1 => side.hi,
        2 => 0.0,
        _ => inside,
    };
    x.clamp(side.lo, side.hi).clamp(f64::MIN, f64::MAX)
}

/// The hull of the angles of corners (limits along edges where one coordinate is infinite) and of points inside.
fn samples(source: &mut Source, y: Interval, x: Interval) -> Option<Interval> {
    let mut hull: Option<Interval> = None;
    let mut points = vec![(y.lo, x.lo), (y.lo, x.hi), (y.hi, x.lo), (y.hi, x.hi)];
    points.resize_with(40, || (member(source, y), member(source, x)));
    for (y, x) in points {
        if (y == 0.0 && x == 0.0) || (y.is_infinite() && x.is_infinite()) {
            continue;
        }
        // −0 is the other side of the cut for the library.
        let angle = (y + 0.0).atan2(x + 0.0);
        let at = Interval {
            lo: angle,
            hi: angle,
        };
        hull = Some(hull.map_or(at, |hull| hull.hull(&at)));
    }
    hull
}

/// The library's angles are off by less than this, relatively.
const SLACK: f64 = 1e-15;

fn holds(range: Interval, hull: Interval) -> bool {
    range.lo <= hull.lo + hull.lo.abs() * SLACK && hull.hi - hull.hi.abs() * SLACK <= range.hi
}

fn is_tight(range: Interval, hull: Interval) -> bool {
    let slack = |x: f64| x.abs() * 4.0 * SLACK + 1e-322;
    hull.lo - range.lo <= slack(hull.lo) && range.hi - hull.hi <= slack(hull.hi)
}

fn boxes(source: &mut Source) -> Vec<Operands> {
    (0..BOXES)
        .map(|_| Operands {
            a: side(source),
            b: side(source),
        })
        .collect()
}

#[test]
fn the_angles_of_boxes_are_those_of_their_corners() {
    let mut source = Source(23);
    let operands = boxes(&mut source);
    for backend in Backend::rounded() {
        for (operands, outcome) in operands
            .iter()
            .zip(backend.run(Operation::Atan2, &operands))
        {
            let (y, x) = (operands.a, operands.b);
            let Some(hull) = samples(&mut source, y, x) else {
                assert!(outcome.empty, "{}: {y:?} {x:?}", backend.name());
                continue;
            };
            let range = outcome.range;
            assert!(
                holds(range, hull),
                "{}: y in {y:?}, x in {x:?}: {range:?}, samples {hull:?}",
                backend.name()
            );
            assert!(
                outcome.jump || is_tight(range, hull),
                "{}: y in {y:?}, x in {x:?}: {range:?} is wider than {hull:?}",
                backend.name()
            );
        }
    }
}

#[test]
fn negative_control_the_angles_of_mirrored_boxes_do_not_fit() {
    let mut source = Source(23);
    let operands = boxes(&mut source);
    let mirrored: Vec<Operands> = operands
        .iter()
        .map(|o| Operands {
            a: o.a,
            b: Interval {
                lo: -o.b.hi,
                hi: -o.b.lo,
            },
        })
        .collect();
    for backend in Backend::rounded() {
        let mut wrong = 0;
        for (operands, outcome) in operands
            .iter()
            .zip(backend.run(Operation::Atan2, &mirrored))
        {
            let hull = samples(&mut source, operands.a, operands.b);
            wrong += usize::from(hull.is_some_and(|hull| !holds(outcome.range, hull)));
        }
        println!("{}: {wrong} of {BOXES} do not fit", backend.name());
        assert!(wrong > BOXES / 4, "{}", backend.name());
    }
}
