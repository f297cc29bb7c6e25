//! Roots that `f64` cannot pin down: grazing rays, where the noise of f is divided by a small slope.

use crate::interval::{Ball, Fine, Interval};
use crate::surface::Surface;

/// A root's interval that is wider than this gets a second look in twice the precision.
pub(crate) const WIDE: f64 = 5e-13;
/// How narrow the second look makes it.
const GOAL: f64 = 1e-13;

/// The exact ray origin + (entry + t)·direction.
pub(crate) struct Line {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    pub entry: f64,
}

impl Line {
    /// The sign of f at `t`, if it is certain.
    fn sign<S: Surface>(&self, prepared: &S::Prepared, t: f64, counts: &mut u64) -> Option<bool> {
        *counts += 1;
        let t = Ball::sum(self.entry, t);
        let f = S::gradient(
            Fine,
            prepared,
            std::array::from_fn(|k| t.along(self.origin[k], self.direction[k])),
        );
        let value = f.d[0].interval();
        let defined = !(f.flags.empty || f.flags.undefined || f.flags.jump);
        let certain = defined && (value.lo > 0.0 || value.hi < 0.0);
        certain.then_some(value.lo > 0.0)
    }
}

/// Bisects an interval that holds exactly one root, at which f changes its sign. Certain signs alone move its ends.
#[cold]
#[inline(never)]
pub(crate) fn sharpen<S: Surface>(
    prepared: &S::Prepared,
    line: &Line,
    root: Interval,
    counts: &mut u64,
) -> Interval {
    let mut root = root;
    let Some(before) = line.sign::<S>(prepared, root.lo, counts) else {
        return root;
    };
    if line.sign::<S>(prepared, root.hi, counts) != Some(!before) {
        return root;
    }
    let goal = GOAL.max(4.0 * f64::EPSILON * root.hi);
    while root.hi - root.lo > goal {
        let middle = root.lo + 0.5 * (root.hi - root.lo);
        match line.sign::<S>(prepared, middle, counts) {
            Some(sign) if sign == before => root.lo = middle,
            Some(_) => root.hi = middle,
            None => break,
        }
    }
    root
}
