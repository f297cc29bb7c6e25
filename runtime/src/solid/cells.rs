//! The cells of a tile that may show something, as beams through them and through their packets tell.

use super::over::side;
use super::tile::{Known, Look};
use super::trace::{Enter, PreparedSolid, Segments, show};
use super::tree::Node;
use crate::beam::{Findings, Grid, Hint, Request, Rows};
use crate::interval::{Interval, Lanes, Scalar};
use crate::render::tile::{PACKETS_OF_CELL, Tile};
use crate::scene::{Prepared, TileJob};
use crate::span::Span8;
use crate::surface::Active;
use crate::trace::{Lone, WithBeams};

/// A solid through one tile.
pub(super) struct Cells<'a> {
    pub solid: &'a PreparedSolid<'a>,
    pub job: &'a TileJob<'a>,
    pub beams: &'a WithBeams<'a>,
    pub tile: &'a mut Tile,
}

impl Cells<'_> {
    /// Traces the tile, of which this much is known.
    pub fn trace(mut self, (hint, rows): (&Hint, &Rows)) {
        let mut findings = self.tile.take_findings();
        let [cells, packets] = &mut *findings;
        let live = self.tile.cells() & self.tile.boxed(self.job.outline);
        let part = (self.tile.corner, live);
        self.look(&Tile::GRID_OF_CELLS, part, (hint, rows), cells);
        let mut missed = 0;
        let full = hint.is_full();
        for (cell, (hint, rows)) in cells.hints.iter().zip(&cells.rows).enumerate() {
            missed |= u8::from(!hint.open) << cell;
            self.tile.full |= u8::from(full || hint.is_full()) << cell;
            if hint.open {
                let first = cell * PACKETS_OF_CELL;
                let part = (self.tile.corner_of(first), self.tile.packets_of(cell));
                self.look(&Tile::GRID_OF_PACKETS, part, (hint, rows), packets);
                self.cell(first, rows, packets);
            }
        }
        self.tile.missed &= missed;
        self.tile.done(findings);
    }

    /// Looks at the beams of a grid, unless it is known that each ray has its root, and on which operand.
    fn look(
        &self,
        grid: &Grid,
        (corner, live): ([u32; 2], u8),
        (known, rows): (&Hint, &Rows),
        findings: &mut Findings,
    ) {
        if known.is_full() && self.only(&rows.near).is_some() {
            findings.know(known, rows);
            return;
        }
        let request = Request {
            space: self.beams.space,
            corner: self.job.view.begin(corner, grid),
            grid,
            live,
            within: Span8::ALL,
            known,
            rows,
            settings: self.job.settings,
        };
        let solid = self.solid;
        solid.survey(self.job.isa, *self.beams, &request, findings);
    }

    /// Traces a cell: rays on which a beam has separated the only root, of one operand, then all others.
    fn cell(&mut self, first: usize, rows: &Rows, packets: &Findings) {
        let open = |k: usize| packets.hints[k].open;
        let mut lone = Vec::with_capacity(PACKETS_OF_CELL);
        for k in (0..PACKETS_OF_CELL).filter(|k| open(*k)) {
            self.job.isa.run(Enter {
                view: self.job.view,
                tile: self.tile,
                packets: first + k..first + k + 1,
            });
            lone.extend(self.lone(first + k, &packets.hints[k], &packets.rows[k].near));
        }
        lone.sort_by_key(|lone: &Lone| lone.leaf);
        let mut rest = self.rest(first, packets);
        for same in lone.chunk_by_mut(|a, b| a.leaf == b.leaf) {
            let leaf = same[0].leaf;
            self.solid.leaves[leaf].lone(self.job, same, self.tile);
            for lone in same {
                rest[lone.packet - first].remove(lone.found);
                let others = self.solid.leaves.len() as u64 - 1;
                self.tile.counts.spared += others * u64::from(lone.found.count_ones());
            }
        }
        self.faces(first, rows, rest);
    }

    /// The only operand that matters, if there is only one, and whether its complement does.
    fn only(&self, active: &Active) -> Option<(usize, bool)> {
        let open = self.solid.node.given(&|leaf| side(active.choice(leaf)));
        match open.ok()? {
            Node::Leaf(leaf) => Some((leaf, false)),
            Node::Not(inner) => match *inner {
                Node::Leaf(leaf) => Some((leaf, true)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The roots of a packet with one on each ray, if it is known on which operand.
    fn lone(&self, packet: usize, hint: &Hint, active: &Active) -> Option<Lone> {
        let mut single = hint.single?;
        let (leaf, turned) = self.only(active)?;
        if turned {
            let [lo, hi] = single.slope;
            single.slope = [-hi, -lo];
        }
        Some(Lone {
            leaf,
            packet,
            single,
            found: 0,
        })
    }

    /// Where the rays of a cell are to be searched.
    fn rest(&self, first: usize, packets: &Findings) -> Vec<Span8> {
        let of_cell = &self.tile.packets[first..first + PACKETS_OF_CELL];
        let domain = self.job.domain;
        let mut rest = self.job.isa.run(Segments {
            own: (*domain != self.tile.domain).then_some(domain),
            packets: of_cell,
        });
        for ((span, packet), hint) in rest.iter_mut().zip(of_cell).zip(&packets.hints) {
            if hint.open {
                span.start(hint.front, &packet.record.entry);
            } else {
                *span = Span8::EMPTY;
            }
        }
        rest
    }

    /// The faces along the rays of a cell, up to the first certain one: near the beam's front, where few operands matter, and
    /// if nothing is there, behind. What the border between these may have caused is looked at again.
    fn faces(&mut self, first: usize, rows: &Rows, mut rest: Vec<Span8>) {
        let job = self.job;
        let look = Look {
            isa: job.isa,
            settings: job.settings,
            first_only: true,
        };
        for (active, reach) in [(&rows.near, rows.reach), (&rows.all, f64::INFINITY)] {
            if rest.iter().all(Span8::is_empty) {
                return;
            }
            let of_cell = self.tile.packets[first..].iter();
            let over: Vec<Span8> = rest
                .iter()
                .zip(of_cell)
                .map(|(span, packet)| span.up_to(reach, &packet.record.entry))
                .collect();
            let known = Known::Sides(active);
            let place = (&mut *self.tile, first);
            let any = self
                .solid
                .faces(&look, known, place, &over, |tile, packet, lane, faces| {
                    let (rest, searched) =
                        (&mut rest[packet - first], over[packet - first].of(lane));
                    let whole = rest.hi[lane] <= searched.hi;
                    let before = |t: Interval| t.hi < searched.hi;
                    let certain = faces.first().is_none_or(|face| {
                        face.verdict.is_certain_hit() && face.verdict.t().is_some_and(before)
                    });
                    if whole || certain {
                        show(job.index, tile, packet, lane, faces);
                        let done = whole || !faces.is_empty();
                        rest.lo[lane] = if done { f64::INFINITY } else { searched.hi };
                    }
                });
            if !any {
                rest.iter_mut()
                    .zip(&over)
                    .for_each(|(rest, over)| rest.pass(over));
            }
        }
    }
}

impl Span8 {
    /// Leaves what is not before a parameter that counts from the camera, on rays with these entries.
    fn start(&mut self, front: f64, entry: &[f64; 8]) {
        for (lo, entry) in self.lo.iter_mut().zip(entry) {
            *lo = lo.max(Scalar.sub_rd(front, *entry));
        }
    }

    /// What is at most such a parameter.
    fn up_to(&self, reach: f64, entry: &[f64; 8]) -> Span8 {
        let mut cut = *self;
        for (hi, entry) in cut.hi.iter_mut().zip(entry) {
            *hi = hi.min(Scalar.sub_rd(reach, *entry));
        }
        cut
    }

    /// Leaves what is behind a first part of it, where there is one.
    fn pass(&mut self, first: &Span8) {
        for k in 0..8 {
            if first.lo[k] <= first.hi[k] {
                let whole = self.hi[k] <= first.hi[k];
                self.lo[k] = if whole { f64::INFINITY } else { first.hi[k] };
            }
        }
    }

    /// Leaves nothing of these rays.
    fn remove(&mut self, lanes: u8) {
        for (k, lo) in self.lo.iter_mut().enumerate() {
            if lanes >> k & 1 != 0 {
                *lo = f64::INFINITY;
            }
        }
    }
}
