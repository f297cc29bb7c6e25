//! Every function of the language: values and derivatives of the generated code against each other and against
//! differences of the plain evaluation.
//!
//! Three ways lead to a derivative: one top-down sweep in space, propagation along a ray, and differences of `at`. The
//! first two are enclosures of the same number, so they must meet; the third is an approximation with a known error.
//! Where there is arb, differences with 800 bits of formulas typed anew must be inside.

#![forbid(unsafe_code)]

mod arb;
mod borders;
#[path = "../support/python.rs"]
mod python;
#[path = "../support/random.rs"]
mod random;
mod surfaces;

use zeroset::interval::Interval;

use random::Random;
use surfaces::{Circular, Hyperbolic, Sample, Wrapped, each, point};

fn meet(a: Interval, b: Interval) -> bool {
    a.lo <= b.hi && b.lo <= a.hi
}

/// Does the enclosure agree with an approximation of this error, relative to the sizes involved?
fn agrees(enclosure: Interval, approximation: f64, tolerance: f64) -> bool {
    let slack = tolerance * (1.0 + approximation.abs());
    enclosure.lo - slack <= approximation && approximation <= enclosure.hi + slack
}

/// Central differences of `f` with one step of Richardson's extrapolation: error about h⁴.
fn difference(f: impl Fn(f64) -> f64) -> f64 {
    let h = 1.0 / 512.0;
    let d = |h: f64| (f(h) - f(-h)) / (2.0 * h);
    (4.0 * d(h / 2.0) - d(h)) / 3.0
}

fn moved(p: [f64; 3], axis: usize, h: f64) -> [f64; 3] {
    let mut q = p;
    q[axis] += h;
    q
}

/// The index of f_ij among the ten.
fn second(i: usize, j: usize) -> usize {
    [[4, 5, 6], [5, 7, 8], [6, 8, 9]][i][j]
}

/// The largest number of disagreements that one surface has at random points.
fn disagreements(value: &dyn Sample, derivatives: &dyn Sample) -> usize {
    let mut random = Random(7);
    let mut wrong = 0;
    for _ in 0..40 {
        let p = random.point(2.0);
        let (all, smooth) = derivatives.space(p.map(point));
        wrong += usize::from(!agrees(all[0], value.at(p), 1e-12));
        for axis in 0..3 {
            let by_difference = difference(|h| value.at(moved(p, axis, h)));
            wrong += usize::from(!agrees(all[1 + axis], by_difference, 1e-6));
            for other in 0..3 {
                let middle = |q: [f64; 3]| derivatives.gradient(q.map(point))[1 + axis].mid();
                let by_difference = difference(|h| middle(moved(p, other, h)));
                wrong +=
                    usize::from(smooth && !agrees(all[second(axis, other)], by_difference, 1e-5));
            }
        }
    }
    wrong
}

#[test]
fn derivatives_in_space_agree_with_differences() {
    each(|name, surface| {
        assert_eq!(disagreements(surface, surface), 0, "{name}");
    });
}

#[test]
fn a_wrong_derivative_would_be_noticed() {
    let (right, wrong) = (Wrapped(Circular), Wrapped(Hyperbolic));
    assert!(disagreements(&right, &wrong) > 100);
}

#[test]
fn derivatives_along_a_ray_meet_those_in_space() {
    each(|name, surface| {
        let mut random = Random(11);
        for _ in 0..40 {
            let (o, d) = (random.point(1.0), random.point(1.0));
            let t = 1.0 + random.next();
            let along = surface.along(o, d, point(t));
            let (three, two, one) = (along.curvature, along.slope, along.value);
            // The exact point o + t·d lies in this box.
            let b: [Interval; 3] = std::array::from_fn(|k| Interval {
                lo: t.mul_add(d[k], o[k]).next_down(),
                hi: t.mul_add(d[k], o[k]).next_up(),
            });
            let (space, smooth) = surface.space(b);
            let slope = dot(&space[1..4], d);
            let mut curvature = point(0.0);
            for i in 0..3 {
                for j in 0..3 {
                    curvature = plus(curvature, times(space[second(i, j)], d[i] * d[j]));
                }
            }
            assert!(
                meet(three[0], space[0]) && meet(two[0], space[0]) && meet(one, space[0]),
                "{name}"
            );
            assert!(
                meet(widened(three[1]), slope) && meet(widened(two[1]), slope),
                "{name}: {two:?} {slope:?}"
            );
            if smooth {
                assert!(
                    meet(widened(three[2]), curvature),
                    "{name}: {:?} {curvature:?}",
                    three[2]
                );
            }
        }
    });
}

#[test]
fn enclosures_over_boxes_hold_those_at_their_points() {
    each(|name, surface| {
        let mut random = Random(13);
        for _ in 0..25 {
            let (c, r) = (random.point(1.5), 0.4 * random.next().abs());
            let b = c.map(|x| Interval {
                lo: x - r,
                hi: x + r,
            });
            let (wide, smooth) = surface.space(b);
            let (o, d) = (random.point(1.0), random.point(1.0));
            let t = Interval {
                lo: 0.3,
                hi: 0.3 + r,
            };
            let along = surface.along(o, d, t).curvature;
            for _ in 0..8 {
                let p: [f64; 3] =
                    std::array::from_fn(|k| (c[k] + r * random.next()).clamp(b[k].lo, b[k].hi));
                let (narrow, _) = surface.space(p.map(point));
                let orders = if smooth { 10 } else { 4 };
                for k in 0..orders {
                    assert!(
                        meet(wide[k], narrow[k]),
                        "{name} {k}: {:?} {:?}",
                        wide[k],
                        narrow[k]
                    );
                }
                let s = t.lo + r * 0.5 * (1.0 + random.next());
                let one = surface.along(o, d, point(s.min(t.hi))).curvature;
                for k in 0..2 {
                    assert!(meet(along[k], one[k]), "{name} {k}");
                }
            }
        }
    });
}

/// Room for the roundings of the test's own products.
fn widened(a: Interval) -> Interval {
    let slack = 1e-12 * (1.0 + a.lo.abs().max(a.hi.abs()));
    Interval {
        lo: a.lo - slack,
        hi: a.hi + slack,
    }
}

fn plus(a: Interval, b: Interval) -> Interval {
    Interval {
        lo: a.lo + b.lo,
        hi: a.hi + b.hi,
    }
}

fn times(a: Interval, c: f64) -> Interval {
    let (p, q) = (a.lo * c, a.hi * c);
    Interval {
        lo: p.min(q),
        hi: p.max(q),
    }
}

fn dot(a: &[Interval], d: [f64; 3]) -> Interval {
    a.iter()
        .zip(d)
        .fold(point(0.0), |sum, (a, d)| plus(sum, times(*a, d)))
}
