//! A tile of the picture while it is worked on.

use std::any::Any;

use super::record::Record;
use super::statistics::Area;
use crate::beam::{Findings, Grid, Rows};
use crate::camera::{COLUMNS, Camera, ROWS, Sampling, plane};
use crate::interval::Packet;
use crate::ray::{Lines, clip};
use crate::solve::Evaluations;
use crate::space::Outline;
use crate::span::Span8;
use crate::verdict::Verdict;

/// Packets are blocks of 4×2 pixels: neighbours need the same steps.
pub(crate) const PACKET: [u32; 2] = [4, 2];
/// A cell is two packets wide and four high, …
pub(crate) const CELL: [u32; 2] = [8, 8];
/// … a tile four cells wide and two high, …
pub(crate) const TILE: [u32; 2] = [32, 16];
/// … and a block, which a thread takes at a time, two tiles wide and four high. So there are eight of each in the next.
pub(crate) const BLOCK: [u32; 2] = [64, 64];
pub(crate) const CELLS: usize = 8;
pub(crate) const PACKETS_OF_CELL: usize = 8;
pub(crate) const PACKETS: usize = CELLS * PACKETS_OF_CELL;
pub(crate) const TILES_OF_BLOCK: usize = 8;

/// How a block is divided into tiles.
pub(crate) const GRID_OF_TILES: Grid = Grid {
    columns: BLOCK[0] / TILE[0],
    part: TILE,
    whole: true,
};

/// How many blocks a picture has.
pub(crate) fn blocks(picture: [u32; 2]) -> u32 {
    picture[0].div_ceil(BLOCK[0]) * picture[1].div_ceil(BLOCK[1])
}

/// A camera with the picture that it takes.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub camera: &'a Camera,
    pub picture: [u32; 2],
    pub sampling: Sampling,
}

impl View<'_> {
    /// Where a pixel is sampled, in pixels to the right and up from the middle of the picture.
    #[inline]
    pub fn plane(&self, pixel: [u32; 2]) -> [f64; 2] {
        let [x, y, _] = plane(pixel, self.picture, self.sampling);
        [x, y]
    }

    /// Where a grid of beams that begins at this pixel does.
    pub fn begin(&self, pixel: [u32; 2], grid: &Grid) -> [f64; 2] {
        let sampling = if grid.whole {
            Sampling::Centre
        } else {
            self.sampling
        };
        let [x, y, _] = plane(pixel, self.picture, sampling);
        [x, y]
    }

    /// c₀ + c₁x + c₂y in these coordinates, for a packet from this pixel on.
    #[inline(always)]
    pub fn linear<P: Packet>(&self, p: P, corner: [u32; 2], c: &[f64; 3]) -> P::F {
        let [x, y] = self.plane(corner);
        let first = p.splat(c[0] + x * c[1] + y * c[2]);
        let columns = p.mul_rn(p.lanes(COLUMNS), p.splat(c[1]));
        p.sub_rn(
            p.add_rn(first, columns),
            p.mul_rn(p.lanes(ROWS), p.splat(c[2])),
        )
    }
}

/// Eight rays, and what is known about them so far.
#[derive(Default)]
pub(crate) struct PacketRays {
    pub lines: Lines,
    /// The last t of interest: the exit from the scene's box, or the nearest certain hit; negative without a ray.
    pub limit: [f64; 8],
    /// What is shown is the nearest certain root, and special is who has an entry in the tile's `events`.
    pub record: Record,
}

/// An event that is not a plain root.
pub(crate) struct Event {
    /// Packet and lane.
    pub packet: u16,
    pub lane: u8,
    pub surface: u16,
    pub verdict: Verdict,
}

/// The rays of a tile and what is known about them. A thread uses one for all its tiles.
pub(crate) struct Tile {
    /// The upper left pixel.
    pub corner: [u32; 2],
    /// Width and height in pixels, as far as the picture goes.
    pub size: [u32; 2],
    /// The box into which the rays are clipped.
    pub domain: [[f64; 3]; 2],
    /// Packet after packet, cell after cell. Only those of `entered` mean anything.
    pub packets: Vec<PacketRays>,
    /// The packets whose rays were made.
    pub entered: u64,
    /// The rows of each surface's tables that matter in each cell.
    pub rows: Vec<[Rows; CELLS]>,
    /// Room for what is found out about its cells, and about a cell's packets.
    pub findings: Option<Box<[Findings; 2]>>,
    /// Room for surfaces that are bound, each of another type.
    pub rooms: Vec<Box<dyn Any>>,
    pub events: Vec<Event>,
    pub counts: Evaluations,
    /// Rays that do not meet the domain, of those that were made.
    pub outside: u64,
    /// Cells in which all rays certainly miss all surfaces, whether they are sampled or not, …
    pub missed: u8,
    /// … and in which all certainly hit one.
    pub full: u8,
}

impl Default for Tile {
    fn default() -> Self {
        let mut packets = Vec::new();
        packets.resize_with(PACKETS, PacketRays::default);
        Tile {
            corner: [0; 2],
            size: [0; 2],
            domain: [[0.0; 3]; 2],
            packets,
            entered: 0,
            rows: Vec::new(),
            findings: None,
            rooms: Vec::new(),
            events: Vec::new(),
            counts: Evaluations::default(),
            outside: 0,
            missed: 0,
            full: 0,
        }
    }
}

impl Tile {
    /// Packet and lane of a pixel, counted from the tile's corner.
    #[inline]
    pub fn place(x: u32, y: u32) -> (usize, usize) {
        let cell = y / CELL[1] * (TILE[0] / CELL[0]) + x / CELL[0];
        let (x, y) = (x % CELL[0], y % CELL[1]);
        let packet = y / PACKET[1] * (CELL[0] / PACKET[0]) + x / PACKET[0];
        let lane = y % PACKET[1] * PACKET[0] + x % PACKET[0];
        (
            cell as usize * PACKETS_OF_CELL + packet as usize,
            lane as usize,
        )
    }

    /// A packet's upper left pixel, counted from the tile's.
    #[inline]
    fn offset(packet: usize) -> [u32; 2] {
        let (cell, k) = (packet / PACKETS_OF_CELL, packet % PACKETS_OF_CELL);
        let (columns, rows) = ((TILE[0] / CELL[0]) as usize, (CELL[0] / PACKET[0]) as usize);
        [
            (cell % columns) as u32 * CELL[0] + (k % rows) as u32 * PACKET[0],
            (cell / columns) as u32 * CELL[1] + (k / rows) as u32 * PACKET[1],
        ]
    }

    /// A packet's upper left pixel.
    #[inline]
    pub fn corner_of(&self, packet: usize) -> [u32; 2] {
        let offset = Self::offset(packet);
        [self.corner[0] + offset[0], self.corner[1] + offset[1]]
    }

    /// Is any pixel of the packet in the picture?
    #[inline]
    fn has(&self, packet: usize) -> bool {
        let [x, y] = Self::offset(packet);
        x < self.size[0] && y < self.size[1]
    }

    /// The cells that have pixels in the picture.
    pub fn cells(&self) -> u8 {
        (0..CELLS).fold(0, |bits, cell| {
            bits | u8::from(self.has(cell * PACKETS_OF_CELL)) << cell
        })
    }

    /// The packets of a cell that have pixels in the picture.
    pub fn packets_of(&self, cell: usize) -> u8 {
        let first = cell * PACKETS_OF_CELL;
        (0..PACKETS_OF_CELL).fold(0, |bits, k| bits | u8::from(self.has(first + k)) << k)
    }

    /// How a tile is divided into cells.
    pub const GRID_OF_CELLS: Grid = Grid {
        columns: TILE[0] / CELL[0],
        part: CELL,
        whole: true,
    };

    /// How a cell is divided into packets.
    pub const GRID_OF_PACKETS: Grid = Grid {
        columns: CELL[0] / PACKET[0],
        part: PACKET,
        whole: false,
    };

    /// How many rays were made.
    pub fn made(&self) -> u64 {
        let all = (0..PACKETS).filter(|k| self.entered >> k & 1 != 0);
        all.map(|k| {
            let [x, y] = Self::offset(k);
            let inside = within(
                self.size[0].saturating_sub(x),
                self.size[1].saturating_sub(y),
            );
            u64::from(inside.count_ones())
        })
        .sum()
    }

    /// Begins another tile.
    pub fn begin(&mut self, view: &View, corner: [u32; 2], domain: [[f64; 3]; 2]) {
        self.corner = corner;
        self.size = [0, 1].map(|k| TILE[k].min(view.picture[k] - corner[k]));
        self.domain = domain;
        self.entered = 0;
        self.counts = Evaluations::default();
        self.outside = 0;
        (self.missed, self.full) = (!0, 0);
    }

    /// The rows of a surface, by its number.
    pub fn rows(&mut self, index: u16) -> &mut [Rows; CELLS] {
        let index = usize::from(index);
        if self.rows.len() <= index {
            self.rows.resize_with(index + 1, Default::default);
        }
        &mut self.rows[index]
    }

    /// Room of a type that was given back before, if there is any.
    pub fn room<T: Any>(&mut self, new: impl FnOnce() -> T) -> Box<T> {
        let known = self.rooms.iter().position(|room| room.is::<T>());
        let room = known.map(|k| self.rooms.swap_remove(k).downcast());
        match room {
            Some(Ok(room)) => room,
            _ => Box::new(new()),
        }
    }

    /// Room for what will be found out about cells and packets.
    pub fn take_findings(&mut self) -> Box<[Findings; 2]> {
        let mut findings = self.findings.take().unwrap_or_default();
        findings.iter_mut().for_each(|found| found.count = 0);
        findings
    }

    /// Counts what was found out, and takes the room back.
    pub fn done(&mut self, findings: Box<[Findings; 2]>) {
        self.counts.beams += findings.iter().map(|found| found.count).sum::<u64>();
        self.findings = Some(findings);
    }

    /// The cells in which an octree has boxes; all if there is none.
    pub fn boxed(&self, outline: Option<&Outline>) -> u8 {
        self.spans(outline).live()
    }

    /// Where an octree's boxes are in each cell, in t; everywhere if there is none.
    pub fn spans(&self, outline: Option<&Outline>) -> Span8 {
        outline.map_or(Span8::ALL, |outline| {
            outline.spans(self.corner, &Self::GRID_OF_CELLS)
        })
    }

    /// The pixels of the picture in a cell.
    pub fn pixels(&self, cell: usize) -> u64 {
        let offset = Self::offset(cell * PACKETS_OF_CELL);
        let [width, height] = [0, 1].map(|k| CELL[k].min(self.size[k].saturating_sub(offset[k])));
        u64::from(width) * u64::from(height)
    }

    /// What is certain about the tile's area, in pixels.
    pub fn area(&self) -> Area {
        let mut area = Area::default();
        for cell in 0..CELLS {
            let sum = if self.full >> cell & 1 != 0 {
                &mut area.hit
            } else if self.missed >> cell & 1 != 0 {
                &mut area.miss
            } else {
                &mut area.undecided
            };
            *sum += self.pixels(cell);
        }
        area
    }

    /// Makes the rays of a packet, unless they are there, with their entries into the domain.
    #[inline(always)]
    pub fn enter<P: Packet>(&mut self, p: P, view: &View, packet: usize) {
        if self.entered >> packet & 1 != 0 {
            return;
        }
        self.entered |= 1 << packet;
        let [x, y] = Self::offset(packet);
        let rays = &mut self.packets[packet];
        let columns = self.size[0].saturating_sub(x);
        let inside = within(columns, self.size[1].saturating_sub(y));
        let corner = [self.corner[0] + x, self.corner[1] + y];
        rays.record.forget();
        let mut met = 0;
        for part in 0..P::PARTS {
            let p = p.part(part);
            let lines = &mut rays.lines;
            view.camera
                .rays(p, corner, view.picture, view.sampling, lines);
            met |= rays.enter(p, inside, &self.domain);
        }
        self.outside += u64::from((inside & !met).count_ones());
    }
}

/// The lanes of a packet inside a tile that ends so many pixels to the right and below.
fn within(columns: u32, rows: u32) -> u8 {
    let row = if columns >= PACKET[0] {
        0xf
    } else {
        (1 << columns) - 1
    };
    match rows {
        0 => 0,
        1 => row,
        _ => row | row << 4,
    }
}

impl PacketRays {
    /// Starts the rays of `inside` where they enter a box; the answer is which of them do.
    #[inline(always)]
    pub fn enter<P: Packet>(&mut self, p: P, inside: u8, domain: &[[f64; 3]; 2]) -> u8 {
        let span = clip(p, &self.lines, domain);
        let met = p.and(p.le(span.near, span.far), p.mask(inside));
        let length = p.sub_ru(span.far, span.near);
        let limit = p.select(met, length, p.splat(-1.0));
        p.store(limit, &mut self.limit);
        let entry = p.select(met, span.near, p.splat(0.0));
        p.store(entry, &mut self.record.entry);
        p.bits(met)
    }
}
