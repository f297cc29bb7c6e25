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
    struct Part;
    let p0 = max((x + 0.6)^2 + (y + 0.6)^2 - 0.0049, max(z - 0.35, -z));
    let p1 = max(max(abs(x + 0.6) - 0.09, abs(y + 0.2) - 0.09), max(z - 0.4, -z));
    let p2 = (x + 0.6)^2 + (y - 0.2)^2 + (z - 0.125)^2 - 0.0100;
    let p3 = max((x + 0.6)^2 + (y - 0.6)^2 - 0.0064, max(z - 0.5, -z));
    let p4 = max(max(abs(x + 0.2) - 0.07, abs(y + 0.6) - 0.07), max(z - 0.35, -z));
    let p5 = (x + 0.2)^2 + (y + 0.2)^2 + (z - 0.200)^2 - 0.0169;
    let p6 = max((x + 0.2)^2 + (y - 0.2)^2 - 0.0036, max(z - 0.25, -z));
    let p7 = max(max(abs(x + 0.2) - 0.08, abs(y - 0.6) - 0.08), max(z - 0.5, -z));
    let p8 = (x - 0.2)^2 + (y + 0.6)^2 + (z - 0.175)^2 - 0.0121;
    let p9 = max((x - 0.2)^2 + (y + 0.2)^2 - 0.0081, max(z - 0.4, -z));
    let p10 = max(max(abs(x - 0.2) - 0.06, abs(y - 0.2) - 0.06), max(z - 0.25, -z));
    let p11 = (x - 0.2)^2 + (y - 0.6)^2 + (z - 0.250)^2 - 0.0144;
    let p12 = max((x - 0.6)^2 + (y + 0.6)^2 - 0.0049, max(z - 0.35, -z));
    let p13 = max(max(abs(x - 0.6) - 0.09, abs(y + 0.2) - 0.09), max(z - 0.4, -z));
    let p14 = (x - 0.6)^2 + (y - 0.2)^2 + (z - 0.125)^2 - 0.0100;
    let p15 = max((x - 0.6)^2 + (y - 0.6)^2 - 0.0064, max(z - 0.5, -z));
    let pegs = min(min(min(min(p0, p1), min(p2, p3)), min(min(p4, p5), min(p6, p7))), min(min(min(p8, p9), min(p10, p11)), min(min(p12, p13), min(p14, p15))));
    let h0 = (x + 0.4)^2 + (y + 0.4)^2 - 0.0064;
    let h1 = (x + 0.4)^2 + y^2 - 0.0064;
    let h2 = (x + 0.4)^2 + (y - 0.4)^2 - 0.0064;
    let h3 = x^2 + (y + 0.4)^2 - 0.0064;
    let h4 = x^2 + y^2 - 0.0064;
    let h5 = x^2 + (y - 0.4)^2 - 0.0064;
    let h6 = (x - 0.4)^2 + (y + 0.4)^2 - 0.0064;
    let h7 = (x - 0.4)^2 + y^2 - 0.0064;
    let h8 = (x - 0.4)^2 + (y - 0.4)^2 - 0.0064;
    let holes = min(min(min(min(h0, h1), min(h2, h3)), min(min(h4, h5), min(h6, h7))), h8);
    let plate = max(max(abs(x), abs(y)) - 0.85, abs(z) - 0.1);
    let dome = x^2 + y^2 + (z + 0.2)^2 - 0.16;
    let body = (plate + dome - sqrt((plate - dome)^2 + 0.01))/2;
    max(min(body, pegs), -holes) = 0
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
    let oblique = Camera::orthographic(DVec3::new(1.5, -2.0, 2.0), DVec3::ZERO, DVec3::Z, 2.4)
        .expect("a camera beside the z axis");
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
    measure(&only, "machine part", &Part, &oblique);
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
