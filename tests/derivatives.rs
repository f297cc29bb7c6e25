//! Every function of the language: values and derivatives of the generated code against each other and against
//! differences of the plain evaluation.
//!
//! Three ways lead to a derivative: one top-down sweep in space, propagation along a ray, and differences of `at`. The
//! first two are enclosures of the same number, so they must meet; the third is an approximation with a known error.

#![forbid(unsafe_code)]

use zeroset::implicit;
use zeroset::interval::{Interval, Scalar};
use zeroset::ray::Rays;
use zeroset::surface::Surface;

/// Declares surfaces, and a function that runs `$check` on a default one of each.
macro_rules! zoo {
    ($($name:ident { $($formula:tt)* })*) => {
        $(implicit! { #[derive(Clone)] struct $name; $($formula)* })*

        fn each(mut visit: impl FnMut(&str, &dyn Sample)) {
            $(visit(stringify!($name), &Wrapped($name));)*
        }
    };
}

zoo! {
    Polynomial { x^3*y - 2*x*y*z + z^4 - (x - y)^2*(y + 3)^3 + x^2 - 1 }
    Quotient { (x*y + 1)/(z^2 + 2) - x/(3 + y^2) + 1/(x^2 + y^2 + 4) }
    NegativePowers { (x + 5)^-2 + (y + 6)^-3*z + (x^2 + 1)^1.5 + (y^2 + 2)^-0.5 + (z^2 + 3)^0.3 }
    RealPower { (x^2 + 1)^(y/4) + 2^x - z }
    Roots { sqrt(x^2 + y^2 + 1)*z + cbrt(x + 9) - cbrt(z*y) }
    Exponentials { exp(x*y) + exp2(z - x) - exp_m1(y/2)*z }
    Logarithms { ln(x^2 + 2) + ln_1p(y^2)*z - log2(z^2 + 3) + log10(x + 7) }
    Circular { sin(x*y) + cos(y + z)*x - tan(z/4) }
    Arcs { asin(x/5)*y + acos(y/5) - atan(z*x) + atan2(x + 6, y*z + 1) }
    Hyperbolic { sinh(x) - cosh(y*z) + tanh(x + z)*y }
    Areas { asinh(x*z) + acosh(y^2 + 2) - atanh(z/6)*x }
    Distances { hypot(x - 3, y + 4) + abs(z - 4)*x + recip(y + 7) }
    Extremes { max(x - 5, y*z) + min(x*x, z + 9) + clamp(x*y, -20, 20) }
    Branches { if x + 5 < y - 5 || x > 8 && z > 0 { x*y } else if z < 10 { y*z^2 } else { 1 } }
    Sums { sum(i in 0..4) { sin(i*x + y)*(z - i)^2 } + prod(i in 1..4) { x + i*y*z } }
    Nested { sum(i in 0..3) { prod(j in 0..3) { x + i*y - j*z } * cos(i*x) } }
    FoldedExtremes { min(i in 0..3) { (x - 7*i)^2 + y*z } + max(i in 0..3) { y - 9*i + x*z } }
    Shared { let s = x*y + z; let q = s^2 - sin(s); q*s + q^3 }
}

/// What the tests ask of a surface, free of its type.
trait Sample {
    fn at(&self, p: [f64; 3]) -> f64;
    /// f, gradient and Hessian over a box.
    fn space(&self, b: [Interval; 3]) -> ([Interval; 10], bool);
    /// f and its gradient alone.
    fn gradient(&self, b: [Interval; 3]) -> [Interval; 4];
    /// f, f', f'' over a segment of a ray, and the same by the shorter entry points.
    fn along(
        &self,
        o: [f64; 3],
        d: [f64; 3],
        t: Interval,
    ) -> ([Interval; 3], [Interval; 2], Interval);
}

struct Wrapped<S>(S);

impl<S: Surface> Sample for Wrapped<S> {
    fn at(&self, p: [f64; 3]) -> f64 {
        self.0.at(p)
    }

    fn space(&self, b: [Interval; 3]) -> ([Interval; 10], bool) {
        let jet = S::hessian(Scalar, &self.0.prepare(), b);
        let f = jet.flags;
        (jet.d, !(f.empty || f.undefined || f.jump || f.kink))
    }

    fn gradient(&self, b: [Interval; 3]) -> [Interval; 4] {
        S::gradient(Scalar, &self.0.prepare(), b).d
    }

    fn along(
        &self,
        o: [f64; 3],
        d: [f64; 3],
        t: Interval,
    ) -> ([Interval; 3], [Interval; 2], Interval) {
        let prepared = self.0.prepare();
        let mut bound = S::unbound(Scalar);
        let rays = Rays {
            origin: o.map(point),
            direction: d.map(point),
            end: t.hi,
        };
        S::bind(
            Scalar,
            &prepared,
            &rays,
            &S::everything(&prepared),
            &mut bound,
        );
        (
            S::curvature(Scalar, &prepared, &bound, t).d,
            S::slope(Scalar, &prepared, &bound, t).d,
            S::value(Scalar, &prepared, &bound, t).d[0],
        )
    }
}

fn point(x: f64) -> Interval {
    Interval { lo: x, hi: x }
}

/// Numbers in [−1, 1) from a fixed seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    fn point(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| size * self.next())
    }
}

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
            let (three, two, one) = surface.along(o, d, point(t));
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
            let (along, _, _) = surface.along(o, d, t);
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
                let (one, _, _) = surface.along(o, d, point(s.min(t.hi)));
                for k in 0..2 {
                    assert!(meet(along[k], one[k]), "{name} {k}");
                }
            }
        }
    });
}

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
    let (_, [_, slope], _) = Wrapped(surface).along(start, [1.0, 0.0, 0.0], t);
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
