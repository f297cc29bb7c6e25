//! The surfaces under test, as a user writes them.

use zeroset::implicit;

implicit! {
    /// A sphere of radius 0.8, by a decimal literal.
    #[derive(Clone)]
    pub struct Sphere;
    x^2 + y^2 + z^2 = 0.64
}

implicit! {
    /// An ellipsoid off the centre, by decimal literals.
    #[derive(Clone)]
    pub struct Ellipsoid;
    ((x - 0.1)/0.9)^2 + ((y + 0.05)/0.6)^2 + (z/0.35)^2 = 1
}

implicit! {
    /// A ring around the z axis, by its distance from a circle.
    #[derive(Clone)]
    pub struct Torus {
        /// The circle's radius.
        pub major: f64 = 0.6,
        /// The ring's own radius.
        pub minor: f64 = 0.25,
    }
    let ring = sqrt(x^2 + y^2) - major;
    ring^2 + z^2 = minor^2
}

implicit! {
    /// The same ring as a polynomial, R = 0.6 and r = 0.25 as decimal literals.
    #[derive(Clone)]
    pub struct TorusQuartic;
    (x^2 + y^2 + z^2 + 0.2975)^2 = 1.44*(x^2 + y^2)
}

implicit! {
    /// A sphere twice: f never changes its sign.
    #[derive(Clone)]
    pub struct DoubledSphere {
        /// The radius.
        pub radius: f64 = 0.8,
    }
    (x^2 + y^2 + z^2 - radius^2)^2
}

implicit! {
    /// Exponentials of quadratics around centres.
    #[derive(Clone)]
    pub struct Exponentials {
        /// Centre, then the coefficients of dx², dy², dz², dx·dy, dx·dz, dy·dz.
        pub rows: [[f64; 9]],
        /// What the sum is compared with.
        pub level: f64 = 0.5,
    }
    level = sum([u, v, w, a, b, c, d, e, f] in rows) {
        exp(-(a*(x - u)^2 + b*(y - v)^2 + c*(z - w)^2
            + d*(x - u)*(y - v) + e*(x - u)*(z - w) + f*(y - v)*(z - w)))
    }
}

implicit! {
    /// A plane, x = 1/5, and a pole at x = 0, where the sign changes without a root.
    #[derive(Clone)]
    pub struct Pole;
    1/x - 5
}
