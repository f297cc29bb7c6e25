//! Solids, the same as formulas, and the same operands put together wrongly.

use crate::compare::HALF;
use zeroset::glam::{DAffine3, DMat3, dvec3};
use zeroset::{Operand, Scene, Solid, Surface, implicit};

// A ball, or for k = 0 a tube along z.
implicit! { #[derive(Clone)] pub struct Ball { pub a: f64 = 0, pub b: f64 = 0, pub c: f64 = 0, pub r: f64 = 1, pub k: f64 = 1 }
(x - a)^2 + (y - b)^2 + k*(z - c)^2 = r^2 }
implicit! { #[derive(Clone)] pub struct Half { pub a: f64 = 0, pub b: f64 = 0, pub c: f64 = 0, pub d: f64 = 0 }
a*x + b*y + c*z = d }
implicit! { #[derive(Clone)] pub struct Torus; (sqrt(x^2 + y^2) - 0.8)^2 + z^2 = 0.09 }
implicit! { #[derive(Clone)] pub struct Blobs; 0.5 = exp(-4*((x - 0.3)^2 + y^2 + z^2)) + exp(-5*((x + 0.3)^2 + y^2 + (z - 0.2)^2)) }
implicit! { #[derive(Clone)] pub struct Parabola; y = sqrt(x) }
implicit! { #[derive(Clone)] pub struct Doubled; (x^2 + y^2 + z^2 - 0.25)^2 }

// Two balls (centre on the x axis, radius, k) and the half space z < cut, by the signs of each and of the whole: many
// solids in one formula.
implicit! { struct Three { p: [f64; 3], q: [f64; 3], cut: f64, signs: [f64; 4] }
signs[0]*max(
    max(
        signs[1]*((x - p[0])^2 + y^2 + p[2]*z^2 - p[1]^2),
        signs[2]*((x - q[0])^2 + y^2 + q[2]*z^2 - q[1]^2)
    ),
    signs[3]*(z - cut)
) }

pub struct Pair {
    pub name: &'static str,
    pub solid: Scene,
    pub formula: Scene,
    pub wrong: Scene,
    /// At most so many rays of the solid's picture are open.
    pub open: u32,
}

fn scene(object: impl Operand) -> Scene {
    Scene::new().with(object).within([-HALF; 3], [HALF; 3])
}

fn pair<S: Surface + 'static>(
    name: &'static str,
    solid: Solid,
    formula: S,
    wrong: Solid,
    open: u32,
) -> Pair {
    Pair {
        name,
        solid: scene(solid),
        formula: scene(formula),
        wrong: scene(wrong),
        open,
    }
}

/// A ball on the x axis.
pub fn ball(a: f64, r: f64) -> Ball {
    Ball::default().with_a(a).with_r(r)
}

/// The points below a plane z = d.
pub fn below(d: f64) -> Half {
    Half::default().with_c(1.0).with_d(d)
}

/// The points with x < d.
pub fn left(d: f64) -> Half {
    Half::default().with_a(1.0).with_d(d)
}

/// |y|, |z| < 0.7.
pub fn square() -> Solid {
    let side = |b, c| Half::default().with_b(b).with_c(c).with_d(0.7);
    side(1.0, 0.0) & side(-1.0, 0.0) & side(0.0, 1.0) & side(0.0, -1.0)
}

/// A rotation by 3-4-5 about z, as its `f64`s, and a translation.
fn turned() -> DAffine3 {
    let matrix = DMat3::from_cols(
        dvec3(0.6, 0.8, 0.0),
        dvec3(-0.8, 0.6, 0.0),
        dvec3(0.0, 0.0, 0.75),
    );
    DAffine3::from_mat3_translation(matrix, dvec3(0.1, 0.2, -0.1))
}

/// Two balls in opposite corners.
pub fn apart() -> Scene {
    let at = |a: f64| Ball {
        a,
        b: a,
        c: a,
        r: 0.3,
        k: 1.0,
    };
    scene(at(1.1) | at(-1.1))
}

pub fn tube() -> Ball {
    ball(0.0, 0.4).with_k(0.0)
}

/// Each solid with its formula, and the same operands in another order of things.
pub fn pairs() -> Vec<Pair> {
    let c = 0.6;
    let s = 0.8;
    let mut pairs = simple();
    pairs.extend([
        pair(
            "nested five deep",
            ((ball(0.0, 1.0) - tube()) | ball(0.9, 0.4)) & !(ball(0.0, 0.7) - below(0.1)),
            implicit! {
                let ball = x^2 + y^2 + z^2;
                let drilled = max(ball - 1, 0.4^2 - (x^2 + y^2));
                max(min(drilled, (x - 0.9)^2 + y^2 + z^2 - 0.4^2), -max(ball - 0.7^2, 0.1 - z))
            },
            ((ball(0.0, 1.0) - tube()) | ball(0.9, 0.4)) - below(0.1),
            0,
        ),
        pair(
            "torus, drilled, placed",
            Torus.placed(turned()) - (tube() | below(-0.2)).placed(turned()),
            implicit! {
                // The inverse of the map.
                let d = c^2 + s^2;
                let u = (c*(x - 0.1) + s*(y - 0.2))/d;
                let v = (c*(y - 0.2) - s*(x - 0.1))/d;
                let w = (z + 0.1)/0.75;
                max((sqrt(u^2 + v^2) - 0.8)^2 + w^2 - 0.09, -min(u^2 + v^2 - 0.16, w + 0.2))
            },
            Torus.placed(turned()) - (tube() | below(-0.2)),
            0,
        ),
        pair(
            "exponentials, hollowed",
            Blobs - ball(0.3, 0.3) - below(-0.1),
            implicit!(max(
                max(
                    0.5 - (exp(-4 * ((x - 0.3) ^ 2 + y ^ 2 + z ^ 2))
                        + exp(-5 * ((x + 0.3) ^ 2 + y ^ 2 + (z - 0.2) ^ 2))),
                    0.3 ^ 2 - ((x - 0.3) ^ 2 + y ^ 2 + z ^ 2)
                ),
                -0.1 - z
            )),
            Blobs - ball(0.3, 0.3) - !below(-0.1),
            0,
        ),
        pair(
            "coincident inner faces",
            ((left(0.0) - left(-0.9)) | (left(0.9) - left(0.0))) & square(),
            implicit!(max(
                min(max(x, -0.9 - x), max(x - 0.9, -x)),
                max(abs(y), abs(z)) - 0.7
            )),
            (left(0.0) - left(-0.9)) & square(),
            0,
        ),
        pair(
            "a root of x that ends",
            ball(0.0, 1.0) & Parabola,
            implicit!(max(x ^ 2 + y ^ 2 + z ^ 2 - 1, y - sqrt(x))),
            ball(0.0, 1.0) - Parabola,
            1500,
        ),
        pair(
            "doubled roots",
            (ball(0.0, 1.0) - Doubled) & below(0.5),
            implicit!(max(
                max(
                    x ^ 2 + y ^ 2 + z ^ 2 - 1,
                    -(x ^ 2 + y ^ 2 + z ^ 2 - 0.25) ^ 2
                ),
                z - 0.5
            )),
            (ball(0.0, 1.0) & !Doubled) - below(0.5),
            0,
        ),
    ]);
    pairs
}

fn three(p: [f64; 3], q: [f64; 3], cut: f64, signs: [f64; 4]) -> Three {
    Three { p, q, cut, signs }
}

fn simple() -> Vec<Pair> {
    // What `Three` leaves out of a maximum.
    let (never, unit) = ([0.0, 9.0, 1.0], [0.0, 1.0, 1.0]);
    vec![
        pair(
            "drilled",
            ball(0.0, 1.0) - tube(),
            three(unit, [0.0, 0.4, 0.0], 9.0, [1.0, 1.0, -1.0, 1.0]),
            ball(0.0, 1.0) & tube(),
            0,
        ),
        pair(
            "nested and cut: hollow",
            (ball(0.0, 1.0) - ball(0.0, 0.6)) & below(0.2),
            three(unit, [0.0, 0.6, 1.0], 0.2, [1.0, 1.0, -1.0, 1.0]),
            (ball(0.0, 1.0) - ball(0.0, 0.6)) - below(0.2),
            0,
        ),
        pair(
            "lens",
            ball(-0.3, 0.8) & ball(0.3, 0.8),
            three([-0.3, 0.8, 1.0], [0.3, 0.8, 1.0], 9.0, [1.0; 4]),
            ball(-0.3, 0.8) | ball(0.3, 0.8),
            0,
        ),
        pair(
            "touching from outside",
            ball(-0.5, 0.5) | ball(0.5, 0.5),
            three(
                [-0.5, 0.5, 1.0],
                [0.5, 0.5, 1.0],
                -9.0,
                [-1.0, -1.0, -1.0, -1.0],
            ),
            ball(-0.5, 0.5) & ball(0.5, 0.5),
            0,
        ),
        pair(
            "touching from inside",
            (ball(0.0, 1.0) - ball(0.5, 0.5)) - below(0.0),
            three(unit, [0.5, 0.5, 1.0], 0.0, [1.0, 1.0, -1.0, -1.0]),
            (ball(0.0, 1.0) - ball(0.5, 0.5)) & below(0.0),
            0,
        ),
        pair(
            "coincident outer faces",
            ball(0.0, 1.0) & ball(0.0, 1.0) & (below(0.3) | below(0.3)),
            three(unit, unit, 0.3, [1.0; 4]),
            ball(0.0, 1.0) & ball(0.0, 1.0) & !below(0.3),
            0,
        ),
        pair(
            "an unbounded complement",
            !ball(0.0, 1.0),
            three(unit, never, 9.0, [-1.0, 1.0, 1.0, 1.0]),
            !ball(0.0, 0.8),
            0,
        ),
        pair(
            "an unbounded complement, cut",
            !(tube() & below(0.1)) & !(ball(0.5, 0.5) & tube() & below(0.1)),
            three(never, [0.0, 0.4, 0.0], 0.1, [-1.0, 1.0, 1.0, 1.0]),
            !(tube() | below(0.1)),
            0,
        ),
        pair(
            "an unbounded union",
            !below(-0.2) | !ball(-0.2, 0.9) | !ball(0.3, 1.0),
            three(
                [-0.2, 0.9, 1.0],
                [0.3, 1.0, 1.0],
                -0.2,
                [-1.0, 1.0, 1.0, 1.0],
            ),
            !below(-0.2) | !ball(-0.2, 0.9) & !ball(0.3, 1.0),
            0,
        ),
    ]
}
