//! An operand behind an object-safe trait: one virtual call per tile, not per ray.

use core::any::Any;
use core::marker::PhantomData;

use glam::DAffine3;

use super::Side;
use super::placed::{Placed, Ready};
use crate::beam::Frame;
use crate::interval::{Interval, Isa};
use crate::render::tile::{PacketRays, Tile};
use crate::scene::TileJob;
use crate::solve::{Evaluations, Settings};
use crate::span::Span8;
use crate::surface::{ParameterError, Surface};
use crate::trace::{
    AssembleOperand, Beam, Lone, NormalsOfTile, OnPicture, SideOfBoxes, Survey, TraceLone, Trails,
    TrailsOfTile,
};

/// A surface in a solid.
pub(crate) trait Leaf: Send + Sync {
    fn name(&self) -> &'static str;
    fn check(&self) -> Result<(), ParameterError>;
    fn domain(&self) -> Option<[[f64; 3]; 2]>;
    /// About how many operations an enclosure takes.
    fn cost(&self) -> u64;
    /// Moves it once more.
    fn place(&mut self, map: DAffine3);
    /// Runs the surface stage.
    fn prepare(&self) -> Box<dyn PreparedLeaf + '_>;
}

/// A surface in a solid after the surface stage.
pub(crate) trait PreparedLeaf: Send + Sync {
    /// Itself over the beams of a picture; nothing if it has no leaves.
    fn on_picture(&self, isa: Isa, frame: &Frame) -> Option<OnPicture>;
    /// What the surface stage made, for [`OnPicture::open`].
    fn prepared(&self) -> &(dyn Any + Send + Sync);
    /// Finds roots on rays that have one each, and tells on which it did.
    fn lone(&self, job: &TileJob, lone: &mut [Lone], tile: &mut Tile);
    /// Its side on each eighth of a beam.
    fn survey(&self, isa: Isa, beam: &Beam, counts: &mut Evaluations) -> [Side; 8];
    /// All events along a tile's rays, where they are to be searched.
    fn trails(
        &self,
        isa: Isa,
        settings: &Settings,
        packets: &[PacketRays],
        search: Vec<Span8>,
        counts: &mut Evaluations,
    ) -> Trails;
    /// Normals for the pixels that show surface number `index`.
    fn normals(&self, isa: Isa, index: u16, tile: &mut Tile);
    /// The sides of eight boxes.
    fn boxes(&self, isa: Isa, boxes: &[[Interval; 8]; 3]) -> [Side; 8];
}

struct Bare<'a, S: Surface> {
    prepared: Ready<S::Prepared>,
    surface: PhantomData<&'a S>,
}

impl<S: Surface + 'static> Leaf for Placed<S> {
    fn name(&self) -> &'static str {
        S::REPORT.name
    }
    fn check(&self) -> Result<(), ParameterError> {
        Surface::check(self)
    }
    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        Surface::domain(self)
    }
    fn cost(&self) -> u64 {
        u64::from(S::REPORT.segment[0].staged) + 1
    }
    fn place(&mut self, map: DAffine3) {
        Placed::place(self, map);
    }
    fn prepare(&self) -> Box<dyn PreparedLeaf + '_> {
        Box::new(Bare::<S> {
            prepared: Surface::prepare(self),
            surface: PhantomData,
        })
    }
}

impl<S: Surface + 'static> PreparedLeaf for Bare<'_, S> {
    fn on_picture(&self, isa: Isa, frame: &Frame) -> Option<OnPicture> {
        isa.run_surface(AssembleOperand::<Placed<S>> {
            prepared: &self.prepared,
            frame,
        })
    }
    fn prepared(&self) -> &(dyn Any + Send + Sync) {
        &self.prepared
    }
    fn lone(&self, job: &TileJob, lone: &mut [Lone], tile: &mut Tile) {
        job.isa.run_surface(TraceLone::<Placed<S>> {
            prepared: &self.prepared,
            job,
            lone,
            tile,
        });
    }
    fn survey(&self, isa: Isa, beam: &Beam, counts: &mut Evaluations) -> [Side; 8] {
        isa.run_surface(Survey::<Placed<S>> {
            prepared: &self.prepared,
            beam,
            counts,
            surface: PhantomData,
        })
    }
    fn trails(
        &self,
        isa: Isa,
        settings: &Settings,
        packets: &[PacketRays],
        search: Vec<Span8>,
        counts: &mut Evaluations,
    ) -> Trails {
        isa.run_surface(TrailsOfTile::<Placed<S>> {
            prepared: &self.prepared,
            settings,
            packets,
            search,
            counts,
            surface: PhantomData,
        })
    }
    fn normals(&self, isa: Isa, index: u16, tile: &mut Tile) {
        isa.run_surface(NormalsOfTile::<Placed<S>>::new(&self.prepared, index, tile));
    }
    fn boxes(&self, isa: Isa, boxes: &[[Interval; 8]; 3]) -> [Side; 8] {
        isa.run_surface(SideOfBoxes::<Placed<S>> {
            prepared: &self.prepared,
            boxes,
            surface: PhantomData,
        })
    }
}
