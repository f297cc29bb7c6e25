//! Products with their rounding errors, on packets.

use super::super::Lanes;

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

/// (h, l) with h + l = a exactly, short enough that products of two are exact (Veltkamp).
#[inline(always)]
fn split<P: Lanes>(p: P, a: P::F) -> (P::F, P::F) {
    let c = p.mul_rn(p.splat(134_217_729.0), a);
    let h = p.sub_rn(c, p.sub_rn(c, a));
    (h, p.sub_rn(a, h))
}
