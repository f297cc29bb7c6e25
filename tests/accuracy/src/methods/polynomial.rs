//! A polynomial along each ray, one ray after the other: its coefficients by interpolation in packets, its first root by
//! the roots of its derivatives.

use std::ops::RangeInclusive;
use std::sync::OnceLock;

use super::Search;
use zeroset::interval::Packet;

/// Degrees for which it is tried.
pub const DEGREES: RangeInclusive<u32> = 2..=16;
const ROOM: usize = 17;

type Coefficients = [f64; ROOM];

#[inline(always)]
pub(super) fn trace<P: Packet>(p: P, search: &Search<P>, degree: u32) -> P::F {
    let zero = p.splat(0.0);
    let half = p.mul_rn(p.splat(0.5), search.end);
    let live = p.le(zero, search.end);
    let degree = degree as usize;
    // f at the Chebyshev nodes of [0, end], and from there its coefficients in u = 2t/end − 1.
    let matrix = matrix(degree);
    let mut sums = [zero; ROOM];
    for (node, row) in matrix.iter().enumerate().take(degree + 1) {
        let u = node_of(degree, node);
        let f = search
            .probe
            .value(p, p.fma_rn(half, p.splat(u), half), live);
        for (sum, weight) in sums.iter_mut().zip(row).take(degree + 1) {
            *sum = p.fma_rn(f, p.splat(*weight), *sum);
        }
    }
    let sums = sums.map(|sum| p.to_array(sum));
    let tolerances = p.to_array(p.div_rn(search.tolerance, half));
    let mut roots = [f64::NAN; 8];
    for (lane, root) in roots.iter_mut().enumerate() {
        if p.bits(live) >> lane & 1 != 0 {
            let coefficients = sums.map(|sum| sum[lane]);
            *root = first(&coefficients, degree, tolerances[lane]);
        }
    }
    let t = p.fma_rn(half, p.lanes(roots), half);
    let found = p.and(live, p.eq(t, t));
    if !p.any(found) {
        return t;
    }
    // One step by f itself takes back what the coefficients lost.
    let at = p.select(found, t, zero);
    let [f, slope] = search.probe.slope(p, at, found);
    let step = p.div_rn(f, slope);
    let small = p.le(p.abs_f(step), p.mul_rn(p.splat(1e-6), half));
    p.select(small, p.sub_rn(t, step), t)
}

fn node_of(degree: usize, node: usize) -> f64 {
    let angle = (node as f64 + 0.5) / (degree + 1) as f64;
    (angle * std::f64::consts::PI).cos()
}

/// For each node, how much f there adds to each coefficient; made once per degree.
fn matrix(degree: usize) -> &'static [Coefficients; ROOM] {
    static MATRICES: [OnceLock<[Coefficients; ROOM]>; ROOM] = [const { OnceLock::new() }; ROOM];
    MATRICES[degree].get_or_init(|| interpolation(degree))
}

/// The coefficient of the Chebyshev polynomial k is 2/(n+1)·Σ f(node)·T_k(node), half that for k = 0.
fn interpolation(degree: usize) -> [Coefficients; ROOM] {
    let mut chebyshev = [[0.0; ROOM]; ROOM];
    (chebyshev[0][0], chebyshev[1][1]) = (1.0, 1.0);
    for k in 2..ROOM {
        for power in 0..ROOM {
            let raised = if power > 0 {
                2.0 * chebyshev[k - 1][power - 1]
            } else {
                0.0
            };
            chebyshev[k][power] = raised - chebyshev[k - 2][power];
        }
    }
    let mut matrix = [[0.0; ROOM]; ROOM];
    for (node, row) in matrix.iter_mut().enumerate().take(degree + 1) {
        let angle = node_of(degree, node).acos();
        for (k, polynomial) in chebyshev.iter().enumerate().take(degree + 1) {
            let share = if k == 0 { 1.0 } else { 2.0 } / (degree + 1) as f64;
            let weight = share * (k as f64 * angle).cos();
            for (entry, power) in row.iter_mut().zip(polynomial) {
                *entry += weight * power;
            }
        }
    }
    matrix
}

fn value(c: &[f64], u: f64) -> [f64; 2] {
    let (mut f, mut slope) = (0.0, 0.0);
    for &c in c.iter().rev() {
        slope = slope * u + f;
        f = f * u + c;
    }
    [f, slope]
}

/// The first root in [−1, 1], or NaN.
fn first(c: &Coefficients, degree: usize, tolerance: f64) -> f64 {
    let mut derivatives = [*c; ROOM];
    for k in 1..degree {
        for power in 0..=degree - k {
            derivatives[k][power] = derivatives[k - 1][power + 1] * (power + 1) as f64;
        }
    }
    // Ends of the pieces on which the next polynomial is monotone.
    let (mut ends, mut count) = ([0.0; ROOM + 2], 0usize);
    for k in (0..degree).rev() {
        let polynomial = &derivatives[k][..=degree - k];
        let (mut roots, mut found) = ([0.0; ROOM + 2], 0);
        let mut a = -1.0;
        let mut fa = value(polynomial, a)[0];
        for b in ends[..count].iter().copied().chain([1.0]) {
            let fb = value(polynomial, b)[0];
            if (fa < 0.0) != (fb < 0.0) {
                let root = within(polynomial, [a, b], fa < 0.0, tolerance);
                if k == 0 {
                    return root;
                }
                roots[found] = root;
                found += 1;
            }
            (a, fa) = (b, fb);
        }
        (ends, count) = (roots, found);
    }
    f64::NAN
}

/// Newton's iteration in a piece with one root, halving it where a step leaves it.
fn within(c: &[f64], [mut a, mut b]: [f64; 2], rising: bool, tolerance: f64) -> f64 {
    let mut u = 0.5 * (a + b);
    for _ in 0..100 {
        let [f, slope] = value(c, u);
        if (f < 0.0) == rising {
            a = u;
        } else {
            b = u;
        }
        let step = u - f / slope;
        let next = if a < step && step < b {
            step
        } else {
            0.5 * (a + b)
        };
        if (next - u).abs() <= tolerance || next == u {
            return next;
        }
        u = next;
    }
    u
}
