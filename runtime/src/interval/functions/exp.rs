//! eˣ on packets: one reduction, one polynomial, proved.
//!
//! With k = ⌊x/ln 2⌉ and r = x − k·ln 2, eˣ = 2ᵏ·eʳ and |r| ≤ 0.34658. ln 2 is cut into L1 (42 bits, so that k·L1 and
//! x − k·L1 are exact) and L2. In doubles,
//!
//! * r₁ = x − k·L1, t₁ = k·L2, r = r₁ − t₁,
//! * s = r₁ + (r²·q(r) − t₁), near eʳ − 1, with q of degree 9 by Sollya's `fpminimax`,
//! * v = 1 + s, and the result is 2ᵏ·v.
//!
//! Gappa proves |s − (eʳ − 1)| < 2⁻⁵⁴ for r₁ ≤ 0 and < 2⁻⁵³ for r₁ ≥ 0, with and without fused operations
//! (`runtime/proofs/exp_*.g`). Hence eʳ lies between the two neighbours of v:
//!
//! * v < 1 (s < 0): the last sum errs by at most 2⁻⁵⁴, together less than 2⁻⁵³, and doubles in [½, 1] are 2⁻⁵³ apart;
//! * v > 1: it errs by at most 2⁻⁵³, together less than 2⁻⁵², and doubles in [1, 2] are 2⁻⁵² apart;
//! * v = 1: −2⁻⁵⁴ ≤ s ≤ 2⁻⁵³, so eʳ − 1 is above −2⁻⁵³ and below 2⁻⁵².
//!
//! (s and r₁ have one sign unless both are below 2⁻³², where all errors are below 2⁻⁸⁰. The quotient x/ln 2 errs by
//! less than 2⁻⁴², and ln 2/2 < 0.346574, which leaves room for it.) Scaling by 2ᵏ is exact as
//! long as the result is normal. So a point's enclosure is the two neighbours: two units wide.

use super::super::enclose::Enclose;
use super::super::lanes::WHOLE;
use super::super::{Interval, Lanes};
use super::thin::{self, unless_exact};

/// The coefficients of q, from the constant one on.
const Q: [u64; 10] = [
    0x3fe000000000000b,
    0x3fc5555555555561,
    0x3fa555555555022d,
    0x3f8111111110d645,
    0x3f56c16c1854e9fc,
    0x3f2a01a01baddbb3,
    0x3efa019975e50177,
    0x3ec71dddfd6f9507,
    0x3e928afa5e33078f,
    0x3e5af8575077d162,
];
/// ln 2 to 42 bits, and the rest.
const L1: u64 = 0x3fe62e42fefa3800;
pub const L2: u64 = 0x3d2ef35793c76730;
/// 1/ln 2
const LOG2E: u64 = 0x3ff71547652b82fe;

/// The least x whose power is surely normal; below it the bounds are 0 and e⁻⁷⁰⁸ ≈ 3.3·10⁻³⁰⁸.
pub const LEAST: f64 = -708.0;
/// The greatest double below ln(MAX). Its power is 2·10⁻¹⁴ below MAX, so the result never overflows.
pub const GREATEST: u64 = 0x40862e42fefa39ef;

/// An interval that reaches no further than this from its middle is hardly more than a point.
const THIN: f64 = 1.0 / (1u64 << 30) as f64;

/// eᵃ
#[inline(always)]
pub fn exp<P: Enclose>(p: P, a: Interval<P::F>) -> Interval<P::F> {
    let least = p.splat(LEAST);
    let greatest = p.splat(f64::from_bits(GREATEST));
    let (middle, radius) = thin::middle(p, &a);
    let bounded = p.and(p.le(least, a.lo), p.le(a.hi, greatest));
    let thin = p.and(bounded, p.le(radius, p.splat(THIN)));
    if !p.any(p.not(thin)) {
        return thin_exp(p, middle, radius);
    }
    let lo = p.before(near(p, p.max_f(p.min_f(a.lo, greatest), least)));
    let hi = p.after(near(p, p.max_f(p.min_f(a.hi, greatest), least)));
    Interval {
        lo: p.select(p.lt(a.lo, least), p.splat(0.0), lo),
        hi: p.select(p.lt(greatest, a.hi), p.splat(f64::INFINITY), hi),
    }
}

/// Over middle ± radius: 1 − |δ| ≤ e^δ ≤ 1 + |δ| + δ² for |δ| ≤ 1.
#[inline(always)]
fn thin_exp<P: Enclose>(p: P, middle: P::F, radius: P::F) -> Interval<P::F> {
    let v = near(p, middle);
    let (under, over) = (p.before(v), p.after(v));
    let more = p.mul_ru(radius, p.splat(1.0 + 2.0 * THIN));
    let exact = p.eq(radius, p.splat(0.0));
    Interval {
        lo: unless_exact(p, exact, under, p.fma_rd(p.neg_f(radius), under, under)),
        hi: unless_exact(p, exact, over, p.fma_ru(more, over, over)),
    }
}

/// eˣ approximately, for every x; 0 where it is not a normal number, NaN of NaN.
#[inline(always)]
pub fn anywhere<P: Lanes>(p: P, x: P::F) -> P::F {
    let least = p.splat(LEAST);
    let greatest = p.splat(f64::from_bits(GREATEST));
    // Constants first: a NaN passes through.
    let y = near(p, p.max_f(least, p.min_f(greatest, x)));
    let y = p.select(p.lt(x, least), p.splat(0.0), y);
    p.select(p.lt(greatest, x), p.splat(f64::INFINITY), y)
}

/// eˣ to within a unit in the last place, for LEAST ≤ x ≤ GREATEST.
#[inline(always)]
pub fn near<P: Lanes>(p: P, x: P::F) -> P::F {
    let (k, r1) = reduce(p, x);
    let t = tail(p, r1, p.mul_rn(k, p.splat(f64::from_bits(L2))));
    p.scale(p.add_rn(p.splat(1.0), p.add_rn(r1, t)), k)
}

/// k = ⌊x/ln 2⌉ and r₁ = x − k·L1, exactly.
#[inline(always)]
pub fn reduce<P: Lanes>(p: P, x: P::F) -> (P::F, P::F) {
    // Adding 1.5·2⁵² leaves the nearest whole number in the low bits.
    let shift = p.splat(WHOLE);
    let k = p.sub_rn(p.fma_rn(x, p.splat(f64::from_bits(LOG2E)), shift), shift);
    (k, p.fma_rn(k, p.splat(-f64::from_bits(L1)), x))
}

/// Near e^(r₁ − t₁) − 1 − r₁ for |t₁| ≤ 2⁻³², t₁ being k·L2 (less what x itself was rounded by).
#[inline(always)]
pub fn tail<P: Lanes>(p: P, r1: P::F, t1: P::F) -> P::F {
    let r = p.sub_rn(r1, t1);
    let mut q = p.splat(f64::from_bits(Q[9]));
    let mut i = 9;
    while i > 0 {
        i -= 1;
        q = p.fma_rn(r, q, p.splat(f64::from_bits(Q[i])));
    }
    p.fms_rn(p.mul_rn(r, r), q, t1)
}
