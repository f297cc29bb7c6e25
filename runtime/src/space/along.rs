//! Where one ray meets an octree's boxes.

use super::outline::MARGIN;
use super::tree::Tree;
use crate::camera::Ray;
use crate::interval::{Interval, Isa, Kernel, Packet};

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
        let (origin, direction) = (self.ray.origin.to_array(), self.ray.direction.to_array());
        let root = &self.tree.root;
        let point = |x: f64| p.point(p.splat(x));
        let low = [0, 1, 2].map(|k| p.sub(point(root.low[k]), point(origin[k])));
        let speed = direction.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
        let side = root
            .size
            .iter()
            .fold(0.0, |most: f64, side| most.max(side.hi));
        let mut all = [f64::INFINITY, f64::NEG_INFINITY];
        self.tree.walk(&mut |parts| {
            let sides = root.parts(p, parts.place, parts.level);
            let mut span = Interval {
                lo: p.splat(0.0),
                hi: p.splat(f64::INFINITY),
            };
            for (k, &d) in direction.iter().enumerate() {
                pass(p, p.add(low[k], sides[k]), d, &mut span);
            }
            let met = parts.open & p.bits(p.le(span.lo, span.hi));
            if parts.last {
                let margin = MARGIN * side / speed / f64::from(1u32 << parts.level);
                let (lo, hi) = (p.to_array(span.lo), p.to_array(span.hi));
                for k in (0..8).filter(|k| met >> k & 1 != 0) {
                    all = [all[0].min(lo[k] - margin), all[1].max(hi[k] + margin)];
                }
            }
            met
        });
        all
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
