//! What a certified ray costs: nanoseconds per ray of a 512² picture on one thread, for each processor path, beside one
//! plain `f64` evaluation of the same formula per ray. All columns are measured in turn in one run; medians.

#![forbid(unsafe_code)]

use cpu_time::ProcessTime;
use glam::DVec3;
use std::hint::black_box;
use zeroset::camera::{Camera, Sampling};
use zeroset::implicit;
use zeroset::interval::Isa;
use zeroset::render::{Options, render};
use zeroset::scene::Scene;
use zeroset::surface::Surface;

implicit! { #[derive(Clone)] struct Sphere; x^2 + y^2 + z^2 = 0.64 }

implicit! {
    #[derive(Clone)]
    struct Torus { major: f64 = 0.6, minor: f64 = 0.25 }
    (sqrt(x^2 + y^2) - major)^2 + z^2 = minor^2
}

implicit! {
    #[derive(Clone)]
    struct Exponentials { rows: [[f64; 10]], level: f64 = 0.5 }
    level = sum([a, b, c, d, e, f, g, h, i, j] in rows) {
        exp(a*x^2 + b*y^2 + c*z^2 + d*x*y + e*x*z + f*y*z + g*x + h*y + i*z + j)
    }
}

implicit! {
    #[derive(Clone)]
    struct Balls { rows: [[f64; 4]] }
    min([cx, cy, cz, r] in rows) { (x - cx)^2 + (y - cy)^2 + (z - cz)^2 - r^2 } = 0
}

implicit! {
    #[derive(Clone)]
    struct Barth;
    let phi = (1 + sqrt(5)) / 2;
    let p = 1.9*x;
    let q = 1.9*y;
    let r = 1.9*z;
    4*(phi^2*p^2 - q^2)*(phi^2*q^2 - r^2)*(phi^2*r^2 - p^2) = (1 + 2*phi)*(p^2 + q^2 + r^2 - 1)^2
}

/// The side of the picture.
const SIZE: u32 = 512;
/// Timed runs of each column.
const RUNS: usize = 9;

fn main() {
    let camera = Camera::orthographic(DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO, DVec3::Y, 2.0)
        .expect("a camera along the z axis");
    println!(
        "ns of CPU time per ray, {SIZE}² rays, one thread, median of {RUNS} interleaved runs (least … most)"
    );
    // A name restricts the run to the surfaces whose names hold it.
    let only = std::env::args().nth(1).unwrap_or_default();
    measure(&only, "sphere", &Sphere, &camera);
    measure(&only, "torus with sqrt", &Torus::default(), &camera);
    measure(&only, "Barth sextic", &Barth, &camera);
    measure(&only, "8 exponentials", &exponentials(8), &camera);
    measure(&only, "64 exponentials", &exponentials(64), &camera);
    measure(&only, "64 balls", &balls(64), &camera);
}

/// Numbers in [0, 1), always the same.
fn numbers() -> impl FnMut() -> f64 {
    let mut state = 1u64;
    move || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Balls inside the cube, from a fixed seed.
fn balls(count: usize) -> Balls {
    let mut random = numbers();
    let mut row = || {
        let c: [f64; 3] = std::array::from_fn(|_| 1.6 * random() - 0.8);
        [c[0], c[1], c[2], 0.08 + 0.1 * random()]
    };
    Balls {
        rows: (0..count).map(|_| row()).collect(),
    }
}

/// Negative definite quadratics around centres inside the ball of radius 0.7, from a fixed seed.
fn exponentials(terms: usize) -> Exponentials {
    let mut random = numbers();
    let mut rows = Vec::new();
    while rows.len() < terms {
        let c: [f64; 3] = std::array::from_fn(|_| 1.4 * random() - 0.7);
        let s: [f64; 3] = std::array::from_fn(|_| 15.0 + 30.0 * random());
        let m: [f64; 3] = std::array::from_fn(|_| 8.0 * (random() - 0.5));
        // −(s·d² + m·dd) about c; the mixed terms are small beside the squares, so it is negative definite.
        let [a, b, e] = s.map(|v| -v);
        let [xy, xz, yz] = m;
        let g = -(2.0 * a * c[0] + xy * c[1] + xz * c[2]);
        let h = -(2.0 * b * c[1] + xy * c[0] + yz * c[2]);
        let i = -(2.0 * e * c[2] + xz * c[0] + yz * c[1]);
        let j = -0.5 * (g * c[0] + h * c[1] + i * c[2]);
        rows.push([a, b, e, xy, xz, yz, g, h, i, j]);
    }
    Exponentials { rows, level: 0.5 }
}

fn measure<S: Surface + Clone + 'static>(only: &str, name: &str, surface: &S, camera: &Camera) {
    if !name.contains(only) {
        return;
    }
    let scene = Scene::new()
        .with(surface.clone())
        .within([-1.0; 3], [1.0; 3]);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("one thread");
    let mut paths = Isa::available();
    // A path's name restricts it further.
    if let Some(path) = std::env::args().nth(2) {
        paths.retain(|isa| isa.name() == path);
    }
    let mut times = vec![Vec::new(); paths.len() + 1];
    let mut report = Vec::new();
    for run in 0..=RUNS {
        for (k, &isa) in paths.iter().enumerate() {
            let mut options = Options::new(SIZE, SIZE);
            options.isa = Some(isa);
            let start = ProcessTime::now();
            let picture = pool
                .install(|| render(&scene, camera, &options))
                .expect("a valid scene");
            let time = start.elapsed();
            // The first round warms up, and tells what was done.
            if run == 0 {
                report.push(picture.statistics().clone());
            } else {
                times[k].push(time.as_nanos() as f64);
            }
        }
        let start = ProcessTime::now();
        evaluate(surface, camera);
        if run > 0 {
            times[paths.len()].push(start.elapsed().as_nanos() as f64);
        }
    }
    println!("{name}");
    let rays = f64::from(SIZE * SIZE);
    for (k, times) in times.iter_mut().enumerate() {
        times.sort_by(f64::total_cmp);
        let [least, median, most] = [0, times.len() / 2, times.len() - 1].map(|i| times[i] / rays);
        let label = paths.get(k).map_or("plain f64, once", |isa| isa.name());
        let done = report.get(k).map(|s| {
            let e = &s.evaluations;
            let per = |n: u64| n as f64 / rays;
            format!(
                "beams {:.3} value {:.2} slope {:.2} point {:.2} float {:.2} curvature {:.2} fine {:.3} per ray; roots {} misses {} other {}",
                per(e.beams), per(e.value), per(e.slope), per(e.point), per(e.float), per(e.curvature), per(e.fine),
                s.root, s.miss, s.rays - s.root - s.miss
            )
        });
        println!(
            "  {label:16} {median:8.2} ({least:.2} … {most:.2})  {}",
            done.unwrap_or_default()
        );
    }
}

/// One plain evaluation per ray, where the ray starts.
fn evaluate<S: Surface>(surface: &S, camera: &Camera) {
    let mut sum = 0.0;
    for y in 0..SIZE {
        for x in 0..SIZE {
            let ray = camera.ray(x, y, SIZE, SIZE, Sampling::Centre);
            sum += surface.at(ray.at(2.5).to_array());
        }
    }
    black_box(sum);
}
