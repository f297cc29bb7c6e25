//! What no render can avoid, for a benchmark: of a finished picture all roots are known, and only what proves them is
//! evaluated, by the render's own kernels.
//!
//! The beams that a render looks at are bound, and f is enclosed once over each group of eight, up to where their rays'
//! search began; whatever else a survey evaluates is search. Then the rays of each packet that shows something are made
//! and bound, f is enclosed over the fewest pieces that cover their ways to the roots, at both ends of each root's
//! interval, and once with its slope around it; and the gradient is evaluated.

mod plan;
mod replay;

use crate::beam::{Frame, Space};
use crate::camera::Camera;
use crate::interval::{Isa, Packet};
use crate::render::tile::View;
use crate::render::{Options, Rendering};
use crate::surface::Surface;

use super::{AssembleLeaves, Leaves, WithBeams};
use plan::{Make, Plan};
use replay::Replay;

/// How far a replay goes: each part includes those before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Part {
    /// Beams.
    Beams,
    /// Rays are made and bound.
    Rays,
    /// Their ways to the roots.
    Ways,
    /// f at the ends of the roots' intervals, and its slope around them.
    Ends,
    /// Gradients: all that a picture needs to show.
    Gradients,
    /// Rays that pass the surface, as far as no beam excludes them.
    Passing,
}

/// How often what is evaluated.
#[derive(Clone, Copy, Default, Debug)]
pub struct Counts {
    /// Rays with a root.
    pub hits: u64,
    /// Groups of eight beams.
    pub groups: u64,
    /// Packets that show something.
    pub packets: u64,
    /// Enclosures of f over pieces of these packets' ways to the roots.
    pub pieces: u64,
    /// Rays whose way could not be covered, or whose root is not proved by a slope: the limit leaves them out.
    pub left: u64,
    /// Packets with rays that pass the surface, …
    pub passing: u64,
    /// … and enclosures over pieces of their ways.
    pub more: u64,
}

/// A picture's roots, and what proves them.
pub struct Limit<S: Surface> {
    prepared: S::Prepared,
    domain: [[f64; 3]; 2],
    camera: Camera,
    options: Options<'static>,
    isa: Isa,
    beams: (Frame, Leaves),
    plan: Plan,
}

/// Is code made for this back-end? For those with vectors.
const fn compiled<P: Packet>() -> bool {
    let name = P::NAME.as_bytes();
    name.len() == "avx512".len() && name[0] == b'a' || name.len() == "avx2".len()
}

impl<S: Surface> Limit<S> {
    /// What proves the roots of this picture of one surface; nothing if it is not traced in beams, or the back-end has no
    /// vectors.
    pub fn new(
        surface: &S,
        domain: [[f64; 3]; 2],
        camera: Camera,
        options: Options<'static>,
        picture: &Rendering,
    ) -> Option<Self> {
        let prepared = surface.prepare();
        let isa = options.isa.or_else(|| Isa::detect().ok())?;
        let size = [options.width, options.height];
        let frame = camera.frame(size, &domain)?;
        let leaves = isa.run_surface(AssembleLeaves::<S> {
            prepared: &prepared,
            frame: &frame,
        })?;
        let mut limit = Limit {
            prepared,
            domain,
            camera,
            options,
            isa,
            beams: (frame, leaves),
            plan: Plan::default(),
        };
        let mut plan = Plan::default();
        let made = isa.run_surface(Make::<S> {
            prepared: &limit.prepared,
            view: &limit.view(),
            beams: limit.with_beams(),
            settings: &options.settings,
            picture,
            plan: &mut plan,
        });
        limit.plan = plan;
        made.then_some(limit)
    }

    /// How often what is evaluated.
    pub fn counts(&self) -> Counts {
        self.plan.counts
    }

    /// Evaluates all of it again, up to a part. How many lanes did not prove what they did before: none, ever.
    pub fn replay(&self, upto: Part) -> u64 {
        self.isa.run_surface(Replay::<S> {
            prepared: &self.prepared,
            view: &self.view(),
            beams: self.with_beams(),
            plan: &self.plan,
            upto,
        })
    }

    fn view(&self) -> View<'_> {
        View {
            camera: &self.camera,
            picture: [self.options.width, self.options.height],
            sampling: self.options.sampling,
        }
    }

    fn with_beams(&self) -> WithBeams<'_> {
        WithBeams {
            space: Space {
                frame: &self.beams.0,
                domain: &self.domain,
            },
            leaves: &*self.beams.1,
        }
    }
}
