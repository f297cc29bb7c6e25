//! Three surfaces whose kernels `scripts/inlining` disassembles: a quadric, a root of a quadric, a sum of exponentials.

use zeroset::glam::{DVec3, dvec3};
use zeroset::{Camera, Options, Scene, implicit, render};

implicit! {
    pub struct Sphere;
    x^2 + y^2 + z^2 = 1
}

implicit! {
    pub struct Torus;
    (sqrt(x^2 + y^2) - 1)^2 + z^2 = 0.09
}

implicit! {
    pub struct Blobs {
        pub rows: [[f64; 4]; 4] =
            [[0.5, 0, 0, 4], [-0.5, 0, 0, 4], [0, 0.5, 0.2, 5], [0, -0.5, -0.2, 5]],
    }
    1 = sum([a, b, c, k] in rows) { 2*exp(-k*((x - a)^2 + (y - b)^2 + (z - c)^2)) }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Scene::new()
        .with(Sphere)
        .with(Torus)
        .with(Blobs::default())
        .within([-1.5; 3], [1.5; 3]);
    let camera = Camera::perspective(dvec3(3.0, 2.0, 1.0), DVec3::ZERO, DVec3::Z, 40.0)?;
    let picture = render(&scene, &camera, &Options::new(32, 32))?;
    println!("{}", picture.statistics());
    Ok(())
}
