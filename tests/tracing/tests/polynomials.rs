//! Thousands of rays against Sturm's theorem in rational arithmetic: no miss and no root may be wrong.

use glam::DVec3;
use zeroset::camera::{Camera, Sampling};
use zeroset::contract::unsound::Unrounded;
use zeroset::contract::{Auto, Bisection, Halley, Newton, Tightened};
use zeroset::interval::Isa;
use zeroset::render::{Options, Rendering, render};
use zeroset::scene::Scene;
use zeroset_tracing_tests::dual::Hand;
use zeroset_tracing_tests::exact::Poly;
use zeroset_tracing_tests::formulas::{DoubleSphere, Sphere, Torus};
use zeroset_tracing_tests::oracle::{Truth, coordinates};
use zeroset_tracing_tests::staged::Ball;

fn sphere(p: &[Poly; 3], r: f64) -> Poly {
    let square = p[0].mul(&p[0]).add(&p[1].mul(&p[1])).add(&p[2].mul(&p[2]));
    let r = Poly::number(r);
    square.sub(&r.mul(&r))
}

fn torus(p: &[Poly; 3], major: f64, minor: f64) -> Poly {
    // The surface's fields are floats, and so is the constant that it computes of them.
    let flat = p[0].mul(&p[0]).add(&p[1].mul(&p[1]));
    let shifted = flat
        .add(&p[2].mul(&p[2]))
        .add(&Poly::number(major * major - minor * minor));
    shifted
        .mul(&shifted)
        .sub(&Poly::number(4.0 * major * major).mul(&flat))
}

/// Cameras near and far, along an axis (zero components), and at an angle.
fn cameras(size: f64) -> Vec<Camera> {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z) * size;
    vec![
        Camera::perspective(at(2.5, 1.8, 4.0), DVec3::ZERO, DVec3::Y, 40.0).unwrap(),
        Camera::perspective(at(0.0, 0.0, 4.0), DVec3::ZERO, DVec3::Y, 35.0).unwrap(),
        Camera::perspective(at(0.1, 0.2, 0.3), DVec3::X * size, DVec3::Y, 90.0).unwrap(),
        Camera::perspective(at(1e3, 2e3, 3e3), DVec3::ZERO, DVec3::Y, 0.05).unwrap(),
        Camera::perspective(at(1e6, 1e5, 2e6), DVec3::ZERO, DVec3::Y, 1e-4).unwrap(),
        Camera::orthographic(at(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, 4.0 * size).unwrap(),
        Camera::orthographic(at(5.0, 4.0, 3.0), DVec3::ZERO, DVec3::Y, 4.0 * size).unwrap(),
    ]
}

const SIZE: u32 = 16;

fn options(isa: Isa) -> Options<'static> {
    let mut options = Options::new(SIZE, SIZE);
    options.isa = Some(isa);
    // Corners: with an even size, rays through the middle of the picture and along the axes.
    options.sampling = Sampling::Corner;
    options
}

/// The truth about every pixel, row by row.
fn truths(camera: &Camera, domain: &[[f64; 3]; 2], f: &dyn Fn(&[Poly; 3]) -> Poly) -> Vec<Truth> {
    let pixels =
        (0..SIZE * SIZE).map(|i| camera.ray(i % SIZE, i / SIZE, SIZE, SIZE, Sampling::Corner));
    pixels
        .map(|ray| Truth::new(&f(&coordinates(&ray)), &ray, domain))
        .collect()
}

/// How many answers are wrong, with the first complaint.
fn judge_all(picture: &Rendering, truths: &[Truth]) -> (usize, Option<String>) {
    let (mut wrong, mut complaint) = (0, None);
    for (i, truth) in (0..).zip(truths) {
        let (x, y) = (i % SIZE, i / SIZE);
        if let Err(why) = truth.judge(&picture.answer(x, y)) {
            wrong += 1;
            complaint.get_or_insert_with(|| format!("pixel ({x}, {y}): {why}"));
        }
    }
    (wrong, complaint)
}

/// Renders with each camera, on each instruction set, by each solver, and judges.
fn prove(
    scenes: &[(&str, Scene)],
    domain: [[f64; 3]; 2],
    size: f64,
    f: &dyn Fn(&[Poly; 3]) -> Poly,
) {
    for camera in cameras(size) {
        let truths = truths(&camera, &domain, f);
        for isa in Isa::available() {
            for (name, scene) in scenes {
                let picture = render(scene, &camera, &options(isa)).unwrap();
                let (wrong, complaint) = judge_all(&picture, &truths);
                assert_eq!(
                    wrong,
                    0,
                    "{name} on {isa}, {camera:?}: {}",
                    complaint.unwrap_or_default()
                );
                let s = picture.statistics();
                assert!(
                    s.tangent + s.unresolved <= s.rays / 20,
                    "{name} on {isa}: too much is open\n{s}"
                );
            }
        }
    }
}

/// The same surface by each of these solvers.
macro_rules! by_solvers {
    ($surface:expr, $($solver:ident)*) => {
        [$((stringify!($solver), Scene::new().with_solver::<$solver, _>($surface))),*]
    };
}

#[test]
fn spheres() {
    let s = Hand::new(Sphere(0.7), 2.0);
    let scenes = by_solvers!(s, Auto Newton Tightened Halley Bisection);
    prove(&scenes, s.domain, 1.0, &|p| sphere(p, 0.7));
}

#[test]
fn spheres_in_closed_form() {
    for (radius, half, size) in [
        (1.0, 2.0, 1.0),
        (0.3, 0.5, 1.0),
        (7e5, 1e6, 1e6),
        (3e-4, 1e-3, 1e-3),
    ] {
        let scenes = [("ball", Scene::new().with(Ball { radius, half }))];
        prove(&scenes, [[-half; 3], [half; 3]], size, &|p| {
            sphere(p, radius)
        });
    }
}

#[test]
fn toruses() {
    // 1.5² − 0.5² and 4·1.5² are floats.
    let s = Hand::new(
        Torus {
            major: 1.5,
            minor: 0.5,
        },
        2.5,
    );
    let scenes = by_solvers!(s, Auto Newton Tightened Halley);
    prove(&scenes, s.domain, 1.0, &|p| torus(p, 1.5, 0.5));
}

#[test]
fn double_spheres_have_no_certain_hit() {
    let s = Hand::new(DoubleSphere(1.0), 2.0);
    let camera = &cameras(1.0)[0];
    let f = |p: &[Poly; 3]| {
        let f = sphere(p, 1.0);
        f.mul(&f)
    };
    let truths = truths(camera, &s.domain, &f);
    for isa in Isa::available() {
        let picture = render(&Scene::new().with(s), camera, &options(isa)).unwrap();
        let (wrong, complaint) = judge_all(&picture, &truths);
        assert_eq!(wrong, 0, "{isa}: {}", complaint.unwrap_or_default());
        let statistics = picture.statistics();
        assert_eq!(statistics.root + statistics.crossing, 0, "{statistics}");
        assert!(statistics.tangent > 40, "{statistics}");
    }
}

/// The suite can fail: answers about a slightly different sphere are caught.
#[test]
fn wrong_answers_are_caught() {
    let s = Ball {
        radius: 1.0,
        half: 2.0,
    };
    let camera = &cameras(1.0)[0];
    let picture = render(&Scene::new().with(s), camera, &options(Isa::available()[0])).unwrap();
    let truths = truths(camera, &[[-2.0; 3], [2.0; 3]], &|p| sphere(p, 1.0 + 1e-13));
    let (wrong, _) = judge_all(&picture, &truths);
    assert!(wrong > 20, "only {wrong} wrong answers were noticed");
}

/// A surface that does not ask for it is not compiled without rounding.
#[test]
#[should_panic(expected = "unsound::Unrounded")]
fn without_rounding_a_surface_has_to_ask() {
    let scene = Scene::new().with(Hand::new(Sphere(0.7), 2.0));
    let _ = render(&scene, &cameras(1.0)[0], &options(Isa::unrounded()[0]));
}

/// The same code with rounding to nearest is caught.
#[test]
fn without_rounding_answers_are_wrong() {
    let s = Hand::new(Sphere(0.7), 2.0);
    for isa in Isa::unrounded() {
        let mut wrong = 0;
        for camera in cameras(1.0) {
            let scene = Scene::new().with_solver::<Unrounded, _>(s);
            let picture = render(&scene, &camera, &options(isa)).unwrap();
            wrong += judge_all(&picture, &truths(&camera, &s.domain, &|p| sphere(p, 0.7))).0;
        }
        println!("{isa}: {wrong} wrong answers");
        assert!(wrong > 0, "{isa}: rounding to nearest was not noticed");
    }
}
