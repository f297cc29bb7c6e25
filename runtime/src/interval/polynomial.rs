//! Polynomials in t over segments: Bernstein coefficients, from coefficients that are computed once per ray.
//!
//! Over [a, a + w] the polynomial f has the Bernstein coefficients b_j = Σ_i (j over i)/(n over i)·αᵢwⁱ, where αᵢ are the
//! coefficients of f(a + s). All values of f lie between the least and the greatest of them; for the derivatives take
//! those of αᵢ. What f is where its variable occurs often costs nothing here, and narrow segments lose nothing.
//!
//! **Rounding.** All is computed to nearest, and bounded at once. The coefficients cₖ come with radii rₖ. A term cₖ is
//! rounded at most n + 1 times by Horner's scheme for αᵢ (each step of it once with FMA, else twice), 3 times for the
//! power of w and its weight n + 2 at most, and n times in the sums: less than 6n + 16 roundings of u = 2⁻⁵³ each. The
//! terms' absolute values sum up to no more than Σ |cₖ|σᵏ with σ = |a| + w, because Bernstein coefficients of a polynomial
//! without negative coefficients grow with j, and the last is its value at the end. So f is within Σ ρₖσᵏ of what was
//! computed, ρₖ = rₖ + (6n + 16)u|cₖ|, and its derivatives within the derivatives of that sum by σ. A product that
//! underflows is off by 2⁻¹⁰⁷⁴, which the tiny part of ρₖ covers; w ≥ 2⁻⁸⁰, so that its powers do not.

use super::{Interval, Packet, Rounding, Routine};

/// A polynomial of degree N − 1 in s = t − middle, known to within Σ ρₖ|s|ᵏ.
#[derive(Clone, Copy)]
pub struct Polynomial<P: Packet, const N: usize> {
    middle: P::F,
    c: [P::F; N],
    rho: [P::F; N],
}

/// The least width: its twelfth power is a normal number. A segment that is narrower is widened, below any rounding of t.
const LEAST_WIDTH: f64 = 1.0 / ((1u128 << 80) as f64);
/// Covers underflow; see above.
const TINY: f64 = 1e-300;

impl<P: Packet, const N: usize> Polynomial<P, N> {
    /// The highest degree whose powers of w cannot underflow.
    pub const MOST: usize = 12;
    /// Up to so many coefficients, code stands where it is used.
    const IN_PLACE: usize = 8;

    /// The polynomial with these coefficients around `middle`.
    #[inline(always)]
    pub fn new(p: P, middle: P::F, c: &[Interval<P::F>; N]) -> Self {
        const { assert!(N > 0 && N <= Self::MOST + 1) }
        let (half, tiny) = (p.splat(0.5), p.splat(TINY));
        // A little more: Σ ρₖσᵏ is rounded too.
        let more = p.splat(1.0 + 1.0 / (1u64 << 40) as f64);
        let gamma = p.splat((6 * N + 16) as f64 * 0.5 * f64::EPSILON);
        let mut made = Polynomial::zero(p);
        made.middle = middle;
        let mut k = 0;
        while k < N {
            let m = p.add_rn(p.mul_rn(half, c[k].lo), p.mul_rn(half, c[k].hi));
            let r = p.max_f(p.sub_ru(c[k].hi, m), p.sub_ru(m, c[k].lo));
            made.c[k] = m;
            if P::Rounding::ON {
                made.rho[k] = p.fma_rn(p.fma_rn(p.abs_f(m), gamma, r), more, tiny);
            }
            k += 1;
        }
        made
    }

    /// The polynomial 0: room, to be written by the ray stage.
    #[inline(always)]
    pub fn zero(p: P) -> Self {
        let zero = p.splat(0.0);
        Polynomial {
            middle: zero,
            c: [zero; N],
            rho: [zero; N],
        }
    }

    /// Enclosures of f and its first K − 1 derivatives over a segment, but nothing where rounding makes out most of a range, in some lane: on narrow segments, beside roots of
    /// high order, where coefficients overflow or are lost below 1e-300. What a formula says as it is written is then
    /// narrower, and never wider by more.
    #[inline(always)]
    pub fn telling<const K: usize>(&self, p: P, t: &Interval<P::F>) -> Option<[Interval<P::F>; K]> {
        let hulls = self.hulls::<K>(p, t);
        let mut ranges = [p.point(p.splat(0.0)); K];
        let mut told = hulls[0].sharp;
        let mut k = 0;
        while k < K {
            told = p.and(told, hulls[k].finite);
            ranges[k] = hulls[k].range;
            k += 1;
        }
        (!p.any(p.not(told))).then_some(ranges)
    }

    /// The hulls of f and its first K − 1 derivatives over a segment. Of low degree in place: with what it takes and says in memory, it took up to half as long again.
    #[inline(always)]
    pub fn hulls<const K: usize>(&self, p: P, t: &Interval<P::F>) -> [Hull<P>; K] {
        let ranges = Ranges { of: self, t };
        if const { N <= Self::IN_PLACE } {
            return ranges.call(p);
        }
        p.operation(ranges)
    }
}

struct Ranges<'a, P: Packet, const N: usize, const K: usize> {
    of: &'a Polynomial<P, N>,
    t: &'a Interval<P::F>,
}

/// The range of a polynomial, or of a derivative.
#[derive(Clone, Copy)]
pub struct Hull<P: Packet> {
    /// All values, where `finite` is set.
    pub range: Interval<P::F>,
    /// Nothing overflowed: else the range is none.
    pub finite: P::M,
    /// Rounding makes out less than half of the range.
    pub sharp: P::M,
}

impl<P: Packet, const N: usize, const K: usize> Routine<P> for Ranges<'_, P, N, K> {
    type Output = [Hull<P>; K];

    #[inline(always)]
    fn call(self, p: P) -> [Hull<P>; K] {
        let Ranges { of, t } = self;
        let a = p.sub_rd(t.lo, of.middle);
        let w = p.sub_ru(p.sub_ru(t.hi, of.middle), a);
        let w = p.max_f(w, p.splat(LEAST_WIDTH));
        let errors = errors(p, &of.rho, p.add_ru(p.abs_f(a), w));
        let alpha = shifted(p, of.c, a);
        let mut powers = [p.splat(1.0); N];
        let mut i = 1;
        while i < N {
            powers[i] = p.mul_rn(powers[i - 1], w);
            i += 1;
        }
        let mut hulls = [hull::<P, N, 0>(p, &alpha, &powers, errors[0]); K];
        if K > 1 {
            hulls[1] = hull::<P, N, 1>(p, &alpha, &powers, errors[1]);
        }
        if K > 2 {
            hulls[2] = hull::<P, N, 2>(p, &alpha, &powers, errors[2]);
        }
        hulls
    }
}

/// Repeats a block for each number from 0 to 12: the optimiser leaves nested loops of this size as they are, and then
/// vectors pass through memory, at three times the cost.
macro_rules! unrolled {
    ($i:ident => $body:block) => {
        unrolled!($i in 0 1 2 3 4 5 6 7 8 9 10 11 12 => $body)
    };
    ($i:ident in $($n:literal)* => $body:block) => {
        $({ const $i: usize = $n; $body })*
    };
}

/// The coefficients of f(a + s).
#[inline(always)]
fn shifted<P: Packet, const N: usize>(p: P, mut c: [P::F; N], a: P::F) -> [P::F; N] {
    unrolled!(FIRST => {
        unrolled!(BACK => {
            if FIRST + BACK + 1 < N {
                let j = N - 2 - BACK;
                c[j] = p.fma_rn(c[j + 1], a, c[j]);
            }
        });
    });
    c
}

/// Σ ρₖσᵏ and its first two derivatives by σ.
#[inline(always)]
fn errors<P: Packet, const N: usize>(p: P, rho: &[P::F; N], sigma: P::F) -> [P::F; 3] {
    let zero = p.splat(0.0);
    let (mut e0, mut e1, mut e2) = (rho[N - 1], zero, zero);
    let mut k = N - 1;
    while k > 0 {
        k -= 1;
        e2 = p.fma_rn(e2, sigma, e1);
        e1 = p.fma_rn(e1, sigma, e0);
        e0 = p.fma_rn(e0, sigma, rho[k]);
    }
    [e0, e1, p.add_rn(e2, e2)]
}

/// The range of the k-th derivative: the hull of its Bernstein coefficients, widened by the error.
#[inline(always)]
fn hull<P: Packet, const N: usize, const K: usize>(
    p: P,
    alpha: &[P::F; N],
    powers: &[P::F; N],
    error: P::F,
) -> Hull<P> {
    // The forward differences of the Bernstein coefficients at the first one.
    let mut d = [p.splat(0.0); N];
    unrolled!(I => {
        if I + K < N {
            let weight = falling(I + K, K) / binomial(N - 1 - K, I);
            d[I] = p.mul_rn(alpha[I + K], p.mul_rn(powers[I], p.splat(weight)));
        }
    });
    let (mut least, mut most) = (d[0], d[0]);
    unrolled!(J => {
        unrolled!(I => {
            if J != 0 && I + J + K < N {
                d[I] = p.add_rn(d[I], d[I + 1]);
            }
        });
        if J != 0 && J + K < N {
            // A NaN stays in d[0], and is what remains in the end.
            least = p.min_f(least, d[0]);
            most = p.max_f(most, d[0]);
        }
    });
    let spread = p.sub_rn(most, least);
    Hull {
        range: Interval {
            lo: p.sub_rd(least, error),
            hi: p.add_ru(most, error),
        },
        finite: p.lt(p.add_rn(spread, error), p.splat(f64::INFINITY)),
        sharp: p.lt(p.add_rn(error, error), spread),
    }
}

/// n·(n − 1)·… of k factors.
const fn falling(n: usize, k: usize) -> f64 {
    let (mut product, mut i) = (1.0, 0);
    while i < k {
        product *= (n - i) as f64;
        i += 1;
    }
    product
}

/// n over k.
const fn binomial(n: usize, k: usize) -> f64 {
    falling(n, k) / falling(k, k)
}
