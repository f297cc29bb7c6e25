//! What contractors need of intervals beyond arithmetic.

use super::enclose::Enclose;
use super::lanes::operation;
use super::{Arithmetic, Interval, Lanes};

/// Interval operations on the lanes of one instruction set: what enclosures and contractors are written in.
///
/// Every back-end is one; the operations of formulas are those of [`Arithmetic`].
pub trait Packet:
    Enclose + Arithmetic<Packet = Self, Value = Interval<<Self as Lanes>::F>>
{
    /// [lo, hi] in each lane. The caller sees to the invariants of [`Interval`].
    #[inline(always)]
    fn interval(self, lo: Self::F, hi: Self::F) -> Interval<Self::F> {
        Interval { lo, hi }
    }

    /// [x, x] in each lane; x is finite.
    #[inline(always)]
    fn point(self, x: Self::F) -> Interval<Self::F> {
        Interval { lo: x, hi: x }
    }

    /// s·x for an exact number of the surface stage: one product for each bound. x is bounded.
    #[inline(always)]
    fn times(self, s: &Interval, x: Interval<Self::F>) -> Interval<Self::F> {
        times(self, &s.lo, &x)
    }

    /// The real line.
    #[inline(always)]
    fn entire(self) -> Interval<Self::F> {
        Interval {
            lo: self.splat(f64::NEG_INFINITY),
            hi: self.splat(f64::INFINITY),
        }
    }

    /// Lane-wise `mask ? yes : no`.
    #[inline(always)]
    fn select_interval(
        self,
        mask: Self::M,
        yes: Interval<Self::F>,
        no: Interval<Self::F>,
    ) -> Interval<Self::F> {
        Interval {
            lo: self.select(mask, yes.lo, no.lo),
            hi: self.select(mask, yes.hi, no.hi),
        }
    }

    /// The smallest interval that holds both.
    #[inline(always)]
    fn hull(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Interval<Self::F> {
        Interval {
            lo: self.min_f(a.lo, b.lo),
            hi: self.max_f(a.hi, b.hi),
        }
    }

    /// What both hold, and the lanes where that is nothing; there the interval is not to be used.
    #[inline(always)]
    fn intersect(self, a: Interval<Self::F>, b: Interval<Self::F>) -> (Interval<Self::F>, Self::M) {
        let lo = self.max_f(a.lo, b.lo);
        let hi = self.min_f(a.hi, b.hi);
        (Interval { lo, hi }, self.lt(hi, lo))
    }

    /// Where 0 ∈ a.
    #[inline(always)]
    fn has_zero(self, a: Interval<Self::F>) -> Self::M {
        let zero = self.splat(0.0);
        self.and(self.le(a.lo, zero), self.le(zero, a.hi))
    }

    /// Where lo < 0 < hi.
    #[inline(always)]
    fn straddles_zero(self, a: Interval<Self::F>) -> Self::M {
        let zero = self.splat(0.0);
        self.and(self.lt(a.lo, zero), self.lt(zero, a.hi))
    }

    /// Where a ⊆ b.
    #[inline(always)]
    fn is_subset(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Self::M {
        self.and(self.le(b.lo, a.lo), self.le(a.hi, b.hi))
    }

    /// Where a lies in the interior of b (an infinite bound is interior to an infinite one).
    #[inline(always)]
    fn is_interior(self, a: Interval<Self::F>, b: Interval<Self::F>) -> Self::M {
        let lower = self.or(
            self.lt(b.lo, a.lo),
            self.eq(b.lo, self.splat(f64::NEG_INFINITY)),
        );
        let upper = self.or(
            self.lt(a.hi, b.hi),
            self.eq(b.hi, self.splat(f64::INFINITY)),
        );
        self.and(lower, upper)
    }

    /// A number near the middle, inside a; for finite bounds.
    #[inline(always)]
    fn mid(self, a: Interval<Self::F>) -> Self::F {
        let half = self.splat(0.5);
        let m = self.add_rn(self.mul_rn(half, a.lo), self.mul_rn(half, a.hi));
        self.max_f(self.min_f(m, a.hi), a.lo)
    }

    /// hi − lo, rounded up.
    #[inline(always)]
    fn width(self, a: Interval<Self::F>) -> Self::F {
        self.sub_ru(a.hi, a.lo)
    }

    /// The greatest |x| in a.
    #[inline(always)]
    fn magnitude(self, a: Interval<Self::F>) -> Self::F {
        self.max_f(self.neg_f(a.lo), a.hi)
    }

    /// entry·d + o, within one or two units in the last place of the *result*, whatever cancels: the new origin of a
    /// ray that starts far away.
    #[inline(always)]
    fn recentre(self, entry: Self::F, d: Self::F, o: Self::F) -> Interval<Self::F> {
        Interval {
            lo: self.fma_rd(entry, d, o),
            hi: self.fma_ru(entry, d, o),
        }
    }

    /// Newton's division: all x with x·d = n for some d ∈ den and n ∈ num.
    ///
    /// Where 0 is inside `den` and not in `num` these are two pieces: (−∞, first.hi] and [second.lo, ∞); where `den`
    /// only touches 0 it is one, unbounded on one side; where 0 is in both it is the line. `two`: both pieces are to be
    /// used. Elsewhere the first is the answer, and `empty` says where there is none (den = [0, 0], 0 ∉ num).
    #[allow(clippy::type_complexity)]
    #[inline(always)]
    fn div_ext(
        self,
        num: Interval<Self::F>,
        den: Interval<Self::F>,
    ) -> (Interval<Self::F>, Interval<Self::F>, Self::M, Self::M) {
        let p = self;
        let zero = p.splat(0.0);
        let (minus, plus) = (p.splat(f64::NEG_INFINITY), p.splat(f64::INFINITY));
        let zero_num = p.has_zero(num);
        let two = p.and_not(p.straddles_zero(den), zero_num);
        let point_zero = p.and(p.eq(den.lo, zero), p.eq(den.hi, zero));
        let empty = p.and_not(point_zero, zero_num);
        let line = p.and(p.has_zero(den), zero_num);

        // One piece: the quotient, which is one-sided where den touches 0 and num does not.
        let quotient = p.i_div(num, den);
        // Two pieces. For num > 0: x ≤ n/den.lo and x ≥ n/den.hi with n = num.lo, the one nearer to 0; for num < 0 with
        // n = num.hi, x ≤ n/den.hi and x ≥ n/den.lo.
        let above = p.lt(zero, num.lo);
        let n = p.select(above, num.lo, num.hi);
        let left = p.div_ru(n, p.select(above, den.lo, den.hi));
        let right = p.div_rd(n, p.select(above, den.hi, den.lo));

        let wide = p.select_interval(line, p.entire(), quotient);
        let first = Interval {
            lo: p.select(two, minus, wide.lo),
            hi: p.select(two, left, wide.hi),
        };
        let second = Interval {
            lo: p.select(two, right, wide.lo),
            hi: p.select(two, plus, wide.hi),
        };
        (first, second, two, empty)
    }
}

impl<P: Enclose> Packet for P {}

#[inline(always)]
fn times<P: Packet>(p: P, s: &f64, x: &Interval<P::F>) -> Interval<P::F> {
    operation!(<P: Packet> p, (s: f64 = s, x: Interval<P::F> = x) -> Interval<P::F> = p => {
        let s = p.splat(s);
        let negative = p.lt(s, p.splat(0.0));
        Interval {
            lo: p.mul_rd(s, p.select(negative, x.hi, x.lo)),
            hi: p.mul_ru(s, p.select(negative, x.lo, x.hi)),
        }
    })
}
