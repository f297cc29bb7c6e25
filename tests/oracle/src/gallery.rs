//! The pictures that are checked.

use std::ops::RangeInclusive;

use glam::DVec3;
use zeroset::camera::{Camera, Ray};
use zeroset::contract::unsound::Unrounded;
use zeroset::contract::{Auto, Contractor};
use zeroset::scene::Scene;
use zeroset::solve::Settings;
use zeroset::surface::Surface;

use crate::exponentials;
use crate::judge::{Oracle, Polynomial};
use crate::picture::Picture;
use crate::polynomials;
use crate::segment::Corners;
use crate::sturm::Poly;
use crate::sum::Sum;
use crate::surfaces::{DoubledSphere, Ellipsoid, Exponentials, Pole, Sphere, Torus, TorusQuartic};

/// The box of all pictures.
pub const CORNERS: Corners = [[-1.0; 3], [1.0; 3]];

/// Along the z axis: directions with two components that are 0.
pub fn along_z() -> (&'static str, Camera) {
    let from = DVec3::new(0.0, 0.0, 3.0);
    let camera = Camera::orthographic(from, DVec3::ZERO, DVec3::Y, 2.2);
    ("along z", camera.expect("a camera"))
}

/// In perspective, from an angle.
pub fn oblique() -> (&'static str, Camera) {
    from("oblique", 1.0, 30.0)
}

/// From an angle, `scale` times as far away as usual; the field of view in degrees.
fn from(name: &'static str, scale: f64, degrees: f64) -> (&'static str, Camera) {
    let from = DVec3::new(2.5, 1.8, 4.0) * scale;
    let camera = Camera::perspective(from, DVec3::ZERO, DVec3::Y, degrees);
    (name, camera.expect("a camera"))
}

fn picture<C: Contractor, S: Surface + 'static>(
    name: &str,
    surface: S,
    (view, camera): (&str, Camera),
    oracle: impl Oracle + Send + 'static,
) -> Picture {
    Picture {
        name: format!("{name}, {view}"),
        scene: Scene::new()
            .with_solver::<C, _>(surface)
            .within(CORNERS[0], CORNERS[1]),
        corners: CORNERS,
        camera,
        settings: Settings::default(),
        oracle: Box::new(oracle),
    }
}

/// Sphere, ellipsoid, both tori and the doubled sphere, near and far; quadrics also without their closed form.
pub fn polynomial_pictures() -> Vec<Picture> {
    polynomials_by::<Auto>()
}

fn polynomials_by<C: Contractor>() -> Vec<Picture> {
    let mut all = Vec::new();
    let views = [
        along_z(),
        oblique(),
        from("a thousand away", 2e2, 0.15),
        from("a million away", 2e5, 0.00015),
    ];
    for view in views {
        let quartic = Polynomial(|ray: &Ray| polynomials::torus(ray, 0.6, 0.25));
        all.extend(quadric::<C, _>("sphere", Sphere, view, polynomials::sphere));
        all.extend(quadric::<C, _>(
            "ellipsoid",
            Ellipsoid,
            view,
            polynomials::ellipsoid,
        ));
        all.push(picture::<C, _>("torus", Torus::default(), view, quartic));
        let quartic = Polynomial(polynomials::torus_quartic);
        all.push(picture::<C, _>(
            "torus as a quartic",
            TorusQuartic,
            view,
            quartic,
        ));
        let doubled = Polynomial(|ray: &Ray| polynomials::doubled_sphere(ray, 0.8));
        all.push(picture::<C, _>(
            "doubled sphere",
            DoubledSphere::default(),
            view,
            doubled,
        ));
    }
    all
}

/// A quadric with its closed form and without.
fn quadric<C: Contractor, S: Surface + Clone + 'static>(
    name: &str,
    surface: S,
    view: (&str, Camera),
    formula: fn(&Ray) -> Poly,
) -> [Picture; 2] {
    let closed = picture::<C, _>(name, surface.clone(), view, Polynomial(formula));
    let name = format!("{name} without closed form");
    let mut searched = picture::<C, _>(&name, surface, view, Polynomial(formula));
    searched.settings.closed_forms = false;
    [closed, searched]
}

/// Sums of 1, 8 and 64 exponentials for each of these seeds: along the z axis for odd ones, else in perspective.
pub fn sums(seeds: RangeInclusive<u64>) -> Vec<Picture> {
    let all = sums_with_terms::<Auto>(seeds);
    all.into_iter().map(|s| s.1).collect()
}

/// The same, with their terms.
pub fn sums_with_terms<C: Contractor>(seeds: RangeInclusive<u64>) -> Vec<(Sum, Picture)> {
    let mut all = Vec::new();
    for seed in seeds {
        let view = if seed % 2 == 1 { along_z() } else { oblique() };
        for terms in [1, 8, 64] {
            let sum = exponentials::random(seed, terms);
            let surface = Exponentials {
                rows: sum.rows.clone(),
                level: sum.level,
            };
            let name = format!("{terms} exponentials, seed {seed}");
            all.push((sum.clone(), picture::<C, _>(&name, surface, view, sum)));
        }
    }
    all
}

/// The pictures of the negative control, one of each kind of surface, for the back-ends without rounding.
pub fn controls() -> Vec<Picture> {
    let mut all = polynomials_by::<Unrounded>();
    all.retain(|p| p.name.ends_with("oblique"));
    let sums = sums_with_terms::<Unrounded>(2..=2);
    all.extend(sums.into_iter().map(|s| s.1));
    all
}

/// A solver's pictures: a pole, and surfaces with silhouettes.
pub fn by<C: Contractor>() -> Vec<Picture> {
    let view = oblique();
    // The pole lies before the root.
    let behind = from("from behind", -1.0, 30.0);
    let torus = Polynomial(|ray: &Ray| polynomials::torus(ray, 0.6, 0.25));
    let mut all = vec![
        picture::<C, _>("pole", Pole, behind, Polynomial(polynomials::pole)),
        picture::<C, _>("sphere", Sphere, view, Polynomial(polynomials::sphere)),
        picture::<C, _>("torus", Torus::default(), view, torus),
    ];
    for picture in &mut all {
        // What beams and closed forms settle is not the contractor's.
        picture.settings.closed_forms = false;
        picture.settings.beams = false;
    }
    all
}
