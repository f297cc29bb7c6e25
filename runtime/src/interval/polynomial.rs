//! Polynomials in t over segments: Bernstein coefficients, from coefficients that are computed once per ray.
//!
//! Let γₖ = cₖ/(n over k), the coefficients in a scaled basis, and E the step from one coefficient to the next. In this basis
//! f(a + s) has the coefficients αᵢ = (1 + aE)ⁿ⁻ⁱγᵢ, and over [a, a + w] the Bernstein coefficients (1 + wE)ʲα₀: two
//! triangles of fused operations, without a power or a binomial. All values of f lie between the least and the greatest
//! of the (1 + wE)ʲα₀, those of f' between those of n·(1 + wE)ʲα₁, those of f'' between those of n(n − 1)·(1 + wE)ʲα₂: they
//! all stand in one triangle. What f is where its variable occurs often costs nothing here, and narrow segments lose nothing.
//! (The triangles are de Casteljau's; see R. T. Farouki, *The Bernstein polynomial basis: a centennial retrospective*, 2012.)
//!
//! **Rounding.** All is computed to nearest, and bounded at once. The coefficients cₖ come with radii rₖ. A term cₖ is
//! rounded twice for γₖ, at most 2n times in each triangle (each step of it once with FMA, else twice), and once for
//! the factor of a derivative: 4n + 3 roundings of u = 2⁻⁵³. The
//! terms' absolute values sum up to no more than Σ |cₖ|σᵏ with σ = |a| + w, because Bernstein coefficients of a polynomial
//! without negative coefficients grow with j, and the last is its value at the end. So f is within Σ ρₖσᵏ of what was
//! computed, ρₖ = rₖ + (4n + 12)u|cₖ|, and its derivatives within the derivatives of that sum by σ. An operation that
//! underflows is off by 2⁻¹⁰⁷⁴, which the tiny part of ρₖ covers.

use super::{Interval, Packet, Rounding, Routine};

/// A polynomial of degree N − 1 in s = t − middle, known to within Σ ρₖ|s|ᵏ.
#[derive(Clone, Copy)]
pub struct Polynomial<P: Packet, const N: usize> {
    middle: P::F,
    /// Each over its binomial coefficient.
    c: [P::F; N],
    rho: [P::F; N],
}

/// Covers underflow; see above.
const TINY: f64 = 1e-300;

impl<P: Packet, const N: usize> Polynomial<P, N> {
    /// The highest degree that the triangles are written for.
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
        let gamma = p.splat((4 * N + 8) as f64 * 0.5 * f64::EPSILON);
        let mut made = Polynomial::zero(p);
        made.middle = middle;
        let mut k = 0;
        while k < N {
            let m = p.add_rn(p.mul_rn(half, c[k].lo), p.mul_rn(half, c[k].hi));
            let r = p.max_f(p.sub_ru(c[k].hi, m), p.sub_ru(m, c[k].lo));
            made.c[k] = p.mul_rn(m, p.splat(const { weights::<N>() }[k]));
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
        let errors = errors(p, &of.rho, p.add_ru(p.abs_f(a), w));
        let alpha = shifted(p, of.c, a);
        let (least, most) = extremes::<P, N, K>(p, alpha, w);
        let mut hulls = [Hull::new(p, least[0], most[0], errors[0]); K];
        let mut k = 1;
        while k < K {
            let scale = p.splat(const { scales::<N>() }[k]);
            let (least, most) = (p.mul_rn(least[k], scale), p.mul_rn(most[k], scale));
            hulls[k] = Hull::new(p, least, most, errors[k]);
            k += 1;
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

/// The scaled coefficients of f(a + s).
#[inline(always)]
fn shifted<P: Packet, const N: usize>(p: P, mut c: [P::F; N], a: P::F) -> [P::F; N] {
    unrolled!(J => { row::<P, N, J>(p, &mut c, a) });
    c
}

/// One row of a triangle: those that have J + 1 neighbours behind them take a step.
#[inline(always)]
fn row<P: Packet, const N: usize, const J: usize>(p: P, c: &mut [P::F; N], step: P::F) {
    unrolled!(I => {
        if I + J + 1 < N {
            c[I] = p.fma_rn(c[I + 1], step, c[I]);
        }
    });
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

/// The least and the greatest (1 + wE)ʲαₖ, for k below K.
#[inline(always)]
fn extremes<P: Packet, const N: usize, const K: usize>(
    p: P,
    mut c: [P::F; N],
    w: P::F,
) -> ([P::F; K], [P::F; K]) {
    let mut least = [p.splat(0.0); K];
    let mut k = 0;
    while k < K && k < N {
        least[k] = c[k];
        k += 1;
    }
    let mut most = least;
    unrolled!(J => {
        row::<P, N, J>(p, &mut c, w);
        unrolled!(I in 0 1 2 => {
            if I < K && I + J + 1 < N {
                // A NaN stays in c, and is what remains in the end.
                least[I] = p.min_f(least[I], c[I]);
                most[I] = p.max_f(most[I], c[I]);
            }
        });
    });
    (least, most)
}

impl<P: Packet> Hull<P> {
    /// From the least and the greatest coefficient, and how far off they are.
    #[inline(always)]
    fn new(p: P, least: P::F, most: P::F, error: P::F) -> Self {
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
}

/// The factors of f, f' and f'': 1, n and n(n − 1), n = N − 1.
const fn scales<const N: usize>() -> [f64; 3] {
    [1.0, falling(N - 1, 1), falling(N - 1, 2)]
}

/// 1/(n over k), n = N − 1.
const fn weights<const N: usize>() -> [f64; N] {
    let (mut all, mut k) = ([1.0; N], 0);
    while k < N {
        all[k] = falling(k, k) / falling(N - 1, k);
        k += 1;
    }
    all
}

/// n·(n − 1)·… of k factors.
const fn falling(n: usize, k: usize) -> f64 {
    let (mut product, mut i) = (1.0, 0);
    while i < k {
        product *= n as f64 - i as f64;
        i += 1;
    }
    product
}
