//! A surface for each group of functions, and what the tests ask of it.

use zeroset::implicit;
use zeroset::interval::{Flags, Interval, Scalar};
use zeroset::ray::Rays;
use zeroset::surface::Surface;

/// Declares surfaces, and a function that visits each.
macro_rules! zoo {
    ($($name:ident { $($formula:tt)* })*) => {
        $(implicit! { #[derive(Clone)] pub struct $name; $($formula)* })*

        pub fn each(mut visit: impl FnMut(&str, &dyn Sample)) {
            $(visit(stringify!($name), &Wrapped($name));)*
        }
    };
}

zoo! {
    Polynomial { x^3*y - 2*x*y*z + z^4 - (x - y)^2*(y + 3)^3 + x^2 - 1 }
    Quotient { (x*y + 1)/(z^2 + 2) - x/(3 + y^2) + 1/(x^2 + y^2 + 4) }
    NegativePowers { (x + 5)^-2 + (y + 6)^-3*z + (x^2 + 1)^1.5 + (y^2 + 2)^-0.5 + (z^2 + 3)^0.3 }
    RealPower { (x^2 + 1)^(y/4) + 2^x - z }
    Roots { sqrt(x^2 + y^2 + 1)*z + cbrt(x + 9) - cbrt(z*y) }
    Exponentials { exp(x*y) + exp2(z - x) - exp_m1(y/2)*z }
    Logarithms { ln(x^2 + 2) + ln_1p(y^2)*z - log2(z^2 + 3) + log10(x + 7) }
    Circular { sin(x*y) + cos(y + z)*x - tan(z/4) }
    Arcs { asin(x/5)*y + acos(y/5) - atan(z*x) + atan2(x + 6, y*z + 1) }
    Hyperbolic { sinh(x) - cosh(y*z) + tanh(x + z)*y }
    Areas { asinh(x*z) + acosh(y^2 + 2) - atanh(z/6)*x }
    Distances { hypot(x - 3, y + 4) + abs(z - 4)*x + recip(y + 7) }
    Extremes { max(x - 5, y*z) + min(x*x, z + 9) + clamp(x*y, -20, 20) }
    Branches { if x + 5 < y - 5 || x > 8 && z > 0 { x*y } else if z < 10 { y*z^2 } else { 1 } }
    Sums { sum(i in 0..4) { sin(i*x + y)*(z - i)^2 } + prod(i in 1..4) { x + i*y*z } }
    Nested { sum(i in 0..3) { prod(j in 0..3) { x + i*y - j*z } * cos(i*x) } }
    FoldedExtremes { min(i in 0..3) { (x - 7*i)^2 + y*z } + max(i in 0..3) { y - 9*i + x*z } }
    Shared { let s = x*y + z; let q = s^2 - sin(s); q*s + q^3 }
}

/// What the tests ask of a surface, free of its type.
pub trait Sample {
    fn at(&self, p: [f64; 3]) -> f64;
    /// f, gradient and Hessian over a box, and whether the Hessian holds.
    fn space(&self, b: [Interval; 3]) -> ([Interval; 10], bool);
    /// f and its gradient alone.
    fn gradient(&self, b: [Interval; 3]) -> [Interval; 4];
    /// f and its derivatives over a segment of a ray.
    fn along(&self, o: [f64; 3], d: [f64; 3], t: Interval) -> Along;
}

/// f and its derivatives over a segment of a ray, by each entry point.
pub struct Along {
    pub curvature: [Interval; 3],
    pub slope: [Interval; 2],
    pub value: Interval,
    /// The second derivative holds.
    pub smooth: bool,
}

pub struct Wrapped<S>(pub S);

impl<S: Surface> Sample for Wrapped<S> {
    fn at(&self, p: [f64; 3]) -> f64 {
        self.0.at(p)
    }

    fn space(&self, b: [Interval; 3]) -> ([Interval; 10], bool) {
        let jet = S::hessian(Scalar, &self.0.prepare(), b);
        (jet.d, smooth(&jet.flags))
    }

    fn gradient(&self, b: [Interval; 3]) -> [Interval; 4] {
        S::gradient(Scalar, &self.0.prepare(), b).d
    }

    fn along(&self, o: [f64; 3], d: [f64; 3], t: Interval) -> Along {
        let prepared = self.0.prepare();
        let mut bound = S::unbound(Scalar);
        let rays = Rays {
            origin: o.map(point),
            direction: d.map(point),
            end: t.hi,
        };
        S::bind(
            Scalar,
            &prepared,
            &rays,
            &S::everything(&prepared),
            &mut bound,
        );
        let three = S::curvature(Scalar, &prepared, &bound, t);
        Along {
            curvature: three.d,
            slope: S::slope(Scalar, &prepared, &bound, t).d,
            value: S::value(Scalar, &prepared, &bound, t).d[0],
            smooth: smooth(&three.flags),
        }
    }
}

fn smooth(f: &Flags<Scalar>) -> bool {
    !(f.empty || f.undefined || f.jump || f.kink)
}

pub fn point(x: f64) -> Interval {
    Interval { lo: x, hi: x }
}
