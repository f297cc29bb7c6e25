//! A tile of the picture while it is worked on.

use crate::camera::{Camera, Sampling};
use crate::interval::{Kernel, Packet};
use crate::ray::{Lines, clip};
use crate::solve::Evaluations;
use crate::verdict::Verdict;

/// Packets are blocks of 4×2 pixels: neighbours need the same steps.
pub(crate) const PACKET: [u32; 2] = [4, 2];
/// Tiles are squares of this many pixels.
pub(crate) const TILE: u32 = 16;

/// No surface.
pub(crate) const NOTHING: u16 = u16::MAX;

/// Eight rays, and the nearest certain root of each so far.
pub(crate) struct PacketRays {
    pub lines: Lines,
    /// The parameter from which t counts.
    pub entry: [f64; 8],
    /// The last t of interest: the exit from the scene's box, or the nearest certain hit; negative without a ray.
    pub limit: [f64; 8],
    /// The nearest certain root.
    pub lo: [f64; 8],
    pub hi: [f64; 8],
    /// The surface that it is on.
    pub surface: [u16; 8],
    /// Rays whose nearest root overlaps one of another surface.
    pub tied: u8,
    /// Rays with an entry in the tile's `events`.
    pub special: u8,
    /// Unit normals towards the viewer, of the rays that show a surface; zero where the gradient is.
    pub normal: [[f32; 8]; 3],
}

/// An event that is not a plain root.
pub(crate) struct Event {
    /// Packet and lane.
    pub packet: u16,
    pub lane: u8,
    pub surface: u16,
    pub verdict: Verdict,
}

/// The rays of a tile and what is known about them.
pub(crate) struct Tile {
    /// Width and height in pixels.
    pub size: [u32; 2],
    pub packets: Vec<PacketRays>,
    pub events: Vec<Event>,
    pub counts: Evaluations,
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

/// The camera's rays for a tile, with their entries into the scene's box.
pub(crate) struct Rays<'a> {
    pub camera: &'a Camera,
    pub picture: [u32; 2],
    pub sampling: Sampling,
    pub domain: &'a [[f64; 3]; 2],
    pub corner: [u32; 2],
    pub size: [u32; 2],
}

impl Kernel for Rays<'_> {
    type Output = Tile;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Tile {
        let rows = self.size[1].div_ceil(PACKET[1]);
        let columns = Tile::stride(self.size);
        let mut packets = Vec::with_capacity((rows * columns) as usize);
        for row in 0..rows {
            for column in 0..columns {
                let corner = [
                    self.corner[0] + column * PACKET[0],
                    self.corner[1] + row * PACKET[1],
                ];
                packets.push(self.packet(p, corner));
            }
        }
        Tile {
            size: self.size,
            packets,
            events: Vec::new(),
            counts: Evaluations::default(),
        }
    }
}

impl Rays<'_> {
    #[inline(always)]
    fn packet<P: Packet>(&self, p: P, corner: [u32; 2]) -> PacketRays {
        let mut lines = Lines {
            origin: [[0.0; 8]; 3],
            direction: [[0.0; 8]; 3],
        };
        let mut inside = 0u8;
        for lane in 0..8u32 {
            let x = corner[0] + lane % PACKET[0];
            let y = corner[1] + lane / PACKET[0];
            let ray = self
                .camera
                .ray(x, y, self.picture[0], self.picture[1], self.sampling);
            lines.set(lane as usize, &ray);
            let within = x < self.corner[0] + self.size[0] && y < self.corner[1] + self.size[1];
            inside |= u8::from(within) << lane;
        }
        let span = clip(p, &lines, self.domain);
        let met = p.and(p.le(span.near, span.far), p.mask(inside));
        let length = p.sub_ru(span.far, span.near);
        let zero = p.splat(0.0);
        PacketRays {
            lines,
            entry: p.to_array(p.select(met, span.near, zero)),
            limit: p.to_array(p.select(met, length, p.splat(-1.0))),
            lo: [f64::INFINITY; 8],
            hi: [f64::INFINITY; 8],
            surface: [NOTHING; 8],
            tied: 0,
            special: 0,
            normal: [[0.0; 8]; 3],
        }
    }
}
