//! What a scene uses unless told otherwise.

use super::{Contractor, Pieces, sealed::Sealed};
use crate::interval::{Interval, Packet};
use crate::solve::{Field, Solver, differentiable, excluded, nonzero};

/// Steps from the front of T: for the first root, what lies there matters most.
///
/// f over T decides most segments alone. Where it does not, f' over T and f at the front give a certified step, and the
/// signs at both ends of a monotone segment decide whether it holds a root.
#[derive(Clone, Copy, Debug, Default)]
pub struct Auto;

impl Sealed for Auto {
    fn solver<P: Packet>() -> Solver<P> {
        Solver::default()
    }
}

impl Contractor for Auto {
    const NAME: &'static str = "auto";
    const ORDER: u8 = 2;

    #[inline(always)]
    fn contract<P: Packet>(field: &mut Field<'_, P>, t: &Interval<P::F>, live: P::M) -> Pieces<P> {
        let p = field.p;
        let mut pieces = Pieces::all(p, t);
        let f = field.value(t, live);
        pieces.none = excluded(p, &f.d[0], &f.flags, live);
        let rest = p.and_not(live, pieces.none);
        if p.any(rest) {
            let f = field.slope(t, rest);
            let usable = differentiable(p, &f.flags, rest);
            if p.any(usable) {
                from_front(field, t, &f.d[1], usable, &mut pieces);
            }
            pieces.halve_slow(p, t, rest);
        }
        pieces
    }
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
    pieces: &mut Pieces<P>,
) {
    let p = field.p;
    let zero = p.splat(0.0);
    let front = field.point(t.lo, usable);
    let known = p.and(usable, nonzero(p, &front.d[0]));
    pieces.stuck = p.and_not(usable, known);
    let negative = p.lt(front.d[0].hi, zero);
    let size = p.select(negative, p.neg_f(front.d[0].hi), front.d[0].lo);
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
        pieces.none = p.or(pieces.none, p.and(falling, above));
        pieces.one = p.and(falling, below);
        pieces.slope = *d;
    }
}
