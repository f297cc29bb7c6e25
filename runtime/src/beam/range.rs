//! Ranges of leaves, and of their derivatives, over a piece of a beam.

use super::{Direction, LinearOver, QuadraticOver, Slab, Towards};
use crate::interval::{Interval, Packet, Parameter, doubled};

/// [−r, r], added.
#[inline(always)]
fn widen<P: Packet>(p: P, a: Interval<P::F>, r: P::F) -> Interval<P::F> {
    Interval {
        lo: p.sub_rd(a.lo, r),
        hi: p.add_ru(a.hi, r),
    }
}

impl<F: Copy> Towards<F> {
    /// The derivative along a ray, from those by t, x and y.
    #[inline(always)]
    fn along<P: Packet<F = F>>(
        &self,
        p: P,
        t: Interval<F>,
        x: Interval<F>,
        y: Interval<F>,
    ) -> Interval<F> {
        let x = p.radius(self.turn[0], p.magnitude(x), p.splat(0.0));
        let both = p.radius(self.turn[1], p.magnitude(y), x);
        widen(p, t, p.radius(self.tilt, p.magnitude(t), both))
    }
}

/// Over a slab a form is its value on the middle ray, whose range is exact, and x·g_x(t) + y·g_y(t) + the squares and the
/// product of x and y.
impl<P: Packet> LinearOver<P> {
    /// The range.
    #[inline(always)]
    pub(super) fn range(&self, p: P, over: &Slab<P::F>) -> Interval<P::F> {
        let x = p.radius(over.half[0], p.magnitude(self.side[0]), p.splat(0.0));
        let both = p.radius(over.half[1], p.magnitude(self.side[1]), x);
        widen(p, over.t.linear(p, &self.middle), both)
    }

    /// The derivative that `towards` names.
    #[inline(always)]
    pub(super) fn slope(&self, p: P, towards: &Towards<P::F>) -> Interval<P::F> {
        let [x, y] = self.side;
        match towards.direction {
            Direction::Along => towards.along(p, self.middle.c1, x, y),
            Direction::Right => x,
            Direction::Up => y,
            Direction::Any => p.hull(towards.along(p, self.middle.c1, x, y), p.hull(x, y)),
        }
    }
}

impl<P: Packet> QuadraticOver<P> {
    /// The range.
    #[inline(always)]
    pub(super) fn range(&self, p: P, over: &Slab<P::F>) -> Interval<P::F> {
        let zero = p.splat(0.0);
        let middle = over.t.quadratic(p, &self.middle);
        let [x, y] = over.half;
        let mut around = p.radius(p.radius(x, y, zero), p.magnitude(self.mixed), zero);
        for (h, side) in [x, y].into_iter().zip(&self.side) {
            around = p.radius(h, p.magnitude(over.t.linear(p, side)), around);
        }
        let (mut below, mut above) = (around, around);
        for (h, bend) in [x, y].into_iter().zip(&self.square) {
            let square = p.radius(h, h, zero);
            below = p.radius(square, p.max_f(p.neg_f(bend.lo), zero), below);
            above = p.radius(square, p.max_f(bend.hi, zero), above);
        }
        Interval {
            lo: p.sub_rd(middle.lo, below),
            hi: p.add_ru(middle.hi, above),
        }
    }

    /// The derivative by t at fixed x and y.
    #[inline(always)]
    pub(super) fn by_t(&self, p: P, over: &Slab<P::F>) -> Interval<P::F> {
        let on_middle = over.t.quadratic_slope(p, &self.middle);
        let x = p.radius(over.half[0], p.magnitude(self.side[0].c1), p.splat(0.0));
        widen(
            p,
            on_middle,
            p.radius(over.half[1], p.magnitude(self.side[1].c1), x),
        )
    }

    /// The derivative by x (k = 0) or y (k = 1).
    #[inline(always)]
    fn by_side(&self, p: P, over: &Slab<P::F>, k: usize) -> Interval<P::F> {
        let on_middle = over.t.linear(p, &self.side[k]);
        let own = doubled(p, self.square[k]);
        let own = p.radius(over.half[k], p.magnitude(own), p.splat(0.0));
        widen(
            p,
            on_middle,
            p.radius(over.half[1 - k], p.magnitude(self.mixed), own),
        )
    }

    /// The derivative that `towards` names.
    #[inline(always)]
    pub(super) fn slope(&self, p: P, towards: &Towards<P::F>) -> Interval<P::F> {
        let over = &towards.over;
        match towards.direction {
            Direction::Right => self.by_side(p, over, 0),
            Direction::Up => self.by_side(p, over, 1),
            Direction::Along | Direction::Any => {
                let side = [self.by_side(p, over, 0), self.by_side(p, over, 1)];
                let along = towards.along(p, self.by_t(p, over), side[0], side[1]);
                match towards.direction {
                    Direction::Any => p.hull(along, p.hull(side[0], side[1])),
                    _ => along,
                }
            }
        }
    }

    /// The second derivative in the direction that `towards` names.
    #[inline(always)]
    pub(super) fn curvature(&self, p: P, towards: &Towards<P::F>) -> Interval<P::F> {
        let (right, up) = (doubled(p, self.square[0]), doubled(p, self.square[1]));
        match towards.direction {
            Direction::Right => right,
            Direction::Up => up,
            Direction::Along => self.bend(p, towards),
            Direction::Any => p.hull(self.bend(p, towards), p.hull(right, up)),
        }
    }

    /// The second derivative along a ray, where x(t) = x₀ + at, |a| ≤ `turn`: wᵀHw with w = (1 ± tilt, ± turn, ± turn).
    #[inline(always)]
    fn bend(&self, p: P, towards: &Towards<P::F>) -> Interval<P::F> {
        let [a, b] = towards.turn;
        let one = p.splat(1.0);
        let rate = Interval {
            lo: p.sub_rd(one, towards.tilt),
            hi: p.add_ru(one, towards.tilt),
        };
        let side = |r: P::F| Interval {
            lo: p.neg_f(r),
            hi: r,
        };
        let (x, y) = (side(a), side(b));
        let mixed = p.add(p.mul(x, self.side[0].c1), p.mul(y, self.side[1].c1));
        let squares = p.add(
            p.mul(p.sqr(x), self.square[0]),
            p.mul(p.sqr(y), self.square[1]),
        );
        let rest = p.add(squares, p.mul(p.mul(x, y), self.mixed));
        let t = p.mul(p.sqr(rate), self.middle.c2);
        doubled(p, p.add(p.add(t, p.mul(rate, mixed)), rest))
    }
}
