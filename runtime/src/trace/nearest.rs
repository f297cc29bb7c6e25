//! What is kept of a packet of a tile: what is nearest.

use crate::interval::{Interval, Packet};
use crate::ray::clip;
use crate::render::tile::{Event, PacketRays};
use crate::solve::Events;
use crate::verdict::Verdict;

/// The part of each ray that is still of interest, inside the surface's own box if that is not the scene's.
#[inline(always)]
pub(crate) fn segment<P: Packet>(
    p: P,
    packet: &PacketRays,
    own: Option<&[[f64; 3]; 2]>,
) -> (Interval<P::F>, P::M) {
    let zero = p.splat(0.0);
    let limit = p.lanes(packet.limit);
    let mut live = p.le(zero, limit);
    let (mut start, mut end) = (zero, limit);
    if let Some(domain) = own {
        let entry = p.lanes(packet.record.entry);
        let span = clip(p, &packet.lines, domain);
        start = p.max_f(p.sub_rd(span.near, entry), zero);
        end = p.min_f(p.sub_ru(span.far, entry), limit);
        live = p.and(live, p.and(p.le(span.near, span.far), p.le(start, end)));
    }
    (
        Interval {
            lo: p.select(live, start, zero),
            hi: p.select(live, end, zero),
        },
        live,
    )
}

/// How far behind a root another surface is searched, relatively: beyond what noise hides of a root in the same place.
const TIED: f64 = 1.0 / (1u64 << 40) as f64;

/// Keeps the nearer root of each ray. Where it overlaps the nearest one so far their order is open, and the one that begins
/// first is shown.
#[inline(always)]
pub(super) fn keep<P: Packet>(
    p: P,
    packet: &mut PacketRays,
    hit: P::M,
    t: &Interval<P::F>,
    index: u16,
) {
    let record = &mut packet.record;
    let (old_lo, old_hi) = (p.lanes(record.lo), p.lanes(record.hi));
    let nearer = p.and(hit, p.lt(t.lo, old_lo));
    let apart = p.or(p.lt(t.hi, old_lo), p.lt(old_hi, t.lo));
    let tied = p.bits(p.and_not(hit, apart));
    let nearer_bits = p.bits(nearer);
    record.tied = (record.tied & !p.bits(p.and(nearer, apart))) | tied;
    record.shown |= nearer_bits;
    p.store(p.select(nearer, t.lo, old_lo), &mut record.lo);
    p.store(p.select(nearer, t.hi, old_hi), &mut record.hi);
    let limit = p.lanes(packet.limit);
    // A little further, so that a root of another surface in the same place can be proved too, and told to be tied.
    let more = p.mul_ru(p.splat(8.0), p.sub_ru(t.hi, t.lo));
    let more = p.max_f(more, p.mul_ru(t.hi, p.splat(TIED)));
    let end = p.add_ru(t.hi, more);
    let limit = p.select(hit, p.min_f(limit, end), limit);
    p.store(limit, &mut packet.limit);
    for lane in p.own() {
        if nearer_bits >> lane & 1 != 0 {
            record.surface[lane] = index;
        }
    }
}

/// Moves a packet's events to the tile. Nothing behind a certain hit is of interest.
#[cold]
pub(super) fn collect(
    packet: &mut PacketRays,
    number: u16,
    index: u16,
    (events, all): (&mut Events, &mut Vec<Event>),
) {
    for lane in 0..8u8 {
        let i = usize::from(lane);
        if events.touched >> lane & 1 == 0 {
            continue;
        }
        packet.record.special |= 1 << lane;
        for &verdict in &events.of[i] {
            all.push(Event {
                packet: number,
                lane,
                surface: index,
                verdict,
            });
            if let Verdict::Crossing { t } | Verdict::Root { t } = verdict {
                packet.limit[i] = packet.limit[i].min(t.hi);
            }
        }
    }
    events.clear();
}
