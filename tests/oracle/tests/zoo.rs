//! Singular surfaces along random, tangent and special rays, against true roots that another program found: the bounded
//! part of `tests/zoo`, whose `oracle.py fixture` wrote the file.

#![forbid(unsafe_code)]

use zeroset::verdict::Verdict;
use zeroset_oracle::dyadic::Dyadic;
use zeroset_zoo::surfaces::{BarthSextic, Gyroid, Scherk, Steiner, ThinShell, Whitney};
use zeroset_zoo::text::{self, Answered};
use zeroset_zoo::trace;

/// A true root: its parameter from the ray's origin.
struct Truth {
    rays: Vec<zeroset::camera::Ray>,
    roots: Vec<Vec<Dyadic>>,
}

/// The rays of one surface with their roots inside the cube.
fn fixture(name: &str) -> Truth {
    let mut truth = Truth {
        rays: Vec::new(),
        roots: Vec::new(),
    };
    let lines = include_str!("../fixtures/zoo.txt").lines();
    let own = lines
        .skip_while(|line| *line != format!("surface {name}"))
        .skip(1)
        .take_while(|line| !line.starts_with("surface"));
    for line in own {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("ray") => {
                truth.rays.push(text::ray(words).expect("a ray"));
                truth.roots.push(Vec::new());
            }
            Some("root") => {
                let parts = text::numbers(words.take(3)).expect("a root");
                let root = parts
                    .iter()
                    .fold(Dyadic::whole(0), |sum, x| sum.add(&Dyadic::float(*x)));
                truth.roots.last_mut().expect("a ray's root").push(root);
            }
            other => panic!("{other:?} in the fixture"),
        }
    }
    assert!(truth.rays.len() > 100, "{name}");
    truth
}

/// Is the root in entry + [lo, hi], give or take what the fixture leaves out of its digits?
fn holds(answered: &Answered, event: &Verdict, root: &Dyadic) -> bool {
    let Some(t) = event.t() else {
        return false;
    };
    let slack = Dyadic::float(1e-40);
    let from = root.sub(&Dyadic::float(answered.entry));
    let below = from.add(&slack).sub(&Dyadic::float(t.lo));
    let above = Dyadic::float(t.hi).sub(&from.sub(&slack));
    below.sign() >= 0 && above.sign() >= 0
}

/// Roots outside all events, and certified roots that are none or several.
fn wrong(truth: &Truth, answers: &[Answered]) -> [usize; 2] {
    let mut wrong = [0; 2];
    for (roots, answered) in truth.roots.iter().zip(answers) {
        let held = |event: &Verdict| roots.iter().filter(|r| holds(answered, event, r)).count();
        for root in roots {
            let seen = answered.events.iter().any(|e| holds(answered, e, root));
            wrong[0] += usize::from(!seen);
        }
        for event in &answered.events {
            let certified = matches!(event, Verdict::Root { .. });
            wrong[1] += usize::from(certified && held(event) != 1);
        }
    }
    wrong
}

/// Everything a nanounit off.
fn shifted(answers: &[Answered]) -> Vec<Answered> {
    let mut answers = answers.to_vec();
    for answered in &mut answers {
        answered.entry += 1e-9;
    }
    answers
}

macro_rules! zoo {
    ($($test:ident: $name:literal in $half:expr, $surface:expr;)*) => {
        $(#[test]
        fn $test() {
            let truth = fixture($name);
            let answers = trace($surface, $half, &truth.rays).expect("rays");
            assert_eq!(wrong(&truth, &answers), [0, 0]);
            // The control.
            let [missed, false_ones] = wrong(&truth, &shifted(&answers));
            assert!(missed > 10 && false_ones > 10, "{missed} {false_ones}");
        })*
    };
}

zoo! {
    fifty_nodes: "barth_sextic" in 2.0, BarthSextic::default();
    double_lines_through_a_triple_point: "steiner" in 0.6, Steiner;
    a_pinch_point: "whitney" in 1.5, Whitney;
    waves: "gyroid" in std::f64::consts::TAU, Gyroid;
    sheets_apart_by_a_trillionth: "thin_shell" in 1.0, ThinShell::default();
    exponential_waves: "scherk" in 10.0, Scherk;
}
