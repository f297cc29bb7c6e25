//! The names of the formula language, in plain `f64`: what `Surface::at` calls, and what an editor shows for a name.

macro_rules! functions {
    ($($(#[$doc:meta])* $name:ident($($argument:ident),*) = $value:expr;)*) => {
        $($(#[$doc])*
        #[inline(always)]
        #[must_use]
        pub fn $name($($argument: f64),*) -> f64 {
            $value
        })*
    };
}

/// The x coordinate of the point.
#[inline(always)]
#[must_use]
pub fn x(point: &[f64; 3]) -> f64 {
    point[0]
}

/// The y coordinate of the point.
#[inline(always)]
#[must_use]
pub fn y(point: &[f64; 3]) -> f64 {
    point[1]
}

/// The z coordinate of the point.
#[inline(always)]
#[must_use]
pub fn z(point: &[f64; 3]) -> f64 {
    point[2]
}

functions! {
    /// π = 3.14159…
    pi() = std::f64::consts::PI;
    /// τ = 2π = 6.28318…
    tau() = std::f64::consts::TAU;
    /// √a, for a ≥ 0.
    sqrt(a) = a.sqrt();
    /// ∛a, for all a.
    cbrt(a) = a.cbrt();
    /// |a|. It has a kink at 0.
    abs(a) = a.abs();
    /// eᵃ.
    exp(a) = a.exp();
    /// 2ᵃ.
    exp2(a) = a.exp2();
    /// eᵃ − 1.
    exp_m1(a) = a.exp_m1();
    /// The natural logarithm, for a > 0.
    ln(a) = a.ln();
    /// ln(1 + a), for a > −1.
    ln_1p(a) = a.ln_1p();
    /// The logarithm to base 2, for a > 0.
    log2(a) = a.log2();
    /// The logarithm to base 10, for a > 0.
    log10(a) = a.log10();
    /// The sine of a in radians.
    sin(a) = a.sin();
    /// The cosine of a in radians.
    cos(a) = a.cos();
    /// The tangent of a in radians, off its poles.
    tan(a) = a.tan();
    /// The arc sine in [−π/2, π/2], for −1 ≤ a ≤ 1.
    asin(a) = a.asin();
    /// The arc cosine in [0, π], for −1 ≤ a ≤ 1.
    acos(a) = a.acos();
    /// The arc tangent in (−π/2, π/2).
    atan(a) = a.atan();
    /// The angle of the point (b, a) in (−π, π]: `atan2(y, x)`. It jumps across the negative axis.
    atan2(a, b) = a.atan2(b);
    /// The hyperbolic sine.
    sinh(a) = a.sinh();
    /// The hyperbolic cosine.
    cosh(a) = a.cosh();
    /// The hyperbolic tangent.
    tanh(a) = a.tanh();
    /// The inverse of `sinh`.
    asinh(a) = a.asinh();
    /// The inverse of `cosh` with values ≥ 0, for a ≥ 1.
    acosh(a) = a.acosh();
    /// The inverse of `tanh`, for −1 < a < 1.
    atanh(a) = a.atanh();
    /// √(a² + b²).
    hypot(a, b) = a.hypot(b);
    /// 1/a, for a ≠ 0.
    recip(a) = a.recip();
    /// The smaller of two numbers. It has a kink where they are equal.
    min(a, b) = if b < a { b } else { a };
    /// The larger of two numbers. It has a kink where they are equal.
    max(a, b) = if b > a { b } else { a };
    /// `a`, but not below `low` nor above `high`. It has a kink at both.
    clamp(a, low, high) = max(min(a, high), low);
}
