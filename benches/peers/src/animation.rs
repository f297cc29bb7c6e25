//! A camera that moves around the surface of the default example: frames per second.

use crate::Arguments;
use crate::family::{Form, SumOfExpQuadrics, quadratics};
use crate::random::Random;
use crate::timing::{Contender, digits, interleave, pool, timed};
use glam::DVec3;
use zeroset::render::{Options, render, render_over};
use zeroset::space::Subdivision;
use zeroset::{Camera, Scene};

const SIZE: u32 = 512;
const FRAMES: u32 = 60;
/// The default example's, as its arguments and its picture say.
const TERMS: usize = 8;
const SEED: u64 = 4;
const FROM: DVec3 = DVec3::new(2.6, -4.4, 2.5);
const AT: DVec3 = DVec3::new(0.0, 0.0, -0.03);
const DEGREES: f64 = 19.5;

fn scene() -> Scene {
    let mut random = Random::new(SEED);
    let terms = quadratics(&mut random, TERMS, Form::NegativeDefinite);
    Scene::new().with(SumOfExpQuadrics { terms, level: 0.5 })
}

/// Once around the vertical axis, a little up and down.
fn camera(frame: u32) -> Camera {
    let turn = std::f64::consts::TAU * f64::from(frame) / f64::from(FRAMES);
    let (sin, cos) = turn.sin_cos();
    let from = DVec3::new(
        cos * FROM.x - sin * FROM.y,
        sin * FROM.x + cos * FROM.y,
        FROM.z + 0.8 * (2.0 * turn).sin(),
    );
    Camera::perspective(from, AT, DVec3::Z, DEGREES).expect("a camera beside the scene")
}

/// All frames; their hits, so that nothing is left out.
fn film(scene: &Scene, change: fn(&mut Options)) -> u64 {
    let mut options = Options::new(SIZE, SIZE);
    change(&mut options);
    let mut last = render(scene, &camera(0), &options).expect("a valid scene");
    let mut hits = last.statistics().root;
    for frame in 1..FRAMES {
        last = render_over(last, scene, &camera(frame), &options).expect("a valid scene");
        hits += last.statistics().root;
    }
    hits
}

/// A name, whether there are boxes, and what is switched off.
type Way = (&'static str, bool, fn(&mut Options));

const WAYS: [Way; 4] = [
    ("beams", false, |_| ()),
    ("beams and octree", true, |_| ()),
    ("octree alone", true, |o| o.settings.beams = false),
    ("neither", false, |o| o.settings.beams = false),
];

/// Frames per second on one and on two threads; an octree is built once for each film, in the measured time.
pub fn run(arguments: &Arguments) {
    println!(
        "\n### An animation: the default example, {FRAMES} frames of {SIZE}²; depth {}; one thread by processor time\n",
        arguments.depth
    );
    println!(
        "| threads | | frames per second | s for all frames | by beams alone | hits |\n|---|---|---|---|---|---|"
    );
    let how = Subdivision {
        depth: arguments.depth,
        ..Subdivision::default()
    };
    for threads in [1, 2] {
        let pool = &pool(threads);
        let work = move |space: bool, change: fn(&mut Options)| {
            pool.install(|| {
                let mut scene = scene();
                if space {
                    scene = scene.subdivided(&how).expect("a valid scene");
                }
                film(&scene, change)
            })
        };
        let mut contenders: Vec<Contender> = WAYS
            .iter()
            .map(|&(_, space, change)| -> Contender {
                Box::new(move || timed(threads, || work(space, change)))
            })
            .collect();
        let times = interleave(arguments.runs, &mut contenders);
        for (&(name, space, change), time) in WAYS.iter().zip(&times) {
            let rate = |t: f64| digits(f64::from(FRAMES) / t);
            println!(
                "| {threads} | {name} | {} ({} … {}) | {} | {} | {} |",
                rate(time.median),
                rate(time.most),
                rate(time.least),
                digits(time.median),
                digits(time.median / times[0].median),
                work(space, change)
            );
        }
    }
}
