//! Hard rays, one by one: first roots and all roots, on every processor path.

#![forbid(unsafe_code)]

use zeroset::camera::Ray;
use zeroset::interval::Isa;
use zeroset_oracle::gallery::{self, oblique};
use zeroset_oracle::picture::{Outcome, Picture, paths};
use zeroset_oracle::stress;

/// The polynomial surfaces, each once.
fn surfaces() -> Vec<Picture> {
    let mut all = gallery::polynomial_pictures();
    let view = oblique().0;
    all.retain(|p| p.name.ends_with(view));
    all
}

fn check(pictures: &[Picture], rays: &[Ray]) -> Vec<Outcome> {
    pictures.iter().map(|p| check_one(p, rays)).collect()
}

/// Nothing is wrong, and no path contradicts another; only the oracle for sums may be undecided.
fn check_one(picture: &Picture, rays: &[Ray]) -> Outcome {
    let outcome = picture.check_rays(rays, &paths());
    let mut wrong = outcome.wrong_lists.clone();
    for (path, tally) in &outcome.paths {
        println!("{}; {path}: {tally}", outcome.name);
        let sum = outcome.name.contains("exponentials");
        assert!(sum || tally.undecided == 0);
        if tally.wrong > 0 {
            wrong.extend(tally.examples.clone());
        }
    }
    assert_eq!(outcome.wrong(), 0, "{}: {}", outcome.name, wrong.join("\n"));
    let differences = outcome.differences.join("\n");
    assert_eq!(outcome.contradictions, 0, "{}: {differences}", outcome.name);
    outcome
}

/// Tangent to the sphere within ±3 ulp: hits, misses and tangencies, all of them right.
#[test]
fn tangent_rays() {
    let outcomes = check(&surfaces(), &stress::tangents(0.8, 400));
    let (_, sphere) = &outcomes[0].paths[0];
    assert!(sphere.misses > 0 && sphere.misses < sphere.rays);
}

#[test]
fn rays_parallel_to_axes_and_faces() {
    check(&surfaces(), &stress::parallels(400));
}

#[test]
fn rays_from_inside() {
    check(&surfaces(), &stress::towards(0.0, 400));
}

#[test]
fn rays_from_far_away() {
    for distance in [3.0, 1e3, 1e6, 1e9] {
        check(&surfaces(), &stress::towards(distance, 200));
    }
}

/// From a pixel's width beside the silhouette to the last bit.
#[test]
fn rays_that_graze() {
    let mut pictures = surfaces();
    pictures.extend(gallery::sums(1..=2));
    for picture in &pictures {
        let rays = stress::silhouettes(picture, 24, 12, Isa::available()[0]);
        assert!(rays.len() > 300, "{}: {} rays", picture.name, rays.len());
        let outcome = check_one(picture, &rays);
        for (path, tally) in &outcome.paths {
            // What the oracle for sums cannot tell is within 1e-9 of a tangency.
            assert!(
                tally.undecided * 2 < tally.rays,
                "{}; {path}: {tally}",
                picture.name
            );
        }
    }
}

/// As shadow rays do.
#[test]
fn rays_from_the_surface() {
    let near =
        |k: usize, x: f64| -> [f64; 3] { std::array::from_fn(|i| if i == k { x } else { 0.0 }) };
    let mut points = Vec::new();
    for (k, x) in [
        (0, 0.8),
        (1, -0.8),
        (0, 0.85),
        (1, 0.35),
        (2, 0.8),
        (0, 1.0),
        (1, 0.55),
    ] {
        points.extend([near(k, x), near(k, x.next_up()), near(k, x.next_down())]);
    }
    check(&surfaces(), &stress::starting_at(&points, 210));
}

#[test]
fn rays_with_odd_directions() {
    check(&surfaces(), &stress::lopsided(280));
}
