//! The cases.

use zeroset::implicit;
use zeroset::verdict::Why;

use crate::Case;
use crate::expected::Expected::{self, Crossing, Hit, Near, Noise, Open, Root, Tangent};

/// An ulp around 0.8.
const ULP: f64 = 1.0 / (1u64 << 53) as f64;

macro_rules! cases {
    ($($what:literal: ($($f:tt)*) in $half:tt along $o:expr, $d:expr => [$($expected:expr),* $(,)?];)*) => {
        /// All cases.
        pub fn cases() -> Vec<Case> {
            vec![$(Case::new(
                $what,
                stringify!($($f)*),
                implicit!($($f)*),
                $half,
                [$o, $d],
                vec![$($expected),*],
            )),*]
        }
    };
}

cases! {
    // Far away.
    "from 10³ sizes away": (x^2 + y^2 + z^2 = 0.64) in 1.0 along [-1e3, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(999.2), Root(1000.8)];
    "from 10⁶ sizes away": (x^4 + y^4 + z^4 - x^2 = 0.25) in 2.0 along [-1e6, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(1e6 - 1.0986841134678098), Root(1e6 + 1.0986841134678098)];
    "from 10⁶ sizes away, a quadric": (x^2 + y^2 + z^2 = 0.25) in 1.0 along [-1e6, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(1e6 - 0.5), Root(1e6 + 0.5)];
    // Two sheets.
    "two sheets 2⁻⁴⁰ apart": (max(x^2 + y^2 + z^2 - 0.64, (0.8 - 2^-40)^2 - x^2 - y^2 - z^2)) in 1.0
        along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(1.2), Root(1.2 + 2f64.powi(-40)), Root(2.8 - 2f64.powi(-40)), Root(2.8)];
    "a shell, 0.001 thick": (max(x^2 + y^2 + z^2 - 0.64, 0.799^2 - x^2 - y^2 - z^2)) in 1.0
        along [-2.0, 0.3, 0.4], [1.0, 0.0, 0.0]
        => [Root(1.3755002001601602), Root(1.3767817396770212), Root(2.623218260322979), Root(2.62449979983984)];
    "two roots 2⁻⁴⁰ apart": (x*(x - 2^-40)*(1 + y^2)) in 1.0 along [-0.625, 0.0, 0.25], [1.0, 0.0, 0.0]
        => [
            Root(0.625).or(Hit(0.625, 1e-14)),
            Root(0.625 + 2f64.powi(-40)).or(Hit(0.625 + 2f64.powi(-40), 1e-14)),
        ];
    "two roots 2⁻⁵² apart": (exp(x)*(x - 0.5)*(x - 0.5 - 2^-52)) in 1.0 along [-0.625, 0.0, 0.25], [1.0, 0.0, 0.0]
        => [Tangent(1.125)];
    "two roots near noise": (exp(z)*cos(y) = cos(x)) in 10.0
        along [10.786609806268668, 4.7115428434696005, -1.8841801274891363],
            [-0.03260640643380925, 2.584853066223136e-05, 0.37886816488980696]
        => [Root(29.999982665857075), Root(30.000017334058032)];
    // Tangents.
    "tangent": (x^2 + y^2 + z^2 = 0.5625) in 1.0 along [-2.0, 0.75, 0.0], [1.0, 0.0, 0.0] => [Tangent(2.0)];
    "tangent, an ulp inside": (x^2 + y^2 + z^2 = 0.5625) in 1.0 along [-2.0, 0.75 - ULP, 0.0], [1.0, 0.0, 0.0]
        => [Root(2.0 - 1.2904784139758764e-8), Root(2.0 + 1.2904784139758764e-8)];
    "tangent, an ulp outside": (x^2 + y^2 + z^2 = 0.5625) in 1.0 along [-2.0, 0.75 + ULP, 0.0], [1.0, 0.0, 0.0] => [];
    "tangent to a torus": ((x^2 + y^2 + z^2 + 0.1875)^2 = x^2 + y^2) in 1.0 along [-2.0, 0.75, 0.0], [1.0, 0.0, 0.0]
        => [Tangent(2.0)];
    // 0.8 as an f64 is 4.4e-17 too large.
    "a miss by less than an ulp": (x^2 + y^2 + z^2 = 0.64) in 1.0 along [-2.0, 0.8, 0.0], [1.0, 0.0, 0.0] => [];
    "tangent to what is flat": ((y + 2)^0.5 + 1e-9*x^2 = 2^0.5) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Tangent(2.0)];
    "tangent to what is flat, where no second look is as sharp": (atan(y + 0.5) + 1e-9*x^2 = atan(0.5)) in 1.0
        along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Near(Why::Floor, 2.0, 1e-2)];
    "a triple root that no f64 is": (27*x^3 - 27*x^2 + 9*x = 1) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [
            Near(Why::Floor, 7.0/3.0 - 5e-6, 1e-5).or_nothing(),
            Near(Why::Floor, 7.0/3.0, 1e-2),
        ];
    // Singular points.
    "through a node": (x^2 + y^2 - z^2) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Tangent(2.0)];
    "through a node of Cayley's cubic": (4*(x^2 + y^2 + z^2) + 16*x*y*z = 1) in 1.5
        along [0.5, 0.5, -2.5], [0.0, 0.0, 1.0] => [Tangent(2.0)];
    "through two cusps": (x^2 + z^2 - y^3*(1 - y)^3) in 1.2 along [0.0, -1.0, 0.0], [0.0, 1.0, 0.0]
        => [Crossing(1.0), Crossing(2.0)];
    "across a cusp": (x^2 + z^2 - y^3*(1 - y)^3) in 1.2 along [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Tangent(1.0)];
    "along a double line": (x^2 - y^2*z) in 1.5 along [0.0, 0.0, -2.0], [0.0, 0.0, 1.0]
        => [Open(Why::Flat, 0.5, 3.5)];
    "along a line of Himmel": (x^2 - y^2*z^2) in 1.5 along [0.0, -2.0, 0.0], [0.0, 1.0, 0.0]
        => [Open(Why::Flat, 0.5, 3.5)];
    // Doubled.
    "a doubled sphere": ((x^2 + y^2 + z^2 - 0.5625)^2) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Tangent(1.25), Tangent(2.75)];
    "a doubled wave": (sin(x + y)^2) in 1.0 along [-2.0, 0.5, 0.0], [1.0, 0.0, 0.0] => [Tangent(1.5)];
    "an isolated point": (x^2 + y^2 + z^2) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Tangent(2.0)];
    "beside an isolated point": (x^2 + y^2 + z^2) in 1.0 along [-2.0, 1e-150, 0.0], [1.0, 0.0, 0.0]
        => [Tangent(2.0)];
    "beside an isolated point by 10⁻⁷": (x^2 + y^2 + z^2) in 1.0 along [-2.0, 1e-7, 0.0], [1.0, 0.0, 0.0] => [];
    // f∘ray ≡ 0.
    "inside a plane": (y) in 1.0 along [-2.0, 0.0, 0.3], [1.0, 0.0, 0.1] => [Open(Why::Flat, 1.0, 3.0)];
    "f∘ray ≡ 0": (x*sin(y) + z^3*exp(x)) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Open(Why::Flat, 1.0, 3.0)];
    "f∘ray ≡ 0 by cancellation": (sin(x + y) - sin(x)*cos(y) - cos(x)*sin(y)) in 1.0
        along [-2.0, 0.1, 0.3], [1.0, 0.2, 0.1] => [Open(Why::Flat, 1.0, 3.0)];
    "f∘ray ≡ 0 after a root": ((x + 0.5)*(abs(y) + max(x, 0) - x)) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(1.5), Open(Why::Flat, 2.0, 3.0)];
    // Directions and origins.
    "zero direction components": (x^3 + y^2 + z^2 = 0.64) in 1.0 along [0.25, -2.0, -0.5], [0.0, 1.0, -0.0]
        => [Root(2.0 - 0.374375f64.sqrt()), Root(2.0 + 0.374375f64.sqrt())];
    "an origin on the surface": (x^2 + y^2 + z^2 = 0.5625) in 1.0 along [0.75, 0.0, 0.0], [-1.0, 0.0, 0.0]
        => [Root(0.0).or(Near(Why::Floor, 0.0, 1e-6)), Root(1.5)];
    "an origin on the surface, outward": (x^3 + y^2 + z^2 = 0.421875) in 1.0 along [0.75, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(0.0).or(Near(Why::Floor, 0.0, 1e-6))];
    "a root on the face of entry": (x^3 + x + y + 2) in 1.0 along [-3.0, 0.0, 0.5], [1.0, 0.0, 0.0] => [Root(2.0)];
    "a root on the face of exit": (x^3 + x + y - 2) in 1.0 along [-3.0, 0.0, 0.5], [1.0, 0.0, 0.0] => [Root(4.0)];
    // Huge exponents.
    "|x|⁵⁰⁰": (abs(x)^500 + 0.5*abs(y)^35 + 0.5*z^4 = 1) in 1.3 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(1.0), Root(3.0)];
    "|x|⁵⁰⁰, beside the flat middle": (abs(x)^500 + 0.5*abs(y)^35 + 0.5*z^4 = 1) in 1.3
        along [0.0, 0.0, -2.0], [0.0, 0.0, 1.0] => [Root(2.0 - 2f64.powf(0.25)), Root(2.0 + 2f64.powf(0.25))];
    "|x|⁵⁰⁰ = 0": (abs(x)^500) in 1.0 along [-2.0, 0.3, 0.0], [1.0, 0.0, 0.0] => [Open(Why::Flat, 1.75, 2.25)];
    // Overflow.
    "exp to ∞": (exp(1000*x^2) - exp(1000*y^2)) in 2.0 along [-3.0, 0.25, 0.0], [1.0, 0.0, 0.0]
        => [Root(2.75), Root(3.25)];
    "∞ − ∞": (exp(1000*x^2) - exp(1000*x^2 + y^2)) in 2.0 along [-3.0, 0.25, 0.0], [1.0, 0.0, 0.0]
        => [Open(Why::Flat, 1.0, 2.157).or(Open(Why::Flat, 1.0, 5.0)), Open(Why::Flat, 3.843, 5.0).or_nothing()];
    "huge coefficients": (1e300*(x^2 + y^2 + z^2) = 0.64e300) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(1.2), Root(2.8)];
    "huge coefficients, beyond f64": (1e200*x*(1e200*x^2 + 1)) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Root(2.0).or(Hit(2.0, 1e-6))];
    // Domains.
    "ln across its domain": (ln(x) + y) in 2.0 along [-3.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Root(4.0)];
    "sqrt across its domain": (sqrt(x^2 - 0.25) - 0.5) in 1.0 along [-2.0, 0.1, 0.0], [1.0, 0.0, 0.0]
        => [Root(2.0 - 0.5f64.sqrt()), Root(2.0 + 0.5f64.sqrt())];
    "a root at the border of the domain": (sqrt(x) + y) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Near(Why::Undefined, 2.0, 1e-6)];
    "a sign change at a pole": (1/x - 5) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Near(Why::Undefined, 2.0, 1e-6).or_nothing(), Root(2.2)];
    "nested roots": (sqrt(sqrt(x) - 0.5) - 0.5) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Root(2.5625)];
    "poles of tan": (tan(4*x) - y) in 1.0 along [-2.0, 0.5, 0.0], [1.0, 0.0, 0.0]
        => [
            Root(2.0 + (0.5f64.atan() - std::f64::consts::PI) / 4.0),
            Near(Why::Undefined, 2.0 - std::f64::consts::FRAC_PI_8, 1e-6).or_nothing(),
            Root(2.0 + 0.5f64.atan() / 4.0),
            Near(Why::Undefined, 2.0 + std::f64::consts::FRAC_PI_8, 1e-6).or_nothing(),
            Root(2.0 + (0.5f64.atan() + std::f64::consts::PI) / 4.0),
        ];
    "the cut of atan2": (atan2(y, x) - 1) in 1.0 along [-0.5, -2.0, 0.0], [0.0, 1.0, 0.0]
        => [Near(Why::Undefined, 2.0, 1e-6).or_nothing()];
    "atan2": (atan2(y, x) - 1) in 1.0 along [-2.0, 0.5, 0.0], [1.0, 0.0, 0.0] => [Root(2.0 + 0.5 / 1f64.tan())];
    "fractional exponents": ((x + 1)^1.5 + y^0.25 - 2) in 1.0 along [-2.0, 0.0625, 0.0], [1.0, 0.0, 0.0]
        => [Root(1.0 + 1.5f64.powf(2.0 / 3.0))];
    "a kink through 0": (abs(x) - abs(y)) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Near(Why::Floor, 2.0, 1e-6)];
    "a branch that jumps": (if x > 0 { x + 1 } else { x - 1 }) in 2.0 along [-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [Near(Why::Undefined, 3.0, 1e-6).or_nothing()];
    // Periods.
    "sin of 10¹⁵": (sin(1e15 + x) - y) in 4.0 along [-5.0, 0.25, 0.0], [1.0, 0.0, 0.0]
        => [Expected::wide(5.0 - 1.857017861928034, 0.7), Expected::wide(5.0 + 0.779214281377602, 0.1)];
    "sin of 10¹⁵·x": (sin(1e15*x) + 2*y) in 1.0 along [-2.0, 0.25, 0.0], [1.0, 0.0, 0.0]
        => [Noise, Open(Why::Budget, 1.0, 3.0)];
    "a root, then sin of 10¹⁵·x": ((x + 0.5)*(2.5 + sin(1e15*max(x, 0)) - 2*cos(1e15*max(x, 0)))) in 1.0
        along [-2.0, 0.25, 0.0], [1.0, 0.0, 0.0] => [Root(1.5), Noise, Open(Why::Budget, 2.0, 3.0)];
    // Denormals.
    "denormal coefficients": (1e-310*x^3 - 1e-310*y) in 1.0 along [-2.0, 0.125, 0.0], [1.0, 0.0, 0.0]
        => [Root(2.5).or(Hit(2.5, 1e-12))];
    "the least coefficient": (5e-324*x^3 - 5e-324*y) in 1.0 along [-2.0, 0.125, 0.0], [1.0, 0.0, 0.0]
        => [Open(Why::Flat, 1.0, 3.0)];
    "a high root": (1 - x^20*y) in 1.0 along [-2.0, 1.0, 0.0], [1.0, 0.0, 0.0] => [Root(1.0), Root(3.0)];
    "a root of order 21": ((x - 0.25)^21) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0] => [Crossing(2.25)];
    "Wilkinson": (prod(k in 1..11) { 12*x - k }) in 1.0 along [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        => [
            Root(2.0 + 1.0 / 12.0), Root(2.0 + 2.0 / 12.0), Root(2.25), Root(2.0 + 4.0 / 12.0), Root(2.0 + 5.0 / 12.0),
            Root(2.5), Root(2.0 + 7.0 / 12.0), Root(2.0 + 8.0 / 12.0), Root(2.75), Root(2.0 + 10.0 / 12.0),
        ];
}
