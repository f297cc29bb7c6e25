//! From a traced tile to its pixels.

use super::rendering::{Kind, Piece, Record};
use super::statistics::Phases;
use super::tile::{NOTHING, PacketRays, Tile};
use crate::interval::Interval;
use crate::verdict::{Answer, Verdict};

/// Puts together the answers of rays with more than a plain root, by packet and lane, and moves what they show to the
/// front. Events that begin behind the nearest certain hit belong to hidden surfaces.
pub(super) fn specials(tile: &mut Tile) -> Vec<(u16, u8, Answer)> {
    let mut specials = Vec::new();
    if tile.events.is_empty() {
        return specials;
    }
    tile.events.sort_by_key(|e| (e.packet, e.lane));
    for group in tile
        .events
        .chunk_by(|a, b| (a.packet, a.lane) == (b.packet, b.lane))
    {
        let (number, lane) = (group[0].packet, group[0].lane);
        let packet = &mut tile.packets[usize::from(number)];
        let i = usize::from(lane);
        let mut events: Vec<(Verdict, u16)> =
            group.iter().map(|e| (e.verdict, e.surface)).collect();
        if packet.surface[i] != NOTHING {
            let t = Interval {
                lo: packet.lo[i],
                hi: packet.hi[i],
            };
            events.push((Verdict::Root { t }, packet.surface[i]));
        }
        let begin = |v: &Verdict| v.t().map_or(f64::INFINITY, |t| t.lo);
        events.sort_by(|a, b| begin(&a.0).total_cmp(&begin(&b.0)));
        let answer = answer(packet.entry[i], &events);
        let shown = answer.shown();
        let surface = events
            .iter()
            .find(|(v, _)| shown.is_some() && v.t() == shown)
            .map_or(NOTHING, |e| e.1);
        packet.surface[i] = surface;
        if let Some(t) = shown {
            (packet.lo[i], packet.hi[i]) = (t.lo, t.hi);
        }
        specials.push((number, lane, answer));
    }
    specials
}

/// The first event; if it is open, the first certain hit behind. Open pieces of other surfaces that touch the first
/// one's make one piece with it.
fn answer(entry: f64, events: &[(Verdict, u16)]) -> Answer {
    let mut merged = Vec::with_capacity(events.len());
    for (verdict, _) in events {
        verdict.append(&mut merged);
    }
    Answer::from_events(entry, &merged)
}

/// The pixels of a tile.
pub(super) fn piece(tile: &Tile, specials: Vec<(u16, u8, Answer)>, phases: Phases) -> Piece {
    let [width, height] = tile.size;
    let seen = |packet: &PacketRays| packet.surface != [NOTHING; 8];
    if specials.is_empty() && !tile.packets.iter().any(seen) {
        return Piece {
            size: tile.size,
            counts: tile.counts,
            phases,
            ..Piece::default()
        };
    }
    let mut records = Vec::with_capacity((width * height) as usize);
    let mut listed = Vec::with_capacity(specials.len());
    for y in 0..height {
        for x in 0..width {
            let (number, lane) = Tile::place(tile.size, x, y);
            let packet = &tile.packets[number];
            let plain = if packet.surface[lane] == NOTHING {
                Kind::Miss
            } else {
                Kind::Root
            };
            let special = packet.special >> lane & 1 != 0;
            let kind = if special {
                find(&specials, number, lane, records.len(), &mut listed)
            } else {
                plain
            };
            records.push(Record {
                entry: packet.entry[lane],
                lo: packet.lo[lane],
                hi: packet.hi[lane],
                normal: [
                    packet.normal[0][lane],
                    packet.normal[1][lane],
                    packet.normal[2][lane],
                ],
                surface: packet.surface[lane],
                kind,
                tied: packet.tied >> lane & 1 != 0,
            });
        }
    }
    Piece {
        records,
        size: tile.size,
        specials: listed,
        counts: tile.counts,
        phases,
    }
}

/// Lists a ray's answer under its pixel.
#[cold]
fn find(
    specials: &[(u16, u8, Answer)],
    packet: usize,
    lane: usize,
    pixel: usize,
    listed: &mut Vec<(u32, Answer)>,
) -> Kind {
    let found = specials.binary_search_by_key(&(packet as u16, lane as u8), |(p, l, _)| (*p, *l));
    let Ok(found) = found else {
        return Kind::Miss;
    };
    let answer = specials[found].2;
    let kind = match answer.first {
        Verdict::Miss => return Kind::Miss,
        // A root alone needs no list.
        Verdict::Root { .. } => return Kind::Root,
        Verdict::Tangent { .. } => Kind::Tangent,
        Verdict::Crossing { .. } => Kind::Crossing,
        Verdict::Unresolved { .. } => Kind::Unresolved,
    };
    listed.push((pixel as u32, answer));
    kind
}
