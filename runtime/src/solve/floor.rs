//! Where the march is stuck: a segment too short to be split, or a front that cannot be told from a root.

use core::marker::PhantomData;

use super::tangent::{self, Ends};
use super::{Brackets, Events, Field, differentiable, excluded, nonzero};
use crate::contract::Contractor;
use crate::interval::{Flags, Interval, Jet, Packet, Routine};
use crate::verdict::{Verdict, Why};

/// The work on the lanes `stuck`, a routine of its own because it is rare.
pub(crate) struct Stuck<'b, 'f, C, P: Packet> {
    field: &'b mut Field<'f, P>,
    over: Interval<P::F>,
    t: Interval<P::F>,
    lanes: P::M,
    shortest: P::F,
    events: &'b mut Events,
    solver: PhantomData<C>,
}

/// What became of the stuck lanes: a bracket, an event, or nothing at all.
pub(crate) struct Outcome<P: Packet> {
    pub brackets: Brackets<P>,
    /// An event was reported to which nothing later may reach back.
    pub met: P::M,
    /// It is a sign change that is a hit without a second look.
    pub hit: P::M,
    /// All up to here is dealt with.
    pub behind: P::F,
}

impl<'b, 'f, C: Contractor, P: Packet> Stuck<'b, 'f, C, P> {
    /// `over` is the whole search, `t` where it is stuck, `shortest` the length from which on nothing is split.
    pub fn new(
        field: &'b mut Field<'f, P>,
        over: Interval<P::F>,
        t: Interval<P::F>,
        lanes: P::M,
        shortest: P::F,
        events: &'b mut Events,
    ) -> Self {
        Stuck {
            field,
            over,
            t,
            lanes,
            shortest,
            events,
            solver: PhantomData,
        }
    }
}

/// The neighbourhood of t in which the sign of f is hidden.
struct Zone<P: Packet> {
    t: Interval<P::F>,
    ends: Ends<P>,
}

impl<C: Contractor, P: Packet> Routine<P> for Stuck<'_, '_, C, P> {
    type Output = Outcome<P>;

    #[inline(always)]
    fn call(self, p: P) -> Outcome<P> {
        let Stuck {
            field,
            over,
            t,
            lanes,
            shortest,
            events,
            ..
        } = self;
        let zone = surround(field, &over, &t, lanes, shortest);
        let mut brackets = Brackets::none(p);
        let f = enclose::<C, P>(field, &zone.t, lanes);
        let mut open = p.and_not(lanes, excluded(p, &f.d[0], &f.flags, lanes));
        let continuous = differentiable(p, &f.flags, open);
        let change = zone.ends.change(p);
        if C::ORDER >= 1 {
            let monotone = p.and(continuous, nonzero(p, &f.d[1]));
            let rising = p.lt(p.splat(0.0), f.d[1].lo);
            let one = p.and(monotone, change);
            brackets.put(p, one, &zone.t, &f.d[1], rising, zone.t.hi);
            open = p.and_not(open, one);
            open = p.and_not(open, p.and(monotone, zone.ends.same(p)));
            // f is 0 exactly at an end: that is the root.
            let at_lo = p.and(p.and(monotone, open), zero(p, &zone.ends.lo));
            let at_hi = p.and_not(p.and(p.and(monotone, open), zero(p, &zone.ends.hi)), at_lo);
            let lo = Interval {
                lo: zone.t.lo,
                hi: zone.t.lo,
            };
            let hi = Interval {
                lo: zone.t.hi,
                hi: zone.t.hi,
            };
            brackets.put(p, at_lo, &lo, &f.d[1], rising, zone.t.hi);
            brackets.put(p, at_hi, &hi, &f.d[1], rising, zone.t.hi);
            open = p.and_not(p.and_not(open, at_lo), at_hi);
        }
        let mut behind = zone.t.hi;
        if C::ORDER >= 2 && p.any(open) {
            let found = tangent::tangent(field, &zone.t, &f, &zone.ends, open);
            brackets.join(p, found.brackets.found, &found.brackets);
            open = p.and_not(p.and_not(open, found.none), found.brackets.found);
            behind = p.select(found.brackets.found, found.brackets.resume, behind);
            let met = p.and(found.tangent, p.le(t.lo, found.t.hi));
            report_tangents(p, met, &t, &found, events);
            open = p.and_not(open, found.tangent);
        }
        let crossed = p.and(p.and(open, continuous), change);
        let mut hit = p.none();
        if p.any(open) {
            hit = report(p, open, crossed, &t, &zone.t, &over, &f.flags, events);
        }
        Outcome {
            brackets,
            met: crossed,
            hit,
            behind,
        }
    }
}

/// Nothing is known of f'.
#[inline(always)]
pub(super) fn any_slope<P: Packet>(p: P) -> Interval<P::F> {
    Interval {
        lo: p.splat(f64::NEG_INFINITY),
        hi: p.splat(f64::INFINITY),
    }
}

/// Is f exactly 0?
#[inline(always)]
fn zero<P: Packet>(p: P, f: &Interval<P::F>) -> P::M {
    let zero = p.splat(0.0);
    p.and(p.eq(f.lo, zero), p.eq(f.hi, zero))
}

/// Grows a neighbourhood of t by factors of four until f has a certain sign at both its ends, or the search ends there.
#[inline(always)]
fn surround<P: Packet>(
    field: &mut Field<'_, P>,
    over: &Interval<P::F>,
    t: &Interval<P::F>,
    lanes: P::M,
    shortest: P::F,
) -> Zone<P> {
    let p = field.p;
    let mut margin = shortest;
    let mut open = lanes;
    let mut zone = *over;
    let mut ends = Ends { lo: *t, hi: *t };
    while p.any(open) {
        let lo = p.max_f(p.sub_rd(t.lo, margin), over.lo);
        let hi = p.min_f(p.add_ru(t.hi, margin), over.hi);
        let at_lo = field.point(lo, open);
        let at_hi = field.point(hi, open);
        let left = p.or(
            p.or(nonzero(p, &at_lo.d[0]), at_lo.flags.empty),
            p.le(lo, over.lo),
        );
        let right = p.or(
            p.or(nonzero(p, &at_hi.d[0]), at_hi.flags.empty),
            p.le(over.hi, hi),
        );
        let now = p.and(open, p.and(left, right));
        zone = super::select(p, now, &Interval { lo, hi }, &zone);
        ends.lo = super::select(p, now, &at_lo.d[0], &ends.lo);
        ends.hi = super::select(p, now, &at_hi.d[0], &ends.hi);
        open = p.and_not(open, now);
        margin = p.mul_rn(margin, p.splat(4.0));
        // A segment without length, or a margin lost in rounding, ends with the first or last float.
        let lost = p.and(p.le(margin, p.splat(0.0)), open);
        margin = p.select(lost, p.splat(f64::MIN_POSITIVE), margin);
    }
    Zone { t: zone, ends }
}

/// The enclosure of the highest order that the solver uses.
#[inline(always)]
fn enclose<C: Contractor, P: Packet>(
    field: &mut Field<'_, P>,
    t: &Interval<P::F>,
    lanes: P::M,
) -> super::Enclosed<P, 3> {
    if C::ORDER >= 2 {
        return field.curvature(t, lanes);
    }
    if C::ORDER == 1 {
        let f = field.slope(t, lanes);
        return Jet {
            d: [f.d[0], f.d[1], f.d[1]],
            flags: f.flags,
        };
    }
    let f = field.value(t, lanes);
    Jet {
        d: [f.d[0]; 3],
        flags: f.flags,
    }
}

/// Tangencies; `t` is where the search was stuck: all before it is known to be free.
#[cold]
pub(super) fn report_tangents<P: Packet>(
    p: P,
    met: P::M,
    t: &Interval<P::F>,
    found: &tangent::Found<P>,
    events: &mut Events,
) {
    let front = p.to_array(t.lo);
    let (lo, hi) = (p.to_array(found.t.lo), p.to_array(found.t.hi));
    let residual = p.to_array(found.residual);
    let met = p.bits(met);
    for lane in 0..8 {
        if met >> lane & 1 != 0 {
            let t = Interval {
                lo: lo[lane].max(front[lane]),
                hi: hi[lane],
            };
            events.push(
                lane,
                Verdict::Tangent {
                    t,
                    residual: residual[lane],
                },
            );
        }
    }
}

/// What is left: sign changes, and what is open. The lanes whose sign change is sharp, together with what it touched.
#[cold]
#[allow(clippy::too_many_arguments)]
fn report<P: Packet>(
    p: P,
    open: P::M,
    crossing: P::M,
    t: &Interval<P::F>,
    zone: &Interval<P::F>,
    over: &Interval<P::F>,
    flags: &Flags<P>,
    events: &mut Events,
) -> P::M {
    let mut hits = 0;
    let front = p.to_array(t.lo);
    let hi = p.to_array(zone.hi);
    let end = p.to_array(over.hi);
    let (open, crossing) = (p.bits(open), p.bits(crossing));
    let undefined = p.bits(p.or(flags.undefined, flags.jump));
    for lane in 0..8 {
        if open >> lane & 1 == 0 {
            continue;
        }
        let t = Interval {
            lo: front[lane],
            hi: hi[lane],
        };
        let why = if undefined >> lane & 1 != 0 {
            Why::Undefined
        } else if t.hi - t.lo > end[lane] / 256.0 {
            Why::Flat
        } else {
            Why::Floor
        };
        let crosses = crossing >> lane & 1 != 0;
        events.push(
            lane,
            if crosses {
                Verdict::Crossing { t }
            } else {
                Verdict::Unresolved { t, why }
            },
        );
        let last = events.of[lane].last().map(|e| e.unless_vague(end[lane]));
        let sharp = matches!(last, Some(Verdict::Crossing { .. }));
        hits |= u8::from(crosses && sharp) << lane;
    }
    p.mask(hits)
}
