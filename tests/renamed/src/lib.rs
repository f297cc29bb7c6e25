//! Surfaces in a crate that knows the library by another name, with every lint that its author could ask for.
//!
//! `cargo clippy --workspace` is the test: generated code stays quiet. What it computes is tested in `tests/`.

#![deny(warnings, missing_docs, missing_debug_implementations, unreachable_pub)]
#![deny(
    unused,
    nonstandard_style,
    rust_2018_idioms,
    future_incompatible,
    let_underscore
)]
#![deny(
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    unused_qualifications
)]
#![deny(clippy::all, clippy::pedantic)]
#![forbid(unsafe_code)]

/// The library, passed on as part of another one's interface.
pub mod shapes {
    pub use certified::{Surface, implicit};
}

certified::implicit! {
    /// A ball.
    #[derive(Clone, Debug, Default)]
    pub struct Ball;
    x^2 + y^2 + z^2 = 1
}

shapes::implicit! {
    /// A ring around the z axis, through the re-export.
    #[derive(Clone, Debug)]
    #[domain(x in -3..3, y in -3..3, z in -1..1)]
    pub struct Torus {
        /// Radius of the ring.
        pub major: f64 = 2,
        /// Radius of the tube.
        pub minor: f64 = 0.5,
    }
    let ring = sqrt(x^2 + y^2) - major;
    ring^2 + z^2 = minor^2
}

certified::implicit! {
    /// Every kind of operation: tables, folds, branches, functions.
    #[derive(Clone, Debug)]
    pub struct Everything {
        /// Numbers.
        pub shifts: [f64; 3] = [0, 0.25, 1/3],
        /// Rows of a length that is known when the program runs.
        pub rows: [[f64; 2]] = [[1, 2]],
    }
    let side = if x > 0 && y <= 1 { x } else if z < 0 { -z } else { y };
    let waves = sum(i in 0..3) { sin(shifts[i]*x)/(2 + i) };
    max(min(side, waves), abs(z)) + exp(-x^2)*sum([a, b] in rows) { a*cos(b*y) } - clamp(z, -1, 1) + atan2(y, 3)
}

/// A surface inside a function, and one that captures a local.
#[must_use]
pub fn values(point: [f64; 3]) -> [f64; 2] {
    use certified::Surface as _;
    certified::implicit! { struct Plane { height: f64 } z - height }
    let radius = 2.0;
    let captured = certified::implicit!(x ^ 2 + y ^ 2 + z ^ 2 = radius ^ 2);
    [Plane { height: 1.0 }.at(point), captured.at(point)]
}

/// A surface made by a macro of this crate.
macro_rules! slab {
    ($(#[$attribute:meta])* $vis:vis $name:ident, $half:expr) => {
        certified::implicit! {
            $(#[$attribute])*
            #[derive(Clone, Copy, Debug)]
            $vis struct $name;
            abs(z) - $half
        }
    };
}

slab!(
    /// A slab, half as thick as a ball.
    pub Slab,
    1/2
);

mod inner {
    slab!(pub(crate) Hidden, 1 + 1);
}

/// What the surface of a private module is worth at a point.
#[must_use]
pub fn hidden(point: [f64; 3]) -> f64 {
    use shapes::Surface as _;
    inner::Hidden.at(point)
}

/// Everything that generated code names, under other meanings.
pub mod shadowed {
    #![allow(non_camel_case_types, dead_code)]
    struct f64;
    struct bool;
    struct usize;
    struct Vec;
    struct Option;
    struct Result;
    struct Some;
    struct None;
    struct Ok;
    struct Err;
    trait Default {}
    trait Surface {}
    trait Arithmetic {}
    mod std {}
    mod core {}
    mod certified {}

    ::certified::implicit! {
        /// Its fields are of the primitive type all the same.
        #[derive(Debug)]
        pub struct Shadowed {
            /// Numbers.
            pub row: [f64; 3] = [1; 3],
            /// Rows.
            pub rows: [[f64; 2]] = [[1, 2]],
        }
        // Known numbers that only bounds and indices use.
        let first = 1;
        let last = first + 1;
        x^2 + sum(i in 0..last) { i*y } + row[last] + sum([a, b] in rows) { a*z + b }
    }
}
