//! Rounding on or off, as a type: the same back-end code gives both.

use super::sealed::Sealed;

/// Whether a back-end rounds outward.
pub trait Rounding: Copy + Send + Sync + Sealed + 'static {
    /// True for [`Directed`].
    const ON: bool;
}

/// Bounds are rounded outward: enclosures hold.
#[derive(Clone, Copy, Debug, Default)]
pub struct Directed;

/// Every bound is rounded to nearest and nothing is widened: enclosures do **not** hold. Negative controls must fail
/// with it, and it shows what rigour costs.
#[derive(Clone, Copy, Debug, Default)]
pub struct ToNearest;

impl Sealed for Directed {}
impl Sealed for ToNearest {}

impl Rounding for Directed {
    const ON: bool = true;
}

impl Rounding for ToNearest {
    const ON: bool = false;
}
