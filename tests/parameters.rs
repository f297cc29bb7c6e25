//! Fields: defaults, setters, tables of fixed and run-time length, and what is refused.

#![forbid(unsafe_code)]

use zeroset::implicit;
use zeroset::surface::{Continuity, ParameterError, Surface};

implicit! {
    /// A ring around the z axis.
    #[derive(Clone, Debug, PartialEq)]
    #[domain(x in -2.5..2.5, y in -2.5..2.5, z in -1/3..sqrt(2))]
    pub struct Torus {
        /// Radius of the ring.
        pub major: f64 = 2,
        /// Radius of the tube.
        pub minor: f64 = 0.5,
    }
    (sqrt(x^2 + y^2) - major)^2 + z^2 = minor^2
}

implicit! { struct Union { balls: [[f64; 4]] }
min([a, b, c, r] in balls) { (x - a)^2 + (y - b)^2 + (z - c)^2 - r^2 } }

implicit! { struct Indexed { shifts: [f64], grid: [[f64; 2]; 2] = [[1, 2], [3, 4]] }
sum(i in 0..2) { (x - shifts[i + 1])^2 * grid[1][i] } + y + z }

implicit! { struct Sum { rows: [[f64; 2]] }
sum([a, b] in rows) { a*x + b } + 0*y + z }

#[test]
fn defaults_and_setters() {
    let torus = Torus::default();
    assert_eq!((torus.major, torus.minor), (2.0, 0.5));
    let other = torus.clone().with_major(3.0).with_minor(1.0);
    assert_eq!(
        other,
        Torus {
            major: 3.0,
            minor: 1.0
        }
    );
    assert_eq!(other.at([4.0, 0.0, 0.0]), 0.0);
}

#[test]
fn the_domain_is_rounded_outward() {
    let [low, high] = Torus::default().domain().expect("a domain");
    assert_eq!((low[0], high[0]), (-2.5, 2.5));
    // −1/3 and √2 are no doubles: the box must hold them.
    assert!(low[2] < -1.0 / 3.0 && (-1.0 / 3.0 - low[2]) < 1e-15);
    assert!(high[2] >= 2f64.sqrt() && (high[2] - 2f64.sqrt()) < 1e-15);
}

#[test]
fn numbers_that_are_not_finite_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = Torus::default()
            .with_minor(bad)
            .check()
            .expect_err("not finite");
        assert!(matches!(
            error,
            ParameterError::NotFinite {
                surface: "Torus",
                field: "minor",
                ..
            }
        ));
        assert!(error.to_string().contains("`minor` of `Torus`"), "{error}");
    }
    let error = Union {
        balls: vec![[0.0, 0.0, f64::NAN, 1.0]],
    }
    .check()
    .expect_err("not finite");
    assert!(matches!(
        error,
        ParameterError::NotFinite { field: "balls", .. }
    ));
}

#[test]
fn tables_that_are_too_short_are_refused() {
    let error = Union { balls: vec![] }
        .check()
        .expect_err("a minimum of nothing");
    assert_eq!(
        error,
        ParameterError::TooFewRows {
            surface: "Union",
            field: "balls",
            rows: 0,
            needed: 1
        }
    );
    let short = Indexed {
        shifts: vec![0.0, 1.0],
        grid: [[1.0; 2]; 2],
    };
    let error = short.check().expect_err("shifts[2] is used");
    assert_eq!(
        error,
        ParameterError::TooFewRows {
            surface: "Indexed",
            field: "shifts",
            rows: 2,
            needed: 3
        }
    );
    assert!(
        Indexed {
            shifts: vec![0.0, 1.0, 2.0],
            grid: [[1.0; 2]; 2]
        }
        .check()
        .is_ok()
    );
}

#[test]
fn tables_of_run_time_length() {
    let union = Union {
        balls: vec![[0.0, 0.0, 0.0, 1.0], [5.0, 0.0, 0.0, 2.0]],
    };
    assert_eq!(union.at([0.0; 3]), -1.0);
    assert_eq!(union.at([5.0, 0.0, 0.0]), -4.0);
    let indexed = Indexed {
        shifts: vec![9.0, 1.0, 2.0],
        grid: [[0.0; 2], [10.0, 100.0]],
    };
    assert_eq!(indexed.at([3.0, 0.5, 0.25]), 40.0 + 100.0 + 0.75);
    // An empty sum is 0.
    assert_eq!(Sum { rows: vec![] }.at([1.0, 2.0, 3.0]), 3.0);
    assert_eq!(
        Sum {
            rows: vec![[2.0, 1.0], [1.0, 1.0]]
        }
        .at([1.0, 2.0, 3.0]),
        8.0
    );
}

#[test]
fn locals_are_captured() {
    let radius = 0.5;
    let ball = implicit!(x ^ 2 + y ^ 2 + z ^ 2 = radius ^ 2);
    assert_eq!(ball.at([0.5, 0.0, 0.0]), 0.0);
}

#[test]
fn reports_say_what_the_compiler_knows() {
    assert_eq!(Torus::REPORT.degree, None);
    assert_eq!(Torus::REPORT.continuity, Continuity::Continuous);
    assert_eq!(Torus::REPORT.functions, ["sqrt"]);
    assert_eq!(Union::REPORT.continuity, Continuity::Continuous);
    assert_eq!(Indexed::REPORT.degree, Some(2));
    assert_eq!(Indexed::REPORT.leaves, 1);
    const { assert!(Union::REPORT.total) };
}
