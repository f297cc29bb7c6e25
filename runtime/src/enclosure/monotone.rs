//! The values at the ends.

use super::{Enclosure, first, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, Field, differentiable, nonzero};

/// The hull of the values at the ends of T where 0 ∉ f'(T), else the staged enclosure.
#[derive(Clone, Copy, Debug, Default)]
pub struct Monotone;

impl Sealed for Monotone {}

impl Enclosure for Monotone {
    const NAME: &'static str = "monotone";

    #[inline(always)]
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1> {
        let p = field.p;
        let f = field.slope(t, live);
        let mut over = first(&f);
        let usable = p.and(differentiable(p, &f.flags, live), nonzero(p, &f.d[1]));
        if p.any(usable) {
            let ends = [field.point(t.lo, usable), field.point(t.hi, usable)];
            let range = form(p, &ends[0].d[0], &ends[1].d[0]);
            over.d[0] = p.select_interval(usable, range, over.d[0]);
        }
        over
    }
}

/// f lies between its values at the ends of T, enclosed in `lo` and `hi`, if it is defined, continuous and monotone on T.
#[inline(always)]
pub fn form<P: Packet>(p: P, lo: &Interval<P::F>, hi: &Interval<P::F>) -> Interval<P::F> {
    p.hull(*lo, *hi)
}
