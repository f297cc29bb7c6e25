//! Sums, products and quotients with their rounding errors, on packets.

use super::super::Lanes;

/// The unevaluated sum of two doubles, the second no larger than a unit in the last place of the first.
#[derive(Clone, Copy)]
pub struct Sum<F> {
    /// The larger part.
    pub high: F,
    /// The smaller part.
    pub low: F,
}

/// (h, l) with h + l = a·b exactly, barring overflow and underflow: one fused operation, or Dekker's product.
#[inline(always)]
pub fn two_product<P: Lanes>(p: P, a: P::F, b: P::F) -> (P::F, P::F) {
    let h = p.mul_rn(a, b);
    if P::FUSED {
        return (h, p.fms_rn(a, b, h));
    }
    let (a1, a0) = split(p, a);
    let (b1, b0) = split(p, b);
    let rest = p.sub_rn(h, p.mul_rn(a1, b1));
    let rest = p.sub_rn(rest, p.mul_rn(a0, b1));
    let rest = p.sub_rn(rest, p.mul_rn(a1, b0));
    (h, p.sub_rn(p.mul_rn(a0, b0), rest))
}

/// a + b exactly, for |a| ≥ |b| or a = 0 (Dekker).
#[inline(always)]
pub fn fast_two_sum<P: Lanes>(p: P, a: P::F, b: P::F) -> Sum<P::F> {
    let high = p.add_rn(a, b);
    Sum {
        high,
        low: p.sub_rn(b, p.sub_rn(high, a)),
    }
}

/// (h, l) with h + l = a exactly, short enough that products of two are exact (Veltkamp).
#[inline(always)]
fn split<P: Lanes>(p: P, a: P::F) -> (P::F, P::F) {
    let c = p.mul_rn(p.splat(134_217_729.0), a);
    let h = p.sub_rn(c, p.sub_rn(c, a));
    (h, p.sub_rn(a, h))
}

/// q + ρ near (n + n′)/(d + d′), for |n′| ≤ u|n|, |d′| ≤ u|d|, u = 2⁻⁵³, barring overflow and underflow: to 2⁻¹⁰¹
/// relatively, with |ρ| ≤ 2⁻⁵⁰|q|.
///
/// q is n times the rounded reciprocal of d, so it errs by 2u relatively. n − q·d takes 2u·|n|; it is exact up to one
/// rounding (with q·d = h + l, n − h by Sterbenz), n′ − q·d′ adds 2u·|n| with two: together below 4u·|n|, wrong by 8u²·|n|
/// at most. The product with the reciprocal adds 8u² relatively, d for d + d′ in it 4u².
#[inline(always)]
pub fn quotient<P: Lanes>(p: P, n: Sum<P::F>, d: Sum<P::F>) -> Sum<P::F> {
    let inverse = p.div_rn(p.splat(1.0), d.high);
    let q = p.mul_rn(n.high, inverse);
    let rest = remainder(p, n.high, q, d.high);
    let low = p.fma_rn(p.neg_f(q), d.low, n.low);
    Sum {
        high: q,
        low: p.mul_rn(p.add_rn(rest, low), inverse),
    }
}

/// x − a·b, rounded once, where a·b is x up to a few units in the last place.
#[inline(always)]
pub fn remainder<P: Lanes>(p: P, x: P::F, a: P::F, b: P::F) -> P::F {
    if P::FUSED {
        return p.fma_rn(p.neg_f(a), b, x);
    }
    let (h, l) = two_product(p, a, b);
    p.sub_rn(p.sub_rn(x, h), l)
}
