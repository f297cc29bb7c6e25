//! Functions of one variable with known answers, on every instruction set, by every solver.

use glam::DVec3;
use zeroset::camera::Ray;
use zeroset::contract::{Auto, Bisection, Contractor, Halley, Newton, Tightened};
use zeroset::interval::{Interval, Isa};
use zeroset::render::{Options, all_roots};
use zeroset::scene::Scene;
use zeroset::verdict::{Verdict, Why};
use zeroset_tracing_tests::dual::Hand;
use zeroset_tracing_tests::formulas::Line;

/// All events of `line` on [from, to] along the x axis; t is x − from.
fn events<C: Contractor>(isa: Isa, line: Line, from: f64, to: f64, budget: u32) -> Vec<Verdict> {
    let domain = [[from, -1.0, -1.0], [to, 1.0, 1.0]];
    let scene = Scene::new().with_solver::<C, _>(Hand {
        formula: line,
        domain,
    });
    let ray = Ray {
        origin: DVec3::new(from, 0.0, 0.0),
        direction: DVec3::X,
    };
    let mut options = Options::new(1, 1);
    options.isa = Some(isa);
    options.settings.budget = budget;
    let mut lists = all_roots(&scene, &ray, &options).unwrap();
    let (entry, events) = lists.remove(0);
    assert_eq!(entry, 0.0);
    events
}

/// Runs a check for each solver with derivatives on each instruction set.
fn with_derivatives(check: impl Fn(&str, &dyn Fn(Line, f64, f64) -> Vec<Verdict>)) {
    for isa in Isa::available() {
        let name = |solver: &str| format!("{solver} on {isa}");
        check(&name("auto"), &|l, a, b| {
            events::<Auto>(isa, l, a, b, 10_000)
        });
        check(&name("newton"), &|l, a, b| {
            events::<Newton>(isa, l, a, b, 10_000)
        });
        check(&name("tightened"), &|l, a, b| {
            events::<Tightened>(isa, l, a, b, 10_000)
        });
        check(&name("halley"), &|l, a, b| {
            events::<Halley>(isa, l, a, b, 10_000)
        });
    }
}

/// The roots of a list that holds nothing else.
fn roots(name: &str, events: &[Verdict]) -> Vec<Interval> {
    let only = |v: &Verdict| match v {
        Verdict::Root { t } => *t,
        other => panic!("{name}: {other:?} in {events:?}"),
    };
    events.iter().map(only).collect()
}

/// Each root is where it should be, and tight.
fn assert_roots(name: &str, events: &[Verdict], expected: &[f64]) {
    let found = roots(name, events);
    assert_eq!(found.len(), expected.len(), "{name}: {found:?}");
    for (t, x) in found.iter().zip(expected) {
        // The expected value is rounded: within an ulp of the exact root.
        assert!(
            t.lo <= x + 4e-16 && x - 4e-16 <= t.hi,
            "{name}: {t:?} is not {x}"
        );
        assert!(t.hi - t.lo <= 1e-12, "{name}: {t:?} is wide");
    }
}

#[test]
fn simple_roots_are_found_and_tight() {
    with_derivatives(|name, run| {
        assert_roots(name, &run(Line::Plane(0.3), 0.0, 1.0), &[0.3]);
        assert_roots(name, &run(Line::Plane(2.0), 0.0, 1.0), &[]);
        assert_roots(
            name,
            &run(Line::ThreeRoots, -3.0, 3.0),
            &[3.0 - 2f64.sqrt(), 3.0, 3.0 + 2f64.sqrt()],
        );
        assert_roots(name, &run(Line::ThreeRoots, 0.5, 3.0), &[2f64.sqrt() - 0.5]);
    });
}

#[test]
fn sheets_as_close_as_floats_permit_are_told_apart() {
    with_derivatives(|name, run| {
        for e in [0.25, 1e-2, 1e-4, 1e-6, 1e-8] {
            let s = f64::sqrt(e);
            let events = run(Line::Sheets(e), 0.0, 2.0);
            let found = roots(name, &events);
            assert_eq!(found.len(), 2, "{name}, {e}: {events:?}");
            for (t, x) in found.iter().zip([1.0 - s, 1.0 + s]) {
                assert!(t.lo - 1e-10 <= x && x <= t.hi + 1e-10, "{name}, {e}: {t:?}");
                // f = (x − 1)² − e has noise 1e-16 and slope 2√e at its roots.
                assert!(
                    t.hi - t.lo <= 1e-12 + 4e-16 / s,
                    "{name}, {e}: {t:?} is wide"
                );
            }
        }
    });
}

#[test]
fn sheets_that_do_not_touch_zero_are_misses() {
    with_derivatives(|name, run| {
        for e in [-0.25, -1e-4, -1e-8, -1e-12] {
            assert_eq!(run(Line::Sheets(e), 0.0, 2.0), [], "{name}, {e}");
        }
    });
}

#[test]
fn a_double_root_is_a_tangency_and_never_a_root() {
    with_derivatives(|name, run| {
        for (line, from, to, at) in [
            (Line::Sheets(0.0), 0.3, 2.0, 0.7),
            (Line::Exponential, -1.1, 2.0, 1.1),
        ] {
            let events = run(line, from, to);
            let is_newton = name.starts_with("newton");
            match events[..] {
                [Verdict::Tangent { t, residual }] => {
                    assert!(t.contains(at) && t.width() < 1e-6, "{name}: {t:?}");
                    assert!(residual < 1e-14, "{name}: {residual}");
                }
                // Newton has no second derivative to prove it with.
                [Verdict::Unresolved { t, why: Why::Floor }] if is_newton => {
                    assert!(t.contains(at) && t.width() < 1e-6, "{name}: {t:?}");
                }
                _ => panic!("{name}, {line:?}: {events:?}"),
            }
        }
    });
}

#[test]
fn the_search_goes_on_behind_a_tangency() {
    with_derivatives(|name, run| {
        let events = run(Line::DoubleThenSingle, 0.3, 3.0);
        assert_eq!(events.len(), 2, "{name}: {events:?}");
        assert!(events[0].is_open(), "{name}: {events:?}");
        assert_roots(name, &events[1..], &[1.7]);
    });
}

#[test]
fn a_triple_root_is_a_crossing() {
    with_derivatives(|name, run| {
        let events = run(Line::Cube, 0.3, 2.0);
        match events[..] {
            [Verdict::Crossing { t }] => {
                assert!(t.contains(0.7) && t.width() < 1e-4, "{name}: {t:?}")
            }
            _ => panic!("{name}: {events:?}"),
        }
    });
}

#[test]
fn derivatives_are_not_used_across_a_pole() {
    // f' < 0 wherever it exists, and f < 0 at both ends; there is a root at 0.2.
    with_derivatives(|name, run| {
        let events = run(Line::Pole, -1.0, 1.0);
        let hits: Vec<_> = events
            .iter()
            .filter(|v| v.is_certain_hit())
            .copied()
            .collect();
        assert_roots(name, &hits, &[1.2]);
        let open: Vec<_> = events.iter().filter(|v| v.is_open()).collect();
        for v in &open {
            assert!(
                matches!(
                    v,
                    Verdict::Unresolved {
                        why: Why::Undefined,
                        ..
                    }
                ),
                "{name}: {events:?}"
            );
            assert!(v.t().unwrap().contains(1.0), "{name}: {events:?}");
        }
    });
}

#[test]
fn domains_are_left_and_entered() {
    with_derivatives(|name, run| {
        assert_roots(name, &run(Line::Root, -1.0, 1.0), &[1.25]);
        let events = run(Line::RootAtBorder, 0.0, 3.0);
        assert!(
            matches!(events[..], [Verdict::Unresolved { t, .. }] if t.contains(1.0)),
            "{name}: {events:?}"
        );
    });
}

#[test]
fn kinks_are_no_obstacle() {
    with_derivatives(|name, run| {
        assert_roots(name, &run(Line::Kink, 0.0, 3.0), &[0.5, 1.5]);
        // A root at the kink itself, without a change of sign, cannot be decided.
        let events = run(Line::Touch, 0.3, 3.0);
        assert!(
            matches!(events[..], [Verdict::Unresolved { t, .. }] if t.contains(0.7)),
            "{name}: {events:?}"
        );
    });
}

#[test]
fn sheets_closer_than_rounding_are_covered() {
    with_derivatives(|name, run| {
        let events = run(Line::Sheets(1e-20), 0.3, 2.0);
        for x in [0.7 - 1e-10, 0.7 + 1e-10] {
            let covered = |v: &Verdict| {
                v.t()
                    .is_some_and(|t| t.lo <= x + 4e-16 && x - 4e-16 <= t.hi)
            };
            assert!(events.iter().any(covered), "{name}: {events:?}");
        }
    });
}

#[test]
fn a_ray_in_the_surface_ends_quickly() {
    with_derivatives(|name, run| {
        let events = run(Line::Flat, -1.0, 1.0);
        // Rays are searched a little beyond the box.
        assert!(
            matches!(events[..], [Verdict::Unresolved { t, why: Why::Flat }] if t.lo == 0.0 && t.hi - 2.0 < 3e-13),
            "{name}: {events:?}"
        );
    });
}

#[test]
fn a_spent_budget_leaves_all_the_rest_open() {
    for isa in Isa::available() {
        let events = events::<Bisection>(isa, Line::DoubleThenSingle, 0.3, 3.0, 12);
        assert!(
            matches!(events[..], [Verdict::Unresolved { t, why: Why::Budget }] if t.hi >= 2.7 && t.contains(0.7)),
            "{events:?}"
        );
    }
}

#[test]
fn bisection_proves_crossings() {
    for isa in Isa::available() {
        let events = events::<Bisection>(isa, Line::ThreeRoots, 0.5, 3.0, 10_000);
        let x = 2f64.sqrt() - 0.5;
        assert!(
            matches!(events[..], [Verdict::Crossing { t }] if t.contains(x) && t.width() <= 1e-12),
            "{events:?}"
        );
    }
}

#[test]
fn a_root_on_the_face_of_the_box() {
    with_derivatives(|name, run| {
        for (c, at) in [(0.0, 0.0), (1.0, 1.0)] {
            let events = run(Line::Plane(c), 0.0, 1.0);
            // Proved where the arithmetic is exact; where each bound is widened the sign at the face stays open.
            match events[..] {
                [Verdict::Root { t } | Verdict::Unresolved { t, why: Why::Floor }] => {
                    assert!(t.contains(at) && t.width() < 1e-12, "{name}: {t:?}");
                }
                _ => panic!("{name}: {events:?}"),
            }
        }
    });
}
