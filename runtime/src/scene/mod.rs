//! What is in the picture.

mod surface;

pub(crate) use surface::{Label, Prepared, Search, TileJob, Trace};

use crate::contract::Contractor;
use crate::render::RenderError;
use crate::solid::Operand;
use crate::space::{Octree, Subdivision};
use crate::surface::{ParameterError, Surface};

/// Surfaces and [solids](crate::solid), and the box that they are seen in.
///
/// ```
/// use zeroset::{Scene, contract::Halley, implicit};
///
/// implicit! { struct Ball; x^2 + y^2 + z^2 = 1 }
/// implicit! { struct Tube; x^2 + y^2 = 0.25 }
/// let scene = Scene::new().with(Ball).with_solver::<Halley, _>(Tube).within([-2.0; 3], [2.0; 3]);
/// assert_eq!(scene.len(), 2);
/// ```
#[derive(Default)]
pub struct Scene {
    pub(crate) surfaces: Vec<Box<dyn Trace>>,
    bounds: Option<[[f64; 3]; 2]>,
    octree: Option<Octree>,
}

/// A scene that cannot be rendered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A field of a surface is NaN or infinite.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A surface has no box to be searched in.
    #[error(
        "`{surface}` has no domain: add `#[domain(…)]` to its definition, or give the scene a box with `Scene::within`"
    )]
    NoDomain {
        /// The surface's name.
        surface: &'static str,
    },
    /// A box has crossed, infinite or too distant corners.
    #[error(
        "the box of {of} is not one: each lower corner must be at or below the upper one, and both within ±1e150"
    )]
    BadBox {
        /// The surface's name, or "the scene".
        of: &'static str,
    },
    /// There are more surfaces than a picture can tell apart.
    #[error("a scene holds at most 65535 surfaces, this one has {0}")]
    TooMany(usize),
}

impl Scene {
    /// Nothing yet.
    pub fn new() -> Self {
        Scene::default()
    }

    /// Adds a surface or a solid, to be solved by [`Auto`](crate::contract::Auto).
    pub fn with(self, object: impl Operand) -> Self {
        object.add_to(self)
    }

    /// Adds a surface, to be solved by the contractor `C`.
    pub fn with_solver<C: Contractor, S: Surface + 'static>(self, surface: S) -> Self {
        self.add(Box::new(surface::Solver::<S, C>::new(surface)))
    }

    pub(crate) fn add(mut self, object: Box<dyn Trace>) -> Self {
        self.surfaces.push(object);
        self.octree = None;
        self
    }

    /// The box in which surfaces without a domain of their own are searched.
    pub fn within(mut self, low: [f64; 3], high: [f64; 3]) -> Self {
        self.bounds = Some([low, high]);
        self.octree = None;
        self
    }

    /// Finds the boxes in which its surfaces may have roots, for all pictures and rays to come: see
    /// [`space`](crate::space). It uses the threads of rayon's current pool. What is added to the scene afterwards, or another
    /// box, drops them again.
    ///
    /// # Errors
    /// As [`render`](fn@crate::render), for the scene and the instruction set.
    pub fn subdivided(mut self, how: &Subdivision) -> Result<Self, RenderError> {
        self.octree = Some(Octree::new(&self, how)?);
        Ok(self)
    }

    /// The boxes that [`subdivided`](Self::subdivided) found.
    pub fn octree(&self) -> Option<&Octree> {
        self.octree.as_ref()
    }

    /// Calls one of the smallest boxes of an object empty, whatever it holds: for negative controls alone.
    #[cfg(feature = "unrounded")]
    #[doc(hidden)]
    #[must_use]
    pub fn forget_box(mut self, object: usize, number: u32) -> Self {
        if let Some(octree) = &mut self.octree {
            octree.forget(object, number);
        }
        self
    }

    /// How many surfaces there are, operands of solids among them. Their indices follow the order in which they were added.
    pub fn len(&self) -> usize {
        self.labels().count()
    }

    pub(crate) fn labels(&self) -> impl Iterator<Item = Label> {
        self.surfaces.iter().flat_map(|surface| surface.labels())
    }

    /// Is there no surface?
    pub fn is_empty(&self) -> bool {
        self.surfaces.is_empty()
    }

    /// The index of the first label of each object.
    pub(crate) fn first_labels(&self) -> Vec<u16> {
        let mut next = 0;
        let mut first = Vec::with_capacity(self.surfaces.len());
        for surface in &self.surfaces {
            first.push(next);
            next += surface.labels().len() as u16;
        }
        first
    }

    /// Checks all parameters, and finds each surface's box.
    pub(crate) fn boxes(&self) -> Result<Vec<[[f64; 3]; 2]>, SceneError> {
        let surfaces = self.len();
        if surfaces > usize::from(u16::MAX) {
            return Err(SceneError::TooMany(surfaces));
        }
        if let Some(bounds) = &self.bounds {
            Self::check_box(bounds, "the scene")?;
        }
        let mut boxes = Vec::with_capacity(self.surfaces.len());
        for surface in &self.surfaces {
            surface.check()?;
            let name = surface.name();
            let own = surface
                .domain()
                .or(self.bounds)
                .ok_or(SceneError::NoDomain { surface: name })?;
            Self::check_box(&own, name)?;
            boxes.push(own);
        }
        Ok(boxes)
    }

    /// Coordinates within ±1e150 keep the parameters t of all rays finite.
    pub(crate) fn check_box(b: &[[f64; 3]; 2], of: &'static str) -> Result<(), SceneError> {
        let fine = (0..3).all(|k| b[0][k] <= b[1][k] && b[0][k] >= -1e150 && b[1][k] <= 1e150);
        if fine {
            Ok(())
        } else {
            Err(SceneError::BadBox { of })
        }
    }
}

/// The smallest box around boxes; nothing if there are none.
pub(crate) fn hull(boxes: &[[[f64; 3]; 2]]) -> Option<[[f64; 3]; 2]> {
    boxes.iter().copied().reduce(|a, b| {
        let mut all = a;
        for k in 0..3 {
            all[0][k] = a[0][k].min(b[0][k]);
            all[1][k] = a[1][k].max(b[1][k]);
        }
        all
    })
}
