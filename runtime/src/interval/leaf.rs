//! Linear and quadratic leaves: subexpressions of degree ≤ 2 along a ray, reduced to their coefficients once per ray.

use super::{Arithmetic, Interval, Packet, Polynomial};

/// c₀ + c₁t, for t ≥ 0.
#[derive(Clone, Copy)]
pub struct Linear<P: Packet> {
    /// The value at t = 0.
    pub c0: Interval<P::F>,
    /// The slope.
    pub c1: Interval<P::F>,
}

/// c₀ + c₁t + c₂t², for t ≥ 0.
///
/// Because t ≥ 0, the lower bound of all quadratics with these coefficients is one quadratic, that of the lower bounds,
/// and likewise above: the range over a segment is exact up to rounding.
#[derive(Clone, Copy)]
pub struct Quadratic<P: Packet> {
    /// The value at t = 0.
    pub c0: Interval<P::F>,
    /// The slope at t = 0.
    pub c1: Interval<P::F>,
    /// Half the curvature.
    pub c2: Interval<P::F>,
    /// A lower bound of the lower quadratic over all t; +∞ if it has no minimum (then the ends decide).
    pub low: P::F,
    /// An upper bound of the upper quadratic over all t; −∞ if it has no maximum.
    pub high: P::F,
    /// An enclosure of the vertex −c₁/2c₂ of the one of both that has its extreme value there; else not used.
    pub vertex: Interval<P::F>,
}

/// A kind of leaves: along rays (any [`Packet`] stands for its own), or over [beams](crate::beam).
pub trait Leaves: Copy + 'static {
    /// Whose lanes the leaves fill.
    type Packet: Packet;
    /// A subexpression of degree 1.
    type Linear: Copy + Send + Sync;
    /// A subexpression of degree 2.
    type Quadratic: Copy + Send + Sync;
    /// The N coefficients of a polynomial of higher degree; nothing where they are of no use.
    type Polynomial<const N: usize>: Copy + Send + Sync;
    /// The leaf 0: room in arrays.
    fn linear(p: Self::Packet) -> Self::Linear;
    /// The leaf 0: room in arrays.
    fn quadratic(p: Self::Packet) -> Self::Quadratic;
    /// The polynomial 0: room in tuples.
    fn polynomial<const N: usize>(p: Self::Packet) -> Self::Polynomial<N>;
}

impl<P: Packet> Leaves for P {
    type Packet = P;
    type Linear = Linear<P>;
    type Quadratic = Quadratic<P>;
    type Polynomial<const N: usize> = Polynomial<P, N>;
    #[inline(always)]
    fn linear(p: P) -> Linear<P> {
        Linear::zero(p)
    }
    #[inline(always)]
    fn quadratic(p: P) -> Quadratic<P> {
        Quadratic::zero(p)
    }
    #[inline(always)]
    fn polynomial<const N: usize>(p: P) -> Polynomial<P, N> {
        Polynomial::zero(p)
    }
}

/// A map from leaves to leaves, such as from a beam's to those of the beams inside it.
pub trait Rebind {
    /// What there is.
    type From: Leaves;
    /// What is made of it.
    type To: Leaves;
    /// The lanes that are filled.
    fn lanes(&self) -> <Self::To as Leaves>::Packet;
    /// For a leaf of degree 1.
    fn linear(&self, leaf: &<Self::From as Leaves>::Linear) -> <Self::To as Leaves>::Linear;
    /// For a leaf of degree 2.
    fn quadratic(
        &self,
        leaf: &<Self::From as Leaves>::Quadratic,
    ) -> <Self::To as Leaves>::Quadratic;
}

/// Where leaves are evaluated: over a segment of rays ([`Interval`] with `lo ≥ 0`) or at a point of them ([`At`], t ≥ 0),
/// or over a piece of a [beam](crate::beam). The derivative is by t, or in the direction that the parameter names.
pub trait Parameter<A: Arithmetic>: Copy {
    /// The leaves that it is a parameter of.
    type Leaves: Leaves<Packet = A::Packet>;
    /// c₀ + c₁t
    fn linear(self, a: A, leaf: &<Self::Leaves as Leaves>::Linear) -> A::Value;
    /// c₁
    fn linear_slope(self, a: A, leaf: &<Self::Leaves as Leaves>::Linear) -> A::Value;
    /// c₀ + c₁t + c₂t²
    fn quadratic(self, a: A, leaf: &<Self::Leaves as Leaves>::Quadratic) -> A::Value;
    /// c₁ + 2c₂t
    fn quadratic_slope(self, a: A, leaf: &<Self::Leaves as Leaves>::Quadratic) -> A::Value;
    /// 2c₂
    fn quadratic_curvature(self, a: A, leaf: &<Self::Leaves as Leaves>::Quadratic) -> A::Value;
    /// Does a rough look suffice, which leaves out rows that hardly matter?
    #[inline(always)]
    fn rough(self) -> bool {
        false
    }
    /// A polynomial of higher degree and its first K − 1 derivatives, over a segment of rays; nothing where a formula is
    /// better evaluated as it is written, and for other parameters.
    #[inline(always)]
    fn polynomial<const N: usize, const K: usize>(
        self,
        _a: A,
        _of: &<Self::Leaves as Leaves>::Polynomial<N>,
    ) -> Option<[A::Value; K]> {
        None
    }
}

/// A single t ≥ 0 per lane.
#[derive(Clone, Copy)]
pub struct At<F>(pub F);
