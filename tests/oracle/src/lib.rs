//! Surfaces declared as a user would, and answers about their rays that are found by other means: an oracle of its own
//! for every formula, that shares no arithmetic, no graph and no parser with the project.

#![forbid(unsafe_code)]
// Coordinates are told apart by their index, in several arrays at once; numbers have the operations that are used, by name.
#![allow(clippy::needless_range_loop, clippy::should_implement_trait)]

pub mod claims;
pub mod dyadic;
pub mod exponential;
pub mod exponentials;
pub mod gallery;
pub mod judge;
pub mod picture;
pub mod polynomials;
pub mod sample;
pub mod search;
pub mod segment;
pub mod stress;
pub mod sturm;
pub mod sum;
pub mod surfaces;
pub mod tally;
pub mod wide;
