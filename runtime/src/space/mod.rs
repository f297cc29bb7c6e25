//! Space in boxes: where a scene's surfaces certainly have no root, whatever ray passes.
//!
//! [`Scene::subdivided`] halves each surface's box along all axes, again and again, and keeps the parts that may hold roots. f
//! is enclosed over eight parts at once by the same generated code as over beams: a box is a bundle of parallel rays. The
//! boxes belong to the scene, and serve any number of pictures and rays.
//!
//! ```
//! use zeroset::glam::{DVec3, dvec3};
//! use zeroset::space::Subdivision;
//! use zeroset::{Camera, Options, Scene, implicit, render};
//!
//! implicit! {
//!     #[domain(x in -1..1, y in -1..1, z in -1..1)]
//!     struct Ball; x^2 + y^2 + z^2 = 0.5
//! }
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::new().with(Ball).subdivided(&Subdivision::default())?;
//! let boxes = scene.octree().expect("it was made");
//! assert!(boxes.certainly_free(0, &[[-0.3; 3], [0.3; 3]]));
//! assert!(!boxes.certainly_free(0, &[[-0.3; 3], [0.8; 3]]));
//! for angle in [0.0f64, 0.1, 0.2] {
//!     let from = 4.0 * dvec3(angle.cos(), angle.sin(), 0.5);
//!     let camera = Camera::perspective(from, DVec3::ZERO, DVec3::Z, 40.0)?;
//!     assert!(render(&scene, &camera, &Options::new(64, 64))?.statistics().evaluations.apart > 0);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # When it pays
//!
//! Beams of rays, which each picture uses by itself, find out the same for one camera. Beside them boxes save a tenth or a fifth of the
//! time of pictures of constructive models and of unions of many parts, and nothing on simple shapes; where beams are switched
//! off, up to more than half. Making them takes from a twentieth of a picture's time to a tenth.
//!
//! # What is proved
//!
//! A part is left out if an enclosure of f over all of it does not hold 0, or if f is nowhere defined there; it says so by
//! f itself or by its mean value form, which asks that f is certainly defined and continuous. A solid's part is left out
//! where its operands' sides decide that all of it is inside, or all outside. Parts are enclosed outward and leave no gaps,
//! so no root is between them. A picture's rays are searched only where boxes that may hold roots lie on the picture, and a
//! little further; where such a search meets anything but plain roots, the whole ray is searched again, so that what is
//! decided does not depend on the boxes.

mod along;
mod cells;
mod divide;
mod outline;
mod projection;
mod tree;

use std::time::{Duration, Instant};

pub(crate) use cells::{Place, Root, eight};
pub(crate) use divide::{Boxes, Divider, Division};
pub(crate) use outline::Outline;
pub(crate) use tree::Tree;

use crate::interval::Isa;
use crate::render::RenderError;
use crate::scene::Scene;

/// How far space is divided.
#[derive(Clone, Copy, Debug)]
pub struct Subdivision {
    /// How often each surface's box is halved, from 1 to 16.
    pub depth: u32,
    /// A level is not divided if that could give more boxes than this, for each surface.
    pub boxes: usize,
    /// The instruction set; nothing means as for [`Options`](crate::Options).
    pub isa: Option<Isa>,
}

impl Default for Subdivision {
    /// Five times, to a 32nd of each side. Finer boxes save a little more on costly formulas, and take several times as long
    /// to make.
    fn default() -> Self {
        Subdivision {
            depth: 5,
            boxes: 1 << 20,
            isa: None,
        }
    }
}

/// What a subdivision took.
#[derive(Clone, Copy, Debug, Default)]
pub struct Census {
    /// Boxes that were looked at.
    pub boxes: u64,
    /// The smallest boxes that may hold roots.
    pub open: u64,
    /// Enclosures, each of eight boxes.
    pub evaluations: u64,
    /// By the clock on the wall; the threads are those of the pool from which it is called.
    pub elapsed: Duration,
}

/// The boxes of a scene in which surfaces may have roots. It is part of its scene, and no other scene's.
pub struct Octree {
    trees: Vec<Tree>,
    census: Census,
}

impl Octree {
    /// Divides the boxes of a scene's surfaces.
    pub(crate) fn new(scene: &Scene, how: &Subdivision) -> Result<Self, RenderError> {
        let start = Instant::now();
        let isa = match how.isa {
            Some(isa) => isa,
            None => Isa::detect()?,
        };
        let mut census = Census::default();
        let surfaces = scene.surfaces.iter().zip(scene.boxes()?);
        let trees = surfaces
            .map(|(surface, domain)| {
                Tree::grow(&*surface.prepare(), isa, &domain, how, &mut census)
            })
            .collect();
        census.elapsed = start.elapsed();
        Ok(Octree { trees, census })
    }

    /// What it took to make.
    pub fn census(&self) -> &Census {
        &self.census
    }

    /// The smallest boxes in which object number `object` may have roots, lower and upper corners. Objects are surfaces and
    /// solids, in the order in which they were added.
    ///
    /// # Panics
    /// If there is no such object.
    pub fn boxes(&self, object: usize) -> Vec<[[f64; 3]; 2]> {
        self.trees[object].boxes()
    }

    /// Has an object certainly no root in a region, as far as that is within its box?
    ///
    /// # Panics
    /// If there is no such object.
    pub fn certainly_free(&self, object: usize, region: &[[f64; 3]; 2]) -> bool {
        self.trees[object].is_free(region)
    }

    pub(crate) fn trees(&self) -> &[Tree] {
        &self.trees
    }

    /// Calls one of the smallest boxes empty, whatever it holds: for negative controls alone.
    #[cfg(feature = "unrounded")]
    pub(crate) fn forget(&mut self, object: usize, number: u32) {
        self.trees[object].forget(number);
    }
}
