//! Certified rendering of implicit surfaces.

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
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

/// Compiles an implicit surface f(x, y, z) = 0 from its formula.
///
/// ```
/// use zeroset::{implicit, surface::Surface};
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
