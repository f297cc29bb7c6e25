//! Leaves of a picture, and leaves of beams inside other beams.

use super::{LinearOver, OverBeams, QuadraticOver};
use crate::interval::{Interval, Lanes, Linear, Packet, Quadratic, Rebind, doubled, operation};

/// s·a for a number s.
#[inline(always)]
fn times<P: Packet>(p: P, s: P::F, a: Interval<P::F>) -> Interval<P::F> {
    Interval {
        lo: p.min_f(p.mul_rd(s, a.lo), p.mend(p.mul_rd(s, a.hi))),
        hi: p.max_f(p.mul_ru(s, a.lo), p.mend(p.mul_ru(s, a.hi))),
    }
}

/// a + s·b
#[inline(always)]
fn plus<P: Packet>(p: P, a: Interval<P::F>, s: P::F, b: Interval<P::F>) -> Interval<P::F> {
    p.add(a, times(p, s, b))
}

/// The leaves of a whole picture, from those along six lines through the frame's origin, in the lanes 0 to 5: in the
/// directions T (forward), R (right), U (up), T + R, T + U and R + U.
///
/// Along a line in direction d a quadratic form q has the coefficients q(o), ∇q(o)·d and dᵀQd, and
/// 2dᵀQe = (d+e)ᵀQ(d+e) − dᵀQd − eᵀQe gives the mixed ones.
pub(crate) struct Assemble<P>(pub P);

impl<P: Packet> Assemble<P> {
    #[inline(always)]
    fn lane(&self, a: Interval<<P::Eight as Lanes>::F>, lane: usize) -> Interval<P::F> {
        let p = self.0;
        let one = |x| p.splat(p.eight().to_array(x)[lane]);
        Interval {
            lo: one(a.lo),
            hi: one(a.hi),
        }
    }
}

impl<P: Packet> Rebind for Assemble<P> {
    type From = P::Eight;
    type To = OverBeams<P>;
    #[inline(always)]
    fn lanes(&self) -> P {
        self.0
    }
    #[inline(always)]
    fn linear(&self, leaf: &Linear<P::Eight>) -> LinearOver<P> {
        LinearOver {
            middle: Linear {
                c0: self.lane(leaf.c0, 0),
                c1: self.lane(leaf.c1, 0),
            },
            side: [self.lane(leaf.c1, 1), self.lane(leaf.c1, 2)],
        }
    }
    #[inline(always)]
    fn quadratic(&self, leaf: &Quadratic<P::Eight>) -> QuadraticOver<P> {
        let p = self.0;
        let along = [0, 1, 2].map(|k| self.lane(leaf.c2, k));
        let mixed = |sum: usize, i: usize, j: usize| {
            p.sub(p.sub(self.lane(leaf.c2, sum), along[i]), along[j])
        };
        QuadraticOver {
            middle: Quadratic::new(p, self.lane(leaf.c0, 0), self.lane(leaf.c1, 0), along[0]),
            side: [
                Linear {
                    c0: self.lane(leaf.c1, 1),
                    c1: mixed(3, 0, 1),
                },
                Linear {
                    c0: self.lane(leaf.c1, 2),
                    c1: mixed(4, 0, 2),
                },
            ],
            square: [along[1], along[2]],
            mixed: mixed(5, 1, 2),
        }
    }
}

/// Moves the middle rays to x = `at[0]` + `turn[0]`·t, y = `at[1]` + `turn[1]`·t, which is where the new x and y are 0.
#[derive(Clone, Copy)]
pub(crate) struct Shift<P: Packet> {
    pub p: P,
    pub at: [P::F; 2],
    pub turn: [P::F; 2],
}

impl<P: Packet> Rebind for Shift<P> {
    type From = OverBeams<P>;
    type To = OverBeams<P>;
    #[inline(always)]
    fn lanes(&self) -> P {
        self.p
    }
    #[inline(always)]
    fn linear(&self, leaf: &LinearOver<P>) -> LinearOver<P> {
        operation!(
            <P: Packet> self.p, (by: Shift<P> = self, leaf: LinearOver<P> = leaf) -> LinearOver<P>
            = p => by.of_linear(p, &leaf)
        )
    }
    #[inline(always)]
    fn quadratic(&self, leaf: &QuadraticOver<P>) -> QuadraticOver<P> {
        operation!(
            <P: Packet> self.p, (by: Shift<P> = self, leaf: QuadraticOver<P> = leaf) -> QuadraticOver<P>
            = p => by.of_quadratic(p, &leaf)
        )
    }
}

impl<P: Packet> Shift<P> {
    #[inline(always)]
    fn of_linear(&self, p: P, leaf: &LinearOver<P>) -> LinearOver<P> {
        let mut middle = leaf.middle;
        for k in 0..2 {
            middle.c0 = plus(p, middle.c0, self.at[k], leaf.side[k]);
            middle.c1 = plus(p, middle.c1, self.turn[k], leaf.side[k]);
        }
        LinearOver {
            middle,
            side: leaf.side,
        }
    }
    /// With x = a + bt + x' and y likewise: the derivatives at the sides are those of the form at the new middle; along it
    /// c + ½(a(g + g') …), because the form is quadratic: the mean of the old and the new derivative is the slope between.
    #[inline(always)]
    fn of_quadratic(&self, p: P, leaf: &QuadraticOver<P>) -> QuadraticOver<P> {
        let half = p.splat(0.5);
        let mut side = leaf.side;
        for (k, slope) in side.iter_mut().enumerate() {
            let twice = doubled(p, leaf.square[k]);
            let other = 1 - k;
            slope.c0 = plus(p, slope.c0, self.at[k], twice);
            slope.c0 = plus(p, slope.c0, self.at[other], leaf.mixed);
            slope.c1 = plus(p, slope.c1, self.turn[k], twice);
            slope.c1 = plus(p, slope.c1, self.turn[other], leaf.mixed);
        }
        let (mut c0, mut c1, mut c2) = (leaf.middle.c0, leaf.middle.c1, leaf.middle.c2);
        for (k, (old, new)) in leaf.side.iter().zip(&side).enumerate() {
            // The mean slope towards the side is g₀ + g₁t with these coefficients; times a + bt it is the change.
            let g0 = times(p, half, p.add(old.c0, new.c0));
            let g1 = times(p, half, p.add(old.c1, new.c1));
            c0 = plus(p, c0, self.at[k], g0);
            c1 = plus(p, plus(p, c1, self.turn[k], g0), self.at[k], g1);
            c2 = plus(p, c2, self.turn[k], g1);
        }
        QuadraticOver {
            middle: Quadratic::new(p, c0, c1, c2),
            side,
            square: leaf.square,
            mixed: leaf.mixed,
        }
    }
}
