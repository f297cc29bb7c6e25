//! Every example of the formula language, rendered by the default path, and compared with plain floats.
//!
//! The comparison needs no tolerance: where f, sampled along a pixel's ray, is clearly of both signs, the ray has a root
//! of a continuous function, so the verdict must not be a miss; and where the verdict is one root, f must be of opposite
//! signs on its two sides.

// Documentation of these surfaces stands where the language is described.
#![allow(missing_docs)]

use zeroset::camera::{Ray, Sampling};
use zeroset::glam::{DVec3, dvec3};
use zeroset::verdict::Verdict;
use zeroset::{Camera, Options, Scene, Surface, implicit, render};

implicit! { pub struct Sphere; x^2 + y^2 + z^2 = 1 }

implicit! {
    /// A ring around the z axis.
    #[derive(Clone, Debug)]
    pub struct Torus { pub major: f64 = 2, pub minor: f64 = 0.5 }
    let ring = sqrt(x^2 + y^2) - major;
    ring^2 + z^2 = minor^2
}

implicit! { pub struct Gyroid { pub k: f64 = 2*pi }
sin(k*x)*cos(k*y) + sin(k*y)*cos(k*z) + sin(k*z)*cos(k*x) }

implicit! {
    #[derive(Clone)]
    pub struct SumOfExpQuadrics {
        /// weight, centre, inverse squared radii
        pub blobs: [[f64; 7]; 8],
        pub level: f64 = 1,
    }
    level = sum([w, cx, cy, cz, ax, ay, az] in blobs) {
        w * exp(-(ax*(x - cx)^2 + ay*(y - cy)^2 + az*(z - cz)^2))
    }
}

implicit! { #[derive(Clone)] pub struct Drilled { pub r: f64 = 0.4 }
let cube = max(max(abs(x), abs(y)), abs(z)) - 1;
max(cube, r - hypot(x, y)) }

implicit! { #[derive(Clone)] pub struct Spheres { pub s: [[f64; 4]; 5] }
min([a, b, c, r] in s) { (x-a)^2 + (y-b)^2 + (z-c)^2 - r^2 } }

implicit! { #[derive(Clone)] pub struct Capsule { pub h: f64 = 1 }
let d = if z > h { z - h } else if z < -h { z + h } else { 0 };
x^2 + y^2 + d^2 = 0.25 }

implicit! { #[derive(Clone)] pub struct Clamped { pub h: f64 = 1 }
let d = z - clamp(z, -h, h);
x^2 + y^2 + d^2 = 0.25 }

const SIZE: u32 = 48;

/// How many pixels have which first verdict.
#[derive(Debug, Default, PartialEq)]
struct Counts {
    miss: u32,
    root: u32,
    /// Tangencies, crossings and undecided pieces.
    other: u32,
}

/// Renders a surface inside a cube, and compares each pixel with samples of f.
fn picture<S: Surface + 'static>(surface: S, twin: &S, half: f64) -> Counts {
    let camera = Camera::perspective(dvec3(3.1, 2.3, 1.7) * half, DVec3::ZERO, DVec3::Z, 40.0);
    let camera = camera.expect("a camera");
    let scene = Scene::new().with(surface).within([-half; 3], [half; 3]);
    let rendering = render(&scene, &camera, &Options::new(SIZE, SIZE)).expect("a picture");
    let mut counts = Counts::default();
    for (px, py) in (0..SIZE * SIZE).map(|i| (i % SIZE, i / SIZE)) {
        let answer = rendering.pixel(px, py).answer;
        let ray = camera.ray(px, py, SIZE, SIZE, Sampling::Centre);
        if let Some(wrong) = refute(twin, half, &ray, answer.entry, &answer.first) {
            panic!("{}: pixel ({px}, {py}): {wrong}", S::REPORT.name);
        }
        match answer.first {
            Verdict::Miss => counts.miss += 1,
            Verdict::Root { .. } => counts.root += 1,
            _ => counts.other += 1,
        }
    }
    counts
}

/// What samples of f say against a verdict.
fn refute<S: Surface>(
    surface: &S,
    half: f64,
    ray: &Ray,
    entry: f64,
    verdict: &Verdict,
) -> Option<String> {
    let f = |t: f64| surface.at(ray.at(t).to_array());
    match verdict {
        Verdict::Miss => {
            // All of the cube lies between these.
            let steps = (0..=400)
                .map(|i| half * (1.5 + 5.5 * f64::from(i) / 400.0) / ray.direction.length());
            let inside = steps.filter(|t| ray.at(*t).abs().max_element() < half);
            let values: Vec<f64> = inside.map(f).collect();
            let clearly = |sign: f64| values.iter().any(|v| v * sign > 1e-9);
            (clearly(1.0) && clearly(-1.0)).then(|| "a miss, but f changes sign".to_owned())
        }
        Verdict::Root { t } => {
            let width = 1e-6 * half;
            let (before, after) = (f(entry + t.lo - width), f(entry + t.hi + width));
            // Two roots may be closer together than that; then f is nearly 0 on both sides.
            let apart = before * after < 0.0 || before.abs().min(after.abs()) < 1e-9;
            (!apart).then(|| format!("a root, but f is {before} and {after} on its sides"))
        }
        _ => None,
    }
}

fn few(counts: &Counts, name: &str) {
    let most = SIZE * SIZE / 100;
    assert!(counts.root > 200, "{name}: {counts:?}");
    assert!(counts.miss > 200, "{name}: {counts:?}");
    assert!(counts.other <= most, "{name}: {counts:?}");
}

#[test]
fn spheres_and_rings() {
    few(&picture(Sphere, &Sphere, 1.5), "sphere");
    let torus = Torus::default();
    few(&picture(torus.clone(), &torus, 2.6), "torus");
}

#[test]
fn gyroids() {
    // It reaches the border of its cube everywhere: few rays miss it.
    let counts = picture(Gyroid::default(), &Gyroid::default(), 0.5);
    assert!(counts.root > 700 && counts.other <= 23, "{counts:?}");
}

#[test]
fn sums_of_exponentials() {
    let blob = |i: u8| {
        let turn = f64::from(i) * std::f64::consts::FRAC_PI_4;
        let tilt = f64::from(i % 3) / 3.0;
        [
            1.6,
            0.7 * turn.cos(),
            0.7 * turn.sin(),
            tilt - 0.3,
            3.0,
            2.0,
            4.0,
        ]
    };
    let surface = SumOfExpQuadrics {
        blobs: std::array::from_fn(|i| blob(i as u8)),
        level: 1.0,
    };
    few(&picture(surface.clone(), &surface, 1.4), "blobs");
}

#[test]
fn solids() {
    few(
        &picture(Drilled::default(), &Drilled::default(), 1.4),
        "drilled cube",
    );
    let spheres = Spheres {
        s: [
            [0.0, 0.0, 0.0, 0.6],
            [0.6, 0.0, 0.0, 0.3],
            [-0.6, 0.1, 0.2, 0.35],
            [0.0, 0.7, 0.0, 0.25],
            [0.1, 0.0, 0.7, 0.4],
        ],
    };
    few(&picture(spheres.clone(), &spheres, 1.2), "spheres");
}

#[test]
fn capsules() {
    few(
        &picture(Capsule::default(), &Capsule::default(), 1.6),
        "capsule",
    );
    few(
        &picture(Clamped::default(), &Clamped::default(), 1.6),
        "clamped capsule",
    );
}

#[test]
fn captured_locals() {
    let radius = 0.8;
    let ball = implicit!(x ^ 2 + y ^ 2 + z ^ 2 = radius ^ 2);
    let twin = implicit!(x ^ 2 + y ^ 2 + z ^ 2 = radius ^ 2);
    let half = 1.0;
    let at = |p: [f64; 3]| (ball.at(p), twin.at(p));
    assert_eq!(at([0.0; 3]), (-0.8 * 0.8, -0.8 * 0.8));
    let camera = Camera::perspective(dvec3(3.1, 2.3, 1.7), DVec3::ZERO, DVec3::Z, 40.0);
    let scene = Scene::new().with(ball).within([-half; 3], [half; 3]);
    let picture = render(
        &scene,
        &camera.expect("a camera"),
        &Options::new(SIZE, SIZE),
    );
    let picture = picture.expect("a picture");
    let counts = picture.statistics();
    assert!(counts.root > 200 && counts.miss > 200, "{counts}");
    assert_eq!(counts.unresolved, 0, "{counts}");
}

/// The control: samples refute wrong verdicts.
#[test]
fn wrong_verdicts_are_refuted() {
    let ray = Ray {
        origin: dvec3(3.0, 0.0, 0.0),
        direction: dvec3(-1.0, 0.0, 0.0),
    };
    let refuted = |t: f64| {
        let t = zeroset::interval::Interval { lo: t, hi: t };
        refute(&Sphere, 1.5, &ray, 0.0, &Verdict::Root { t }).is_some()
    };
    assert!(refute(&Sphere, 1.5, &ray, 0.0, &Verdict::Miss).is_some());
    assert!(refuted(1.9) && refuted(2.1) && !refuted(2.0));
}
