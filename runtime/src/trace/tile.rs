//! A tile against one surface: its cells, and their packets.

use core::marker::PhantomData;

use super::beams::OverGroup;
use super::packet::{Known, LooksBehind, Packets};
use crate::beam::{Bundle, Findings, Grid, Hint, OverBeams, Request, Rows, Scout, Space};
use crate::contract::Contractor;
use crate::interval::{Kernel, Packet};
use crate::render::tile::{CELLS, PACKETS_OF_CELL, Tile};
use crate::scene::TileJob;
use crate::space::Outline;
use crate::span::Span8;
use crate::surface::Surface;

/// Traces one surface through a tile, and keeps what is nearer than what the tile holds.
pub(crate) struct TraceTile<'a, S: Surface, C> {
    pub prepared: &'a S::Prepared,
    pub job: &'a TileJob<'a>,
    /// What is known about the whole tile.
    pub hint: Hint,
    /// The rows that matter there.
    pub rows: &'a Rows,
    pub tile: &'a mut Tile,
    pub solver: PhantomData<C>,
}

impl<S: Surface, C: Contractor> Kernel for TraceTile<'_, S, C> {
    type Output = ();
    const IN_PARTS: bool = true;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let TileJob { beams, index, .. } = *self.job;
        let over = match (beams, self.hint.single) {
            (Some(beams), None) => OverGroup::<S, P>::within(self.prepared, beams.leaves, || {
                self.tile.room(|| S::unbound::<OverBeams<P>>(p))
            }),
            _ => None,
        };
        let mut trace = Packets::<S, C, P>::new(p, self.prepared, self.job, index, self.tile);
        let known = (&self.hint, self.rows);
        // Where a beam has found all roots there is nothing to add.
        let outline = self.job.outline.filter(|_| !self.hint.is_full());
        match (over, beams) {
            (Some(mut over), Some(beams)) => {
                trace.cells(Some((&mut over, beams.space)), known, outline);
                trace.tile.rooms.push(over.bound);
            }
            _ => trace.cells(None, known, outline),
        }
        trace.done();
    }
}

impl<S: Surface, C: Contractor, P: Packet> Packets<'_, S, C, P> {
    /// Traces the packets that may show something, as beams through the cells and, where these do not suffice, through the
    /// packets tell. Without beams, or where all is known, nothing is looked at again.
    #[inline(always)]
    fn cells(
        &mut self,
        mut surface: Option<(&mut dyn Bundle<P>, Space)>,
        (hint, rows): (&Hint, &Rows),
        outline: Option<&Outline>,
    ) {
        let mut findings = self.tile.take_findings();
        let [cells, packets] = &mut *findings;
        let spans = self.tile.spans(outline);
        let all = self.tile.cells();
        let open = all & spans.live();
        match &mut surface {
            _ if open == 0 => cells.close(),
            Some(surface) => {
                let part = (self.tile.corner, open, spans);
                self.look(surface, &Tile::GRID_OF_CELLS, part, (hint, rows), cells);
            }
            None => {
                cells.know(hint, rows);
                cells.keep(open);
            }
        }
        let apart = cells.apart | all & !open;
        let apart = (0..CELLS).filter(|k| apart >> k & 1 != 0);
        self.tile.counts.apart += apart.map(|k| self.tile.pixels(k)).sum::<u64>();
        let mut missed = 0;
        for (cell, (hint, rows)) in cells.hints.iter().zip(&cells.rows).enumerate() {
            let first = cell * PACKETS_OF_CELL;
            let within = [spans.lo[cell], spans.hi[cell]];
            missed |= u8::from(!hint.open) << cell;
            self.tile.full |= u8::from(hint.is_full()) << cell;
            if !hint.open {
                continue;
            }
            let looked = match &mut surface {
                Some(surface) if hint.single.is_none() => {
                    let within = Span8 {
                        lo: [within[0]; 8],
                        hi: [within[1]; 8],
                    };
                    let corner = self.tile.corner_of(first);
                    let part = (corner, self.tile.packets_of(cell), within);
                    self.look(surface, &Tile::GRID_OF_PACKETS, part, (hint, rows), packets);
                    true
                }
                _ => false,
            };
            let Findings {
                hints: own_hints,
                rows: own_rows,
                pieces,
                ..
            } = &mut *packets;
            let mut behind = surface.as_mut().map(|(surface, space)| LooksBehind {
                surface: &mut **surface,
                space: *space,
                pieces,
                ready: false,
            });
            for k in 0..PACKETS_OF_CELL {
                let (hint, rows) = if looked {
                    (&own_hints[k], &own_rows[k])
                } else {
                    (hint, rows)
                };
                if hint.open {
                    self.packet(first + k, (hint, rows, within), &mut behind);
                }
            }
        }
        core::mem::swap(&mut cells.rows, self.tile.rows(self.index));
        self.tile.missed &= missed;
        self.tile.done(findings);
    }

    #[inline(always)]
    fn look(
        &self,
        (surface, space): &mut (&mut dyn Bundle<P>, Space),
        grid: &Grid,
        (corner, live, within): ([u32; 2], u8, Span8),
        (known, rows): (&Hint, &Rows),
        findings: &mut Findings,
    ) {
        let request = Request {
            space: *space,
            corner: self.view.begin(corner, grid),
            grid,
            live,
            within,
            known,
            rows,
            settings: self.settings,
        };
        Scout::survey(self.p, *surface, &request, findings);
    }

    /// Traces a packet of the tile, of which this much is known.
    #[inline(always)]
    fn packet(&mut self, number: usize, known: Known, behind: &mut Option<LooksBehind<'_, P>>) {
        self.tile.enter(self.p, self.view, number);
        if let Some(behind) = behind {
            behind.ready = false;
        }
        for part in 0..P::PARTS {
            self.p = self.p.part(part);
            self.part(number, known, behind);
        }
    }
}
