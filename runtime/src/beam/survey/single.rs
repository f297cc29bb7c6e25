//! Beams on each of whose rays there is exactly one root.

use super::Found;
use super::march::{Sides, Surveyor};
use crate::beam::{Direction, Slab};
use crate::contract::middle;
use crate::interval::{Interval, Packet, Routine};
use crate::solve::{differentiable, nonzero, select};

/// A piece around a root of the middle ray.
struct Trial<P: Packet> {
    root: P::F,
    t: Interval<P::F>,
    /// Is f on its end faces enclosed with derivatives there, or with those of the whole piece?
    own_sides: bool,
}

/// A shorter piece is tried if a kink is in so many of eight.
const MANY: u32 = 4;
/// A piece from the front ends so many times as far behind the root: on faces that the rays meet steeply, …
const NEAR: f64 = 1.25;
/// … and on others, at a higher price.
const FAR: f64 = 4.0;
/// A piece around the other rays' roots reaches so much further than they seem to: f is bent.
const MARGIN: f64 = 1.25;
/// The same in widths of the beam: faces that the rays meet at right angles spread nothing.
const BENT: f64 = 0.125;

impl<P: Packet> Surveyor<'_, P> {
    /// Every ray of a beam has exactly one root in a piece if f has opposite certain signs on its two end faces, is continuous
    /// between them, and strictly monotone along all rays. All that lies between the front and the piece counts as a face.
    #[inline(always)]
    pub(super) fn prove_single(&mut self, found: &mut Found<P>) {
        let p = self.p;
        let front = found.front;
        let (root, along) = self.guess(front, found.open);
        let ahead = p.sub_rn(root, front);
        let from_front = |behind: f64, own_sides| Trial {
            root,
            t: Interval {
                lo: front,
                hi: p.fma_rn(ahead, p.splat(behind), root),
            },
            own_sides,
        };
        let kinked = self.try_single(found, &from_front(NEAR, false));
        if !self.stretch.keenly && p.bits(kinked).count_ones() >= MANY {
            p.call(Shorter {
                surveyor: self,
                found,
                root,
                along,
            });
        }
        if self.surface.is_dear() {
            self.try_single(found, &from_front(FAR, true));
        }
    }

    /// Tries the piece in which the roots of all rays should be: it is short, and may leave out a kink.
    #[inline(always)]
    fn try_around(&mut self, found: &mut Found<P>, root: P::F, along: P::F) {
        let p = self.p;
        let [right, up] = [Direction::Right, Direction::Up].map(|side| self.plainly(root, side)[1]);
        let half = self.group.slab(p, &Interval { lo: root, hi: root }).half;
        let spread = p.add_rn(
            p.mul_rn(p.abs_f(right), half[0]),
            p.mul_rn(p.abs_f(up), half[1]),
        );
        let spread = p.div_rn(spread, p.abs_f(along));
        let bent = p.mul_rn(self.group.width(p, root), p.splat(BENT));
        let around = p.fma_rn(spread, p.splat(MARGIN), bent);
        let trial = Trial {
            root,
            t: Interval {
                lo: p.sub_rn(root, around),
                hi: p.add_rn(root, around),
            },
            own_sides: false,
        };
        self.try_single(found, &trial);
    }

    /// Tries a piece for the beams that are open. The answer is for which of them a kink in it may be to blame.
    #[inline(always)]
    fn try_single(&mut self, found: &mut Found<P>, trial: &Trial<P>) -> P::M {
        let p = self.p;
        let front = found.front;
        let slack = p.splat(8.0 * self.group.slack());
        let start = p.max_f(trial.t.lo, front);
        let back = p.max_f(p.add_rn(trial.t.hi, slack), start);
        let likely = p.and(
            p.and_not(found.open, found.one),
            p.and(p.le(back, self.stretch.end), p.lt(start, back)),
        );
        if !p.any(likely) {
            return likely;
        }
        let start = p.select(likely, start, front);
        let back = p.select(likely, back, front);
        let piece = self.group.slab(
            p,
            &Interval {
                lo: start,
                hi: back,
            },
        );
        let along = self.slope(piece, Direction::Along);
        let smooth = differentiable(p, &along.flags, likely);
        let steep = p.and(smooth, nonzero(p, &along.d[1]));
        let kinked = p.and_not(p.and(smooth, along.flags.kink), steep);
        if !p.any(steep) {
            return kinked;
        }
        let slab = self.group.slab(
            p,
            &Interval {
                lo: front,
                hi: back,
            },
        );
        let sides = self.sides(slab, steep);
        let slack = p.splat(2.0 * self.group.slack());
        let first = Interval {
            lo: front,
            hi: p.add_ru(start, slack),
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
        found.front = p.select(one, start, found.front);
        found.back = p.select(one, back, found.back);
        found.slope = select(p, one, &along.d[1], &found.slope);
        let plane = self.plane(trial.root, &along.d[1], &sides);
        for (own, new) in found.plane.iter_mut().zip(plane) {
            *own = p.select(one, new, *own);
        }
        kinked
    }

    /// f on an end face of a slab.
    #[inline(always)]
    fn face(
        &mut self,
        t: &Interval<P::F>,
        trial: &Trial<P>,
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

    /// Where the middle ray's root may be, and f' near it: a few Newton steps from the front, which prove nothing. One that is
    /// shorter than the beam is wide is the last.
    #[inline(always)]
    fn guess(&mut self, front: P::F, live: P::M) -> (P::F, P::F) {
        let p = self.p;
        let width = self.group.width(p, front);
        let (mut x, mut along) = (front, front);
        for round in 0..4 {
            let [value, slope] = self.plainly(x, Direction::Along);
            along = slope;
            let next = p.sub_rn(x, p.div_rn(value, slope));
            // A step that leads nowhere, or is no number, is not taken.
            let fine = p.and(p.le(front, next), p.le(next, self.stretch.end));
            let long = p.and(fine, p.lt(width, p.abs_f(p.sub_rn(next, x))));
            x = p.select(fine, next, x);
            if round > 0 && !p.any(p.and(live, long)) {
                break;
            }
        }
        (x, along)
    }
}

/// The second try, a routine of its own because few surfaces have kinks.
struct Shorter<'a, 'b, P: Packet> {
    surveyor: &'a mut Surveyor<'b, P>,
    found: &'a mut Found<P>,
    root: P::F,
    along: P::F,
}

impl<P: Packet> Routine<P> for Shorter<'_, '_, P> {
    type Output = ();

    #[inline(always)]
    fn call(self, _p: P) {
        let Shorter {
            surveyor,
            found,
            root,
            along,
        } = self;
        surveyor.try_around(found, root, along);
    }
}
