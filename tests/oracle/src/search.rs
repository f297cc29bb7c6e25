//! The first root of a sum of exponentials along a ray, by subdivision.

use crate::sum::Along;
use crate::wide::Wide;

/// The truth about the first root, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    /// There is no root.
    Free,
    /// No root lies before `lo`, and exactly one in [lo, hi], where f changes its sign.
    Root {
        /// Where it begins.
        lo: f64,
        /// Where it ends.
        hi: f64,
        /// The sign of f before the root.
        before: i32,
    },
    /// No root lies before `from`; behind it all is open.
    Open {
        /// Where it begins.
        from: f64,
    },
}

/// Bounds from plain floats are widened by this part of the sizes that they are sums of. An exponent below 10⁵ in size
/// is computed within 10·2⁻⁵³·10⁵ < 2·10⁻¹⁰, and from coefficients as far off; an exponential is then relatively within
/// 5·10⁻¹⁰. The exponents that matter (above −60) belong to coordinates of a few units, and are a thousand times more
/// exact than that.
const MARGIN: f64 = 1e-9;
/// Segments are not split further.
const SHORTEST: f64 = 1e-10;
/// On segments shorter than this f'' is looked at.
const SHORT: f64 = 1e-3;
/// Terms whose exponent stays below this are left out: 64 of them are below 10⁻²⁴.
const NEGLIGIBLE: f64 = -60.0;

/// Bounds of a number.
type Bounds = [f64; 2];

/// A search of one ray.
pub struct Search<'a> {
    along: &'a Along<'a>,
    terms: Vec<[f64; 3]>,
}

impl<'a> Search<'a> {
    /// The first root in [from, to].
    pub fn first_root(along: &'a Along<'a>, from: f64, to: f64) -> Truth {
        let mut terms = along.plain();
        terms.retain(|c| exponent(c, from, to)[1] > NEGLIGIBLE);
        let search = Search { along, terms };
        match search.along.sign(Wide::new(from)) {
            Some(sign) if sign != 0 => search.inside(from, to, sign),
            _ => Truth::Open { from },
        }
    }

    /// The first root in [a, b], where f has the sign `before` at a.
    fn inside(&self, a: f64, b: f64, before: i32) -> Truth {
        let (value, slope) = self.bounds(a, b);
        if value[0] > 0.0 || value[1] < 0.0 {
            return Truth::Free;
        }
        let open = Truth::Open { from: a };
        if slope[0] > 0.0 || slope[1] < 0.0 {
            return self.by_signs(a, b, before).unwrap_or(open);
        }
        if b - a < SHORTEST {
            return open;
        }
        if b - a < SHORT
            && let Some(truth) = self.bent(a, b, before)
        {
            return truth;
        }
        let middle = 0.5 * (a + b);
        match self.inside(a, middle, before) {
            Truth::Free => self.inside(middle, b, before),
            other => other,
        }
    }

    /// The first root in a short [a, b] on which f'' has a certain sign, beside a minimum of |f|. Let g = before·f, so
    /// that g(a) > 0.
    ///
    /// - g'' < 0: g lies above its chord. It has no root if g(b) > 0, and exactly one if g(b) < 0.
    /// - g'' > 0: let c be near the minimum. If g(c) < 0, exactly one root lies before c. Else g lies above its tangent
    ///   at c, that is above g(c) − |g'(c)|·(b − a).
    fn bent(&self, a: f64, b: f64, before: i32) -> Option<Truth> {
        let bounds = self.curvature(a, b);
        let sign = f64::from(before);
        if bounds[0] <= 0.0 && bounds[1] >= 0.0 {
            return None;
        }
        if sign * bounds[0] < 0.0 {
            return self.by_signs(a, b, before);
        }
        let mut c = 0.5 * (a + b);
        let bend = 0.5 * (bounds[0] + bounds[1]);
        for _ in 0..12 {
            let [_, (slope, _)] = self.along.value(Wide::new(c));
            c = (c - slope.hi / bend).clamp(a, b);
        }
        let [(f, margin), (slope, more)] = self.along.value(Wide::new(c));
        let g = sign * f.hi;
        let fall = (slope.hi.abs() + more) * (b - a) * 1.001;
        if g > fall + margin * 1.001 {
            return Some(Truth::Free);
        }
        if g < -margin && c > a {
            return self.by_signs(a, c, before);
        }
        None
    }

    /// What the sign at b says where one root at most can lie in [a, b].
    fn by_signs(&self, a: f64, b: f64, before: i32) -> Option<Truth> {
        match self.along.sign(Wide::new(b)) {
            Some(0) | None => None,
            Some(sign) if sign == before => Some(Truth::Free),
            Some(_) => Some(Truth::Root {
                lo: a,
                hi: b,
                before,
            }),
        }
    }

    /// Bounds of f'' = −Σ e^q·(q'² + q'') over [a, b].
    fn curvature(&self, a: f64, b: f64) -> Bounds {
        let (mut all, mut sizes) = ([0.0; 2], 1.0);
        for c in &self.terms {
            let [low, high] = exponent(c, a, b).map(f64::exp);
            let ends = [c[1] + 2.0 * c[2] * a, c[1] + 2.0 * c[2] * b];
            let squares = ends.map(|x| x * x);
            let least = if ends[0] * ends[1] <= 0.0 {
                0.0
            } else {
                squares[0].min(squares[1])
            };
            let bend = [least + 2.0 * c[2], squares[0].max(squares[1]) + 2.0 * c[2]];
            all[0] += bend[0] * if bend[0] < 0.0 { high } else { low };
            all[1] += bend[1] * if bend[1] < 0.0 { low } else { high };
            sizes += high * (1.0 + squares[0].max(squares[1]) + 2.0 * c[2].abs());
        }
        [-all[1] - MARGIN * sizes, -all[0] + MARGIN * sizes]
    }

    /// Bounds of f and f' over [a, b]: f by its terms' ranges, and by f(m) + f'·(s − m).
    fn bounds(&self, a: f64, b: f64) -> (Bounds, Bounds) {
        let middle = 0.5 * (a + b);
        let (mut value, mut slope, mut at_middle) = ([0.0; 2], [0.0; 2], 0.0);
        let mut sizes = [1.0, 1.0];
        for c in &self.terms {
            let [low, high] = exponent(c, a, b).map(f64::exp);
            let ends = [c[1] + 2.0 * c[2] * a, c[1] + 2.0 * c[2] * b];
            let rate = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            value[0] += low;
            value[1] += high;
            at_middle += (c[0] + middle * (c[1] + middle * c[2])).exp();
            slope[0] += rate[0] * if rate[0] < 0.0 { high } else { low };
            slope[1] += rate[1] * if rate[1] < 0.0 { low } else { high };
            sizes[0] += high;
            sizes[1] += high * (1.0 + rate[0].abs().max(rate[1].abs()));
        }
        let level = self.along.level();
        let slope = [-slope[1] - MARGIN * sizes[1], -slope[0] + MARGIN * sizes[1]];
        let reach = 0.5 * (b - a) * slope[0].abs().max(slope[1].abs());
        let near = level - at_middle;
        let margin = MARGIN * sizes[0];
        let value = [
            (level - value[1]).max(near - reach) - margin,
            (level - value[0]).min(near + reach) + margin,
        ];
        (value, slope)
    }
}

/// The range of c₀ + c₁s + c₂s², c₂ ≤ 0, over [a, b].
fn exponent(c: &[f64; 3], a: f64, b: f64) -> Bounds {
    let at = |s: f64| c[0] + s * (c[1] + s * c[2]);
    let (left, right) = (at(a), at(b));
    let vertex = -0.5 * c[1] / c[2];
    let top = if a < vertex && vertex < b {
        at(vertex)
    } else {
        left.max(right)
    };
    [left.min(right), top.max(left).max(right)]
}
