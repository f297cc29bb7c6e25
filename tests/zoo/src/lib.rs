//! Some forty surfaces, and what the library says about given rays.
//!
//! Rays come as lines, `surface NAME` and below it `ray O O O D D D`, numbers as the bits of `f64`s; to each ray goes
//! its entry into the cube, and then its events follow: `root LO HI`, `tangent LO HI RESIDUAL`, `crossing LO HI`,
//! `open LO HI`, counted from the entry. `oracle.py` writes such rays, and judges the answers.

#![forbid(unsafe_code)]

pub mod surfaces;
pub mod text;

use std::f64::consts::TAU;

use surfaces as s;
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

macro_rules! zoo {
    ($($name:literal in $half:tt: $surface:expr;)*) => {
        /// The names of the surfaces.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Traces rays through the surface of this name.
        ///
        /// # Errors
        /// If there is no such surface, or a ray is not one.
        pub fn trace_named(name: &str, rays: &[Ray]) -> Result<Vec<Answered>, String> {
            match name {
                $($name => trace($surface, $half, rays),)*
                _ => Err(format!("no surface is called {name}; there are {}", NAMES.join(", "))),
            }
        }
    };
}

zoo! {
    "sphere" in 1.0: s::Sphere;
    "ellipsoid" in 1.5: s::Ellipsoid;
    "cylinder" in 1.0: s::Cylinder;
    "cone" in 1.0: s::Cone;
    "hyperboloid" in 1.5: s::Hyperboloid;
    "torus" in 0.9: s::Torus;
    "torus_root" in 0.9: s::TorusRoot;
    "cayley" in 1.5: s::Cayley;
    "clebsch" in 3.0: s::Clebsch;
    "kummer" in 2.5: s::Kummer::default();
    "tangle" in 3.2: s::Tangle;
    "mitchell" in 2.1: s::Mitchell;
    "steiner" in 0.6: s::Steiner;
    "klein" in 4.2: s::Klein;
    "heart" in 1.5: s::Heart;
    "teardrop" in 1.2: s::Teardrop;
    "barth_sextic" in 2.0: s::BarthSextic::default();
    "barth_decic" in 2.2: s::BarthDecic::default();
    "chmutov_6" in 1.35: s::Chmutov6;
    "chmutov_8" in 1.5: s::Chmutov8;
    "bretzel" in 2.4: s::Bretzel;
    "decocube" in 1.3: s::Decocube;
    "icosahedral" in 4.77: s::Icosahedral::default();
    "superquadric" in 1.3: s::Superquadric;
    "gyroid" in TAU: s::Gyroid;
    "schwarz_p" in TAU: s::SchwarzP;
    "schwarz_d" in TAU: s::SchwarzD;
    "blobby" in 2.5: s::Blobby;
    "scherk" in 10.0: s::Scherk;
    "exponentials" in 1.0: s::Exponentials { blobs: s::BLOBS };
    "zitrus" in 1.2: s::Zitrus;
    "ding_dong" in 1.5: s::DingDong;
    "calypso" in 1.5: s::Calypso;
    "whitney" in 1.5: s::Whitney;
    "himmel" in 1.5: s::Himmel;
    "limao" in 1.5: s::Limao;
    "doubled_sphere" in 1.0: s::DoubledSphere;
    "isolated_point" in 1.0: s::IsolatedPoint;
    "thin_shell" in 1.0: s::ThinShell::default();
}
