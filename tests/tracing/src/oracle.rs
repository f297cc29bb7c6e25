//! Judges an answer by exact arithmetic.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use zeroset::camera::Ray;
use zeroset::interval::Interval;
use zeroset::verdict::{Answer, Verdict};

use crate::exact::{Poly, Sturm, rational};

/// The ray's three coordinates as polynomials in t.
pub fn coordinates(ray: &Ray) -> [Poly; 3] {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    [
        Poly::line(o[0], d[0]),
        Poly::line(o[1], d[1]),
        Poly::line(o[2], d[2]),
    ]
}

/// The exact first and last parameter t ≥ 0 of a ray inside a box.
pub fn clip(ray: &Ray, domain: &[[f64; 3]; 2]) -> Option<(BigRational, BigRational)> {
    let mut near = BigRational::zero();
    let mut far: Option<BigRational> = None;
    #[allow(clippy::needless_range_loop)]
    for axis in 0..3 {
        let (o, d) = (ray.origin.to_array()[axis], ray.direction.to_array()[axis]);
        let (lo, hi) = (domain[0][axis], domain[1][axis]);
        if d == 0.0 {
            if o < lo || o > hi {
                return None;
            }
            continue;
        }
        let speed = rational(d);
        let a = (rational(lo) - rational(o)) / &speed;
        let b = (rational(hi) - rational(o)) / &speed;
        let (enters, leaves) = if speed.is_positive() { (a, b) } else { (b, a) };
        near = near.max(enters);
        far = Some(far.map_or(leaves.clone(), |f| f.min(leaves)));
    }
    let far = far?;
    (near <= far).then_some((near, far))
}

/// What there is to know about a polynomial along a ray inside a box.
pub struct Truth {
    /// The exact first and last parameter inside the box.
    span: Option<(BigRational, BigRational)>,
    /// Nothing where the polynomial is 0.
    roots: Option<Sturm>,
}

impl Truth {
    /// Counts the roots of `f` inside a box.
    pub fn new(f: &Poly, ray: &Ray, domain: &[[f64; 3]; 2]) -> Self {
        let roots = (!f.is_zero()).then(|| f.sturm());
        Truth {
            span: clip(ray, domain),
            roots,
        }
    }

    /// What is wrong with an answer; nothing if it is right.
    ///
    /// # Errors
    /// If it is wrong.
    pub fn judge(&self, answer: &Answer) -> Result<(), String> {
        let first = &answer.first;
        let Some((near, far)) = &self.span else {
            // A ray that passes the box within a rounding may be searched there.
            let fine = *first == Verdict::Miss || first.t().is_some_and(|t| t.width() < 1e-9);
            return if fine {
                Ok(())
            } else {
                Err(format!("a ray beside the box: {first:?}"))
            };
        };
        let Some(roots) = &self.roots else {
            let fine = matches!(first, Verdict::Unresolved { .. });
            return if fine {
                Ok(())
            } else {
                Err(format!("f is 0 along the ray: {first:?}"))
            };
        };
        let entry = rational(answer.entry);
        if *first != Verdict::Miss && entry > *near {
            return Err("the entry lies behind the box's face".into());
        }
        judge_one(roots, near, far, &entry, first, true)?;
        match &answer.behind {
            Some(behind) => judge_one(roots, near, far, &entry, behind, false),
            None => Ok(()),
        }
    }
}

fn place(entry: &BigRational, t: &Interval) -> (BigRational, BigRational) {
    (entry + rational(t.lo), entry + rational(t.hi))
}

fn judge_one(
    roots: &Sturm,
    near: &BigRational,
    far: &BigRational,
    entry: &BigRational,
    verdict: &Verdict,
    first: bool,
) -> Result<(), String> {
    let Some(t) = verdict.t() else {
        let count = roots.closed(near, far);
        return if count == 0 {
            Ok(())
        } else {
            Err(format!("called a miss, has {count} roots"))
        };
    };
    let (lo, hi) = place(entry, &t);
    let before = roots.before(near, &lo);
    if first && before > 0 {
        return Err(format!("{before} roots before {verdict:?}"));
    }
    let inside = roots.closed(&lo, &hi);
    match verdict {
        Verdict::Root { .. } if inside != 1 => Err(format!("{inside} roots in {verdict:?}")),
        Verdict::Crossing { .. } if inside == 0 => Err(format!("no root in {verdict:?}")),
        Verdict::Tangent { .. } if inside > 2 => Err(format!("{inside} roots in {verdict:?}")),
        _ => Ok(()),
    }
}
