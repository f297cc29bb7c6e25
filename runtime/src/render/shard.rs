//! Finished tiles: the packets that show something, and no memory for the others.

use super::record::Record;
use super::settle::Special;
use super::statistics::{Phases, Statistics};
use super::tile::{PACKETS, TILES_OF_BLOCK, Tile};
use crate::verdict::{Answer, Verdict};

/// Where the packets of a tile are.
#[derive(Clone, Copy, Default)]
pub(crate) struct Place {
    /// Which shard.
    pub shard: u32,
    /// The first of them in it.
    pub first: u32,
    /// Which packets of the tile are kept there, one behind the other.
    pub kept: u64,
}

impl Place {
    /// Where in the shard a packet is, if it is.
    pub fn of(self, packet: usize) -> Option<usize> {
        let before = self.kept & ((1 << packet) - 1);
        let kept = self.kept >> packet & 1 != 0;
        kept.then_some(self.first as usize + before.count_ones() as usize)
    }
}

/// The finished tiles of a run of tiles.
#[derive(Default)]
pub(crate) struct Shard {
    pub records: Vec<Record>,
    /// The numbers of the tiles, and where their packets are.
    pub tiles: Vec<(u32, Place)>,
    /// Answers that are neither a miss nor a plain root, by record and lane, in ascending order.
    pub specials: Vec<((u32, u8), Answer)>,
    pub statistics: Statistics,
}

/// The memory of a shard whose picture is not needed any more.
pub(crate) struct Memory(Vec<Record>);

/// Room for so many records at most is asked for at once: 25 MB, of which only what is written costs anything.
const ROOM: usize = 1 << 16;

impl Shard {
    /// For about so many blocks.
    pub fn within(memory: Option<Memory>, blocks: usize) -> Self {
        let Memory(mut records) = memory.unwrap_or(Memory(Vec::new()));
        records.reserve((blocks * TILES_OF_BLOCK * PACKETS).min(ROOM));
        Shard {
            records,
            tiles: Vec::with_capacity((blocks * TILES_OF_BLOCK).min(ROOM)),
            ..Shard::default()
        }
    }

    /// What another picture may use.
    pub fn into_memory(mut self) -> Memory {
        self.records.clear();
        Memory(self.records)
    }

    /// Keeps what is known about a tile.
    pub fn keep(&mut self, number: u32, tile: &Tile, specials: Vec<Special>, phases: &Phases) {
        let mut place = Place {
            first: self.records.len() as u32,
            ..Place::default()
        };
        let mut entered = tile.entered;
        while entered != 0 {
            let k = entered.trailing_zeros();
            entered &= entered - 1;
            let record = &tile.packets[k as usize].record;
            if record.shown | record.special == 0 {
                continue;
            }
            place.kept |= 1 << k;
            self.records.push(*record);
            self.statistics.root += u64::from((record.shown & !record.special).count_ones());
            self.statistics.tied += u64::from(record.tied.count_ones());
        }
        for special in specials {
            self.count(&special.answer.first);
            if let Some(record) = place.of(usize::from(special.packet)) {
                let key = (record as u32, special.lane);
                self.specials.push((key, special.answer));
            }
        }
        if place.kept != 0 {
            self.tiles.push((number, place));
        }
        self.statistics.area.add(&tile.area());
        self.statistics.outside += tile.outside;
        self.statistics.made += tile.made();
        self.statistics.evaluations.add(&tile.counts);
        self.statistics.phases.add(phases);
    }

    /// The answer of a ray that is in the list.
    pub fn special(&self, record: usize, lane: usize) -> Answer {
        let key = (record as u32, lane as u8);
        let found = self.specials.binary_search_by_key(&key, |(k, _)| *k);
        self.specials[found.expect("special rays are listed")].1
    }

    fn count(&mut self, first: &Verdict) {
        let s = &mut self.statistics;
        match first {
            // Counted by the bits of their records, and as what is left.
            Verdict::Root { .. } | Verdict::Miss => {}
            Verdict::Tangent { .. } => s.tangent += 1,
            Verdict::Crossing { .. } => s.crossing += 1,
            Verdict::Unresolved { .. } => s.unresolved += 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Record, Shard};

    #[test]
    fn memory_is_used_again() {
        let mut shard = Shard::within(None, 1);
        shard.records.push(Record::default());
        let (place, room) = (shard.records.as_ptr(), shard.records.capacity());
        let again = Shard::within(Some(shard.into_memory()), 1);
        assert!(again.records.is_empty());
        assert_eq!(
            (again.records.as_ptr(), again.records.capacity()),
            (place, room)
        );
        let more = Shard::within(Some(again.into_memory()), 2);
        assert!(more.records.capacity() > room, "the control");
    }
}
