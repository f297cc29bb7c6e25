//! The paper's family: sums of exponentials of quadrics.


implicit! {
    /// The coefficients of x², y², z², xy, xz, yz, x, y, z and 1.
    #[derive(Clone)]
    pub struct ExponentialsOfQuadrics {
        /// A row for each term.
        pub rows: [[f64; 10]],
        /// What the terms sum up to on the surface.
        pub level: f64 = 0.5,
    }
    level = sum([a, b, c, d, e, f, g, h, i, j] in rows) {
        exp(a*x^2 + b*y^2 + c*z^2 + d*x*y + e*x*z + f*y*z + g*x + h*y + i*z + j)
    }
}
