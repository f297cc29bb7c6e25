//! Some forty surfaces, and what the library says about given rays.
//!
//! Rays come as lines, `surface NAME` and below it `ray O O O D D D`, numbers as the bits of `f64`s; to each ray goes
//! its entry into the cube, and then its events follow: `root LO HI`, `tangent LO HI RESIDUAL`, `crossing LO HI`,
//! `open LO HI`, counted from the entry. `oracle.py` writes such rays, and judges the answers.

#![forbid(unsafe_code)]

pub mod nodes;
pub mod surfaces;
pub mod text;

use text::Answered;
use zeroset::camera::Ray;
use zeroset::render::all_roots;
use zeroset::{Options, Scene, Surface};

/// All events along each ray, in a cube of this half width.
///
/// # Errors
/// If a ray is not one.
pub fn trace<S: Surface + 'static>(
    surface: S,
    half: f64,
    rays: &[Ray],
) -> Result<Vec<Answered>, String> {
    let scene = Scene::new().with(surface).within([-half; 3], [half; 3]);
    let options = Options::new(1, 1);
    rays.iter()
        .map(|ray| {
            let lists = all_roots(&scene, ray, &options).map_err(|e| e.to_string())?;
            let list = lists.into_iter().next();
            let (entry, events) = list.ok_or("a scene without surfaces")?;
            Ok(Answered {
                ray: *ray,
                entry,
                events,
            })
        })
        .collect()
}
