//! The oracle's own copies of the polynomial formulas, along a ray, with exact coefficients. Literals are the decimal
//! numbers that they spell: a formula is multiplied by a positive whole number to clear them.

use zeroset::camera::Ray;

use crate::dyadic::Dyadic;
use crate::sturm::Poly;

/// The coordinates x, y, z along the ray.
fn coordinates(ray: &Ray) -> [Poly; 3] {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    std::array::from_fn(|k| Poly::line(o[k], d[k]))
}

fn whole(n: i64) -> Poly {
    Poly::number(&Dyadic::whole(n))
}

/// x² + y² + z²
fn square(p: &[Poly; 3]) -> Poly {
    p[0].square().add(&p[1].square()).add(&p[2].square())
}

/// 25(x² + y² + z²) − 16
pub fn sphere(ray: &Ray) -> Poly {
    square(&coordinates(ray)).times(25).sub(&whole(16))
}

/// (x² + y² + z² − radius²)², with the field's exact value.
pub fn doubled_sphere(ray: &Ray, radius: f64) -> Poly {
    let radius = Poly::number(&Dyadic::float(radius));
    square(&coordinates(ray)).sub(&radius.square()).square()
}

/// ((x − 1/10)/(9/10))² + ((y + 1/20)/(3/5))² + (z/(7/20))² − 1 = ((10x − 1)/9)² + ((20y + 1)/12)² + (20z/7)² − 1,
/// times 252²; 252 is the least common multiple of 9, 12 and 7.
pub fn ellipsoid(ray: &Ray) -> Poly {
    let [x, y, z] = coordinates(ray);
    let x = x.times(10).sub(&whole(1)).times(28);
    let y = y.times(20).add(&whole(1)).times(21);
    let z = z.times(20).times(36);
    square(&[x, y, z]).sub(&whole(252 * 252))
}

/// (x² + y² + z² + R² − r²)² − 4R²(x² + y²): for R > r > 0 the zero set of (√(x² + y²) − R)² + z² − r². With
/// ρ = √(x² + y²) that is ρ² + z² + R² − r² = 2Rρ. Squared, the other branch (ρ + R)² + z² = r² is empty.
pub fn torus(ray: &Ray, major: f64, minor: f64) -> Poly {
    assert!(major > minor && minor > 0.0, "not a ring torus");
    let p = coordinates(ray);
    let major = Poly::number(&Dyadic::float(major)).square();
    let minor = Poly::number(&Dyadic::float(minor)).square();
    let shifted = square(&p).add(&major).sub(&minor);
    let flat = p[0].square().add(&p[1].square());
    shifted.square().sub(&major.times(4).mul(&flat))
}

/// (x² + y² + z² + 119/400)² − 36/25·(x² + y²), times 400².
pub fn torus_quartic(ray: &Ray) -> Poly {
    let p = coordinates(ray);
    let shifted = square(&p).times(400).add(&whole(119));
    let flat = p[0].square().add(&p[1].square());
    shifted.square().sub(&flat.times(400 * 400 / 25 * 36))
}

/// 1 − 5x, which is x·(1/x − 5): the same roots, as x = 0 is none.
pub fn pole(ray: &Ray) -> Poly {
    let [x, ..] = coordinates(ray);
    whole(1).sub(&x.times(5))
}
