//! Certified rendering of implicit surfaces.

pub mod interval;
pub mod ray;
pub mod surface;
