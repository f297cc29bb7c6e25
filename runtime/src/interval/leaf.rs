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
    /// An enclosure of the lower quadratic's vertex −c₁/2c₂, if it has a minimum; else not used.
    pub bottom: Interval<P::F>,
    /// An enclosure of the upper quadratic's vertex, if it has a maximum; else not used.
    pub top: Interval<P::F>,
}

/// Where leaves are evaluated: over a segment ([`Interval`] with `lo ≥ 0`) or at a point ([`At`]), t ≥ 0 in both.
pub trait Parameter<A: Arithmetic>: Copy {
    /// c₀ + c₁t
    fn linear(self, a: A, leaf: &Linear<A::Packet>) -> A::Value;
    /// c₁
    fn linear_slope(self, a: A, leaf: &Linear<A::Packet>) -> A::Value;
    /// c₀ + c₁t + c₂t²
    fn quadratic(self, a: A, leaf: &Quadratic<A::Packet>) -> A::Value;
    /// c₁ + 2c₂t
    fn quadratic_slope(self, a: A, leaf: &Quadratic<A::Packet>) -> A::Value;
    /// 2c₂
    fn quadratic_curvature(self, a: A, leaf: &Quadratic<A::Packet>) -> A::Value;
    /// A polynomial of higher degree and its first K − 1 derivatives, over a segment; nothing for other parameters, for which
    /// a formula is evaluated as it is written.
    #[inline(always)]
    fn polynomial<const N: usize, const K: usize>(
        self,
        _a: A,
        _of: &Polynomial<A::Packet, N>,
    ) -> Option<[A::Value; K]> {
        None
    }
}

/// A single t ≥ 0 per lane.
#[derive(Clone, Copy)]
pub struct At<F>(pub F);
