//! Plain interval arithmetic.

use super::{Enclosure, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, Field};

/// The formula as written, over the box of points o + T·d: what there is without binding times. For comparison; it works
/// ray by ray.
#[derive(Clone, Copy, Debug, Default)]
pub struct Natural;

impl Sealed for Natural {}

impl Enclosure for Natural {
    const NAME: &'static str = "natural";

    #[inline(always)]
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1> {
        field.natural(t, live)
    }
}
