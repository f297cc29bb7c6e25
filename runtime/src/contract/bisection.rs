//! Bisection: needs nothing but enclosures of f.

use core::marker::PhantomData;

use super::{Contractor, Pieces, sealed::Sealed};
use crate::enclosure::{Enclosure, Staged};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, excluded};

/// Excludes by range, with the form `E`, and halves. It proves sign changes but never that a root is the only one, so
/// hits are [`Crossing`](crate::verdict::Verdict::Crossing)s.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bisection<E = Staged>(PhantomData<E>);

impl<E: Enclosure> Sealed for Bisection<E> {}

impl<E: Enclosure> Contractor for Bisection<E> {
    const NAME: &'static str = "bisection";
    const ORDER: u8 = 0;

    type Memory<P: Packet> = ();

    fn memory<P: Packet>(_: P) {}

    #[inline(always)]
    fn contract<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
        (): &mut (),
    ) -> Pieces<P> {
        let p = field.p;
        let f = E::enclose(field, t, live);
        let mut pieces = Pieces::all(p, t);
        pieces.none = excluded(p, &f.d[0], &f.flags, live);
        pieces.halve_slow(p, t, live);
        pieces
    }
}
