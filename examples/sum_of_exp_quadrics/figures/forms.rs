//! The first figure: enclosures of f(T), and the true range that they are compared with.

use zeroset::interval::{Arithmetic, Interval, Scalar};

use super::function::RayFunction;

/// The names of the forms, in the order of [`widths`].
pub const NAMES: [&str; 4] = ["plain", "staged", "mean value", "monotone"];

/// The widths of four enclosures of f(T), each over the true width.
pub struct Widths {
    /// In the order of [`NAMES`].
    pub ratios: [f64; 4],
    /// How far the width taken for true may be short of it, over itself.
    pub doubt: f64,
}

/// Measures all forms.
pub fn widths(f: &RayFunction, t: Interval) -> Widths {
    let truth = range(f, t);
    let width = truth.inner.width();
    let forms = [f.plain(t), f.value(t), mean_value(f, t), monotone(f, t)];
    Widths {
        ratios: forms.map(|form| form.width() / width),
        doubt: truth.outer.width() / width - 1.0,
    }
}

/// f(m) + f'(T)(T − m), m the middle of T, on staged enclosures: by the mean value theorem.
pub fn mean_value(f: &RayFunction, t: Interval) -> Interval {
    let m = t.mid();
    let from_m = Scalar.sub(t, Interval { lo: m, hi: m });
    Scalar.add(f.at(m), Scalar.mul(f.slope(t)[1], from_m))
}

/// The hull of the values at the ends where 0 ∉ f'(T), by monotonicity; elsewhere the staged enclosure.
pub fn monotone(f: &RayFunction, t: Interval) -> Interval {
    let [value, slope] = f.slope(t);
    if slope.contains(0.0) {
        value
    } else {
        f.at(t.lo).hull(&f.at(t.hi))
    }
}

/// f(T) between two bounds.
pub struct Range {
    /// Spanned by values of f at points: f(T) holds it.
    pub inner: Interval,
    /// It holds f(T).
    pub outer: Interval,
}

/// What [`range`] aims at for the difference of the two, each side over the width. Where f is nearly constant on T,
/// rounding stops the search before that.
const TOLERANCE: f64 = 1e-6;

/// f(T) by branch and bound: T is halved, and a piece is done when an enclosure of f there exceeds the values found so
/// far by less than the tolerance.
pub fn range(f: &RayFunction, t: Interval) -> Range {
    let (a, b) = (f.at(t.lo), f.at(t.hi));
    // An upper bound of a value is at least the minimum of f, a lower bound at most its maximum.
    let mut inner = [a.hi.min(b.hi), a.lo.max(b.lo)];
    let mut outer = a.hull(&b);
    let mut open = vec![t];
    // Near an extreme value the excess of the mean value form falls with the square of the width: 26 halvings suffice.
    for halvings in 0..=26 {
        let mut next = Vec::new();
        for piece in open {
            let value = f.at(piece.mid());
            inner = [inner[0].min(value.hi), inner[1].max(value.lo)];
            let excess = TOLERANCE * (inner[1] - inner[0]);
            let bound = enclosure(f, piece);
            let done = bound.lo >= inner[0] - excess && bound.hi <= inner[1] + excess;
            if done || halvings == 26 {
                outer = outer.hull(&bound);
            } else {
                let (lo, m, hi) = (piece.lo, piece.mid(), piece.hi);
                next.extend([Interval { lo, hi: m }, Interval { lo: m, hi }]);
            }
        }
        open = next;
    }
    let [lo, hi] = [inner[0].min(inner[1]), inner[1]];
    Range {
        inner: Interval { lo, hi },
        outer,
    }
}

/// The intersection of all staged forms: as each holds f(T), it is not empty.
fn enclosure(f: &RayFunction, t: Interval) -> Interval {
    let (mean, monotone) = (mean_value(f, t), monotone(f, t));
    mean.intersect(&monotone).unwrap_or(monotone)
}

#[cfg(test)]
mod tests {
    use super::super::function::functions;
    use super::*;

    /// Every form holds the range, and the range holds what 1,000 points say and is not more than theirs by much.
    #[test]
    fn forms_hold_the_range_and_the_range_is_the_samples() {
        for f in functions().iter().step_by(16) {
            for &t in f.segments.iter().step_by(4) {
                let truth = range(f, t);
                assert!(truth.outer.encloses(&truth.inner));
                for form in [f.plain(t), f.value(t), mean_value(f, t), monotone(f, t)] {
                    assert!(form.encloses(&truth.inner), "{form} {}", truth.inner);
                }
                let sample = |k: u32| {
                    f.at((t.lo + t.width() * f64::from(k) / 1000.0).min(t.hi))
                        .mid()
                };
                let samples: Vec<f64> = (0..=1000).map(sample).collect();
                let least = samples.iter().copied().fold(f64::INFINITY, f64::min);
                let most = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                // The values' own enclosures are this wide at most.
                let slack = 1e-12 * most.abs().max(least.abs()).max(1.0);
                let Range { inner, outer } = truth;
                assert!(outer.lo <= least + slack && most - slack <= outer.hi);
                assert!(inner.width() <= (most - least) * 1.01 + slack);
            }
        }
    }

    /// The control: a form that leaves out half of the slope does not hold the range.
    #[test]
    fn half_a_slope_is_caught() {
        let caught = functions().iter().step_by(16).any(|f| {
            let t = f.segments[10];
            let m = f.at(t.mid());
            let half = 0.25 * f.slope(t)[1].lo.abs() * t.width();
            let wrong = Interval {
                lo: m.lo - half,
                hi: m.hi + half,
            };
            !wrong.encloses(&range(f, t).inner)
        });
        assert!(caught);
    }
}
