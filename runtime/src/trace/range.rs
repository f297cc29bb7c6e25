//! f over a piece of one ray.

use core::marker::PhantomData;

use super::Entries;
use crate::camera::Ray;
use crate::enclosure::{Enclosure, Range};
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::{Lines, Rays};
use crate::solve::{Evaluations, Field};
use crate::surface::Surface;

/// f over the points of a ray with parameters in `t`, by the form `E`.
pub(crate) struct RangeAlong<'a, S: Surface, E> {
    pub prepared: &'a S::Prepared,
    pub ray: &'a Ray,
    pub t: Interval,
    pub form: PhantomData<E>,
}

impl<S: Surface, E: Enclosure> Kernel for RangeAlong<'_, S, E> {
    type Output = Range;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Range {
        let entry = p.splat(self.t.lo);
        let length = p.sub_ru(p.splat(self.t.hi), entry);
        let rays = Rays::recentred(p, &Lines::same(self.ray), entry, length);
        let (mut bound, active) = (S::unbound::<P>(p), S::everything(self.prepared));
        let mut entries = Entries::<S, P>::bind(p, self.prepared, &rays, &active, &mut bound);
        let (mut counts, mut spent) = (Evaluations::default(), p.splat(0.0));
        let mut field = Field::new(p, &mut entries, &mut counts, &mut spent);
        let over = Interval {
            lo: p.splat(0.0),
            hi: length,
        };
        let f = E::enclose(&mut field, &over, p.mask(1));
        let first = |x| p.to_array(x)[0];
        Range {
            f: Interval {
                lo: first(f.d[0].lo),
                hi: first(f.d[0].hi),
            },
            undefined: p.bits(f.flags.undefined) & 1 != 0,
            jump: p.bits(f.flags.jump) & 1 != 0,
        }
    }
}
