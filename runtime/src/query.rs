//! Rays one by one.

use core::marker::PhantomData;

use crate::camera::Ray;
use crate::contract::{Auto, Contractor};
use crate::interval::Isa;
use crate::render::{RenderError, Trail, check_ray};
use crate::scene::{Scene, SceneError, Search};
use crate::solve::Settings;
use crate::surface::Surface;
use crate::trace::AlongRay;

/// One surface, ready for any number of rays. Of its code, only what searches rays is compiled: no beams, no normals.
///
/// ```
/// use zeroset::camera::Ray;
/// use zeroset::glam::DVec3;
/// use zeroset::{implicit, interval::Isa, query::Query};
///
/// implicit! { struct Ball; x^2 + y^2 + z^2 = 1 }
/// let query: Query<Ball> = Query::new(&Ball, [[-2.0; 3], [2.0; 3]], Isa::detect()?)?;
/// let trail = query.trail(&Ray { origin: DVec3::new(-3.0, 0.0, 0.0), direction: DVec3::X })?;
/// let roots: Vec<_> = trail.events.iter().filter_map(|event| event.t()).collect();
/// assert!(roots.len() == 2 && (trail.entry + roots[0].lo - 2.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Query<S: Surface, C = Auto> {
    /// How rays are searched.
    pub settings: Settings,
    prepared: S::Prepared,
    domain: [[f64; 3]; 2],
    isa: Isa,
    contractor: PhantomData<C>,
}

impl<S: Surface, C: Contractor> Query<S, C> {
    /// A surface inside a box, lower and upper corner.
    ///
    /// # Errors
    /// If a field of the surface is not finite, or the box is none.
    pub fn new(surface: &S, domain: [[f64; 3]; 2], isa: Isa) -> Result<Self, SceneError> {
        surface.check()?;
        Scene::check_box(&domain, S::REPORT.name)?;
        Ok(Query {
            settings: Settings::default(),
            prepared: surface.prepare(),
            domain,
            isa,
            contractor: PhantomData,
        })
    }

    /// All events along a ray, and all that is known of the search.
    ///
    /// # Errors
    /// If the ray is not one.
    pub fn trail(&self, ray: &Ray) -> Result<Trail, RenderError> {
        check_ray(ray)?;
        Ok(C::run(
            self.isa,
            AlongRay::<S, C> {
                prepared: &self.prepared,
                settings: &self.settings,
                search: &Search {
                    ray,
                    domain: &self.domain,
                    within: None,
                },
                first_only: false,
                solver: PhantomData,
            },
        ))
    }
}
