//! Where one ray meets an octree's boxes.

use super::cells::Root;
use super::projection::MARGIN;
use super::tree::{Parts, Tree};
use crate::camera::Ray;
use crate::interval::{Interval, Isa, Kernel, Packet, Routine};

impl Tree {
    /// The first and the last t ≥ 0 of boxes that may hold roots along a ray, and a little more; crossed if it meets none.
    pub fn along(&self, isa: Isa, ray: &Ray) -> [f64; 2] {
        isa.run(Along { tree: self, ray })
    }
}

struct Along<'a> {
    tree: &'a Tree,
    ray: &'a Ray,
}

impl Kernel for Along<'_> {
    type Output = [f64; 2];

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [f64; 2] {
        let root = &self.tree.root;
        let (origin, direction) = (self.ray.origin.to_array(), self.ray.direction.to_array());
        let point = |x: f64| p.point(p.splat(x));
        let low = [0, 1, 2].map(|k| p.sub(point(root.low[k]), point(origin[k])));
        let speed = direction.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
        let side = root
            .size
            .iter()
            .fold(0.0, |most: f64, side| most.max(side.hi));
        let mut all = [f64::INFINITY, f64::NEG_INFINITY];
        self.tree.walk(&mut |parts| {
            let (met, [lo, hi]) = p.call(Meet {
                root,
                parts,
                low: &low,
                direction: &direction,
            });
            if parts.last {
                let margin = MARGIN * side / speed / f64::from(1u32 << parts.level);
                for k in (0..8).filter(|k| met >> k & 1 != 0) {
                    all = [all[0].min(lo[k] - margin), all[1].max(hi[k] + margin)];
                }
            }
            met
        });
        all
    }
}

/// The parts of a box that a ray meets, and where.
struct Meet<'a, P: Packet> {
    root: &'a Root,
    parts: &'a Parts,
    /// From the ray's origin to the whole box's lower corner.
    low: &'a [Interval<P::F>; 3],
    direction: &'a [f64; 3],
}

impl<P: Packet> Routine<P> for Meet<'_, P> {
    type Output = (u8, [[f64; 8]; 2]);

    #[inline(always)]
    fn call(self, p: P) -> Self::Output {
        let sides = self.root.parts(p, self.parts.place, self.parts.level);
        let mut span = Interval {
            lo: p.splat(0.0),
            hi: p.splat(f64::INFINITY),
        };
        for (k, &d) in self.direction.iter().enumerate() {
            pass(p, p.add(self.low[k], sides[k]), d, &mut span);
        }
        let met = self.parts.open & p.bits(p.le(span.lo, span.hi));
        (met, [p.to_array(span.lo), p.to_array(span.hi)])
    }
}

/// Cuts `span` down to where a ray passes between two faces, which are counted from its origin, at speed `d`.
#[inline(always)]
fn pass<P: Packet>(p: P, faces: Interval<P::F>, d: f64, span: &mut Interval<P::F>) {
    let zero = p.splat(0.0);
    if d == 0.0 {
        let inside = p.and(p.le(faces.lo, zero), p.le(zero, faces.hi));
        span.hi = p.select(inside, span.hi, p.splat(-1.0));
        return;
    }
    let speed = p.splat(d.abs());
    let faces = if d < 0.0 { p.neg(faces) } else { faces };
    span.lo = p.max_f(p.div_rd(faces.lo, speed), span.lo);
    span.hi = p.min_f(p.div_ru(faces.hi, speed), span.hi);
}
