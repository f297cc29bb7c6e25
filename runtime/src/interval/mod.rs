//! Intervals, packets of intervals, and their back-ends.

mod arithmetic;
mod flags;
mod lanes;
mod leaf;

pub use arithmetic::Arithmetic;
pub use flags::{Flags, Jet, Truth, Undecided};
pub use lanes::{Kernel, Lanes, Routine};
pub use leaf::{At, Linear, Parameter, Quadratic};

mod sealed {
    /// Back-ends are this crate's own: a foreign token would not prove anything.
    pub trait Sealed {}
}

/// The closed interval [lo, hi]; with a vector `F`, one interval per lane.
///
/// No NaN, lo < +∞, hi > −∞, lo ≤ hi. An empty result is a flag beside the interval, never a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<F = f64> {
    /// The lower bound.
    pub lo: F,
    /// The upper bound.
    pub hi: F,
}

/// Interval operations on the lanes of one instruction set: what enclosures and contractors are written in.
pub trait Packet: Lanes + Arithmetic<Packet = Self, Value = Interval<<Self as Lanes>::F>> {}
