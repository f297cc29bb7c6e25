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
        let x = p.mul_nonneg_ru(self.turn[0], p.magnitude(x));
        let y = p.mul_nonneg_ru(self.turn[1], p.magnitude(y));
        let rate = p.mul_nonneg_ru(self.tilt, p.magnitude(t));
        widen(p, t, p.add_ru(rate, p.add_ru(x, y)))
    }
}

/// Over a slab a form is its value on the middle ray, whose range is exact, and x·g_x(t) + y·g_y(t) + the squares and the
/// product of x and y.
impl<P: Packet> LinearOver<P> {
    /// The range.
    #[inline(always)]
    pub(super) fn range(&self, p: P, over: &Slab<P::F>) -> Interval<P::F> {
        let x = p.mul_nonneg_ru(over.half[0], p.magnitude(self.side[0]));
        let y = p.mul_nonneg_ru(over.half[1], p.magnitude(self.side[1]));
        widen(p, over.t.linear(p, &self.middle), p.add_ru(x, y))
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
        let mut around = p.mul_nonneg_ru(p.mul_nonneg_ru(x, y), p.magnitude(self.mixed));
        let (mut lo, mut hi) = (middle.lo, middle.hi);
        for (k, h) in [x, y].into_iter().enumerate() {
            let slope = p.magnitude(over.t.linear(p, &self.side[k]));
            around = p.add_ru(around, p.mul_nonneg_ru(h, slope));
            let square = p.mul_nonneg_ru(h, h);
            let bend = self.square[k];
            let below = p.max_f(p.neg_f(bend.lo), zero);
            lo = p.sub_rd(lo, p.mul_nonneg_ru(square, below));
            hi = p.add_ru(hi, p.mul_nonneg_ru(square, p.max_f(bend.hi, zero)));
        }
        widen(p, Interval { lo, hi }, around)
    }

    /// The derivative by t at fixed x and y.
    #[inline(always)]
    pub(super) fn by_t(&self, p: P, over: &Slab<P::F>) -> Interval<P::F> {
        let on_middle = over.t.quadratic_slope(p, &self.middle);
        let x = p.mul_nonneg_ru(over.half[0], p.magnitude(self.side[0].c1));
        let y = p.mul_nonneg_ru(over.half[1], p.magnitude(self.side[1].c1));
        widen(p, on_middle, p.add_ru(x, y))
    }

    /// The derivative by x (k = 0) or y (k = 1).
    #[inline(always)]
    fn by_side(&self, p: P, over: &Slab<P::F>, k: usize) -> Interval<P::F> {
        let on_middle = over.t.linear(p, &self.side[k]);
        let own = doubled(p, self.square[k]);
        let own = p.mul_nonneg_ru(over.half[k], p.magnitude(own));
        let other = p.mul_nonneg_ru(over.half[1 - k], p.magnitude(self.mixed));
        widen(p, on_middle, p.add_ru(own, other))
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
