//! Certified rendering of implicit surfaces.

pub mod camera;
pub mod contract;
pub mod interval;
pub mod ray;
pub mod render;
pub mod scene;
pub mod shade;
pub mod solve;
pub mod surface;
mod trace;
pub mod verdict;
