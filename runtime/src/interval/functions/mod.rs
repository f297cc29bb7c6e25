//! Elementary functions over packets.

pub(super) mod angle;
pub(super) mod arcsine;
pub(super) mod arctangent;
pub(super) mod cbrt;
pub(super) mod circular;
pub(super) mod derived;
pub(super) mod domain;
pub(super) mod exp;
pub(super) mod hyperbolic;
pub(super) mod hypot;
pub(super) mod ln;
mod neighbours;
pub(super) mod power;
mod remainder;
pub(super) mod tangent;
pub(super) mod tested;
mod two_fold;

/// The functions of [`Arithmetic`](super::Arithmetic) whose enclosures are *tested, not proved*: they call the
/// standard library once per lane and bound, and widen its result by four units in the last place on each side. The
/// library promises no bound; none above 2 was ever observed.
pub const UNPROVED: &[&str] = &["pow", "ln_1p", "asinh", "acosh", "atanh"];
