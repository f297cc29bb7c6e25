//! Implicit surfaces f(x, y, z) = 0, rendered with proofs.
//!
//! [`implicit!`] compiles a formula to code that encloses f and its derivatives over pieces of rays, in outward-rounded
//! interval arithmetic. [`render`](fn@render) looks for the first root of each ray with that code. Every pixel comes with
//! a [`Verdict`](verdict::Verdict): nothing there; exactly one root in this interval, and nothing before it; a tangency; or
//! not decided, and said so.
//!
//! ```
//! use zeroset::glam::{DVec3, dvec3};
//! use zeroset::{Camera, Options, Scene, Shading, implicit, render};
//!
//! implicit! { pub struct Ball; x^2 + y^2 + z^2 = 1 }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::new().with(Ball).within([-1.5; 3], [1.5; 3]);
//! let camera = Camera::perspective(dvec3(3.0, 2.0, 1.0), DVec3::ZERO, DVec3::Z, 40.0)?;
//! let picture = render(&scene, &camera, &Options::new(64, 64))?;
//! # let folder = std::env::temp_dir();
//! picture.image(&Shading::default()).save(folder.join("ball.png"))?;
//! assert_eq!(picture.statistics().unresolved, 0);
//! # Ok(())
//! # }
//! ```
//!
//! Should you use it? Yes, if a hole in the surface, or a root that is not there, would be a mistake; or if you want a
//! picture from one line. Not if you need textures, global illumination or an interactive viewer.
//!
//! # Where things are
//!
//! - [`implicit!`] and [`Surface`]: formulas. [How to write them](guide::writing_formulas), and
//!   [what the errors say](guide::reading_the_errors). [How they are differentiated](guide::how_differentiation_works).
//!   [What is proved](guide::what_is_proved), and what would notice.
//! - [`solid`]: intersections, unions and differences of surfaces.
//! - [`Scene`], [`Camera`], [`render`](fn@render), [`Options`], [`Shading`]: pictures.
//! - [`space`]: boxes that hold no root, found once for many pictures and rays.
//! - [`query`]: one surface and rays one by one, without a picture.
//! - [`verdict`]: what is proved about a ray. [`contract`]: how segments shrink, and the choice of a solver.
//!   [`enclosure`]: forms that enclose f over a piece of a ray.
//! - [`interval`]: intervals, packets, back-ends, for those who want to look below.
//!
//! Generated code is compiled in your crate: without optimisation it is far slower. Put `opt-level = 1` under
//! `[profile.dev]`.

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
pub mod beam;
pub mod camera;
pub mod certificate;
pub mod contract;
pub mod enclosure;
pub mod guide;
pub mod interval;
pub mod language;
pub mod query;
pub mod ray;
pub mod render;
pub mod scene;
pub mod shade;
pub mod solid;
pub mod solve;
pub mod space;
mod span;
pub mod surface;
mod trace;
#[cfg(feature = "limit")]
#[doc(hidden)]
pub use trace::limit;
pub mod verdict;

pub use camera::Camera;
pub use glam;
pub use render::{Options, Rendering, render, render_over};
pub use scene::Scene;
pub use shade::Shading;
pub use solid::{Operand, Solid};
pub use surface::Surface;

/// Compiles an implicit surface f(x, y, z) = 0 from its formula.
///
/// ```
/// use zeroset::{Surface, implicit};
///
/// implicit! { pub struct Sphere; x^2 + y^2 + z^2 = 1 }
/// assert_eq!(Sphere.at([2.0, 0.0, 0.0]), 3.0);
///
/// let radius = 0.8;
/// let ball = implicit!(x^2 + y^2 + z^2 = radius^2);
/// assert!(ball.at([0.0, 0.0, 0.0]) < 0.0);
/// ```
#[macro_export]
macro_rules! implicit {
    ($($formula:tt)*) => { $crate::__private::implicit! { $crate $($formula)* } };
}
