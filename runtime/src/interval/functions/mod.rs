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
pub(super) mod inverse_hyperbolic;
pub(super) mod ln;
mod logarithm;
mod neighbours;
pub(super) mod outward;
pub(super) mod power;
pub(super) mod real_power;
mod remainder;
pub(super) mod tangent;
mod thin;
mod two_fold;

/// The functions of [`Arithmetic`](super::Arithmetic) whose enclosures are *tested, not proved*: none. One that calls a
/// library without a promised bound would stand here, and every report of a surface that uses it would name it.
pub const UNPROVED: &[&str] = &[];
