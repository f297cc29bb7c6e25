//! Where the march crawls: before a place where f turns back towards 0, nearly or just touching it.

use super::floor::{Outcome, report_tangents};
use super::tangent::{self, Ends};
use super::{Brackets, Enclosed, Events, Field, nonzero};
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
    /// Those of them where it may be too early: they jump only where f seems to turn near 0.
    pub early: P::M,
    /// Those of them where the march was stuck: it jumps away from a critical point behind it, too.
    pub stuck: P::M,
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
            early,
            stuck,
            events,
        } = self;
        let here = Interval {
            lo: front,
            hi: front,
        };
        let at = field.curvature(&here, lanes);
        let far = p.min_f(p.add_rn(front, reach(p, &at, stuck)), end);
        // What is no number is not taken.
        let lanes = p.and(p.and(lanes, p.lt(front, far)), nonzero(p, &at.d[0]));
        let lanes = p.and_not(lanes, p.and_not(early, turns_near_zero(p, &at)));
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
        let mut found = tangent::tangent(field, &zone, &f, &ends, lanes);
        // From afar f'' is vague: closer by it tells more.
        let sharp = p.le(
            p.sub_rn(found.t.hi, found.t.lo),
            p.mul_rn(end, p.splat(SHARP)),
        );
        found.tangent = p.and_not(found.tangent, p.and_not(early, sharp));
        report_tangents(p, found.tangent, &zone, &found, events);
        let one = found.brackets.found;
        jump.jumped = p.or(p.or(found.none, found.tangent), one);
        jump.outcome.behind = p.select(one, found.brackets.resume, far);
        jump.outcome.brackets = found.brackets;
        jump.outcome.met = found.tangent;
        jump
    }
}

/// A tangency that is met early is this narrow, beside the search.
const SHARP: f64 = 1.0 / (1u64 << 22) as f64;

/// Does the parabola with these derivatives turn at less than a quarter of f?
#[inline(always)]
fn turns_near_zero<P: Packet>(p: P, at: &Enclosed<P, 3>) -> P::M {
    let [f, slope, bend] = at.d.map(|x| p.add_rn(x.lo, x.hi));
    let fall = p.div_rn(p.mul_rn(slope, slope), p.add_rn(bend, bend));
    let part = p.div_rn(p.sub_rn(f, fall), f);
    p.lt(p.abs_f(part), p.splat(0.25))
}

/// Beyond what may lie ahead of a place where f, f' and f'' are about this: a guess, no claim. Where f bends away from 0,
/// half as far again as the root of the parabola with these derivatives. Where it bends towards 0, three times as
/// far as the parabola's turn (between two roots, twice as far would end at the second). Nowhere if the turn lies
/// behind, but for the lanes of `leave`: twice as far from it.
#[inline(always)]
fn reach<P: Packet>(p: P, at: &Enclosed<P, 3>, leave: P::M) -> P::F {
    let zero = p.splat(0.0);
    let [f, slope, bend] = at.d.map(|x| p.add_rn(x.lo, x.hi));
    let turn = p.neg_f(p.div_rn(slope, bend));
    let height = p.div_rn(f, bend);
    let root = p.sqrt_rn(p.sub_rn(p.mul_rn(turn, turn), p.add_rn(height, height)));
    let ahead = p.mul_rn(p.splat(3.0), turn);
    let behind = p.lt(turn, zero);
    let towards = p.select(behind, p.neg_f(turn), ahead);
    let away = p.mul_rn(p.splat(1.5), p.add_rn(turn, root));
    let far = p.select(p.lt(height, zero), away, towards);
    p.select(p.and_not(behind, leave), zero, far)
}
