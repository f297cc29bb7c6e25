//! What a scene uses unless told otherwise.

use super::{Contractor, Pieces, middle, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, Solver, differentiable, excluded, nonzero, select};

/// Steps from the front of T: for the first root, what lies there matters most.
///
/// f over T alone decides many segments. Where it does not, f' over T, which is evaluated with it, and f at the front give a
/// certified step, and the signs at both ends of a monotone segment decide whether it holds a root. (f without f' first
/// takes fewer operations where it decides, but it decides too seldom for all rays of a packet.)
#[derive(Clone, Copy, Debug, Default)]
pub struct Auto;

impl Sealed for Auto {
    fn solver<P: Packet>() -> Solver<P> {
        Solver::default()
    }
}

/// The last front, and f there.
pub struct Memory<P: Packet> {
    at: P::F,
    f: Interval<P::F>,
}

impl<P: Packet> Memory<P> {
    /// Nothing yet: no t is negative.
    #[inline(always)]
    pub fn new(p: P) -> Self {
        let at = p.splat(-1.0);
        Memory {
            at,
            f: Interval { lo: at, hi: at },
        }
    }

    /// f at the front of each lane of `live`, evaluated where it has moved.
    #[inline(always)]
    fn front(&mut self, field: &mut Field<'_, P>, t: P::F, live: P::M) -> Interval<P::F> {
        let p = field.p;
        let new = p.and_not(live, p.eq(t, self.at));
        if p.any(new) {
            let f = field.point(t, new).d[0];
            self.at = p.select(new, t, self.at);
            self.f = select(p, new, &f, &self.f);
        }
        self.f
    }
}

impl Contractor for Auto {
    const NAME: &'static str = "auto";
    const ORDER: u8 = 2;
    type Memory<P: Packet> = Memory<P>;

    #[inline(always)]
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
        let f = field.slope(t, live);
        pieces.none = excluded(p, &f.d[0], &f.flags, live);
        let rest = p.and_not(live, pieces.none);
        let usable = differentiable(p, &f.flags, rest);
        if p.any(usable) {
            from_front(field, t, &f.d[1], usable, memory, &mut pieces);
        }
        shorten(p, t, rest, &mut pieces);
        pieces
    }
}

/// Where a step left more than 60 % of T, f' over T says little about its front: what is searched next is four times as
/// long as the step, at least a tenth of what is left, and at most a half.
#[inline(always)]
fn shorten<P: Packet>(p: P, t: &Interval<P::F>, live: P::M, pieces: &mut Pieces<P>) {
    let left = p.sub_rn(pieces.first.hi, pieces.first.lo);
    let slow = p.lt(p.mul_rn(p.sub_rn(t.hi, t.lo), p.splat(0.6)), left);
    let slow = p.and_not(p.and_not(p.and(slow, live), pieces.none), pieces.one);
    let step = p.sub_rn(pieces.first.lo, t.lo);
    let length = p.max_f(p.mul_rn(step, p.splat(4.0)), p.mul_rn(left, p.splat(0.1)));
    let end = p.add_rn(pieces.first.lo, length);
    let end = p.min_f(end, middle(p, &pieces.first));
    pieces.next = p.select(slow, end, pieces.next);
    pieces.first.hi = p.select(slow, end, pieces.first.hi);
}

/// The certified step. Let f(a) > 0 at the front a (else mirror the signs): by the mean value theorem f stays positive
/// for t − a < f(a)/−inf f'(T), and on all of T if inf f' ≥ 0. Where sup f' < 0, f falls strictly, and its sign at the
/// other end decides: positive, no root; negative, exactly one.
#[inline(always)]
pub(super) fn from_front<P: Packet>(
    field: &mut Field<'_, P>,
    t: &Interval<P::F>,
    d: &Interval<P::F>,
    usable: P::M,
    memory: &mut Memory<P>,
    pieces: &mut Pieces<P>,
) {
    let p = field.p;
    let zero = p.splat(0.0);
    let front = memory.front(field, t.lo, usable);
    let known = p.and(usable, nonzero(p, &front));
    pieces.stuck = p.and_not(usable, known);
    let negative = p.lt(front.hi, zero);
    let size = p.select(negative, p.neg_f(front.hi), front.lo);
    // The fastest and the slowest fall towards 0.
    let fastest = p.select(negative, d.hi, p.neg_f(d.lo));
    let slowest = p.select(negative, d.lo, p.neg_f(d.hi));
    let reach = p.select(
        p.lt(zero, fastest),
        p.div_rd(size, fastest),
        p.splat(f64::INFINITY),
    );
    let reached = p.add_rd(t.lo, reach);
    let cleared = p.and(known, p.lt(t.hi, reached));
    pieces.none = p.or(pieces.none, cleared);
    let moved = p.and_not(known, cleared);
    pieces.first.lo = p.select(moved, p.max_f(reached, t.lo), t.lo);

    let falling = p.and(moved, p.lt(zero, slowest));
    if p.any(falling) {
        let back = field.point(t.hi, falling);
        let f = back.d[0];
        let above = p.or(
            p.and_not(p.lt(zero, f.lo), negative),
            p.and(p.lt(f.hi, zero), negative),
        );
        let below = p.or(
            p.and_not(p.lt(f.hi, zero), negative),
            p.and(p.lt(zero, f.lo), negative),
        );
        let passed = p.and(falling, above);
        memory.at = p.select(passed, t.hi, memory.at);
        memory.f = select(p, passed, &f, &memory.f);
        pieces.none = p.or(pieces.none, passed);
        pieces.one = p.and(falling, below);
        pieces.slope = *d;
    }
}
