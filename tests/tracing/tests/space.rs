//! Boxes that certainly hold no root: they change no verdict, and plain floats find no root in them. Controls: a box that is
//! called empty and is not must be found out by both.

use std::mem::discriminant;

use glam::DVec3;
use zeroset::camera::{Camera, Ray};
use zeroset::interval::Isa;
use zeroset::render::{Options, Rendering, all_roots, render};
use zeroset::scene::Scene;
use zeroset::solve::Evaluations;
use zeroset::space::Subdivision;
use zeroset::verdict::{Verdict, Why};
use zeroset::{Operand, Surface, implicit};

implicit! {
    #[derive(Clone)]
    #[domain(x in -1.2..1.2, y in -1.2..1.2, z in -1.2..1.2)]
    struct Blobs { rows: [[f64; 4]] }
    0.5 = sum([cx, cy, cz, s] in rows) { exp(-s*((x - cx)^2 + (y - cy)^2 + (z - cz)^2)) }
}

implicit! {
    #[derive(Clone)]
    #[domain(x in -1.2..1.2, y in -1.2..1.2, z in -1.2..1.2)]
    struct Balls { rows: [[f64; 4]] }
    min([cx, cy, cz, s] in rows) { (x - cx)^2 + (y - cy)^2 + (z - cz)^2 - 1/s } = 0
}

// Its box cuts it, and touches it where z = 0.25.
implicit! {
    #[derive(Clone)]
    #[domain(x in -1..1, y in -0.75..1, z in -0.25..0.25)]
    struct Torus;
    (sqrt(x^2 + y^2) - 0.625)^2 + z^2 = 0.0625
}

// A pole, where the sign changes without a root, and a border of where f is defined.
implicit! {
    #[derive(Clone)]
    #[domain(x in -1..1, y in -1..1, z in -1..1)]
    struct Pole;
    1/x - 5 + sqrt(y + 0.5) = 0
}

implicit! {
    #[derive(Clone)]
    #[domain(x in -1..1, y in -1..1, z in -1..1)]
    struct Step;
    let low = x^2 + y^2 + 4*z^2 - 0.5;
    let high = sin(9*x)*sin(9*y)/9 + z - 0.1;
    if x < 0.2*y { low } else { high } = 0
}

// Singular along a line, and never of another sign on it.
implicit! {
    #[derive(Clone)]
    #[domain(x in -1..1, y in -1..1, z in -1..1)]
    struct Whitney;
    x^2 - y^2*z = 0
}

implicit! {
    #[derive(Clone)]
    #[domain(x in -1..1, y in -1..1, z in -1..1)]
    struct Twice;
    (x^2 + y^2 + z^2 - 0.64)^2 = 0
}

implicit! { #[derive(Clone)] #[domain(x in -2..-1, y in 0..1, z in 0..1)] struct Left; (x + 1.5)^2 + (y - 0.5)^2 + (z - 0.5)^2 = 0.2 }
implicit! { #[derive(Clone)] #[domain(x in 1..2, y in 0..1, z in -1..0)] struct Right; (x - 1.5)^2 + (y - 0.5)^2 + (z + 0.5)^2 = 0.1 }

implicit! {
    #[derive(Clone)]
    #[domain(x in 1..2, y in 0..1, z in -1..0)]
    struct Bumps { rows: [[f64; 4]] }
    0.5 = sum([cx, cy, cz, s] in rows) { exp(-s*((x - 1.5 - cx)^2 + (y - cy)^2 + (z - cz)^2)) }
}

/// Centres and sharpness, always the same.
fn rows(count: usize) -> Vec<[f64; 4]> {
    let mut state = 5u64;
    let mut random = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut row = || {
        let [x, y, z] = [0; 3].map(|_| 1.6 * random() - 0.8);
        [x, y, z, 30.0 + 60.0 * random()]
    };
    (0..count).map(|_| row()).collect()
}

fn scenes() -> Vec<(&'static str, Scene)> {
    let solid = (Torus
        - Left.placed(glam::DAffine3::from_translation(DVec3::new(
            2.0, -0.5, -0.5,
        ))))
        | Balls { rows: rows(3) };
    vec![
        ("blobs", Scene::new().with(Blobs { rows: rows(12) })),
        ("balls", Scene::new().with(Balls { rows: rows(12) })),
        ("torus", Scene::new().with(Torus)),
        ("pole", Scene::new().with(Pole)),
        ("step", Scene::new().with(Step)),
        ("whitney", Scene::new().with(Whitney)),
        ("twice", Scene::new().with(Twice)),
        (
            "several",
            Scene::new()
                .with(Left)
                .with(Right)
                .with(Torus)
                .with(Blobs { rows: rows(4) }),
        ),
        ("solid", Scene::new().with(solid).with(Right)),
    ]
}

fn cameras() -> [Camera; 4] {
    let at = DVec3::new(0.03, -0.02, 0.01);
    let look = |from, degrees| Camera::perspective(from, at, DVec3::Z, degrees).unwrap();
    [
        look(DVec3::new(3.0, 2.0, 1.5), 35.0),
        look(DVec3::new(0.21, 0.13, 0.17), 110.0),
        look(1e5 * DVec3::new(-0.6, 0.64, 0.48), 1.5e-3),
        Camera::orthographic(DVec3::new(-1.0, 2.0, -3.0), at, DVec3::Y, 2.6).unwrap(),
    ]
}

const SIZE: [u32; 2] = [91, 77];

fn divided(scene: Scene, depth: u32) -> Scene {
    let how = Subdivision {
        depth,
        ..Subdivision::default()
    };
    scene.subdivided(&how).unwrap()
}

/// Is it left open because f may be undefined there? A box tells more at times: that a pole on its face is no root.
fn is_undefined(verdict: &Verdict) -> bool {
    let why = Why::Undefined;
    matches!(verdict, Verdict::Unresolved { why: own, .. } if *own == why)
}

/// What a picture with boxes tells otherwise than one without: kinds of verdicts, surfaces, intervals that should overlap; and
/// how many pixels hit.
fn differences(one: &Rendering, other: &Rendering) -> (Vec<String>, usize) {
    let (mut all, mut hits) = (Vec::new(), 0);
    for (x, y) in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))) {
        let (p, q) = (one.pixel(x, y), other.pixel(x, y));
        let (a, b) = (p.answer, q.answer);
        if is_undefined(&b.first) && !is_undefined(&a.first) {
            continue;
        }
        let apart = match (a.first.t(), b.first.t()) {
            (Some(s), Some(t)) => {
                let shift = a.entry - b.entry;
                shift + s.lo > t.hi || t.lo > shift + s.hi
            }
            (None, None) => false,
            _ => true,
        };
        let kinds = discriminant(&a.first) != discriminant(&b.first)
            || a.behind.map(|v| discriminant(&v)) != b.behind.map(|v| discriminant(&v));
        if apart || kinds || p.surface != q.surface {
            all.push(format!("({x}, {y}): {p:?}, {q:?}"));
        }
        hits += usize::from(p.surface.is_some());
    }
    (all, hits)
}

#[test]
fn boxes_change_no_verdict() {
    for isa in Isa::available() {
        let (mut hits, mut apart, mut trimmed) = (0, 0, 0);
        for (name, scene) in scenes() {
            let scene = divided(scene, 5);
            for (number, camera) in cameras().iter().enumerate() {
                for beams in [false, true] {
                    let mut options = Options::new(SIZE[0], SIZE[1]);
                    options.isa = Some(isa);
                    options.settings.beams = beams;
                    options.settings.closed_forms = false;
                    let with = render(&scene, camera, &options).unwrap();
                    options.settings.space = false;
                    let without = render(&scene, camera, &options).unwrap();
                    let (wrong, hit) = differences(&with, &without);
                    assert!(
                        wrong.is_empty(),
                        "{isa}, {name}, camera {number}, beams {beams}, {} pixels:\n{}",
                        wrong.len(),
                        wrong[0]
                    );
                    hits += hit;
                    apart += with.statistics().evaluations.apart;
                    trimmed += with.statistics().evaluations.trimmed;
                    assert_eq!(without.statistics().evaluations.trimmed, 0);
                }
            }
        }
        println!("{isa}: {hits} hits, {apart} rays apart, {trimmed} shortened");
        assert!(hits > 30_000 && apart > 100_000 && trimmed > 10_000);
    }
}

/// The control.
#[test]
fn boxes_that_are_not_empty_are_missed_in_a_picture() {
    let mut options = Options::new(SIZE[0], SIZE[1]);
    options.normals = false;
    for beams in [false, true] {
        options.settings.beams = beams;
        let whole = divided(Scene::new().with(Balls { rows: rows(12) }), 4);
        let camera = &cameras()[0];
        options.settings.space = false;
        let without = render(&whole, camera, &options).unwrap();
        options.settings.space = true;
        let open = whole.octree().unwrap().census().open as u32;
        let mut scene = whole;
        // Corner after corner of the whole box.
        let mut before = 0;
        for quarter in 0..4 {
            for _ in 0..open / 4 {
                scene = scene.forget_box(0, 0);
            }
            let with = render(&scene, camera, &options).unwrap();
            let wrong = differences(&with, &without).0.len();
            println!(
                "beams {beams}: {wrong} pixels wrong without {} quarters",
                quarter + 1
            );
            assert!(wrong > before + 20);
            before = wrong;
        }
    }
}

#[test]
fn boxes_change_no_list_of_roots() {
    let mut options = Options::new(1, 1);
    let (mut roots, mut passes) = (0, 0);
    for (name, scene) in scenes() {
        let scene = divided(scene, 5);
        let mut state = 77u64;
        let mut random = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        for _ in 0..300 {
            let mut place = || DVec3::new(random(), random(), random());
            let (to, mut direction) = (place(), place());
            if passes % 5 == 0 {
                direction.x = 0.0;
            }
            passes += 1;
            let ray = Ray {
                origin: to - 3.0 * direction,
                direction,
            };
            options.settings.space = true;
            let with = all_roots(&scene, &ray, &options).unwrap();
            options.settings.space = false;
            let without = all_roots(&scene, &ray, &options).unwrap();
            for ((a, one), (b, other)) in with.iter().zip(without) {
                let told = |v: &Verdict| one.iter().any(|w| discriminant(w) == discriminant(v));
                let other: Vec<_> = other
                    .into_iter()
                    .filter(|v| told(v) || !is_undefined(v))
                    .collect();
                assert_eq!(
                    (*a, one.len()),
                    (b, other.len()),
                    "{name}: {one:?}, {other:?}"
                );
                for (s, t) in one.iter().zip(&other) {
                    assert_eq!(discriminant(s), discriminant(t), "{name}: {s:?}, {t:?}");
                    let (s, t) = (s.t().unwrap(), t.t().unwrap());
                    assert!(s.lo <= t.hi && t.lo <= s.hi, "{name}: {s:?}, {t:?}");
                    roots += 1;
                }
            }
        }
    }
    println!("{roots} events");
    assert!(roots > 1000);
}

/// A surface, and its formula by hand in plain floats.
struct Plain {
    name: &'static str,
    scene: Scene,
    domain: [[f64; 3]; 2],
    at: Box<dyn Fn([f64; 3]) -> f64>,
}

fn plain<S: Surface + 'static>(
    name: &'static str,
    surface: S,
    at: impl Fn([f64; 3]) -> f64 + 'static,
) -> Plain {
    Plain {
        name,
        domain: surface.domain().expect("it has a box"),
        scene: Scene::new().with(surface),
        at: Box::new(at),
    }
}

fn squared(p: [f64; 3], c: [f64; 3]) -> f64 {
    (p[0] - c[0]).powi(2) + (p[1] - c[1]).powi(2) + (p[2] - c[2]).powi(2)
}

fn plains() -> Vec<Plain> {
    let blobs = rows(12);
    let balls = rows(12);
    vec![
        plain("blobs", Blobs { rows: rows(12) }, move |p| {
            let term = |r: &[f64; 4]| (-r[3] * squared(p, [r[0], r[1], r[2]])).exp();
            0.5 - blobs.iter().map(term).sum::<f64>()
        }),
        plain("balls", Balls { rows: rows(12) }, move |p| {
            let ball = |r: &[f64; 4]| squared(p, [r[0], r[1], r[2]]) - 1.0 / r[3];
            balls.iter().map(ball).fold(f64::INFINITY, f64::min)
        }),
        plain("torus", Torus, |[x, y, z]| {
            (x.hypot(y) - 0.625).powi(2) + z * z - 0.0625
        }),
        plain("whitney", Whitney, |[x, y, z]| x * x - y * y * z),
    ]
}

/// Pairs of neighbouring points of a grid between which f changes its sign, and how many lie in boxes that are called free.
fn changes(plain: &Plain, scene: &Scene) -> [usize; 2] {
    const SIDE: usize = 70;
    let octree = scene.octree().unwrap();
    let [low, high] = plain.domain;
    // A little askew, so that no point of the grid is on a face of a box.
    let cut = |k: usize, i: usize| low[k] + (high[k] - low[k]) * (i as f64 + 0.37) / SIDE as f64;
    let [mut found, mut wrong] = [0; 2];
    for number in 0..SIDE * SIDE * SIDE {
        let i = [number % SIDE, number / SIDE % SIDE, number / SIDE / SIDE];
        let p = [0, 1, 2].map(|k| cut(k, i[k]));
        let f = (plain.at)(p);
        for axis in (0..3).filter(|k| i[*k] + 1 < SIDE) {
            let mut q = p;
            q[axis] = cut(axis, i[axis] + 1);
            let g = (plain.at)(q);
            // Rounding errors of plain floats change no sign here.
            if f * g < 0.0 && f.abs().min(g.abs()) > 1e-12 {
                found += 1;
                wrong += usize::from(octree.certainly_free(0, &[p, q]));
            }
        }
    }
    [found, wrong]
}

#[test]
fn no_sign_changes_where_space_is_free() {
    for mut plain in plains() {
        let scene = divided(std::mem::take(&mut plain.scene), 5);
        let [found, wrong] = changes(&plain, &scene);
        let octree = scene.octree().unwrap();
        println!(
            "{}: {found} sign changes, {} boxes open, {:?}",
            plain.name,
            octree.boxes(0).len(),
            octree.census()
        );
        assert!(found > 500, "{}", plain.name);
        assert_eq!(wrong, 0, "{}", plain.name);
        // It is of use: most of space is free.
        assert!(octree.census().open < 32 * 32 * 32 / 3, "{}", plain.name);
        assert_eq!(octree.boxes(0).len() as u64, octree.census().open);
        // The control.
        let mut scene = scene;
        for number in 0..40 {
            scene = scene.forget_box(0, 7 * number);
        }
        let [_, wrong] = changes(&plain, &scene);
        println!("control: {wrong}");
        assert!(wrong > 20, "{}: {wrong}", plain.name);
    }
}

/// A surface whose box is beside the picture costs nothing, and one behind another is passed tile by tile.
#[test]
fn surfaces_apart_are_not_evaluated() {
    let camera = Camera::perspective(
        DVec3::new(-2.1, -4.0, 0.5),
        DVec3::new(-2.1, 0.5, 0.5),
        DVec3::Z,
        14.0,
    )
    .unwrap();
    for beams in [false, true] {
        let mut options = Options::new(SIZE[0], SIZE[1]);
        options.settings.beams = beams;
        // Whatever is in the box beside the picture, the counts are the same.
        let [ball, bumps, solid] = [
            Scene::new().with(Left).with(Right),
            Scene::new().with(Left).with(Bumps { rows: rows(50) }),
            Scene::new().with(Left).with(Right - Left),
        ]
        .map(|scene| {
            let picture = render(&scene, &camera, &options).unwrap();
            let statistics = picture.statistics();
            assert!(statistics.root > 500, "{statistics}");
            if beams {
                let all = u64::from(SIZE[0] * SIZE[1]);
                assert!(statistics.evaluations.apart >= all, "{statistics}");
            }
            Evaluations {
                apart: 0,
                ..statistics.evaluations
            }
        });
        assert_eq!((bumps, solid), (ball, ball), "beams {beams}");
    }
}

// Each ray that meets the ball touches it twice, so that it is searched as a whole; the sum has no root, but would have two behind
// the ball without its second row, which is lost beside the first at the ball.
implicit! {
    #[domain(x in -0.5..0.5, y in -0.5..0.5, z in -2..1.5)]
    struct Behind { rows: [[f64; 3]] }
    let sum = sum([cz, s, w] in rows) { w*exp(-s*(x^2 + y^2 + (z - cz)^2)) };
    (x^2 + y^2 + (z - 1)^2 - 0.09)^2*(0.75 - sum) = 0
}

/// Beams leave out rows as far as boxes reach. What is behind is not theirs to tell.
#[test]
fn rows_are_left_out_only_where_boxes_are() {
    let rows = vec![[-1.0, 0.4, 0.8], [-1.0, 12.0, -0.3]];
    let scene = divided(Scene::new().with(Behind { rows }), 7);
    let camera =
        Camera::orthographic(DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO, DVec3::Y, 0.5).unwrap();
    let mut options = Options::new(SIZE[0], SIZE[1]);
    let picture = render(&scene, &camera, &options).unwrap();
    let evaluations = &picture.statistics().evaluations;
    assert!(evaluations.trimmed > 100, "{evaluations:?}");
    options.settings.space = false;
    let without = render(&scene, &camera, &options).unwrap();
    let mut touched = 0;
    for (x, y) in (0..SIZE[0]).flat_map(|x| (0..SIZE[1]).map(move |y| (x, y))) {
        for answer in [picture.answer(x, y), without.answer(x, y)] {
            assert_eq!(answer.behind, None, "({x}, {y}): {answer:?}");
            assert!(!answer.first.is_certain_hit(), "({x}, {y}): {answer:?}");
            touched += usize::from(answer.first != Verdict::Miss);
        }
    }
    assert!(touched > 1_000, "{touched}");
}

#[test]
fn what_is_added_drops_the_boxes() {
    let scene = divided(Scene::new().with(Left), 2);
    assert!(scene.octree().is_some());
    let scene = scene.with(Right);
    assert!(scene.octree().is_none());
    let scene = divided(scene, 2).within([-1.0; 3], [1.0; 3]);
    assert!(scene.octree().is_none());
    let bad = Subdivision::default();
    assert!(
        Scene::new()
            .with(implicit!(x ^ 2 + y ^ 2 = 1))
            .subdivided(&bad)
            .is_err()
    );
}

#[test]
fn a_bound_of_boxes_holds() {
    for boxes in [1, 64, 1000, 20_000] {
        let how = Subdivision {
            depth: 9,
            boxes,
            ..Subdivision::default()
        };
        let scene = Scene::new().with(Torus).subdivided(&how).unwrap();
        let open = scene.octree().unwrap().boxes(0).len();
        assert!(open <= boxes.max(8), "{open} of {boxes}");
        assert!(open >= boxes.min(8) && open as f64 >= boxes as f64 / 64.0);
    }
}
