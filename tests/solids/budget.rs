//! What an operand's spent budget leaves open is reported to the end of the ray, and no root behind is called the first.

use crate::pairs::left;
use std::f64::consts::PI;
use zeroset::camera::Ray;
use zeroset::glam::{DVec3, dvec3};
use zeroset::interval::Isa;
use zeroset::render::trails;
use zeroset::verdict::{Verdict, Why};
use zeroset::{Options, Scene, Solid, implicit};

// Many roots along x, not at 0.
implicit! { #[derive(Clone)] struct Waves; sin(40*x + 1) }

/// The parameters of its roots on the ray from x = −2 to x = `to`.
fn places(to: f64) -> Vec<f64> {
    let place = |k: i32| (f64::from(k) * PI - 1.0) / 40.0 + 2.0;
    (-40..40)
        .map(place)
        .filter(|t| (0.0..to + 2.0).contains(t))
        .collect()
}

/// The events along this ray, and the number of evaluations.
fn events(solid: Solid, budget: u32, isa: Isa) -> (Vec<Verdict>, u64) {
    let scene = Scene::new().with(solid).within([-2.0; 3], [2.0; 3]);
    let ray = Ray {
        origin: dvec3(-2.0, 0.0, 0.0),
        direction: DVec3::X,
    };
    let mut options = Options::new(1, 1);
    options.settings.budget = budget;
    options.isa = Some(isa);
    let trail = trails(&scene, &ray, &options)
        .expect("a valid scene")
        .remove(0);
    (trail.events, trail.evaluations.total())
}

/// All faces in order, then what is open: how many faces are told.
fn told(events: &[Verdict], places: &[f64], end: f64) -> usize {
    let near = |(event, place): &(&Verdict, &f64)| {
        // Places are rounded.
        event
            .t()
            .is_some_and(|t| t.lo - 1e-12 < **place && **place < t.hi + 1e-12)
    };
    let roots = events.iter().take_while(|event| event.is_certain_hit());
    let count = roots.zip(places).take_while(near).count();
    match &events[count..] {
        [] => assert_eq!(count, places.len(), "some are missing: {events:?}"),
        [
            Verdict::Unresolved {
                t,
                why: Why::Budget,
            },
        ] => {
            let next = places.get(count).copied().unwrap_or(end);
            assert!(t.lo <= next && t.hi >= end, "{next} is not in {events:?}");
        }
        rest => panic!("{rest:?} behind {count} of {places:?}"),
    }
    count
}

#[test]
fn a_spent_budget_leaves_the_rest_of_an_operand_open() {
    for isa in Isa::available() {
        let mut counts = Vec::new();
        for budget in (2..200).chain([500, 1_000, 2_500, 100_000]) {
            // It is traced as a solid, and the other operand is far away.
            let (list, evaluations) = events(Waves & left(9.0), budget, isa);
            let all = places(2.0);
            counts.push(told(&list, &all, 4.0));
            // Signs between roots come on top.
            let most = u64::from(budget) + 4 * (all.len() as u64 + 1);
            assert!(
                evaluations > 0 && evaluations <= most,
                "{evaluations} of {budget}"
            );
            // A cut in front: the first face is there, or behind it.
            let (list, _) = events(Waves - left(0.5), budget, isa);
            let faces: Vec<f64> = places(2.0).into_iter().filter(|t| *t > 2.5).collect();
            let first = if (40.0f64 * 0.5 + 1.0).sin() < 0.0 {
                2.5
            } else {
                faces[0]
            };
            let begin = list
                .first()
                .and_then(Verdict::t)
                .expect("a face, or what is open");
            assert!(begin.lo <= first, "{begin:?} is behind {first}");
        }
        let part = counts
            .iter()
            .filter(|n| (1..places(2.0).len()).contains(*n))
            .count();
        assert!(
            part > 50 && counts.last() == Some(&places(2.0).len()),
            "{counts:?}"
        );
    }
}
