//! Errors and counts on a few surfaces; times are for `cargo run --release -p accuracy`.

use zeroset::interval::Isa;
use zeroset_accuracy::judge::{Claim, Claimed, Score};
use zeroset_accuracy::methods::Method;
use zeroset_accuracy::ours::Solver;
use zeroset_accuracy::subject::{Named, Subject};
use zeroset_accuracy::trial::Trial;
use zeroset_accuracy::truth::{self, Known};
use zeroset_zoo::surfaces as s;

const TRUTH: &str = include_str!("../truth.txt");

fn known(name: &str) -> Vec<Known> {
    truth::read(TRUTH).remove(name).expect("a truth")
}

/// Every solver on every instruction set: nothing is wrong, and what is open is what cannot be decided.
fn certified(subject: &dyn Subject, largest: f64, open: u32) {
    let known = known(subject.name());
    let trial = Trial::new(subject, &known);
    for isa in Isa::available() {
        for &solver in subject.solvers() {
            let (score, evaluations) = trial.ours(solver, isa);
            let name = format!("{} {} {isa}", subject.name(), solver.name());
            println!(
                "{name}: largest {:.1e}, median {:.1e}, open {}, evaluations {evaluations:.1}",
                score.largest(),
                score.median(),
                score.open
            );
            assert_eq!(score.wrong(), 0, "{name}: {score:?}");
            assert!(score.largest() <= largest, "{name}: {:e}", score.largest());
            assert!(
                solver == Solver::Bisection || score.open <= open,
                "{name}: {score:?}"
            );
            assert!(score.rays > 250, "{name}");
        }
    }
}

/// The usual methods get close where they find the root, and some have wrong rays: the judge sees them.
fn usual(subject: &dyn Subject, careful: Method, careless: Method) {
    let known = known(subject.name());
    let trial = Trial::new(subject, &known);
    let isa = Isa::available()[0];
    for tolerance in [1e-4, 1e-10] {
        let (score, _) = trial.theirs(careful, tolerance, isa);
        println!(
            "{} {careful} {tolerance:e}: {} wrong, largest {:.1e}",
            subject.name(),
            score.wrong(),
            score.largest()
        );
        assert!(
            score.wrong() <= 3 && score.largest() < 30.0 * tolerance,
            "{careful}: {score:?}"
        );
        assert!(score.errors.len() > 20, "{careful}: {score:?}");
    }
    let (score, _) = trial.theirs(careless, 1e-6, isa);
    assert!(score.wrong() > 10, "control: {careless}: {score:?}");
}

fn sphere() -> impl Subject {
    Named::<_, true> {
        name: "sphere",
        half: 1.0,
        surface: s::Sphere,
    }
}

fn barth() -> impl Subject {
    let surface = s::BarthSextic::default();
    Named::<_, false> {
        name: "barth_sextic",
        half: 2.0,
        surface,
    }
}

fn gyroid() -> impl Subject {
    let half = std::f64::consts::TAU;
    Named::<_, true> {
        name: "gyroid",
        half,
        surface: s::Gyroid,
    }
}

#[test]
fn certified_roots_are_right() {
    certified(&sphere(), 1e-13, 0);
    certified(&barth(), 1e-12, 2);
    certified(&gyroid(), 1e-13, 0);
}

#[test]
fn the_usual_methods_are_what_they_are() {
    usual(&sphere(), Method::Sphere(4096), Method::Sphere(4));
    usual(&sphere(), Method::Polynomial(2), Method::Marching(1));
    usual(&barth(), Method::Marching(2048), Method::Newton(8));
    usual(&barth(), Method::Polynomial(6), Method::Marching(8));
    usual(&gyroid(), Method::Segment(4096), Method::Segment(3));
    usual(&gyroid(), Method::Newton(512), Method::Newton(2));
}

#[test]
fn wrong_claims_are_counted() {
    let known = Known {
        roots: vec![[1.0, 1e-20], [1.5, 0.0]],
        undecided: false,
    };
    let none = Known::default();
    let unknown = Known {
        undecided: true,
        ..Known::default()
    };
    let mut score = Score::default();
    let mut add =
        |known: &Known, claim: Claim| score.add(known, &Claimed { entry: 0.5, claim }, 2.0, 1e-6);
    add(&known, Claim::Root(0.5));
    add(&known, Claim::Root(0.5 + 1e-4));
    add(&known, Claim::Root(1.0));
    add(&known, Claim::Root(0.25));
    add(&known, Claim::Nothing);
    add(&known, Claim::Open);
    add(&none, Claim::Nothing);
    add(&none, Claim::Root(0.1));
    add(&unknown, Claim::Root(0.1));
    let score = score.finished();
    assert_eq!((score.rays, score.open), (8, 1));
    assert_eq!((score.missed, score.invented, score.wrong_sheet), (1, 2, 1));
    assert_eq!(score.errors.len(), 2);
    assert!(
        score.errors[0] < 1e-19 && (score.largest() - 5e-5).abs() < 1e-12,
        "{score:?}"
    );
}
