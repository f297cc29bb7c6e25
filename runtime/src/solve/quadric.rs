//! Closed form: the first root of c₀ + c₁t + c₂t² in a segment.

use super::{nonzero, select};
use crate::interval::{At, Interval, Packet, Parameter, Quadratic};

/// What is certain about a quadric in a segment.
pub(crate) struct Closed<P: Packet> {
    /// The lanes for which this is the whole answer; the others need a search.
    pub decided: P::M,
    /// Of these, the lanes with a root.
    pub hit: P::M,
    /// The first.
    pub root: Interval<P::F>,
    /// No other root lies between the root and this.
    pub resume: P::F,
}

/// How wide the piece is in which a root is looked for, in proportion to both roots: as much as √D loses where D is next to
/// its own noise, and as little as f' there lets be without a zero.
const AROUND: f64 = 1.0 / (1u64 << 26) as f64;

/// Where D = c₁² − 4c₀c₂ is certainly negative there is no root. Else the formula says in plain floats where the first
/// one is, and a Newton image of a small piece around it proves it and encloses it, as narrowly as the coefficients permit:
/// f' has a certain sign on the piece, so there is no other. It is the first if f' has the same sign from the beginning on;
/// or if f has, at the beginning, the sign that it has between the roots, opposite to that of c₂: then no root is behind
/// it either.
///
/// Without a root f has the same sign at both ends; and f' has one sign, or both ends are between the roots.
#[inline(always)]
pub(crate) fn closed_form<P: Packet>(
    p: P,
    leaf: &Quadratic<P>,
    over: &Interval<P::F>,
    live: P::M,
) -> Closed<P> {
    let zero = p.splat(0.0);
    let d = discriminant(p, leaf);
    let mut decided = p.lt(d.hi, zero);
    let mut hit = p.none();
    let (mut root, mut resume) = (*over, over.hi);
    if p.any(p.and_not(live, decided)) {
        let Guess { at, piece, behind } = guess(p, leaf, &d, over);
        let slope = piece.quadratic_slope(p, leaf);
        let image = newton(p, leaf, at, &slope);
        let proved = p.and(
            nonzero(p, &slope),
            p.and(p.le(piece.lo, image.lo), p.le(image.hi, piece.hi)),
        );
        let start = At(over.lo);
        let first_slope = start.quadratic_slope(p, leaf);
        let alone = same_sign(p, &slope, &first_slope);
        let first = start.quadratic(p, leaf);
        let between = opposite_sign(p, &first, &leaf.c2);
        hit = p.and_not(p.and(proved, p.or(alone, between)), decided);
        root = select(p, hit, &image, over);
        let behind = p.min_f(p.max_f(behind, piece.hi), over.hi);
        let until = At(behind).quadratic_slope(p, leaf);
        resume = p.select(same_sign(p, &slope, &until), behind, piece.hi);
        resume = p.select(between, over.hi, resume);
        decided = p.or(decided, hit);
        if p.any(p.and_not(live, decided)) {
            let last = At(over.hi).quadratic(p, leaf);
            let monotone = nonzero(p, &over.quadratic_slope(p, leaf));
            let none = p.and(same_sign(p, &first, &last), p.or(monotone, between));
            decided = p.or(decided, none);
        }
    }
    Closed {
        decided,
        hit,
        root,
        resume,
    }
}

/// c₁² − 4c₀c₂
#[inline(always)]
fn discriminant<P: Packet>(p: P, leaf: &Quadratic<P>) -> Interval<P::F> {
    let four = p.splat(4.0);
    let product = p.mul(leaf.c2, leaf.c0);
    let product = Interval {
        lo: p.mul_rd(product.lo, four),
        hi: p.mul_ru(product.hi, four),
    };
    p.sub(p.sqr(leaf.c1), product)
}

/// What plain floats say.
struct Guess<P: Packet> {
    /// Where the first root in the segment is.
    at: P::F,
    /// A piece of the segment around it.
    piece: Interval<P::F>,
    /// A quarter of the way to the next.
    behind: P::F,
}

/// With q = −½(c₁ ± √D), the sign that of c₁, the roots are q/c₂ and c₀/q: no difference of nearly equal numbers.
#[inline(always)]
fn guess<P: Packet>(
    p: P,
    leaf: &Quadratic<P>,
    d: &Interval<P::F>,
    over: &Interval<P::F>,
) -> Guess<P> {
    let zero = p.splat(0.0);
    let (a, b, c) = (leaf.c2.lo, leaf.c1.lo, leaf.c0.lo);
    let root = p.sqrt_rn(p.max_f(d.lo, zero));
    let towards = p.select(p.lt(b, zero), p.neg_f(root), root);
    let q = p.mul_rn(p.splat(-0.5), p.add_rn(b, towards));
    let (one, other) = (p.div_rn(q, a), p.div_rn(c, q));
    let (near, far) = (p.min_f(one, other), p.max_f(one, other));
    let at = p.select(p.le(over.lo, near), near, far);
    // What is no number is replaced by an end.
    let at = p.min_f(p.max_f(at, over.lo), over.hi);
    let radius = p.mul_rn(p.add_rn(p.abs_f(near), p.abs_f(far)), p.splat(AROUND));
    let piece = Interval {
        lo: p.max_f(p.sub_rn(at, radius), over.lo),
        hi: p.min_f(p.add_rn(at, radius), over.hi),
    };
    let behind = p.add_rn(at, p.mul_rn(p.sub_rn(far, at), p.splat(0.25)));
    Guess { at, piece, behind }
}

/// m − f(m)/f'
#[inline(always)]
fn newton<P: Packet>(p: P, leaf: &Quadratic<P>, m: P::F, slope: &Interval<P::F>) -> Interval<P::F> {
    let (step, _) = p.div(At(m).quadratic(p, leaf), *slope);
    Interval {
        lo: p.sub_rd(m, step.hi),
        hi: p.sub_ru(m, step.lo),
    }
}

#[inline(always)]
fn same_sign<P: Packet>(p: P, a: &Interval<P::F>, b: &Interval<P::F>) -> P::M {
    let zero = p.splat(0.0);
    let positive = p.and(p.lt(zero, a.lo), p.lt(zero, b.lo));
    p.or(positive, p.and(p.lt(a.hi, zero), p.lt(b.hi, zero)))
}

#[inline(always)]
fn opposite_sign<P: Packet>(p: P, a: &Interval<P::F>, b: &Interval<P::F>) -> P::M {
    same_sign(p, a, &p.neg(*b))
}

#[cfg(test)]
mod tests;
