//! How a back-end rounds, as a type: the same code gives the back-ends that are used, and those that must fail.

use super::sealed::Sealed;

/// Whether a back-end's bounds hold, and if not, what is wrong with them. Everything here is a constant, so the code of
/// [`Directed`] is what it would be without the others.
pub trait Rounding: Copy + Send + Sync + Sealed + 'static {
    /// Which of the four it is.
    const MODE: Mode;
    /// Is anything rounded outward?
    const ON: bool = !matches!(Self::MODE, Mode::ToNearest);
    /// Are overflow and underflow taken care of?
    const GUARDED: bool = !matches!(Self::MODE, Mode::Unguarded);
    /// What proved error bounds are multiplied by: 1 but for [`TooTight`].
    const SCALE: f64 = if matches!(Self::MODE, Mode::TooTight) {
        0.1
    } else {
        1.0
    };
    /// How many doubles a step outward is: a tenth of it is none.
    const STEP: u64 = !matches!(Self::MODE, Mode::ToNearest | Mode::TooTight) as u64;
    /// Do bounds hold?
    const HOLDS: bool = matches!(Self::MODE, Mode::Directed);
}

/// What a [`Rounding`] does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Bounds hold.
    Directed,
    /// Nothing is rounded outward.
    ToNearest,
    /// Error bounds are a tenth of the proved ones.
    TooTight,
    /// Overflow and underflow are not taken care of.
    Unguarded,
}

impl Mode {
    /// `name` for bounds that hold, else a name that says what is wrong.
    pub(super) const fn name(self, names: [&'static str; 4]) -> &'static str {
        names[self as usize]
    }
}

/// Bounds are rounded outward: enclosures hold.
#[derive(Clone, Copy, Debug, Default)]
pub struct Directed;

/// Every bound is rounded to nearest and nothing is widened: enclosures do **not** hold. Negative controls must fail
/// with it, and it shows what rigour costs.
#[derive(Clone, Copy, Debug, Default)]
pub struct ToNearest;

/// Every proved error bound is a tenth of what it should be: enclosures do **not** hold. Instructions that round by
/// themselves still do.
#[derive(Clone, Copy, Debug, Default)]
pub struct TooTight;

/// Bounds are widened without regard to overflow and underflow: enclosures do **not** hold there.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unguarded;

/// Each type with its mode.
macro_rules! modes {
    ($($mode:ident)*) => {
        $(impl Sealed for $mode {}

        impl Rounding for $mode {
            const MODE: Mode = Mode::$mode;
        })*
    };
}

modes! { Directed ToNearest TooTight Unguarded }
