//! Rays, eight at a time.

use crate::interval::{Interval, Packet};

/// The lines `origin + t·direction`, t ∈ [0, end], of one packet. Origins lie where the rays enter the box: the exact
/// ray's point at `entry` (a plain `f64` per ray, the same for all surfaces of a scene) is enclosed in `origin`, so
/// coordinates near the surface keep full precision however far away the camera is. Intervals that are wider than a
/// rounding make a beam: a bundle that holds every ray with origin and direction in them.
#[derive(Clone, Copy)]
pub struct Rays<P: Packet> {
    /// Where each ray enters the box; x, y, z.
    pub origin: [Interval<P::F>; 3],
    /// The direction as given, not normalised; x, y, z.
    pub direction: [Interval<P::F>; 3],
    /// The last t of interest, rounded up. Negative lanes hold no ray.
    pub end: P::F,
}
