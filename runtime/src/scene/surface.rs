//! A surface with its solver behind one object-safe trait: one virtual call per tile, not per ray.

use core::any::Any;
use core::marker::PhantomData;

use crate::beam::{Findings, Frame, Hint, Request, Rows};
use crate::camera::Ray;
use crate::contract::Contractor;
use crate::interval::Isa;
use crate::render::tile::{Tile, View};
use crate::solve::Settings;
use crate::space::{Boxes, Division, Outline};
use crate::surface::{Active, ParameterError, Surface};
use crate::trace::{
    AlongRay, AssembleLeaves, DivideBoxes, Leaves, NormalsOfTile, SurveyGrid, TraceTile, Trail,
    WithBeams,
};

/// A surface in a scene.
pub(crate) trait Trace: Send + Sync {
    fn name(&self) -> &'static str;
    /// What it shows in a picture, with a number for each.
    fn labels(&self) -> Vec<Label> {
        vec![Label {
            name: self.name(),
            colour: None,
        }]
    }
    fn check(&self) -> Result<(), ParameterError>;
    fn domain(&self) -> Option<[[f64; 3]; 2]>;
    /// Runs the surface stage.
    fn prepare(&self) -> Box<dyn Prepared + '_>;
}

/// A surface, or an operand of a solid, in a picture.
pub(crate) struct Label {
    pub name: &'static str,
    /// Its own colour, if it has one.
    pub colour: Option<glam::Vec3>,
}

/// What all tiles of a picture have in common, for one surface.
pub(crate) struct TileJob<'a> {
    pub isa: Isa,
    pub settings: &'a Settings,
    pub view: &'a View<'a>,
    /// The surface's box.
    pub domain: &'a [[f64; 3]; 2],
    pub index: u16,
    pub beams: Option<WithBeams<'a>>,
    /// Where its octree's boxes are on the picture.
    pub outline: Option<&'a Outline>,
    /// All rows of its tables.
    pub everything: Rows,
}

/// Where a ray is searched.
pub(crate) struct Search<'a> {
    pub ray: &'a Ray,
    /// The surface's box.
    pub domain: &'a [[f64; 3]; 2],
    /// The first and the last t of its octree's boxes, counted as the ray does; crossed if it meets none.
    pub within: Option<[f64; 2]>,
}

/// A surface after the surface stage, ready for any number of tiles.
pub(crate) trait Prepared: Send + Sync {
    /// The leaves over beams of a picture; nothing if there are none.
    fn leaves(&self, isa: Isa, frame: &Frame) -> Option<Leaves>;
    /// What is known about the beams of a grid.
    fn survey(&self, isa: Isa, beams: WithBeams, request: &Request, findings: &mut Findings);
    /// All rows of its tables.
    fn everything(&self) -> Active;
    /// Which parts of boxes may hold roots; nothing if that cannot be told. The leaves, if there are any, are those along the
    /// axes from the lower corner.
    fn divide(
        &self,
        isa: Isa,
        leaves: Option<&(dyn Any + Send + Sync)>,
        boxes: &Boxes,
    ) -> Option<Division>;
    /// Traces the tile's rays inside the surface's box, and keeps what is nearer than what the tile holds.
    fn trace(&self, job: &TileJob, known: (&Hint, &Rows), tile: &mut Tile);
    /// Normals for the pixels that show this surface.
    fn normals(&self, isa: Isa, index: u16, tile: &mut Tile);
    /// All events along one ray, or those up to the first certain root.
    fn along(&self, isa: Isa, settings: &Settings, search: &Search, first_only: bool) -> Trail;
}

pub(crate) struct Solver<S, C> {
    surface: S,
    contractor: PhantomData<C>,
}

impl<S, C> Solver<S, C> {
    pub fn new(surface: S) -> Self {
        Solver {
            surface,
            contractor: PhantomData,
        }
    }
}

struct Ready<'a, S: Surface, C> {
    prepared: S::Prepared,
    solver: PhantomData<&'a Solver<S, C>>,
}

impl<S: Surface, C: Contractor> Trace for Solver<S, C> {
    fn name(&self) -> &'static str {
        S::REPORT.name
    }
    fn check(&self) -> Result<(), ParameterError> {
        self.surface.check()
    }
    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        self.surface.domain()
    }
    fn prepare(&self) -> Box<dyn Prepared + '_> {
        Box::new(Ready::<S, C> {
            prepared: self.surface.prepare(),
            solver: PhantomData,
        })
    }
}

impl<S: Surface, C: Contractor> Prepared for Ready<'_, S, C> {
    fn leaves(&self, isa: Isa, frame: &Frame) -> Option<Leaves> {
        C::run(
            isa,
            AssembleLeaves::<S> {
                prepared: &self.prepared,
                frame,
            },
        )
    }
    fn survey(&self, isa: Isa, beams: WithBeams, request: &Request, findings: &mut Findings) {
        C::run(
            isa,
            SurveyGrid::<S> {
                prepared: &self.prepared,
                beams,
                request,
                findings,
                surface: PhantomData,
            },
        );
    }
    fn everything(&self) -> Active {
        S::everything(&self.prepared)
    }
    fn divide(
        &self,
        isa: Isa,
        leaves: Option<&(dyn Any + Send + Sync)>,
        boxes: &Boxes,
    ) -> Option<Division> {
        C::run(
            isa,
            DivideBoxes::<S> {
                prepared: &self.prepared,
                leaves: leaves?,
                boxes,
                surface: PhantomData,
            },
        )
    }
    fn trace(&self, job: &TileJob, (hint, rows): (&Hint, &Rows), tile: &mut Tile) {
        C::run(
            job.isa,
            TraceTile::<S, C> {
                prepared: &self.prepared,
                job,
                hint: *hint,
                rows,
                tile,
                solver: PhantomData,
            },
        );
    }
    fn normals(&self, isa: Isa, index: u16, tile: &mut Tile) {
        C::run(isa, NormalsOfTile::<S>::new(&self.prepared, index, tile));
    }
    fn along(&self, isa: Isa, settings: &Settings, search: &Search, first_only: bool) -> Trail {
        C::run(
            isa,
            AlongRay::<S, C> {
                prepared: &self.prepared,
                settings,
                search,
                first_only,
                solver: PhantomData,
            },
        )
    }
}
