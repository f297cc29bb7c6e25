//! A tile of the picture while it is worked on.

use super::record::Record;
use crate::camera::{Camera, Sampling};
use crate::interval::{Kernel, Packet};
use crate::ray::{Lines, clip};
use crate::solve::Evaluations;
use crate::verdict::Verdict;

/// Packets are blocks of 4×2 pixels: neighbours need the same steps.
pub(crate) const PACKET: [u32; 2] = [4, 2];
/// Tiles are squares of this many pixels.
pub(crate) const TILE: u32 = 16;
/// Packets in a whole tile.
pub(crate) const PACKETS: usize = (TILE * TILE / 8) as usize;

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
#[derive(Default)]
pub(crate) struct Tile {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The box into which the rays are clipped.
    pub domain: [[f64; 3]; 2],
    pub packets: Vec<PacketRays>,
    pub events: Vec<Event>,
    pub counts: Evaluations,
    /// Rays that do not meet the domain.
    pub outside: u64,
}

impl Tile {
    /// Packets per row.
    pub fn stride(size: [u32; 2]) -> u32 {
        size[0].div_ceil(PACKET[0])
    }

    /// Packet and lane of a pixel, counted from the tile's corner.
    #[inline]
    pub fn place(size: [u32; 2], x: u32, y: u32) -> (usize, usize) {
        let packet = (y / PACKET[1]) * Self::stride(size) + x / PACKET[0];
        let lane = (y % PACKET[1]) * PACKET[0] + x % PACKET[0];
        (packet as usize, lane as usize)
    }
}

/// Fills a tile of known size and domain with the camera's rays and their entries into the domain.
pub(crate) struct Rays<'a> {
    pub camera: &'a Camera,
    pub picture: [u32; 2],
    pub sampling: Sampling,
    /// The tile's upper left pixel.
    pub corner: [u32; 2],
    pub tile: &'a mut Tile,
}

impl Kernel for Rays<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let Rays { corner, tile, .. } = self;
        let [width, height] = tile.size;
        let (columns, rows) = (width.div_ceil(PACKET[0]), height.div_ceil(PACKET[1]));
        tile.counts = Evaluations::default();
        tile.outside = 0;
        // In place: nothing is moved, and what is not shown needs no clearing.
        tile.packets
            .resize_with((columns * rows) as usize, PacketRays::default);
        for (number, rays) in (0..).zip(&mut tile.packets) {
            let [x, y] = [number % columns * PACKET[0], number / columns * PACKET[1]];
            self.camera.rays(
                p,
                [corner[0] + x, corner[1] + y],
                self.picture,
                self.sampling,
                &mut rays.lines,
            );
            let inside = within(width - x, height - y);
            let met = rays.enter(p, inside, &tile.domain);
            tile.outside += u64::from((inside & !met).count_ones());
        }
    }
}

/// The lanes of a packet inside a tile that ends so many pixels to the right and below.
fn within(columns: u32, rows: u32) -> u8 {
    let row = if columns >= PACKET[0] {
        0xf
    } else {
        (1 << columns) - 1
    };
    if rows >= PACKET[1] {
        row | row << 4
    } else {
        row
    }
}

impl PacketRays {
    /// Starts the rays of `inside` where they enter a box; the answer is which of them do.
    #[inline(always)]
    pub fn enter<P: Packet>(&mut self, p: P, inside: u8, domain: &[[f64; 3]; 2]) -> u8 {
        let span = clip(p, &self.lines, domain);
        let met = p.and(p.le(span.near, span.far), p.mask(inside));
        let length = p.sub_ru(span.far, span.near);
        self.limit = p.to_array(p.select(met, length, p.splat(-1.0)));
        let record = &mut self.record;
        record.entry = p.to_array(p.select(met, span.near, p.splat(0.0)));
        record.lo = [f64::INFINITY; 8];
        record.hi = [f64::INFINITY; 8];
        (record.shown, record.tied, record.special) = (0, 0, 0);
        p.bits(met)
    }
}
