//! Weakened rules, for negative controls alone: each leaves out one condition of a proof, and an oracle must notice.

use std::marker::PhantomData;

use super::auto::{self, Memory};
use super::{Auto, Contractor, Pieces, sealed::Sealed};
use crate::interval::{Interval, Isa, Kernel, Packet};
use crate::solve::{Field, Solver, differentiable, excluded, nonzero};

/// Uses the derivative where f may be undefined or discontinuous.
#[derive(Clone, Copy, Debug, Default)]
pub struct Anywhere;

impl Sealed for Anywhere {}

impl Contractor for Anywhere {
    const NAME: &'static str = "unsound: derivatives anywhere";
    const ORDER: u8 = 2;

    type Memory<P: Packet> = Memory<P>;

    fn memory<P: Packet>(p: P) -> Memory<P> {
        Memory::new(p)
    }

    #[inline(always)]
    fn contract<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
        memory: &mut Memory<P>,
    ) -> Pieces<P> {
        let p = field.p;
        let mut pieces = Pieces::all(p, t);
        let f = field.value(t, live);
        pieces.none = excluded(p, &f.d[0], &f.flags, live);
        let rest = p.and_not(live, pieces.none);
        if p.any(rest) {
            let f = field.slope(t, rest);
            auto::from_front(field, t, &f.d[1], rest, memory, &mut pieces);
            pieces.halve_slow(p, t, rest);
        }
        pieces
    }
}

/// Takes a monotone f for a root, whatever its signs at the ends.
#[derive(Clone, Copy, Debug, Default)]
pub struct Signless;

impl Sealed for Signless {}

impl Contractor for Signless {
    const NAME: &'static str = "unsound: existence without signs";
    const ORDER: u8 = 2;

    type Memory<P: Packet> = Memory<P>;

    fn memory<P: Packet>(p: P) -> Memory<P> {
        Memory::new(p)
    }

    #[inline(always)]
    fn contract<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
        memory: &mut Memory<P>,
    ) -> Pieces<P> {
        let p = field.p;
        let mut pieces = Auto::contract(field, t, live, memory);
        let rest = p.and_not(p.and_not(live, pieces.none), pieces.one);
        if p.any(rest) {
            let f = field.slope(&pieces.first, rest);
            let usable = differentiable(p, &f.flags, rest);
            let monotone = p.and(usable, nonzero(p, &f.d[1]));
            pieces.one = p.or(pieces.one, monotone);
            pieces.slope = p.select_interval(monotone, f.d[1], pieces.slope);
        }
        pieces
    }
}

/// The contractor `C` on the back-ends whose bounds do not hold, and on no others: a surface is compiled for them where it
/// has this solver.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unrounded<C = Auto>(PhantomData<C>);

impl<C: Contractor> Sealed for Unrounded<C> {
    fn solver<P: Packet>() -> Solver<P> {
        C::solver()
    }

    fn run<K: Kernel>(isa: Isa, kernel: K) -> K::Output {
        isa.run_unrounded(kernel)
    }
}

impl<C: Contractor> Contractor for Unrounded<C> {
    const NAME: &'static str = "unsound: without rounding";
    const ORDER: u8 = C::ORDER;

    type Memory<P: Packet> = C::Memory<P>;

    fn memory<P: Packet>(p: P) -> C::Memory<P> {
        C::memory(p)
    }

    #[inline(always)]
    fn contract<P: Packet>(
        field: &mut Field<'_, P>,
        t: &Interval<P::F>,
        live: P::M,
        memory: &mut C::Memory<P>,
    ) -> Pieces<P> {
        C::contract(field, t, live, memory)
    }
}
