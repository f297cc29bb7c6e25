//! From the events of a traced tile to the answers of its rays.

use super::tile::{Event, PacketRays, Tile};
use crate::interval::Interval;
use crate::verdict::{Answer, Verdict};

/// An answer that is more than a miss or a plain root.
pub(super) struct Special {
    pub packet: u16,
    pub lane: u8,
    pub answer: Answer,
}

/// Puts together the answers of rays with events, in ascending order of packet and lane.
pub(super) fn settle(tile: &mut Tile) -> Vec<Special> {
    let mut specials = Vec::new();
    tile.events.sort_by_key(|e| (e.packet, e.lane));
    for events in tile
        .events
        .chunk_by(|a, b| (a.packet, a.lane) == (b.packet, b.lane))
    {
        let Event { packet, lane, .. } = events[0];
        let rays = &mut tile.packets[usize::from(packet)];
        let answer = answer(rays, usize::from(lane), events);
        if matches!(answer.first, Verdict::Root { .. }) {
            rays.record.special &= !(1 << lane);
        } else {
            specials.push(Special {
                packet,
                lane,
                answer,
            });
        }
    }
    tile.events.clear();
    specials
}

/// The answer of one ray, and what it shows moved to the record. The first event counts; if it is open, so does the
/// first certain hit behind. Open pieces of other surfaces that touch the first one's make one piece with it. Events
/// that begin behind the nearest certain hit belong to hidden surfaces.
fn answer(rays: &mut PacketRays, lane: usize, events: &[Event]) -> Answer {
    let record = &mut rays.record;
    let bit = 1 << lane;
    let mut events: Vec<(Verdict, u16)> = events.iter().map(|e| (e.verdict, e.surface)).collect();
    if record.shown & bit != 0 {
        let t = Interval {
            lo: record.lo[lane],
            hi: record.hi[lane],
        };
        events.push((Verdict::Root { t }, record.surface[lane]));
    }
    let begin = |v: &Verdict| v.t().map_or(f64::INFINITY, |t| t.lo);
    events.sort_by(|a, b| begin(&a.0).total_cmp(&begin(&b.0)));
    let mut merged = Vec::with_capacity(events.len());
    for (verdict, _) in &events {
        verdict.append(&mut merged);
    }
    let answer = Answer::from_events(record.entry[lane], &merged);
    let shown = answer.shown();
    record.shown &= !bit;
    if let Some(t) = shown
        && let Some(&(_, surface)) = events.iter().find(|(v, _)| is_part(v, t))
    {
        record.shown |= bit;
        record.surface[lane] = surface;
        (record.lo[lane], record.hi[lane]) = (t.lo, t.hi);
        let overlaps = |v: &Verdict| v.t().is_some_and(|own| own.lo <= t.hi && t.lo <= own.hi);
        if events
            .iter()
            .any(|(v, other)| *other != surface && overlaps(v))
        {
            record.tied |= bit;
        }
    }
    answer
}

/// Is it what is shown in `t`, or the sign change in what was joined to `t`?
fn is_part(verdict: &Verdict, t: Interval) -> bool {
    let inside = |own: Interval| t.lo <= own.lo && own.hi <= t.hi;
    !matches!(verdict, Verdict::Unresolved { .. }) && verdict.t().is_some_and(inside)
}
