//! Which packets of a tile are to be traced, as beams tell.

use crate::beam::{Bundle, Grid, Hint, Request, Scout, Space};
use crate::interval::Packet;
use crate::render::tile::{CELLS, PACKETS, PACKETS_OF_CELL, Tile, View};

/// The packets of a tile that may show something, and what is known about each.
pub(super) struct Plan {
    /// Bit k is set for packet k.
    pub open: u64,
    pub hints: [Hint; PACKETS],
    /// Cells all of whose rays miss the surface, sampled or not, …
    pub missed: u8,
    /// … and all of whose rays hit it.
    pub full: u8,
}

impl Plan {
    /// All packets, of which this is known.
    pub fn everything(hint: &Hint) -> Self {
        Plan {
            open: !0,
            hints: [*hint; PACKETS],
            missed: 0,
            full: if hint.is_full() { !0 } else { 0 },
        }
    }

    /// What beams through the cells and, where these do not suffice, through the packets can tell.
    pub fn survey<P: Packet>(
        p: P,
        surface: &mut dyn Bundle<P>,
        space: Space,
        view: &View,
        hint: &Hint,
        tile: &mut Tile,
    ) -> Self {
        let mut plan = Plan::everything(hint);
        plan.open = 0;
        let mut count = 0;
        let mut look = |corner, grid: &Grid, live, known: &Hint| {
            let request = Request {
                space,
                corner: view.begin(corner, grid),
                grid,
                live,
                known,
            };
            Scout::survey(p, surface, &request, &mut count)
        };
        let cells = look(tile.corner, &Tile::GRID_OF_CELLS, tile.cells(), hint);
        for (cell, known) in cells.iter().enumerate().take(CELLS) {
            let first = cell * PACKETS_OF_CELL;
            plan.missed |= u8::from(!known.open) << cell;
            plan.full |= u8::from(known.is_full()) << cell;
            let packets = if !known.open {
                continue;
            } else if known.single.is_some() {
                [*known; PACKETS_OF_CELL]
            } else {
                let corner = tile.corner_of(first);
                look(corner, &Tile::GRID_OF_PACKETS, tile.packets_of(cell), known)
            };
            for (k, hint) in packets.iter().enumerate() {
                plan.open |= u64::from(hint.open) << (first + k);
                plan.hints[first + k] = *hint;
            }
        }
        tile.counts.beams += count;
        plan
    }
}
