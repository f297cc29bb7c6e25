//! Sums of exponentials: signs to 85 bits, and where these do not tell, to 230 bits in whole numbers.

use num_bigint::BigInt;
use zeroset::camera::Ray;

use crate::dyadic::{Dyadic, sign};
use crate::exponential::{self, BITS};
use crate::wide::Wide;

/// Centre u, v, w, then the coefficients of dx², dy², dz², dx·dy, dx·dz, dy·dz.
pub type Row = [f64; 9];

/// f = level − Σ exp(−q_k(p − centre_k))
#[derive(Clone, Debug)]
pub struct Sum {
    /// A row for each term.
    pub rows: Vec<Row>,
    /// What the sum is compared with.
    pub level: f64,
}

/// f along a ray, s counted from `base`: −q_k = c₀ + c₁s + c₂s².
pub struct Along<'a> {
    sum: &'a Sum,
    ray: Ray,
    /// The ray's parameter at s = 0.
    pub base: f64,
    terms: Vec<[Wide; 3]>,
}

/// Coefficients and parameters up to here keep the margins that are claimed.
const LARGEST: f64 = 1e5;

impl Sum {
    /// f along a ray, for 0 ≤ s ≤ `length`.
    ///
    /// # Panics
    /// If a number is so large that the error bounds would not hold.
    pub fn along(&self, ray: &Ray, base: f64, length: f64) -> Along<'_> {
        let terms: Vec<[Wide; 3]> = self.rows.iter().map(|row| term(row, ray, base)).collect();
        for [c0, c1, c2] in &terms {
            let size = c0.hi.abs() + c1.hi.abs() * length + c2.hi.abs() * length * length;
            assert!(size < LARGEST, "a term of size {size}");
        }
        Along {
            sum: self,
            ray: *ray,
            base,
            terms,
        }
    }
}

/// −q along the ray. With a point p = p₀ + d·s and Δ = p₀ − centre, q is the quadratic form of Δ + d·s.
fn term(row: &Row, ray: &Ray, base: f64) -> [Wide; 3] {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    let delta: [Wide; 3] =
        std::array::from_fn(|k| Wide::new(base).times(d[k]) + Wide::new(o[k]) - Wide::new(row[k]));
    let d = d.map(Wide::new);
    let form = |p: &[Wide; 3], q: &[Wide; 3]| {
        let mut all = Wide::new(0.0);
        for (&a, (i, j)) in row[3..].iter().zip(PAIRS) {
            all = all + (p[i] * q[j]).times(-a);
        }
        all
    };
    [
        form(&delta, &delta),
        form(&delta, &d) + form(&d, &delta),
        form(&d, &d),
    ]
}

/// Which coordinates the coefficients of a row belong to.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl Along<'_> {
    /// The terms in plain floats.
    pub fn plain(&self) -> Vec<[f64; 3]> {
        self.terms.iter().map(|c| c.map(|c| c.hi)).collect()
    }

    /// What the sum is compared with.
    pub fn level(&self) -> f64 {
        self.sum.level
    }

    /// f and f' at s, and how far off each of them may be.
    ///
    /// Exponents are below 10⁵ in size and come from fewer than 50 operations, each relatively within 2⁻¹⁰⁰ of the
    /// largest part, so they are right within 2⁻⁷⁵. So are the exponentials, relatively, and the sum relatively to
    /// the sum of the terms' sizes: 2⁻⁷⁰ of it is a wide margin. A term below e⁻¹⁰⁰ is left out: it is below 2⁻¹⁴⁴, and
    /// its slope below 2⁻¹²⁰.
    pub fn value(&self, s: Wide) -> [(Wide, f64); 2] {
        let (mut value, mut slope) = (Wide::new(self.sum.level), Wide::new(0.0));
        let mut sizes = [self.sum.level.abs() + 1.0, 1.0];
        for &[c0, c1, c2] in &self.terms {
            let q = c0 + s * (c1 + s * c2);
            if q.hi > -100.0 {
                let e = q.exp();
                let bend = s * c2.times(2.0);
                value = value - e;
                slope = slope - e * (c1 + bend);
                sizes[0] += e.hi;
                sizes[1] += e.hi * (1.0 + c1.hi.abs() + bend.hi.abs());
            }
        }
        let margin = 2f64.powi(-70);
        [(value, sizes[0] * margin), (slope, sizes[1] * margin)]
    }

    /// The sign of f at s; nothing if 230 bits do not tell.
    pub fn sign(&self, s: Wide) -> Option<i32> {
        let [(f, margin), _] = self.value(s);
        if f.hi.abs() > margin {
            return Some(if f.hi > 0.0 { 1 } else { -1 });
        }
        self.exact_sign(s)
    }

    /// The same in whole numbers: the exponents are exact, and each exponential is right within 2^(80 − BITS).
    fn exact_sign(&self, s: Wide) -> Option<i32> {
        let t = [self.base, s.hi, s.lo].map(Dyadic::float);
        let t = t[0].add(&t[1]).add(&t[2]);
        let (o, d) = (self.ray.origin.to_array(), self.ray.direction.to_array());
        let mut f = Dyadic::float(self.sum.level).floor_shifted(BITS);
        for row in &self.sum.rows {
            let delta: [Dyadic; 3] = std::array::from_fn(|k| {
                let point = Dyadic::float(o[k]).add(&Dyadic::float(d[k]).mul(&t));
                point.sub(&Dyadic::float(row[k]))
            });
            let mut q = Dyadic::whole(0);
            for (&a, (i, j)) in row[3..].iter().zip(PAIRS) {
                q = q.sub(&Dyadic::float(a).mul(&delta[i]).mul(&delta[j]));
            }
            // Below e⁻²⁴⁰ < 2⁻³²⁰: less than the error of the others.
            if q.add(&Dyadic::whole(240)).sign() > 0 {
                f -= exponential::exp(&q);
            }
        }
        let error = BigInt::from(self.sum.rows.len() + 1) << 80;
        let certain = f > error || f < -error;
        certain.then(|| sign(&f))
    }
}
