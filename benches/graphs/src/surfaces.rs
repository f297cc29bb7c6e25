//! Every surface of the zoo, and sums of exponentials of quadrics, in three forms.

use std::f64::consts::TAU;

use crate::entry::Evaluate;
use zeroset_zoo::each_surface;

/// A surface in three forms.
pub struct Forms {
    /// Its name.
    pub name: &'static str,
    /// Half the side of a cube that shows it.
    pub half: f64,
    /// Naive, shared, in stages with all polynomials as they are written, as users get it.
    pub forms: [Box<dyn Evaluate>; 4],
}

/// A surface's name, half the side of its cube, and itself.
type Listed = (&'static str, f64, Box<dyn Evaluate>);

macro_rules! listed {
    ($($name:literal in $half:tt: $surface:expr;)*) => {
        vec![$(($name, $half, Box::new($surface) as Box<dyn Evaluate>)),*]
    };
}

/// Coefficients of negative definite quadrics around points of a cube.
fn rows(terms: usize) -> Vec<[f64; 10]> {
    let row = |k: usize| {
        let place = |scale: f64| 1.4 * ((k as f64 + 0.5) * scale).fract() - 0.7;
        let c = [0.618, 0.755, 0.570].map(place);
        let s = [0.413, 0.291, 0.834].map(|scale| 22.0 + 15.0 * place(scale));
        let square: f64 = (0..3).map(|i| s[i] * c[i] * c[i]).sum();
        let linear = |i: usize| 2.0 * s[i] * c[i];
        [
            -s[0],
            -s[1],
            -s[2],
            1.5,
            -2.5,
            0.5,
            linear(0),
            linear(1),
            linear(2),
            -square,
        ]
    };
    (0..terms).map(row).collect()
}

macro_rules! list {
    ($($form:ident)*) => {
        [$({
            use crate::$form::{family::ExponentialsOfQuadrics, zoo as s};
            let sum = |terms| ExponentialsOfQuadrics { rows: rows(terms), level: 0.5 };
            let mut all: Vec<Listed> = each_surface!(listed(s));
            all.extend(listed! {
                "8 exponentials of quadrics" in 1.0: sum(8);
                "64 exponentials of quadrics" in 1.0: sum(64);
            });
            all
        }),*]
    };
}

/// All of them.
pub fn all() -> Vec<Forms> {
    let [naive, shared, written, staged] = list!(naive shared written staged);
    let pairs = naive.into_iter().zip(shared);
    let both = pairs.zip(written.into_iter().zip(staged));
    both.map(|((a, b), (c, d))| Forms {
        name: d.0,
        half: d.1,
        forms: [a.2, b.2, c.2, d.2],
    })
    .collect()
}
