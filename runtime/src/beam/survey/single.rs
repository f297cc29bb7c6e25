//! Beams on each of whose rays there is exactly one root.

use super::Found;
use super::march::{Sides, Surveyor};
use crate::beam::{Direction, Slab};
use crate::contract::middle;
use crate::interval::{Interval, Packet};
use crate::solve::{differentiable, nonzero, select};

/// A piece around a root of the middle ray.
struct Trial {
    /// How far behind the root it ends, beside how far before it begins.
    behind: f64,
    /// Is f on its end faces enclosed with derivatives there, or with those of the whole piece?
    own_sides: bool,
}

/// It does on faces that the rays meet steeply, …
const NEAR: Trial = Trial {
    behind: 1.25,
    own_sides: false,
};
/// … and this on others, at a higher price.
const WIDE: Trial = Trial {
    behind: 4.0,
    own_sides: true,
};

impl<P: Packet> Surveyor<'_, P> {
    /// Every ray of a beam has exactly one root in a piece if f has opposite certain signs on its two end faces, is continuous
    /// between them, and strictly monotone along all rays.
    #[inline(always)]
    pub(super) fn prove_single(&mut self, found: &mut Found<P>) {
        let front = found.front;
        let root = self.guess(front, found.open);
        self.try_single(found, root, &NEAR);
        if self.surface.is_dear() {
            self.try_single(found, root, &WIDE);
        }
    }

    /// Tries a piece for the beams that are open.
    #[inline(always)]
    fn try_single(&mut self, found: &mut Found<P>, root: P::F, trial: &Trial) {
        let p = self.p;
        let front = found.front;
        let ahead = p.sub_rn(root, front);
        let back = p.add_rn(root, p.mul_rn(ahead, p.splat(trial.behind)));
        let slack = p.splat(8.0 * self.group.slack());
        let back = p.max_f(p.add_rn(back, slack), front);
        let likely = p.and(
            p.and_not(found.open, found.one),
            p.and(p.le(back, self.stretch.end), p.lt(front, back)),
        );
        if !p.any(likely) {
            return;
        }
        let back = p.select(likely, back, front);
        let t = Interval {
            lo: front,
            hi: back,
        };
        let slab = self.group.slab(p, &t);
        let along = self.slope(slab, Direction::Along);
        let smooth = differentiable(p, &along.flags, likely);
        let steep = p.and(smooth, nonzero(p, &along.d[1]));
        if !p.any(steep) {
            return;
        }
        let sides = self.sides(slab, steep);
        let slack = p.splat(2.0 * self.group.slack());
        let first = Interval {
            lo: front,
            hi: p.add_ru(front, slack),
        };
        let last = Interval {
            lo: p.sub_rd(back, slack),
            hi: back,
        };
        let before = self.face(&first, trial, steep, (&slab, &sides));
        let behind = self.face(&last, trial, steep, (&slab, &sides));
        let zero = p.splat(0.0);
        let rises = p.and(p.lt(before.hi, zero), p.lt(zero, behind.lo));
        let falls = p.and(p.lt(zero, before.lo), p.lt(behind.hi, zero));
        let one = p.and(p.and(steep, sides.usable), p.or(rises, falls));
        found.one = p.or(found.one, one);
        found.back = p.select(one, back, found.back);
        found.slope = select(p, one, &along.d[1], &found.slope);
        let plane = self.plane(root, &along.d[1], &sides);
        for (own, new) in found.plane.iter_mut().zip(plane) {
            *own = p.select(one, new, *own);
        }
    }

    /// f on an end face of a slab.
    #[inline(always)]
    fn face(
        &mut self,
        t: &Interval<P::F>,
        trial: &Trial,
        live: P::M,
        (slab, sides): (&Slab<P::F>, &Sides<P>),
    ) -> Interval<P::F> {
        if !trial.own_sides {
            return self.mean(t, slab, sides);
        }
        let slab = self.group.slab(self.p, t);
        let sides = self.sides(slab, live);
        self.mean(t, &slab, &sides)
    }

    /// The tangential plane at a root of the middle ray, nearly: t there, and its change per pixel. The derivatives are those
    /// in the middle of what they are around.
    #[inline(always)]
    fn plane(&self, root: P::F, along: &Interval<P::F>, sides: &Sides<P>) -> [P::F; 3] {
        let p = self.p;
        let along = middle(p, along);
        let [right, up] = [middle(p, &sides.by[0]), middle(p, &sides.by[1])];
        let scale = p.neg_f(p.div_rn(self.group.pixel(p, root), along));
        let [right, up] = [p.mul_rn(right, scale), p.mul_rn(up, scale)];
        let [x, y] = self.group.pixels;
        let at = p.sub_rn(root, p.add_rn(p.mul_rn(x, right), p.mul_rn(y, up)));
        [at, right, up]
    }

    /// f and its derivative in a direction on the middle ray, nearly.
    #[inline(always)]
    fn plainly(&mut self, x: P::F, direction: Direction) -> [P::F; 2] {
        let p = self.p;
        let half = p.splat(0.5);
        *self.count += self.surface.parts();
        let f = self.surface.slope(p, &self.middle(x, direction));
        f.d.map(|f| p.mul_rn(half, p.add_rn(f.lo, f.hi)))
    }

    /// Where the middle ray's root may be: a few Newton steps from the front, which prove nothing. One that is shorter than the
    /// beam is wide is the last.
    #[inline(always)]
    fn guess(&mut self, front: P::F, live: P::M) -> P::F {
        let p = self.p;
        let width = self.group.width(p, front);
        let mut x = front;
        for round in 0..4 {
            let [value, slope] = self.plainly(x, Direction::Along);
            let next = p.sub_rn(x, p.div_rn(value, slope));
            // A step that leads nowhere, or is no number, is not taken.
            let fine = p.and(p.le(front, next), p.le(next, self.stretch.end));
            let long = p.and(fine, p.lt(width, p.abs_f(p.sub_rn(next, x))));
            x = p.select(fine, next, x);
            if round > 0 && !p.any(p.and(live, long)) {
                break;
            }
        }
        x
    }
}
