//! f over a piece of one ray.

use core::marker::PhantomData;

use super::Enclosure;
use crate::camera::Ray;
use crate::interval::{Interval, Isa};
use crate::surface::Surface;
use crate::trace::RangeAlong;

/// What is known of f on a piece of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// All values of f there.
    pub f: Interval,
    /// f may be undefined somewhere on the piece.
    pub undefined: bool,
    /// f may be discontinuous somewhere on the piece.
    pub jump: bool,
}

/// f over the points of `ray` with parameters in `t`, by the form `E`; `t.lo` is finite, and `t.lo ≤ t.hi`.
///
/// ```
/// use zeroset::camera::Ray;
/// use zeroset::enclosure::{MeanValue, range};
/// use zeroset::glam::DVec3;
/// use zeroset::interval::{Interval, Isa};
/// use zeroset::implicit;
///
/// implicit! { struct Ball; x^2 + y^2 + z^2 = 1 }
/// let ray = Ray { origin: DVec3::new(-2.0, 0.0, 0.0), direction: DVec3::X };
/// let t = Interval { lo: 2.0, hi: 2.5 };
/// let f = range::<MeanValue, _>(&Ball, &ray, t, Isa::detect()?).f;
/// assert!(f.contains(-1.0) && f.contains(-0.75));
/// # Ok::<(), zeroset::interval::IsaError>(())
/// ```
pub fn range<E: Enclosure, S: Surface>(surface: &S, ray: &Ray, t: Interval, isa: Isa) -> Range {
    let prepared = surface.prepare();
    isa.run(RangeAlong::<S, E> {
        prepared: &prepared,
        ray,
        t,
        form: PhantomData,
    })
}
