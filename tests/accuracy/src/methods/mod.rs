//! The usual methods, in plain `f64` on packets of eight rays.

mod march;
mod newton;
mod polynomial;
mod segment;
mod sphere;

use std::fmt;

use zeroset::interval::{Packet, Routine};

use crate::probe::Counted;

pub use polynomial::DEGREES;

/// A method with its setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// So many equal steps, and regula falsi (Illinois) in the first that changes the sign.
    Marching(u32),
    /// Steps |f|/L for the least L ≥ |∇f| in the box, at most so many (Hart 1996).
    Sphere(u32),
    /// Steps |f|/λ for λ ≥ |f'| on a piece of the ray, at most so many (Galin et al. 2020).
    Segment(u32),
    /// So many equal steps, and Newton's iteration from the middle of the first that changes the sign.
    Newton(u32),
    /// The polynomial along the ray: roots of its derivatives, one after the other, part it into monotone pieces, in
    /// which safeguarded Newton steps find the roots (Yuksel 2022).
    Polynomial(u32),
}

impl Method {
    /// The settings to choose from. `degree` is that of the formula, if it is a polynomial.
    pub fn ladder(degree: Option<u32>) -> Vec<Vec<Method>> {
        let steps = [8, 16, 32, 64, 128, 256, 512, 1024, 2048];
        let most = [64, 256, 1024, 4096];
        let mut all = vec![
            steps.map(Method::Marching).to_vec(),
            most.map(Method::Sphere).to_vec(),
            most.map(Method::Segment).to_vec(),
            steps.map(Method::Newton).to_vec(),
        ];
        if let Some(degree) = degree.filter(|degree| DEGREES.contains(degree)) {
            all.push(vec![Method::Polynomial(degree)]);
        }
        all
    }

    /// Without the setting.
    pub fn name(self) -> &'static str {
        match self {
            Method::Marching(_) => "marching and secant",
            Method::Sphere(_) => "sphere tracing",
            Method::Segment(_) => "segment tracing",
            Method::Newton(_) => "marching and Newton",
            Method::Polynomial(_) => "polynomial solver",
        }
    }

    /// Steps, or the degree.
    pub fn setting(self) -> u32 {
        match self {
            Method::Marching(n)
            | Method::Sphere(n)
            | Method::Segment(n)
            | Method::Newton(n)
            | Method::Polynomial(n) => n,
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.name(), self.setting())
    }
}

/// A search for the first root of each ray of a packet.
pub struct Search<'a, P: Packet> {
    /// The method.
    pub method: Method,
    /// The surface.
    pub probe: &'a Counted<'a, P>,
    /// The rays are of interest for t from 0 to this; negative where there is no ray.
    pub end: P::F,
    /// How far from the root the answer may be, in t.
    pub tolerance: P::F,
    /// 1/L in t: at a distance of |f|·`reach` there is no root.
    pub reach: P::F,
}

impl<P: Packet> Routine<P> for Search<'_, P> {
    /// t, and NaN where no root was found.
    type Output = P::F;

    #[inline(always)]
    fn call(self, p: P) -> P::F {
        match self.method {
            Method::Marching(steps) => march::trace(p, &self, steps),
            Method::Sphere(most) => sphere::trace(p, &self, most),
            Method::Segment(most) => segment::trace(p, &self, most),
            Method::Newton(steps) => newton::trace(p, &self, steps),
            Method::Polynomial(degree) => polynomial::trace(p, &self, degree),
        }
    }
}
