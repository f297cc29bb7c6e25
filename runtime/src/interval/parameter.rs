//! Ranges of linear and quadratic leaves.
//!
//! All of it rests on t ≥ 0: the smallest of all c₀ + c₁t + c₂t² with coefficients in intervals is then the one with the
//! three lower bounds, at every t. So the lower bound of the range is the minimum of one ordinary quadratic, and the
//! upper bound the maximum of another. Horner's scheme with fused operations rounds twice, each time downwards (upwards):
//! c₂t + c₁ rounded down is multiplied by t ≥ 0, which keeps the order.

use super::horner;
use super::lanes::operation;
use super::{Arithmetic, At, Interval, Linear, Nearest, Packet, Parameter, Polynomial, Quadratic};

impl<P: Packet> Linear<P> {
    /// c₀ + c₁t.
    #[inline(always)]
    pub fn new(_p: P, c0: Interval<P::F>, c1: Interval<P::F>) -> Self {
        Linear { c0, c1 }
    }

    /// The leaf 0: room in arrays, to be written by the ray stage.
    #[inline(always)]
    pub fn zero(p: P) -> Self {
        let zero = p.point(p.splat(0.0));
        Linear { c0: zero, c1: zero }
    }
}

impl<P: Packet> Quadratic<P> {
    /// c₀ + c₁t + c₂t², with the extreme value c₀ − c₁²/4c₂ of the bounding quadratic that has one, rounded outward.
    #[inline(always)]
    pub fn new(p: P, c0: Interval<P::F>, c1: Interval<P::F>, c2: Interval<P::F>) -> Self {
        operation!(
            <P: Packet> p, (c: [Interval<P::F>; 3] = &[c0, c1, c2]) -> Quadratic<P> = p => with_vertex(p, c)
        )
    }

    /// The leaf 0: room in arrays, to be written by the ray stage.
    #[inline(always)]
    pub fn zero(p: P) -> Self {
        let zero = p.point(p.splat(0.0));
        Quadratic {
            c0: zero,
            c1: zero,
            c2: zero,
            low: p.splat(f64::INFINITY),
            high: p.splat(f64::NEG_INFINITY),
            vertex: zero,
        }
    }
}

/// Upwards (c₂ > 0) the lower quadratic has a minimum, downwards the upper one a maximum, which is the negated minimum of
/// the negated one, at the same t. Never both: the other one bends the same way.
#[inline(always)]
fn with_vertex<P: Packet>(p: P, [c0, c1, c2]: [Interval<P::F>; 3]) -> Quadratic<P> {
    let zero = p.splat(0.0);
    let (up, down) = (p.lt(zero, c2.lo), p.lt(c2.hi, zero));
    let of = |c: Interval<P::F>| p.select(down, p.neg_f(c.hi), c.lo);
    let (c, n, bend) = (of(c0), p.neg_f(of(c1)), of(c2));
    let m = p.abs_f(n);
    let square = p.mul_nonneg_ru(m, m);
    // Rounded down 4c₂ is 0 at worst, which makes the drop infinite, or 0/0 where c₁ = 0: then the minimum is c₀.
    let four = p.max_f(p.mul_rd(p.splat(4.0), bend), zero);
    let low = p.sub_rd(c, p.div_ru(square, four));
    let low = p.select(p.eq(n, zero), c, low);
    // c₂ > 0, so the quotient keeps the order of the numerators.
    let half = p.splat(0.5);
    let vertex = Interval {
        lo: p.div_rd(p.mul_rd(half, n), bend),
        hi: p.div_ru(p.mul_ru(half, n), bend),
    };
    Quadratic {
        c0,
        c1,
        c2,
        low: p.select(up, low, p.splat(f64::INFINITY)),
        high: p.select(down, p.neg_f(low), p.splat(f64::NEG_INFINITY)),
        vertex,
    }
}

/// The bounds of c₀ + c₁t at one t.
#[inline(always)]
fn line_at<P: Packet>(p: P, c0: &Interval<P::F>, c1: &Interval<P::F>, t: &P::F) -> Interval<P::F> {
    operation!(
        <P: Packet> p, (c0: Interval<P::F> = c0, c1: Interval<P::F> = c1, t: P::F = t) -> Interval<P::F>
        = p => Interval {
            lo: horner::line_rd(p, c0.lo, c1.lo, t),
            hi: horner::line_ru(p, c0.hi, c1.hi, t),
        }
    )
}

/// 2a, exactly, where it is a double: where it overflows, the bound that is nearer to 0 is the largest one.
#[inline(always)]
pub(crate) fn doubled<P: Packet>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    operation!(<P: Packet> p, (a: Interval<P::F> = &a) -> Interval<P::F> = p => Interval {
        lo: p.min_f(p.add_rn(a.lo, a.lo), p.splat(f64::MAX)),
        hi: p.max_f(p.add_rn(a.hi, a.hi), p.splat(f64::MIN)),
    })
}

/// Where the vertex is certainly not inside the segment. A NaN is nowhere.
#[inline(always)]
fn outside<P: Packet>(p: P, vertex: Interval<P::F>, t: Interval<P::F>) -> P::M {
    p.or(p.le(vertex.hi, t.lo), p.le(t.hi, vertex.lo))
}

/// c₀ + c₁t over a segment: each bound lies at the end that its slope's sign tells.
#[inline(always)]
fn linear_range<P: Packet>(
    p: P,
    c0: &Interval<P::F>,
    c1: &Interval<P::F>,
    t: &Interval<P::F>,
) -> Interval<P::F> {
    operation!(
        <P: Packet> p, (c0: Interval<P::F> = c0, c1: Interval<P::F> = c1, t: Interval<P::F> = t) -> Interval<P::F>
        = p => linear_bounds(p, c0, c1, t)
    )
}

#[inline(always)]
fn linear_bounds<P: Packet>(
    p: P,
    c0: Interval<P::F>,
    c1: Interval<P::F>,
    t: Interval<P::F>,
) -> Interval<P::F> {
    let zero = p.splat(0.0);
    let at_lo = p.select(p.lt(c1.lo, zero), t.hi, t.lo);
    let at_hi = p.select(p.lt(c1.hi, zero), t.lo, t.hi);
    Interval {
        lo: horner::line_rd(p, c0.lo, c1.lo, at_lo),
        hi: horner::line_ru(p, c0.hi, c1.hi, at_hi),
    }
}

/// c₀ + c₁t + c₂t² over a segment.
#[inline(always)]
fn quadratic_range<P: Packet>(p: P, leaf: &Quadratic<P>, t: Interval<P::F>) -> Interval<P::F> {
    let (lower, upper) = (
        [leaf.c0.lo, leaf.c1.lo, leaf.c2.lo],
        [leaf.c0.hi, leaf.c1.hi, leaf.c2.hi],
    );
    // If the vertex may be inside, the extreme value over all t counts, which is always a bound.
    let outside = outside(p, leaf.vertex, t);
    let low = p.select(outside, p.splat(f64::INFINITY), leaf.low);
    let high = p.select(outside, p.splat(f64::NEG_INFINITY), leaf.high);
    Interval {
        lo: p.min_f(low, horner::least(p, lower, t.lo, t.hi)),
        hi: p.max_f(high, horner::most(p, upper, t.lo, t.hi)),
    }
}

/// Over a segment 0 ≤ lo ≤ hi < ∞.
impl<P: Packet> Parameter<P> for Interval<P::F> {
    type Leaves = P;
    #[inline(always)]
    fn linear(self, p: P, leaf: &Linear<P>) -> Interval<P::F> {
        linear_range(p, &leaf.c0, &leaf.c1, &self)
    }
    #[inline(always)]
    fn linear_slope(self, _p: P, leaf: &Linear<P>) -> Interval<P::F> {
        leaf.c1
    }
    #[inline(always)]
    fn quadratic(self, p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
        operation!(
            <P: Packet> p, (leaf: Quadratic<P> = leaf, t: Interval<P::F> = &self) -> Interval<P::F>
            = p => quadratic_range(p, &leaf, t)
        )
    }
    #[inline(always)]
    fn quadratic_slope(self, p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
        linear_range(p, &leaf.c1, &doubled(p, leaf.c2), &self)
    }
    #[inline(always)]
    fn quadratic_curvature(self, p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
        doubled(p, leaf.c2)
    }
    #[inline(always)]
    fn polynomial<const N: usize, const K: usize>(
        self,
        p: P,
        of: &Polynomial<P, N>,
    ) -> Option<[Interval<P::F>; K]> {
        of.telling(p, &self)
    }
}

/// At one t ≥ 0, which is exact: the enclosures are of the value there.
impl<P: Packet> Parameter<P> for At<P::F> {
    type Leaves = P;
    #[inline(always)]
    fn linear(self, p: P, leaf: &Linear<P>) -> Interval<P::F> {
        line_at(p, &leaf.c0, &leaf.c1, &self.0)
    }
    #[inline(always)]
    fn linear_slope(self, _p: P, leaf: &Linear<P>) -> Interval<P::F> {
        leaf.c1
    }
    #[inline(always)]
    fn quadratic(self, p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
        operation!(
            <P: Packet> p, (leaf: Quadratic<P> = leaf, t: P::F = &self.0) -> Interval<P::F>
            = p => Interval {
                lo: horner::least(p, [leaf.c0.lo, leaf.c1.lo, leaf.c2.lo], t, t),
                hi: horner::most(p, [leaf.c0.hi, leaf.c1.hi, leaf.c2.hi], t, t),
            }
        )
    }
    #[inline(always)]
    fn quadratic_slope(self, p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
        line_at(p, &leaf.c1, &doubled(p, leaf.c2), &self.0)
    }
    #[inline(always)]
    fn quadratic_curvature(self, p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
        doubled(p, leaf.c2)
    }
}

/// At one t, approximately: coefficients are taken at their lower bounds, which are a rounding away from any other.
impl<P: Packet> Parameter<Nearest<P>> for At<P::F> {
    type Leaves = P;
    #[inline(always)]
    fn linear(self, a: Nearest<P>, leaf: &Linear<P>) -> P::F {
        near_line(a.0, &leaf.c0.lo, &leaf.c1.lo, &self.0)
    }
    #[inline(always)]
    fn linear_slope(self, _a: Nearest<P>, leaf: &Linear<P>) -> P::F {
        leaf.c1.lo
    }
    #[inline(always)]
    fn quadratic(self, a: Nearest<P>, leaf: &Quadratic<P>) -> P::F {
        let slope = near_line(a.0, &leaf.c1.lo, &leaf.c2.lo, &self.0);
        near_line(a.0, &leaf.c0.lo, &slope, &self.0)
    }
    #[inline(always)]
    fn quadratic_slope(self, a: Nearest<P>, leaf: &Quadratic<P>) -> P::F {
        near_line(a.0, &leaf.c1.lo, &a.add(leaf.c2.lo, leaf.c2.lo), &self.0)
    }
    #[inline(always)]
    fn quadratic_curvature(self, a: Nearest<P>, leaf: &Quadratic<P>) -> P::F {
        a.add(leaf.c2.lo, leaf.c2.lo)
    }
}

/// c₀ + c₁t, approximately.
#[inline(always)]
fn near_line<P: Packet>(p: P, c0: &P::F, c1: &P::F, t: &P::F) -> P::F {
    operation!(<P: Packet> p, (c0: P::F = c0, c1: P::F = c1, t: P::F = t) -> P::F = p => p.fma_rn(c1, t, c0))
}
