//! Formulas with known answers.

use zeroset::interval::Arithmetic;

use crate::dual::{Dual, Duals, Formula};

/// |p|² − r²
#[derive(Clone, Copy)]
pub struct Sphere(pub f64);

impl Formula for Sphere {
    const NAME: &'static str = "sphere";
    #[inline(always)]
    fn f<A: Arithmetic>(&self, a: A, p: [Dual<A>; 3]) -> Dual<A> {
        let [x, y, z] = p;
        let square = a.plus(a.plus(a.squared(x), a.squared(y)), a.squared(z));
        a.minus(square, a.number(self.0 * self.0))
    }
}

/// (|p|² − r²)²
#[derive(Clone, Copy)]
pub struct DoubleSphere(pub f64);

impl Formula for DoubleSphere {
    const NAME: &'static str = "double sphere";
    #[inline(always)]
    fn f<A: Arithmetic>(&self, a: A, p: [Dual<A>; 3]) -> Dual<A> {
        a.squared(Sphere(self.0).f(a, p))
    }
}

/// (|p|² + R² − r²)² − 4R²(x² + y²)
#[derive(Clone, Copy)]
pub struct Torus {
    /// R
    pub major: f64,
    /// r
    pub minor: f64,
}

impl Formula for Torus {
    const NAME: &'static str = "torus";
    #[inline(always)]
    fn f<A: Arithmetic>(&self, a: A, p: [Dual<A>; 3]) -> Dual<A> {
        let [x, y, z] = p;
        let flat = a.plus(a.squared(x), a.squared(y));
        let square = a.plus(flat, a.squared(z));
        let shifted = a.plus(
            square,
            a.number(self.major * self.major - self.minor * self.minor),
        );
        a.minus(
            a.squared(shifted),
            a.times(a.number(4.0 * self.major * self.major), flat),
        )
    }
}

/// Functions of x alone: along the x axis they are functions of one variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// x − c
    Plane(f64),
    /// (x − 1)² − e
    Sheets(f64),
    /// (x − 1)³
    Cube,
    /// (x − 1)²(x − 2)
    DoubleThenSingle,
    /// 1/x − 5
    Pole,
    /// √x − ½
    Root,
    /// √(x − 1)
    RootAtBorder,
    /// |x − 1| − ½
    Kink,
    /// |x − 1|
    Touch,
    /// y: the x axis lies in the surface.
    Flat,
    /// eˣ − x − 1
    Exponential,
    /// x·(x² − 2)
    ThreeRoots,
}

impl Formula for Line {
    const NAME: &'static str = "a function of x";
    #[inline(always)]
    fn f<A: Arithmetic>(&self, a: A, [x, y, _]: [Dual<A>; 3]) -> Dual<A> {
        let shifted = a.minus(x, a.number(1.0));
        match *self {
            Line::Plane(c) => a.minus(x, a.number(c)),
            Line::Sheets(e) => a.minus(a.squared(shifted), a.number(e)),
            Line::Cube => a.cubed(shifted),
            Line::DoubleThenSingle => a.times(a.squared(shifted), a.minus(x, a.number(2.0))),
            Line::Pole => a.minus(a.inverse(x), a.number(5.0)),
            Line::Root => a.minus(a.root(x), a.number(0.5)),
            Line::RootAtBorder => a.root(shifted),
            Line::Kink => a.minus(a.magnitude(shifted), a.number(0.5)),
            Line::Touch => a.magnitude(shifted),
            Line::Flat => y,
            Line::Exponential => a.minus(a.minus(a.exponential(x), x), a.number(1.0)),
            Line::ThreeRoots => a.times(x, a.minus(a.squared(x), a.number(2.0))),
        }
    }
}
