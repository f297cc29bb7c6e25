//! How wide enclosures are.

use zeroset::interval::{Arithmetic, At, Interval, Scalar};
use zeroset::ray::Rays;
use zeroset::surface::Surface;

use crate::entry::Random;
use crate::surfaces::Forms;

/// Segments of each width.
const SEGMENTS: usize = 400;

/// How wide enclosures over segments are.
#[derive(Clone, Copy, Debug)]
pub struct Widths {
    /// f(T)
    pub value: f64,
    /// f'(T)
    pub slope: f64,
    /// f(m) + f'(m)(T − m) + ½f''(T)(T − m)², m in the middle of T.
    pub taylor: f64,
}

/// Widths over `count` segments of this width on random rays through the cube of this half side. A ray passes the cube
/// in t ∈ [0, 1], or a little more.
pub fn widths<S: Surface>(surface: &S, half: f64, width: f64, count: usize) -> Vec<Widths> {
    let p = Scalar;
    let prepared = surface.prepare();
    let active = S::everything(&prepared);
    let mut bound = S::unbound(p);
    let mut random = Random(5);
    let mut all = Vec::new();
    for _ in 0..count {
        let mut place = |scale: f64| Interval::point(half * scale * (2.0 * random.number() - 1.0));
        let rays = Rays {
            origin: [place(0.6), place(0.6), Interval::point(-half)],
            direction: [place(0.4), place(0.4), Interval::point(2.0 * half)],
            end: 1.0,
        };
        S::bind(p, &prepared, &rays, &active, &mut bound);
        let lo = (1.0 - width) * random.number();
        let t = Interval { lo, hi: lo + width };
        let m = 0.5 * (t.lo + t.hi);
        let [_, slope, curvature] = S::curvature(p, &prepared, &bound, t).d;
        let value = S::value(p, &prepared, &bound, t).d[0];
        let [f, d] = S::slope(p, &prepared, &bound, At(m)).d;
        let step = p.sub(t, Interval::point(m));
        let half = p.mul(curvature, Interval::point(0.5));
        let taylor = p.add(p.add(f, p.mul(d, step)), p.mul_pos(p.sqr(step), half));
        let width = |a: Interval| a.hi - a.lo;
        all.push(Widths {
            value: width(value),
            slope: width(slope),
            taylor: width(taylor),
        });
    }
    all
}

/// Prints how wide f(T) and f'(T) are on the paper's family, in stages and plainly.
pub fn print(surfaces: &[Forms]) {
    for s in surfaces
        .iter()
        .filter(|s| s.name.contains("exponentials of"))
    {
        println!(
            "{}: widths of enclosures over T, medians of {SEGMENTS} segments; a ray passes the cube in t from 0 to 1.\n",
            s.name
        );
        println!(
            "| T | f(T) plain | f(T) staged | quotient | f'(T) plain | f'(T) staged | quotient |"
        );
        println!("|---|---|---|---|---|---|---|");
        for k in 0..=20 {
            let width = (-f64::from(k)).exp2();
            let both = [&s.forms[1], &s.forms[3]].map(|form| form.widths(s.half, width, SEGMENTS));
            let cells = [|w: &Widths| w.value, |w: &Widths| w.slope].map(|of| {
                let [plain, staged] = both
                    .each_ref()
                    .map(|all| median(all.iter().map(of).collect()));
                let pairs = both[0].iter().zip(&both[1]);
                let quotient = median(pairs.map(|(a, b)| of(a) / of(b)).collect());
                format!("{plain:.2e} | {staged:.2e} | {quotient:.2}")
            });
            println!("| 2^-{k} | {} |", cells.join(" | "));
        }
        println!();
    }
}

/// The median.
pub fn median(mut all: Vec<f64>) -> f64 {
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}
