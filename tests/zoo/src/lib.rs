//! Some forty surfaces, and what the library says about given rays.
//!
//! Rays come as lines, `surface NAME` and below it `ray O O O D D D`, numbers as the bits of `f64`s; to each ray goes
//! its entry into the cube, and then its events follow: `root LO HI`, `tangent LO HI RESIDUAL`, `crossing LO HI`,
//! `open LO HI`, counted from the entry. `oracle.py` writes such rays, and judges the answers.

#![forbid(unsafe_code)]

pub mod list;
pub mod nodes;
pub mod surfaces;
pub mod text;

use text::Answered;
use zeroset::Surface;
use zeroset::camera::Ray;
use zeroset::implicit;
use zeroset::interval::Isa;
use zeroset::query::Query;

/// All events along each ray, in a cube of this half width.
///
/// # Errors
/// If a ray is not one.
pub fn trace<S: Surface>(surface: S, half: f64, rays: &[Ray]) -> Result<Vec<Answered>, String> {
    let isa = Isa::detect().map_err(|e| e.to_string())?;
    let query =
        Query::<S>::new(&surface, [[-half; 3], [half; 3]], isa).map_err(|e| e.to_string())?;
    rays.iter()
        .map(|ray| {
            let trail = query.trail(ray).map_err(|e| e.to_string())?;
            Ok(Answered {
                ray: *ray,
                entry: trail.entry,
                events: trail.events,
            })
        })
        .collect()
}
