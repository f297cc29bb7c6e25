//! What the surfaces of this crate are worth, and that they render.

use certified::glam::{DVec3, dvec3};
use certified::{Camera, Options, Scene, Surface, render};
use zeroset_renamed::{Ball, Everything, Slab, Torus, hidden, values};

#[test]
fn formulas_keep_their_values() {
    assert_eq!(Ball.at([2.0, 0.0, 0.0]), 3.0);
    assert_eq!(Torus::default().at([2.0, 0.0, 0.0]), -0.25);
    assert_eq!(Torus::default().with_minor(1.0).at([2.0, 0.0, 0.0]), -1.0);
    assert_eq!(Slab.at([0.0, 0.0, -2.0]), 1.5);
    assert_eq!(hidden([0.0, 0.0, -3.0]), 1.0);
    assert_eq!(values([0.0, 0.0, 3.0]), [2.0, 5.0]);
    // At the origin: the largest of 0 and 0, then exp(0)·1·cos(0) − 0 + atan2(0, 3).
    assert_eq!(Everything::default().at([0.0; 3]), 1.0);
}

#[test]
fn a_scene_mixes_them() {
    let camera = Camera::perspective(dvec3(5.0, 4.0, 3.0), DVec3::ZERO, DVec3::Z, 40.0);
    let scene = Scene::new().with(Ball).with(Torus::default());
    let scene = scene.within([-3.0; 3], [3.0; 3]);
    let picture = render(&scene, &camera.expect("a camera"), &Options::new(32, 32));
    let picture = picture.expect("a picture");
    assert_eq!(picture.surfaces(), ["Ball", "Torus"]);
    let counts = picture.statistics();
    assert!(counts.root > 100 && counts.miss > 100, "{counts}");
    assert_eq!(counts.unresolved, 0, "{counts}");
}
