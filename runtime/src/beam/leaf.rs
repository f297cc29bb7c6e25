//! Leaves over beams: polynomials of degree ≤ 2 in t, x and y.

use core::marker::PhantomData;

use crate::interval::{Interval, Leaves, Linear, Packet, Parameter, Quadratic, Rebind};

/// Leaves over the beams of one packet.
#[derive(Clone, Copy)]
pub struct OverBeams<P>(PhantomData<P>);

/// c + c_t t + c_x x + c_y y.
#[derive(Clone, Copy)]
pub struct LinearOver<P: Packet> {
    /// Along the middle ray, where x = y = 0.
    pub middle: Linear<P>,
    /// The derivatives by x and y.
    pub side: [Interval<P::F>; 2],
}

/// A quadratic polynomial in t, x and y.
#[derive(Clone, Copy)]
pub struct QuadraticOver<P: Packet> {
    /// Along the middle ray, where x = y = 0.
    pub middle: Quadratic<P>,
    /// The derivatives by x and y on the middle ray: they are linear in t.
    pub side: [Linear<P>; 2],
    /// The coefficients of x² and y².
    pub square: [Interval<P::F>; 2],
    /// The coefficient of xy.
    pub mixed: Interval<P::F>,
}

impl<P: Packet> Leaves for OverBeams<P> {
    type Packet = P;
    type Linear = LinearOver<P>;
    type Quadratic = QuadraticOver<P>;
    // Beams evaluate formulas as they are written.
    type Polynomial<const N: usize> = ();
    #[inline(always)]
    fn linear(p: P) -> LinearOver<P> {
        let middle = Linear::zero(p);
        LinearOver {
            middle,
            side: [middle.c0; 2],
        }
    }
    #[inline(always)]
    fn polynomial<const N: usize>(_p: P) {}
    #[inline(always)]
    fn quadratic(p: P) -> QuadraticOver<P> {
        let side = Linear::zero(p);
        QuadraticOver {
            middle: Quadratic::zero(p),
            side: [side; 2],
            square: [side.c0; 2],
            mixed: side.c0,
        }
    }
}

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

#[inline(always)]
fn doubled<P: Packet>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    p.add(a, a)
}

/// The leaves of a whole picture, from those along six lines through the frame's origin, in the lanes 0 to 5: in the
/// directions T (forward), R (right), U (up), T + R, T + U and R + U.
///
/// Along a line in direction d a quadratic form q has the coefficients q(o), ∇q(o)·d and dᵀQd, and
/// 2dᵀQe = (d+e)ᵀQ(d+e) − dᵀQd − eᵀQe gives the mixed ones.
pub(crate) struct Assemble<P>(pub P);

impl<P: Packet> Assemble<P> {
    #[inline(always)]
    fn lane(&self, a: Interval<P::F>, lane: usize) -> Interval<P::F> {
        let p = self.0;
        Interval {
            lo: p.splat(p.to_array(a.lo)[lane]),
            hi: p.splat(p.to_array(a.hi)[lane]),
        }
    }
}

impl<P: Packet> Rebind for Assemble<P> {
    type From = P;
    type To = OverBeams<P>;
    #[inline(always)]
    fn lanes(&self) -> P {
        self.0
    }
    #[inline(always)]
    fn linear(&self, leaf: &Linear<P>) -> LinearOver<P> {
        LinearOver {
            middle: Linear {
                c0: self.lane(leaf.c0, 0),
                c1: self.lane(leaf.c1, 0),
            },
            side: [self.lane(leaf.c1, 1), self.lane(leaf.c1, 2)],
        }
    }
    #[inline(always)]
    fn quadratic(&self, leaf: &Quadratic<P>) -> QuadraticOver<P> {
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
        let p = self.p;
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
    fn quadratic(&self, leaf: &QuadraticOver<P>) -> QuadraticOver<P> {
        let p = self.p;
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

/// A piece of a beam: t in an interval, |x| and |y| at most the two numbers.
#[derive(Clone, Copy)]
pub struct Slab<F> {
    /// Along the middle ray; `lo ≥ 0`.
    pub t: Interval<F>,
    /// The greatest |x| and |y|.
    pub half: [F; 2],
}

/// [−r, r], added.
#[inline(always)]
fn widen<P: Packet>(p: P, a: Interval<P::F>, r: P::F) -> Interval<P::F> {
    Interval {
        lo: p.sub_rd(a.lo, r),
        hi: p.add_ru(a.hi, r),
    }
}

impl<P: Packet> QuadraticOver<P> {
    /// The derivative by t at fixed x and y.
    #[inline(always)]
    fn by_t(&self, p: P, over: &Slab<P::F>) -> Interval<P::F> {
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
}

/// Ranges. Over a slab a form is its value on the middle ray, whose range is exact, and x·g_x(t) + y·g_y(t) + the squares
/// and the product of x and y.
impl<P: Packet> Parameter<P> for Slab<P::F> {
    type Leaves = OverBeams<P>;
    #[inline(always)]
    fn rough(self) -> bool {
        true
    }
    #[inline(always)]
    fn linear(self, p: P, leaf: &LinearOver<P>) -> Interval<P::F> {
        let x = p.mul_nonneg_ru(self.half[0], p.magnitude(leaf.side[0]));
        let y = p.mul_nonneg_ru(self.half[1], p.magnitude(leaf.side[1]));
        widen(p, self.t.linear(p, &leaf.middle), p.add_ru(x, y))
    }
    #[inline(always)]
    fn linear_slope(self, _p: P, leaf: &LinearOver<P>) -> Interval<P::F> {
        leaf.middle.c1
    }
    #[inline(always)]
    fn quadratic(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        let zero = p.splat(0.0);
        let middle = self.t.quadratic(p, &leaf.middle);
        let [x, y] = self.half;
        let mut around = p.mul_nonneg_ru(p.mul_nonneg_ru(x, y), p.magnitude(leaf.mixed));
        let (mut lo, mut hi) = (middle.lo, middle.hi);
        for (k, h) in [x, y].into_iter().enumerate() {
            let slope = p.magnitude(self.t.linear(p, &leaf.side[k]));
            around = p.add_ru(around, p.mul_nonneg_ru(h, slope));
            let square = p.mul_nonneg_ru(h, h);
            let bend = leaf.square[k];
            let below = p.max_f(p.neg_f(bend.lo), zero);
            lo = p.sub_rd(lo, p.mul_nonneg_ru(square, below));
            hi = p.add_ru(hi, p.mul_nonneg_ru(square, p.max_f(bend.hi, zero)));
        }
        widen(p, Interval { lo, hi }, around)
    }
    #[inline(always)]
    fn quadratic_slope(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        leaf.by_t(p, &self)
    }
    #[inline(always)]
    fn quadratic_curvature(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        doubled(p, leaf.middle.c2)
    }
}

/// The direction in which a derivative is taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// Along the rays of the beam.
    Along,
    /// By x.
    Right,
    /// By y.
    Up,
    /// In each of these: what is enclosed holds all three.
    Any,
}

/// A slab, and the derivative in a direction.
#[derive(Clone, Copy)]
pub struct Towards<F> {
    /// Where.
    pub over: Slab<F>,
    /// In which direction.
    pub direction: Direction,
    /// Along a ray of the beam, t grows at a rate within this of 1, …
    pub tilt: F,
    /// … and |x| and |y| at most at these rates.
    pub turn: [F; 2],
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

impl<P: Packet> Parameter<P> for Towards<P::F> {
    type Leaves = OverBeams<P>;
    /// What is to be known in any direction is which rows matter.
    #[inline(always)]
    fn rough(self) -> bool {
        self.direction != Direction::Any
    }
    #[inline(always)]
    fn linear(self, p: P, leaf: &LinearOver<P>) -> Interval<P::F> {
        self.over.linear(p, leaf)
    }
    #[inline(always)]
    fn linear_slope(self, p: P, leaf: &LinearOver<P>) -> Interval<P::F> {
        match self.direction {
            Direction::Along => self.along(p, leaf.middle.c1, leaf.side[0], leaf.side[1]),
            Direction::Right => leaf.side[0],
            Direction::Up => leaf.side[1],
            Direction::Any => {
                let along = self.along(p, leaf.middle.c1, leaf.side[0], leaf.side[1]);
                p.hull(along, p.hull(leaf.side[0], leaf.side[1]))
            }
        }
    }
    #[inline(always)]
    fn quadratic(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        self.over.quadratic(p, leaf)
    }
    #[inline(always)]
    fn quadratic_slope(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        let over = &self.over;
        match self.direction {
            Direction::Right => leaf.by_side(p, over, 0),
            Direction::Up => leaf.by_side(p, over, 1),
            Direction::Along | Direction::Any => {
                let side = [leaf.by_side(p, over, 0), leaf.by_side(p, over, 1)];
                let along = self.along(p, leaf.by_t(p, over), side[0], side[1]);
                match self.direction {
                    Direction::Any => p.hull(along, p.hull(side[0], side[1])),
                    _ => along,
                }
            }
        }
    }
    /// The second derivative in the direction.
    #[inline(always)]
    fn quadratic_curvature(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        let (right, up) = (doubled(p, leaf.square[0]), doubled(p, leaf.square[1]));
        match self.direction {
            Direction::Right => right,
            Direction::Up => up,
            Direction::Along => self.bend(p, leaf),
            Direction::Any => p.hull(self.bend(p, leaf), p.hull(right, up)),
        }
    }
}

impl<F: Copy> Towards<F> {
    /// The second derivative along a ray, where x(t) = x₀ + at, |a| ≤ `turn`: wᵀHw with w = (1 ± tilt, ± turn, ± turn).
    #[inline(always)]
    fn bend<P: Packet<F = F>>(&self, p: P, leaf: &QuadraticOver<P>) -> Interval<F> {
        let [a, b] = self.turn;
        let one = p.splat(1.0);
        let rate = Interval {
            lo: p.sub_rd(one, self.tilt),
            hi: p.add_ru(one, self.tilt),
        };
        let side = |r: F| Interval {
            lo: p.neg_f(r),
            hi: r,
        };
        let (x, y) = (side(a), side(b));
        let mixed = p.add(p.mul(x, leaf.side[0].c1), p.mul(y, leaf.side[1].c1));
        let squares = p.add(
            p.mul(p.sqr(x), leaf.square[0]),
            p.mul(p.sqr(y), leaf.square[1]),
        );
        let rest = p.add(squares, p.mul(p.mul(x, y), leaf.mixed));
        let t = p.mul(p.sqr(rate), leaf.middle.c2);
        doubled(p, p.add(p.add(t, p.mul(rate, mixed)), rest))
    }
}
