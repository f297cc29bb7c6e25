//! Beams: all rays of a rectangle of pixels at once, enclosed by the code that the macro generated for single rays.
//!
//! In the camera's affine coordinates (t, x, y) a beam's piece is a box, and a leaf of degree ≤ 2 a quadratic
//! polynomial of ten coefficients ([`OverBeams`]). They are computed once per picture, and moved to the middle of each beam.
//! Then f over a piece of a beam is what generated code makes of the leaves' ranges there ([`Slab`]), and its derivatives
//! by x, by y or along the rays are what it makes of the leaves' derivatives ([`Towards`]). With these f is also
//! enclosed by its mean value form about the middle ray, f(t, 0, 0) + x·f_x + y·f_y, where f is continuous.

mod frame;
mod group;
mod hint;
mod leaf;
mod parameter;
mod range;
mod rebind;
mod rows;
mod survey;
#[cfg(test)]
mod tests;
mod thin;

pub(crate) use frame::{Frame, View};
pub(crate) use group::{Grid, Group};
pub(crate) use hint::{Hint, Single};
pub use leaf::{LinearOver, OverBeams, QuadraticOver};
pub use parameter::{Direction, Slab, Towards};
pub(crate) use rebind::{Assemble, Shift};
pub(crate) use rows::Rows;
pub(crate) use survey::{Behind, Bundle, Findings, Pieces, Request, Scout, Space};
pub(crate) use thin::Thin;
