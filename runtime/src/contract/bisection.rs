//! Bisection: needs nothing but enclosures of f.

use super::{Contractor, Pieces, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, excluded};

/// Excludes by range, and halves. It proves sign changes but never that a root is the only one, so hits are
/// [`Crossing`](crate::verdict::Verdict::Crossing)s.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bisection;

impl Sealed for Bisection {}

impl Contractor for Bisection {
    const NAME: &'static str = "bisection";
    const ORDER: u8 = 0;

    #[inline(always)]
    fn contract<P: Packet>(field: &mut Field<'_, P>, t: &Interval<P::F>, live: P::M) -> Pieces<P> {
        let p = field.p;
        let f = field.value(t, live);
        let mut pieces = Pieces::all(p, t);
        pieces.none = excluded(p, &f.d[0], &f.flags, live);
        pieces.halve_slow(p, t, live);
        pieces
    }
}
