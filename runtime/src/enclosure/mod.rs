//! Enclosures of f over a piece of a ray, as choices: the forms of the paper's first figure, and the best of them.
//!
//! Each form has a file of its own, in which the mathematics stands as a plain function of enclosures; the trait
//! [`Enclosure`] wraps it with the evaluations that it needs. [`Bisection`](crate::contract::Bisection) takes any of
//! them; [`range`] encloses f over a piece of one ray.
//!
//! The mean value form and its relatives speak of f only where f is certainly defined and continuous on the whole piece,
//! and the Taylor form only where it has no kink either. Elsewhere they fall back to [`Staged`].

mod best;
mod mean_value;
mod monotone;
mod natural;
mod range;
mod staged;
mod taylor;

pub use best::Best;
pub use mean_value::{MeanValue, form as mean_value};
pub use monotone::{Monotone, form as monotone};
pub use natural::Natural;
pub use range::{Range, range};
pub use staged::Staged;
pub use taylor::{Taylor, form as taylor};

use crate::interval::{Interval, Jet, Packet};
use crate::solve::{Enclosed, Field};

mod sealed {
    /// What an enclosure says is part of proofs: they are this crate's own.
    pub trait Sealed {}
}

/// A way to enclose f over segments.
pub trait Enclosure: sealed::Sealed + Copy + Send + Sync + 'static {
    /// The name in reports.
    const NAME: &'static str;

    /// f over the segments `t` of the lanes in `live`.
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1>;
}

/// f alone.
#[inline(always)]
fn first<P: Packet, const N: usize>(f: &Enclosed<P, N>) -> Enclosed<P, 1> {
    Jet {
        d: [f.d[0]],
        flags: f.flags,
    }
}

/// T − c, rounded outward.
#[inline(always)]
fn from_centre<P: Packet>(p: P, t: &Interval<P::F>, c: P::F) -> Interval<P::F> {
    Interval {
        lo: p.sub_rd(t.lo, c),
        hi: p.sub_ru(t.hi, c),
    }
}
