//! The best of all forms, as far as it is needed.

use super::{Enclosure, mean_value, sealed::Sealed, taylor};
use crate::contract::middle;
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, Field, differentiable, excluded, nonzero, twice_differentiable};

/// The intersection of the forms, in ascending order of cost, and each only where those before do not exclude 0: staged,
/// then the mean value form (or the ends, where f is monotone), then Taylor's.
#[derive(Clone, Copy, Debug, Default)]
pub struct Best;

impl Sealed for Best {}

impl Enclosure for Best {
    const NAME: &'static str = "best";

    #[inline(always)]
    fn enclose<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
    ) -> Enclosed<P, 1> {
        let p = field.p;
        let mut over = field.value(t, live);
        let open = p.and_not(live, excluded(p, &over.d[0], &over.flags, live));
        if !p.any(open) {
            return over;
        }
        let f = field.slope(t, open);
        let usable = differentiable(p, &f.flags, open);
        if !p.any(usable) {
            return over;
        }
        let c = middle(p, t);
        let at_c = field.point(c, usable);
        let range = mean_value(p, t, c, &at_c.d[0], &f.d[1]);
        narrow(p, usable, &range, &mut over);
        let monotone = p.and(usable, nonzero(p, &f.d[1]));
        if p.any(monotone) {
            let ends = [field.point(t.lo, monotone), field.point(t.hi, monotone)];
            let range = super::monotone(p, &ends[0].d[0], &ends[1].d[0]);
            narrow(p, monotone, &range, &mut over);
        }
        let bent = p.and_not(p.and_not(usable, nonzero(p, &over.d[0])), monotone);
        if p.any(bent) {
            let f = field.curvature(t, bent);
            let smooth = twice_differentiable(p, &f.flags, bent);
            let at_c = field.slope(&Interval { lo: c, hi: c }, smooth);
            let range = taylor(p, t, c, &at_c.d, &f.d[2]);
            narrow(p, smooth, &range, &mut over);
        }
        over
    }
}

/// Both hold f(T), so their intersection is not empty.
#[inline(always)]
fn narrow<P: Packet>(p: P, lanes: P::M, range: &Interval<P::F>, over: &mut Enclosed<P, 1>) {
    let (both, _) = p.intersect(over.d[0], *range);
    over.d[0] = p.select_interval(lanes, both, over.d[0]);
}
