//! The mean value form.

use super::{Enclosure, first, from_centre, sealed::Sealed};
use crate::contract::middle;
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, Field, differentiable};

/// f(c) + f'(T)(T − c), c the middle of T.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeanValue;

impl Sealed for MeanValue {}

impl Enclosure for MeanValue {
    const NAME: &'static str = "mean value";

    #[inline(always)]
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1> {
        let p = field.p;
        let f = field.slope(t, live);
        let mut over = first(&f);
        let usable = differentiable(p, &f.flags, live);
        if p.any(usable) {
            let c = middle(p, t);
            let at_c = field.point(c, usable);
            let range = form(p, t, c, &at_c.d[0], &f.d[1]);
            over.d[0] = p.select_interval(usable, range, over.d[0]);
        }
        over
    }
}

/// By the mean value theorem f(t) = f(c) + f'(ξ)(t − c) for some ξ between t and c, with `fc` ∋ f(c) and `d` ⊇ f'(T).
/// f must be defined and continuous on T; c lies in T.
#[inline(always)]
pub fn form<P: Packet>(
    p: P,
    t: &Interval<P::F>,
    c: P::F,
    fc: &Interval<P::F>,
    d: &Interval<P::F>,
) -> Interval<P::F> {
    p.add(*fc, p.mul(*d, from_centre(p, t, c)))
}
