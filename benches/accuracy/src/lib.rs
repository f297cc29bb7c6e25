//! The zoo, each surface in its cube. Apart from the program, so that it is compiled once.

#![forbid(unsafe_code)]

use std::f64::consts::TAU;

use zeroset_accuracy::subject::{Named, Subject};
use zeroset_zoo::surfaces as s;

/// This library's other solvers are compiled and measured for some surfaces only, one of each kind: compiling them for all
/// takes half an hour.
macro_rules! subject {
    ("sphere", $($rest:tt)*) => { named!(true, "sphere", $($rest)*) };
    ("torus", $($rest:tt)*) => { named!(true, "torus", $($rest)*) };
    ("barth_sextic", $($rest:tt)*) => { named!(true, "barth_sextic", $($rest)*) };
    ("chmutov_8", $($rest:tt)*) => { named!(true, "chmutov_8", $($rest)*) };
    ("gyroid", $($rest:tt)*) => { named!(true, "gyroid", $($rest)*) };
    ("exponentials", $($rest:tt)*) => { named!(true, "exponentials", $($rest)*) };
    ($($all:tt)*) => { named!(false, $($all)*) };
}

macro_rules! named {
    ($all_solvers:literal, $name:tt, $half:expr, $surface:expr) => {
        Box::new(Named::<_, $all_solvers> {
            name: $name,
            half: $half,
            surface: $surface,
        })
    };
}

macro_rules! subjects {
    ($($name:tt in $half:tt: $surface:expr;)*) => {
        vec![$(subject!($name, $half, $surface)),*]
    };
}

/// All of them.
pub fn subjects() -> Vec<Box<dyn Subject>> {
    zeroset_zoo::each_surface!(subjects(s))
}
