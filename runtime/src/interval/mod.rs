//! Intervals, packets of intervals, and their back-ends.

mod arithmetic;
#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(feature = "unrounded")]
mod control;
mod enclose;
mod environment;
mod fine;
mod flags;
mod forward;
mod functions;
mod horner;
mod isa;
mod lanes;
mod leaf;
mod nearest;
mod number;
mod packet;
mod parameter;
mod polynomial;
mod portable;
mod rounding;
mod scalar;
pub mod series;

pub use arithmetic::Arithmetic;
#[cfg(target_arch = "x86_64")]
pub use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub use avx512::Avx512;
#[cfg(all(target_arch = "x86_64", feature = "one-lane"))]
#[doc(hidden)]
pub use avx512::One;
#[cfg(feature = "unrounded")]
#[doc(hidden)]
pub use control::Control;
pub use fine::{Ball, Fine};
pub use flags::{Flags, Jet, Truth, Undecided};
pub use functions::UNPROVED;
pub(crate) use isa::back_ends;
pub use isa::{Isa, IsaError};
pub(crate) use lanes::operation;
pub use lanes::{Kernel, Lanes, Routine};
pub use leaf::{At, Leaves, Linear, Parameter, Quadratic, Rebind};
pub use nearest::Nearest;
pub use number::IntervalError;
pub use packet::Packet;
pub(crate) use parameter::doubled;
pub use polynomial::{Hull, Polynomial};
pub use portable::Portable;
pub use rounding::{Directed, Mode, Rounding, ToNearest, TooTight, Unguarded};
pub use scalar::Scalar;

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

/// An exact number that is no `f64`: a literal of a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// The tightest enclosure in `f64`.
    pub enclosure: Interval,
    /// The nearest double, and the nearest double to what is left: together within 2⁻¹⁰⁵ of it, relatively.
    pub leading: [f64; 2],
}
