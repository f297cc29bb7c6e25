//! Closed form: the roots of c₀ + c₁t + c₂t² by its discriminant.

use super::select;
use crate::contract::middle;
use crate::interval::{At, Interval, Packet, Parameter, Quadratic};

/// What the discriminant decides.
pub(crate) struct Closed<P: Packet> {
    /// The lanes that are decided; the others need a search.
    pub decided: P::M,
    /// The lanes with two roots, each certainly in its interval, the intervals in ascending order and apart.
    pub two: P::M,
    pub first: Interval<P::F>,
    pub second: Interval<P::F>,
}

/// With D = c₁² − 4c₀c₂:
///
/// - D < 0 for all coefficients in their intervals: no root.
/// - D > 0 and c₂ ≠ 0: two roots. With q = −½(c₁ ± √D), the sign that of c₁, they are q/c₂ and c₀/q: no difference of
///   nearly equal numbers. Where the sign of c₁ is not certain, c₀ and c₂ have opposite signs (D > 0), and (−c₁ ± √D)/2c₂
///   lose nothing either, because |c₁| is small against √D.
/// - else it is left to the search, which proves tangencies.
#[inline(always)]
pub(crate) fn closed_form<P: Packet>(p: P, leaf: &Quadratic<P>, live: P::M) -> Closed<P> {
    let zero = p.splat(0.0);
    let half = p.splat(0.5);
    let four = p.splat(4.0);
    let (a, b, c) = (leaf.c2, leaf.c1, leaf.c0);
    let product = p.mul(a, c);
    let product = Interval {
        lo: p.mul_rd(product.lo, four),
        hi: p.mul_ru(product.hi, four),
    };
    let d = p.sub(p.sqr(b), product);
    let negative = p.lt(d.hi, zero);
    if !p.any(p.and_not(live, negative)) {
        return Closed {
            decided: negative,
            two: p.none(),
            first: d,
            second: d,
        };
    }
    let bent = p.or(p.lt(zero, a.lo), p.lt(a.hi, zero));
    let positive = p.and(p.lt(zero, d.lo), bent);
    let root = Interval {
        lo: p.sqrt_rd(p.max_f(d.lo, zero)),
        hi: p.sqrt_ru(p.max_f(d.hi, zero)),
    };

    // q = −½(c₁ + sign·√D)
    let falls = p.lt(b.hi, zero);
    let certain = p.or(falls, p.lt(zero, b.lo));
    let towards = select(p, falls, &p.neg(root), &root);
    let sum = p.neg(p.add(b, towards));
    let q = Interval {
        lo: p.mul_rd(sum.lo, half),
        hi: p.mul_ru(sum.hi, half),
    };
    let (by_a, _) = p.div(q, a);
    let (by_c, _) = p.div(c, q);
    // (−c₁ ± √D)/2c₂
    let twice = Interval {
        lo: p.mul_rd(a.lo, p.splat(2.0)),
        hi: p.mul_ru(a.hi, p.splat(2.0)),
    };
    let (plus, _) = p.div(p.sub(root, b), twice);
    let (minus, _) = p.div(p.neg(p.add(root, b)), twice);
    let one = select(p, certain, &by_a, &plus);
    let other = select(p, certain, &by_c, &minus);

    let in_order = p.lt(one.hi, other.lo);
    let reversed = p.lt(other.hi, one.lo);
    let two = p.and(positive, p.or(in_order, reversed));
    Closed {
        decided: p.or(negative, two),
        two,
        first: select(p, in_order, &one, &other),
        second: select(p, in_order, &other, &one),
    }
}

/// The first root of a quadric in a segment.
pub(crate) struct First<P: Packet> {
    /// The lanes for which this is the whole answer.
    pub decided: P::M,
    /// Of these, the lanes with a root.
    pub hit: P::M,
    pub root: Interval<P::F>,
    /// No other root lies between the root and this.
    pub resume: P::F,
}

impl<P: Packet> Closed<P> {
    /// Sorts the roots into before, inside and behind `over`. A root across an end of it is left to the search.
    #[inline(always)]
    pub fn first_in(&self, p: P, leaf: &Quadratic<P>, over: &Interval<P::F>) -> First<P> {
        if !p.any(self.two) {
            return First {
                decided: self.decided,
                hit: self.two,
                root: *over,
                resume: over.hi,
            };
        }
        let one = p.and(self.two, inside(p, &self.first, over));
        let skipped = p.and(self.two, outside(p, &self.first, over));
        let other = p.and(skipped, inside(p, &self.second, over));
        let neither = p.and(skipped, outside(p, &self.second, over));
        let none = p.and_not(self.decided, self.two);
        let hit = p.or(one, other);
        let root = select(p, one, &self.first, &self.second);
        let between = middle(
            p,
            &Interval {
                lo: self.first.hi,
                hi: self.second.lo,
            },
        );
        First {
            decided: p.or(p.or(hit, neither), none),
            hit,
            root: tighten(p, leaf, &root, hit),
            resume: p.select(one, p.max_f(between, self.first.hi), over.hi),
        }
    }
}

#[inline(always)]
fn inside<P: Packet>(p: P, t: &Interval<P::F>, over: &Interval<P::F>) -> P::M {
    p.and(p.le(over.lo, t.lo), p.le(t.hi, over.hi))
}

#[inline(always)]
fn outside<P: Packet>(p: P, t: &Interval<P::F>, over: &Interval<P::F>) -> P::M {
    p.or(p.lt(t.hi, over.lo), p.lt(over.hi, t.lo))
}

/// One Newton image: the discriminant's error is as large as a root of the coefficients' error, this one's is not.
#[inline(always)]
fn tighten<P: Packet>(
    p: P,
    leaf: &Quadratic<P>,
    root: &Interval<P::F>,
    hit: P::M,
) -> Interval<P::F> {
    // Leaves are for t ≥ 0.
    let zero = p.splat(0.0);
    let t = select(p, hit, root, &Interval { lo: zero, hi: zero });
    let m = middle(p, &t);
    let f = At(m).quadratic(p, leaf);
    let d = t.quadratic_slope(p, leaf);
    let (step, _) = p.div(f, d);
    let lo = p.max_f(p.sub_rd(m, step.hi), t.lo);
    let hi = p.min_f(p.sub_ru(m, step.lo), t.hi);
    let good = p.and(p.and(hit, super::nonzero(p, &d)), p.le(lo, hi));
    select(p, good, &Interval { lo, hi }, root)
}
