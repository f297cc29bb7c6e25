//! Rays, eight at a time.

use crate::camera::Ray;
use crate::interval::{Interval, Packet};

/// The lines `origin + t·direction`, t ∈ [0, end], of one packet. Origins lie where the rays enter the box: the exact
/// ray's point at `entry` (a plain `f64` per ray, the same for all surfaces of a scene) is enclosed in `origin`, so
/// coordinates near the surface keep full precision however far away the camera is. Intervals that are wider than a
/// rounding make a beam: a bundle that holds every ray with origin and direction in them.
#[derive(Clone, Copy)]
pub struct Rays<P: Packet> {
    /// Where each ray enters the box; x, y, z.
    pub origin: [Interval<P::F>; 3],
    /// The direction as given, not normalised; x, y, z.
    pub direction: [Interval<P::F>; 3],
    /// The last t of interest, rounded up. Negative lanes hold no ray.
    pub end: P::F,
}

/// Up to eight exact rays, as their `f64` numbers; `origin[k][i]` is coordinate k of ray i.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lines {
    pub origin: [[f64; 8]; 3],
    pub direction: [[f64; 8]; 3],
}

impl Lines {
    /// The same ray eight times.
    pub fn same(ray: &Ray) -> Self {
        let spread = |v: [f64; 3]| [[v[0]; 8], [v[1]; 8], [v[2]; 8]];
        Lines {
            origin: spread(ray.origin.to_array()),
            direction: spread(ray.direction.to_array()),
        }
    }
}

/// Where rays are inside a box: `near` is a lower bound of the first parameter t ≥ 0, `far` an upper bound of the last.
/// `far < near` where the ray certainly misses the box. Otherwise both ends are 2⁻⁴⁴ of the way between them further out:
/// a root on a face is then a root like any other.
#[derive(Clone, Copy)]
pub(crate) struct Span<P: Packet> {
    pub near: P::F,
    pub far: P::F,
}

/// The slab method, rounded outward: for each axis with d > 0 the ray is inside for (lo − o)/d ≤ t ≤ (hi − o)/d. An
/// axis with d < 0 is mirrored first, so that each quotient has one rounding direction; with d = 0 (or −0) the axis
/// either never matters or excludes the ray. Origins on a face count as inside.
#[inline(always)]
pub(crate) fn clip<P: Packet>(p: P, lines: &Lines, domain: &[[f64; 3]; 2]) -> Span<P> {
    let zero = p.splat(0.0);
    let mut near = zero;
    let mut far = p.splat(f64::INFINITY);
    let mut axis = 0;
    while axis < 3 {
        let o = p.lanes(lines.origin[axis]);
        let d = p.lanes(lines.direction[axis]);
        let lo = p.splat(domain[0][axis]);
        let hi = p.splat(domain[1][axis]);
        let mirrored = p.lt(d, zero);
        let parallel = p.eq(d, zero);
        let inside = p.and(p.le(lo, o), p.le(o, hi));
        let face_in = p.select(mirrored, p.neg_f(hi), lo);
        let face_out = p.select(mirrored, p.neg_f(lo), hi);
        let from = p.select(mirrored, p.neg_f(o), o);
        let speed = p.abs_f(d);
        let enters = p.div_rd(p.sub_rd(face_in, from), speed);
        let leaves = p.div_ru(p.sub_ru(face_out, from), speed);
        let never = p.splat(f64::NEG_INFINITY);
        let always = p.splat(f64::INFINITY);
        // 0/0 is NaN, and is not selected.
        let enters = p.select(parallel, never, enters);
        let leaves = p.select(parallel, p.select(inside, always, never), leaves);
        near = p.max_f(near, enters);
        far = p.min_f(far, leaves);
        axis += 1;
    }
    // What lies on a face has a certain sign on both of its sides.
    let slack = p.mul_rn(p.sub_rn(far, near), p.splat(1.0 / (1u64 << 44) as f64));
    Span {
        near: p.max_f(p.sub_rd(near, slack), zero),
        far: p.add_ru(far, slack),
    }
}

impl<P: Packet> Rays<P> {
    /// Rays recentred at `entry`: the exact ray's point there is enclosed by one directed FMA, within an ulp or two of
    /// the *result*, however far away the origin is.
    #[inline(always)]
    pub(crate) fn recentred(p: P, lines: &Lines, entry: P::F, end: P::F) -> Self {
        let mut origin = [Interval {
            lo: entry,
            hi: entry,
        }; 3];
        let mut direction = origin;
        let mut axis = 0;
        while axis < 3 {
            let o = p.lanes(lines.origin[axis]);
            let d = p.lanes(lines.direction[axis]);
            origin[axis] = Interval {
                lo: p.fma_rd(entry, d, o),
                hi: p.fma_ru(entry, d, o),
            };
            direction[axis] = Interval { lo: d, hi: d };
            axis += 1;
        }
        Rays {
            origin,
            direction,
            end,
        }
    }
}
