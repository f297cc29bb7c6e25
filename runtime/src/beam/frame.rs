//! A camera's affine coordinates, in which a beam is a box.

use crate::interval::{Arithmetic, Interval, Packet, Scalar};
use crate::ray::Rays;

/// The coordinates (t, α, β) of space with p = from + t·forward + α·right + β·up. The ray of a pixel at (a, b) on the
/// picture plane is α = at, β = bt in a perspective view, and α = a, β = b in an orthographic one: the rays of a
/// rectangle of pixels fill, for t in an interval, a box.
///
/// Rays are the lines of their `f64` numbers, which were rounded. `slack` bounds how far a ray's point at t is from where
/// it should be, in each coordinate, as long as t ≤ `far`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// forward, right, up.
    pub axes: [[f64; 3]; 3],
    /// Where the camera is.
    pub from: [f64; 3],
    pub perspective: bool,
    /// The size of a pixel on the picture plane.
    pub pixel: f64,
    /// The first and the last t in the scene's box.
    pub near: f64,
    pub far: f64,
    /// See above.
    pub slack: f64,
    /// The directions' errors alone, in each coordinate.
    pub tilt: f64,
    /// Lengths of right and up beside that of forward.
    pub aspect: [f64; 2],
    /// From a vector of space to its coordinates, by rows.
    pub inverse: [[Interval; 3]; 3],
}

/// What a camera is made of.
pub(crate) struct View {
    pub from: [f64; 3],
    pub axes: [[f64; 3]; 3],
    pub perspective: bool,
    /// The size of a pixel on the picture plane.
    pub pixel: f64,
    /// Bounds of |a| and |b| over the picture, and beyond it as far as beams reach.
    pub reach: [f64; 2],
}

/// The greatest |x|.
fn magnitude(a: Interval) -> f64 {
    a.lo.abs().max(a.hi.abs())
}

fn point(x: f64) -> Interval {
    Interval { lo: x, hi: x }
}

fn dot(a: &[Interval; 3], b: &[Interval; 3]) -> Interval {
    let s = Scalar;
    let [x, y, z] = [0, 1, 2].map(|k| s.mul(a[k], b[k]));
    s.add(s.add(x, y), z)
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [Interval; 3] {
    let s = Scalar;
    let product = |i: usize, j: usize| s.mul(point(a[i]), point(b[j]));
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| s.sub(product(i, j), product(j, i)))
}

impl Frame {
    /// The frame of a view of a box; nothing where no ray meets the box, or no bound can be had (vectors that are nearly
    /// parallel, numbers too large).
    pub fn new(view: &View, domain: &[[f64; 3]; 2]) -> Option<Frame> {
        let s = Scalar;
        let axes = &view.axes;
        let rows = [
            cross(&axes[1], &axes[2]),
            cross(&axes[2], &axes[0]),
            cross(&axes[0], &axes[1]),
        ];
        let volume = dot(&axes[0].map(point), &rows[0]);
        if volume.lo <= 0.0 && volume.hi >= 0.0 {
            return None;
        }
        let inverse = rows.map(|row| row.map(|x| s.div(x, volume).0));

        let (mut near, mut far) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in 0..8usize {
            let d = [0, 1, 2].map(|k| {
                let c = point(domain[corner >> k & 1][k]);
                s.sub(c, point(view.from[k]))
            });
            let t = dot(&inverse[0], &d);
            near = near.min(t.lo);
            far = far.max(t.hi);
        }
        // A coordinate of a ray is the sum of three rounded products, and each is within four roundings of the exact one.
        let unit = 8.0 * (0.5 * f64::EPSILON);
        let [a, b] = view.reach;
        let error = |main: f64, k: usize| {
            unit * (axes[1][k].abs() * a + axes[2][k].abs() * b + main.abs()) + 1e-300
        };
        let greatest = |errors: [f64; 3]| {
            let sums =
                inverse.map(|row| (0..3).map(|k| magnitude(row[k]) * errors[k]).sum::<f64>());
            2.0 * sums.into_iter().fold(0.0, f64::max)
        };
        let (tilt, shift) = if view.perspective {
            (greatest([0, 1, 2].map(|k| error(axes[0][k], k))), 0.0)
        } else {
            (0.0, greatest([0, 1, 2].map(|k| error(view.from[k], k))))
        };
        let reach = 2.0 * far.abs().max(near.abs());
        // The middle of a beam is at most (a, b) from the frame's, and moves with t.
        let slack = 2.0 * (1.0 + a + b) * (shift + (tilt + 4.0 * f64::EPSILON) * reach);
        let length = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let forward = length(&axes[0]);
        let frame = Frame {
            axes: *axes,
            from: view.from,
            perspective: view.perspective,
            pixel: view.pixel,
            near: (near - 2.0 * slack).max(-4.0 * slack),
            far: far + 2.0 * slack,
            slack,
            tilt,
            aspect: [length(&axes[1]) / forward, length(&axes[2]) / forward],
            inverse,
        };
        let fine = frame.slack.is_finite() && frame.near.is_finite() && frame.far.is_finite();
        (fine && far >= 0.0).then_some(frame)
    }

    /// Space itself, with its axes x, y and z, from a point on. Nothing is rounded here.
    pub fn axes_from(from: [f64; 3]) -> Frame {
        let unit = |k: usize| [0, 1, 2].map(|j| if j == k { 1.0 } else { 0.0 });
        let axes = [0, 1, 2].map(unit);
        Frame {
            axes,
            from,
            perspective: false,
            pixel: 1.0,
            near: 0.0,
            far: f64::INFINITY,
            slack: 0.0,
            tilt: 0.0,
            aspect: [1.0; 2],
            inverse: axes.map(|row| row.map(point)),
        }
    }

    /// The lines through the point at `near` on the middle ray that [`Assemble`](super::Assemble) asks for.
    #[inline(always)]
    pub fn lines<P: Packet>(&self, p: P) -> Rays<P> {
        const FORWARD: [f64; 8] = [1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0];
        const RIGHT: [f64; 8] = [0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0];
        const UP: [f64; 8] = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0];
        let near = p.splat(self.near);
        let [t, x, y] = [FORWARD, RIGHT, UP].map(|weights| p.lanes(weights));
        let mut rays = Rays {
            origin: [p.point(near); 3],
            direction: [p.point(near); 3],
            end: p.splat(f64::INFINITY),
        };
        for axis in 0..3 {
            let [forward, right, up] = self.axes.map(|v| p.splat(v[axis]));
            rays.origin[axis] = p.recentre(near, forward, p.splat(self.from[axis]));
            // Weights are 0 or 1: the products are exact.
            let part = |weight: P::F, v: P::F| p.point(p.mul_rn(weight, v));
            rays.direction[axis] = p.add(p.add(part(t, forward), part(x, right)), part(y, up));
        }
        rays
    }
}
