//! Normals of what is seen.

use core::marker::PhantomData;

use crate::interval::{Kernel, Nearest, Packet, Routine};
use crate::render::tile::{PACKETS_OF_CELL, PacketRays, Tile};
use crate::surface::{Active, Surface};

/// Unit normals, in plain floats, for the pixels that show the surface.
pub(crate) struct NormalsOfTile<'a, S: Surface> {
    prepared: &'a S::Prepared,
    index: u16,
    tile: &'a mut Tile,
    surface: PhantomData<S>,
}

impl<'a, S: Surface> NormalsOfTile<'a, S> {
    pub fn new(prepared: &'a S::Prepared, index: u16, tile: &'a mut Tile) -> Self {
        NormalsOfTile {
            prepared,
            index,
            tile,
            surface: PhantomData,
        }
    }
}

/// The gradient, a function of its own.
pub(super) struct Gradient<'a, S: Surface, P: Packet> {
    pub prepared: &'a S::Prepared,
    /// The rows that matter there.
    pub active: &'a Active,
    pub point: &'a [P::F; 3],
}

impl<S: Surface, P: Packet> Routine<P> for Gradient<'_, S, P> {
    type Output = [P::F; 4];
    #[inline(always)]
    fn call(self, p: P) -> [P::F; 4] {
        S::seen(Nearest(p), self.prepared, self.active, *self.point).d
    }
}

impl<S: Surface> Kernel for NormalsOfTile<'_, S> {
    type Output = ();
    const IN_PARTS: bool = true;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let NormalsOfTile {
            prepared,
            index,
            tile,
            ..
        } = self;
        let mut entered = tile.entered;
        // Operands of solids are seen with all of their rows.
        let (rows, all) = (tile.rows.get(usize::from(index)), Active::default());
        while entered != 0 {
            let number = entered.trailing_zeros() as usize;
            let packet = &mut tile.packets[number];
            entered &= entered - 1;
            let mut shown = packet.record.shown;
            for (lane, surface) in packet.record.surface.iter().enumerate() {
                shown &= !(u8::from(*surface != index) << lane);
            }
            for part in 0..P::PARTS {
                let p = p.part(part);
                let shown = shown & p.bits(p.all());
                if shown == 0 {
                    continue;
                }
                let point = points(p, packet);
                let active = rows.map_or(&all, |rows| {
                    rows[number / PACKETS_OF_CELL].at(|| farthest(packet, shown))
                });
                let [_, x, y, z] = p.call(Gradient::<S, P> {
                    prepared,
                    active,
                    point: &point,
                });
                tile.counts.gradient += u64::from(shown.count_ones());
                tile.counts.packets += 1;
                store(p, packet, [x, y, z], shown);
            }
        }
    }
}

/// The last parameter of the roots that are shown.
fn farthest(packet: &PacketRays, shown: u8) -> f64 {
    let record = &packet.record;
    let roots = (0..8).filter(|lane| shown >> lane & 1 != 0);
    roots.fold(0.0, |last, lane| {
        (record.entry[lane] + record.hi[lane]).max(last)
    })
}

/// Where the shown roots are: from the entry, so that far cameras lose nothing.
#[inline(always)]
pub(super) fn points<P: Packet>(p: P, packet: &PacketRays) -> [P::F; 3] {
    let half = p.splat(0.5);
    let t = p.add_rn(
        p.mul_rn(p.lanes(packet.record.lo), half),
        p.mul_rn(p.lanes(packet.record.hi), half),
    );
    let entry = p.lanes(packet.record.entry);
    let mut point = [t; 3];
    for (axis, x) in point.iter_mut().enumerate() {
        let d = p.lanes(packet.lines.direction[axis]);
        let start = p.fma_rn(entry, d, p.lanes(packet.lines.origin[axis]));
        *x = p.fma_rn(t, d, start);
    }
    point
}

/// Unit length, and towards the viewer; zero where there is no direction.
#[inline(always)]
fn store<P: Packet>(p: P, packet: &mut PacketRays, g: [P::F; 3], shown: u8) {
    let zero = p.splat(0.0);
    let square = p.add_rn(
        p.add_rn(p.mul_rn(g[0], g[0]), p.mul_rn(g[1], g[1])),
        p.mul_rn(g[2], g[2]),
    );
    let length = p.sqrt_rn(square);
    let mut towards = zero;
    for (axis, &component) in g.iter().enumerate() {
        towards = p.fma_rn(component, p.lanes(packet.lines.direction[axis]), towards);
    }
    let fine = p.and(p.lt(zero, length), p.lt(length, p.splat(f64::INFINITY)));
    let scale = p.div_rn(p.splat(1.0), length);
    let scale = p.select(p.lt(zero, towards), p.neg_f(scale), scale);
    for (axis, &component) in g.iter().enumerate() {
        let n = p.to_array(p.select(fine, p.mul_rn(component, scale), zero));
        let kept = &mut packet.record.normal[axis];
        for lane in p.own() {
            let own = shown >> lane & 1 != 0;
            kept[lane] = if own { n[lane] as f32 } else { kept[lane] };
        }
    }
}
