//! Single rays along the x axis, where the answer is known.

use crate::pairs::{Ball, Doubled, Parabola, ball, left};
use zeroset::camera::Ray;
use zeroset::glam::{DAffine3, DVec3, dvec3};
use zeroset::render::{RenderError, all_roots};
use zeroset::scene::SceneError;
use zeroset::surface::ParameterError;
use zeroset::verdict::{Verdict, Why};
use zeroset::{Operand, Options, Scene};

/// All events along the ray from x = −2 in a cube of half width 2, so that t is x + 2.
fn events(solid: impl Operand) -> Vec<Verdict> {
    let scene = Scene::new().with(solid).within([-2.0; 3], [2.0; 3]);
    let ray = Ray {
        origin: dvec3(-2.0, 0.0, 0.0),
        direction: DVec3::X,
    };
    let lists = all_roots(&scene, &ray, &Options::new(1, 1)).expect("a valid scene");
    assert_eq!(lists[0].0, 0.0);
    lists[0].1.clone()
}

/// Each place is the only one of its root.
#[track_caller]
fn roots(solid: impl Operand, places: &[f64]) {
    let events = events(solid);
    let fits = events.len() == places.len()
        && events.iter().zip(places).all(|(event, x)| {
            matches!(event, Verdict::Root { t } if t.contains(x + 2.0) && t.width() < 1e-12)
        });
    assert!(fits, "{events:?}, not roots at x = {places:?}");
}

/// One event, of which the order of faces is open.
#[track_caller]
fn open(solid: impl Operand, place: f64) {
    let events = events(solid);
    let [Verdict::Unresolved { t, why: Why::Order }] = events[..] else {
        panic!("{events:?}, not one open order");
    };
    assert!(t.contains(place + 2.0) && t.width() < 1e-10, "{t:?}");
}

#[test]
fn coincident_faces_are_reported() {
    // One side of a face in both operands, and the order does not matter: it is a root.
    roots(left(0.5) & left(0.5), &[0.5]);
    roots(left(0.5) | left(0.5) | left(0.5), &[0.5]);
    // Opposite sides: f = −|x − 1/2| and |x − 1/2| touch 0.
    open(left(0.5) | !left(0.5), 0.5);
    open(left(0.5) - left(0.5), 0.5);
}

#[test]
fn roots_too_close_to_order_are_reported() {
    // Apart by one part in 2⁴⁰ they have an order; one ulp apart they have none that eight-byte numbers of t can show.
    let near = 0.5 - 2f64.powi(-40);
    roots(left(0.5) - left(near), &[near, 0.5]);
    roots(left(near) - left(0.5), &[]);
    open(left(0.3) - left(0.3f64.next_down()), 0.3);
    // The order of all does not matter to a solid that each of them changes, nor to one that none changes.
    roots(left(0.3) & left(0.3f64.next_down()), &[0.3]);
    roots(
        left(-1.0) | (left(0.3) - left(0.3f64.next_down())) & left(-1.5),
        &[-1.0],
    );
}

#[test]
fn sides_come_from_signs_and_not_from_counts() {
    // A double root counts two, one or none; behind it f still has the same sign.
    let places = [-1.0, -0.9, 0.9, 1.0];
    let shell = || ball(0.0, 1.0) - ball(0.0, 0.9);
    roots((shell() - Doubled) & left(3.0), &places);
    // It is an event of the solid where it matters, and the roots behind are as certain as those before.
    let events = events(ball(0.0, 1.0) - Doubled);
    let certain: Vec<bool> = events.iter().map(Verdict::is_certain_hit).collect();
    assert!(
        certain.first() == Some(&true) && certain.last() == Some(&true) && certain.len() >= 3,
        "{events:?}"
    );
}

#[test]
fn outside_of_a_domain_nothing_is_claimed() {
    // y − √x has no side for x < 0, which matters inside of the ball only.
    let events = events(ball(0.0, 1.0) & Parabola);
    let Verdict::Unresolved {
        t,
        why: Why::Undefined,
    } = events[0]
    else {
        panic!("{events:?}");
    };
    assert!(t.contains(1.5) && t.lo < 1.1 && t.hi > 1.9, "{events:?}");
    // Outside of the other operand it does not matter.
    roots(ball(1.5, 0.3) - Parabola - left(-1.0), &[]);
    roots(
        (ball(1.5, 0.3) & left(9.0)) | (Parabola & left(-1.9) & !left(-1.8)),
        &[1.2, 1.8],
    );
}

#[test]
fn placements_are_exact_maps() {
    let shift = DAffine3::from_translation(dvec3(0.25, 0.0, 0.0));
    roots(ball(0.0, 1.0).placed(shift), &[-0.75, 1.25]);
    // In turn: first the scaling, then the shift. t keeps its meaning.
    let scale = DAffine3::from_scale(dvec3(0.5, 3.0, 1.0));
    roots(ball(0.0, 1.0).placed(scale).placed(shift), &[-0.25, 0.75]);
    roots(
        (ball(0.0, 1.0) - left(0.0)).placed(scale).placed(shift),
        &[0.25, 0.75],
    );
    // A mirror leaves inside what is inside.
    roots(
        left(0.5).placed(DAffine3::from_scale(dvec3(-1.0, 1.0, 1.0))) & left(1.0),
        &[-0.5, 1.0],
    );
}

#[test]
fn maps_without_an_inverse_are_refused() {
    for map in [
        DAffine3::from_scale(dvec3(1.0, 0.0, 1.0)),
        DAffine3::from_translation(dvec3(f64::NAN, 0.0, 0.0)),
    ] {
        let scene = Scene::new()
            .with(Ball::default().placed(map))
            .within([-2.0; 3], [2.0; 3]);
        let ray = Ray {
            origin: DVec3::ZERO,
            direction: DVec3::X,
        };
        let error = all_roots(&scene, &ray, &Options::new(1, 1)).expect_err("no such placement");
        let expected = ParameterError::Placement { surface: "Ball" };
        assert!(
            matches!(&error, RenderError::Scene(SceneError::Parameter(e)) if *e == expected),
            "{error}"
        );
        assert!(error.to_string().contains("determinant"), "{error}");
    }
}
