//! Where leaves are evaluated over beams: a piece of a beam, and a direction for derivatives.

use super::{LinearOver, OverBeams, QuadraticOver};
use crate::interval::{Interval, Packet, Parameter, doubled, operation};

/// A piece of a beam: t in an interval, |x| and |y| at most the two numbers.
#[derive(Clone, Copy)]
pub struct Slab<F> {
    /// Along the middle ray; `lo ≥ 0`.
    pub t: Interval<F>,
    /// The greatest |x| and |y|.
    pub half: [F; 2],
}

impl<F: Copy> Slab<F> {
    /// The mean value form: f on the middle ray, ± |x|·|f_x| ± |y|·|f_y| with the derivatives over the slab.
    #[inline(always)]
    pub(crate) fn mean<P: Packet<F = F>>(
        &self,
        p: P,
        middle: &Interval<F>,
        by: &[Interval<F>; 2],
    ) -> Interval<F> {
        let x = p.radius(self.half[0], p.magnitude(by[0]), p.splat(0.0));
        let around = p.radius(self.half[1], p.magnitude(by[1]), x);
        Interval {
            lo: p.sub_rd(middle.lo, around),
            hi: p.add_ru(middle.hi, around),
        }
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

/// Ranges of leaves, each an operation of its own: a formula has many leaves.
macro_rules! ranges {
    ($over:ty: $($name:ident($leaf:ident) = $range:ident $(of $part:ident)?;)*) => {$(
        #[inline(always)]
        fn $name(self, p: P, leaf: &$leaf<P>) -> Interval<P::F> {
            operation!(
                <P: Packet> p, (leaf: $leaf<P> = leaf, at: $over = &self) -> Interval<P::F>
                = p => leaf.$range(p, &at$(.$part)?)
            )
        }
    )*};
}

impl<P: Packet> Parameter<P> for Slab<P::F> {
    type Leaves = OverBeams<P>;
    #[inline(always)]
    fn rough(self) -> bool {
        true
    }
    #[inline(always)]
    fn linear_slope(self, _p: P, leaf: &LinearOver<P>) -> Interval<P::F> {
        leaf.middle.c1
    }
    #[inline(always)]
    fn quadratic_curvature(self, p: P, leaf: &QuadraticOver<P>) -> Interval<P::F> {
        doubled(p, leaf.middle.c2)
    }
    ranges! {
        Slab<P::F>:
        linear(LinearOver) = range;
        quadratic(QuadraticOver) = range;
        quadratic_slope(QuadraticOver) = by_t;
    }
}

impl<P: Packet> Parameter<P> for Towards<P::F> {
    type Leaves = OverBeams<P>;
    /// What is to be known in any direction is which rows matter.
    #[inline(always)]
    fn rough(self) -> bool {
        self.direction != Direction::Any
    }
    ranges! {
        Towards<P::F>:
        linear(LinearOver) = range of over;
        linear_slope(LinearOver) = slope;
        quadratic(QuadraticOver) = range of over;
        quadratic_slope(QuadraticOver) = slope;
        quadratic_curvature(QuadraticOver) = curvature;
    }
}
