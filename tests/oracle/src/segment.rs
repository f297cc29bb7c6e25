//! Where a ray is inside a box, exactly.

use zeroset::camera::Ray;

use crate::dyadic::{Dyadic, Rational};

/// The corners of a box.
pub type Corners = [[f64; 3]; 2];

/// The first and the last parameter t ≥ 0 of the part of a ray inside a box; nothing if there is none.
pub fn clip(ray: &Ray, corners: &Corners) -> Option<(Rational, Rational)> {
    let mut near = Rational::dyadic(&Dyadic::whole(0));
    let mut far: Option<Rational> = None;
    let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
    let lines = origin.into_iter().zip(direction);
    for ((o, d), (&lo, &hi)) in lines.zip(corners[0].iter().zip(&corners[1])) {
        if d == 0.0 {
            if o < lo || o > hi {
                return None;
            }
            continue;
        }
        let reaches = |face: f64| {
            let way = Dyadic::float(face).sub(&Dyadic::float(o));
            Rational::quotient(&way, &Dyadic::float(d))
        };
        let (enters, leaves) = if d > 0.0 { (lo, hi) } else { (hi, lo) };
        let (enters, leaves) = (reaches(enters), reaches(leaves));
        if enters.compare(&near).is_gt() {
            near = enters;
        }
        if far.as_ref().is_none_or(|far| leaves.compare(far).is_lt()) {
            far = Some(leaves);
        }
    }
    let far = far?;
    near.compare(&far).is_le().then_some((near, far))
}

/// The exact parameter entry + t.
pub fn place(entry: f64, t: f64) -> Rational {
    Rational::dyadic(&Dyadic::float(entry).add(&Dyadic::float(t)))
}
