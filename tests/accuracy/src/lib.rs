//! The first root along each ray of a picture: by this library, and by the methods that people use in plain `f64`.
//!
//! The usual methods get what a fair rival would have: packets of eight rays on the best instruction set, the same
//! compiled formula in plain floats, with quadratic parts reduced to coefficients once per ray, and a setting tuned for
//! each tolerance. What is measured is in units of the box: an error of 1 is half the width of the cube.

#![forbid(unsafe_code)]

pub mod judge;
pub mod methods;
pub mod ours;
pub mod probe;
pub mod subject;
pub mod trial;
pub mod truth;

/// Columns and rows of the pictures.
pub const SIZE: u32 = 96;
/// Every so many pixels, in both directions, the truth is known.
pub const STRIDE: u32 = 6;
