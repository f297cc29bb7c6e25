//! Interval arithmetic with exact leaves.

use super::{Enclosure, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, Field};

/// What the compiled code says: interval arithmetic on the ranges of the leaves, which are exact for subexpressions of
/// degree 2 and less.
#[derive(Clone, Copy, Debug, Default)]
pub struct Staged;

impl Sealed for Staged {}

impl Enclosure for Staged {
    const NAME: &'static str = "staged";

    #[inline(always)]
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1> {
        field.value(t, live)
    }
}
