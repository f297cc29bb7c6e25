//! Rays on each of which a beam through a solid has separated the only root, which is one of an operand.

use super::packet::Packets;
use crate::beam::Single;
use crate::contract::Auto;
use crate::interval::{Kernel, Packet};
use crate::render::tile::Tile;
use crate::scene::TileJob;
use crate::surface::Surface;

/// A packet of a tile whose rays have one root each.
pub(crate) struct Lone {
    /// The operand.
    pub leaf: usize,
    pub packet: usize,
    /// Where the roots are; the slope is the operand's.
    pub single: Single,
    /// The rays whose root was found.
    pub found: u8,
}

/// Finds roots of one operand.
pub(crate) struct TraceLone<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub job: &'a TileJob<'a>,
    pub lone: &'a mut [Lone],
    pub tile: &'a mut Tile,
}

impl<S: Surface> Kernel for TraceLone<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let Some(Lone { leaf, .. }) = self.lone.first() else {
            return;
        };
        let index = self.job.index + *leaf as u16;
        let mut trace = Packets::<S, Auto, P>::new(p, self.prepared, self.job, index, self.tile);
        let active = S::everything(self.prepared);
        for lone in self.lone {
            lone.found = trace.only(lone.packet, &lone.single, &active);
        }
        trace.done();
    }
}
