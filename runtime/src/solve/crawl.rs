//! Where the march crawls: before a place where f turns back towards 0, nearly or just touching it.

use super::floor::{Outcome, report_tangents};
use super::tangent::{self, Ends};
use super::{Brackets, Events, Field, nonzero};
use crate::interval::{Interval, Packet, Routine};

/// Jumps over the critical point before the fronts of `lanes`: a routine of its own because it is rare.
///
/// First-order steps get shorter and shorter there: f and f' are both small. The second derivative tells where f' is 0,
/// about; [`tangent`](tangent::tangent) proves what there is up to three times as far.
pub(super) struct Crawl<'b, 'f, P: Packet> {
    pub field: &'b mut Field<'f, P>,
    pub front: P::F,
    /// Where the search ends.
    pub end: P::F,
    pub lanes: P::M,
    pub events: &'b mut Events,
}

/// What lies before the fronts of the lanes that jumped.
pub(super) struct Jump<P: Packet> {
    pub jumped: P::M,
    pub outcome: Outcome<P>,
}

impl<P: Packet> Routine<P> for Crawl<'_, '_, P> {
    type Output = Jump<P>;

    #[inline(always)]
    fn call(self, p: P) -> Jump<P> {
        let Crawl {
            field,
            front,
            end,
            lanes,
            events,
        } = self;
        let here = Interval {
            lo: front,
            hi: front,
        };
        let at = field.curvature(&here, lanes);
        // Three times as far as Newton's step on f' goes: a guess, no claim. (Between two roots, twice as far would end
        // at the second.)
        let slope = p.add_rn(at.d[1].lo, at.d[1].hi);
        let step = p.mul_rn(p.splat(1.5), p.div_rn(slope, at.d[2].lo));
        let far = p.min_f(p.sub_rn(front, step), end);
        // What is no number is not taken.
        let lanes = p.and(p.and(lanes, p.lt(front, far)), nonzero(p, &at.d[0]));
        let mut jump = Jump {
            jumped: p.none(),
            outcome: Outcome {
                brackets: Brackets::none(p),
                met: p.none(),
                hit: p.none(),
                behind: far,
            },
        };
        if !p.any(lanes) {
            return jump;
        }
        let zone = Interval { lo: front, hi: far };
        let f = field.curvature(&zone, lanes);
        let ends = Ends {
            lo: at.d[0],
            hi: field.point(far, lanes).d[0],
        };
        let found = tangent::tangent(field, &zone, &f, &ends, lanes);
        report_tangents(p, found.tangent, &zone, &found, events);
        let one = found.brackets.found;
        jump.jumped = p.or(p.or(found.none, found.tangent), one);
        jump.outcome.behind = p.select(one, found.brackets.resume, far);
        jump.outcome.brackets = found.brackets;
        jump.outcome.met = found.tangent;
        jump
    }
}
