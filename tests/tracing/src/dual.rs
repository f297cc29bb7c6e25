//! Forward differentiation over any number system: plain, and looser than what the compiler emits.

use zeroset::interval::{
    Arithmetic, Flags, Interval, Jet, Leaves, Linear, Packet, Parameter, Rebind,
};
use zeroset::ray::Rays;
use zeroset::surface::{Active, Continuity, Operations, ParameterError, Report, Surface};

/// A value with its first two derivatives along a line.
#[derive(Clone, Copy)]
pub struct Dual<A: Arithmetic> {
    /// Value, first and second derivative.
    pub d: [A::Value; 3],
    /// What the operations said.
    pub flags: Flags<A::Packet>,
}

/// A formula in x, y and z.
pub trait Formula: Copy + Send + Sync + 'static {
    /// The name in reports.
    const NAME: &'static str;
    /// f
    fn f<A: Arithmetic>(&self, a: A, p: [Dual<A>; 3]) -> Dual<A>;
}

/// Operations on [`Dual`]s.
pub trait Duals: Arithmetic {
    /// A constant.
    #[inline(always)]
    fn number(self, c: f64) -> Dual<Self> {
        let zero = self.constant(&Interval::ZERO);
        Dual {
            d: [self.constant(&Interval::point(c)), zero, zero],
            flags: self.clear(),
        }
    }
    /// a + b
    #[inline(always)]
    fn plus(self, a: Dual<Self>, b: Dual<Self>) -> Dual<Self> {
        let d = [
            self.add(a.d[0], b.d[0]),
            self.add(a.d[1], b.d[1]),
            self.add(a.d[2], b.d[2]),
        ];
        Dual {
            d,
            flags: self.join(a.flags, b.flags),
        }
    }
    /// a − b
    #[inline(always)]
    fn minus(self, a: Dual<Self>, b: Dual<Self>) -> Dual<Self> {
        let d = [
            self.sub(a.d[0], b.d[0]),
            self.sub(a.d[1], b.d[1]),
            self.sub(a.d[2], b.d[2]),
        ];
        Dual {
            d,
            flags: self.join(a.flags, b.flags),
        }
    }
    /// a·b
    #[inline(always)]
    fn times(self, a: Dual<Self>, b: Dual<Self>) -> Dual<Self> {
        let two = self.constant(&Interval::point(2.0));
        let first = self.add(self.mul(a.d[1], b.d[0]), self.mul(a.d[0], b.d[1]));
        let cross = self.mul(two, self.mul(a.d[1], b.d[1]));
        let second = self.add(
            self.add(self.mul(a.d[2], b.d[0]), cross),
            self.mul(a.d[0], b.d[2]),
        );
        Dual {
            d: [self.mul(a.d[0], b.d[0]), first, second],
            flags: self.join(a.flags, b.flags),
        }
    }
    /// The chain rule: g(a) with g, g', g'' at a.
    #[inline(always)]
    fn chain(self, g: [Self::Value; 3], a: Dual<Self>, flags: Flags<Self::Packet>) -> Dual<Self> {
        let first = self.mul(g[1], a.d[1]);
        let second = self.add(self.mul(g[2], self.sqr(a.d[1])), self.mul(g[1], a.d[2]));
        Dual {
            d: [g[0], first, second],
            flags: self.join(a.flags, flags),
        }
    }
    /// a²
    #[inline(always)]
    fn squared(self, a: Dual<Self>) -> Dual<Self> {
        let two = self.constant(&Interval::point(2.0));
        self.chain(
            [self.sqr(a.d[0]), self.mul(two, a.d[0]), two],
            a,
            self.clear(),
        )
    }
    /// a³
    #[inline(always)]
    fn cubed(self, a: Dual<Self>) -> Dual<Self> {
        let three = self.constant(&Interval::point(3.0));
        let six = self.constant(&Interval::point(6.0));
        let g = [
            self.powi(a.d[0], 3),
            self.mul(three, self.sqr(a.d[0])),
            self.mul(six, a.d[0]),
        ];
        self.chain(g, a, self.clear())
    }
    /// eᵃ
    #[inline(always)]
    fn exponential(self, a: Dual<Self>) -> Dual<Self> {
        let e = self.exp(a.d[0]);
        self.chain([e, e, e], a, self.clear())
    }
    /// 1/a
    #[inline(always)]
    fn inverse(self, a: Dual<Self>) -> Dual<Self> {
        let (r, flags) = self.recip(a.d[0]);
        let two = self.constant(&Interval::point(2.0));
        let square = self.sqr(r);
        self.chain(
            [r, self.neg(square), self.mul(two, self.mul(square, r))],
            a,
            flags,
        )
    }
    /// √a
    #[inline(always)]
    fn root(self, a: Dual<Self>) -> Dual<Self> {
        let (s, flags) = self.sqrt(a.d[0]);
        let half = self.constant(&Interval::point(0.5));
        let quarter = self.constant(&Interval::point(-0.25));
        let (r, at_zero) = self.recip(s);
        let (by_a, at_zero_too) = self.div(r, a.d[0]);
        let flags = Flags {
            empty: flags.empty,
            ..self.join(self.join(flags, at_zero), at_zero_too)
        };
        self.chain([s, self.mul(half, r), self.mul(quarter, by_a)], a, flags)
    }
    /// |a|
    #[inline(always)]
    fn magnitude(self, a: Dual<Self>) -> Dual<Self> {
        let (s, flags) = self.abs_slope(a.d[0]);
        let zero = self.constant(&Interval::ZERO);
        self.chain([self.abs(a.d[0]), s, zero], a, flags)
    }
}

impl<A: Arithmetic> Duals for A {}

/// A formula as a surface in a box.
#[derive(Clone, Copy)]
pub struct Hand<F> {
    /// The formula.
    pub formula: F,
    /// Its box.
    pub domain: [[f64; 3]; 2],
}

impl<F: Formula> Hand<F> {
    /// A formula in the cube of this half width around the origin.
    #[inline(always)]
    pub fn new(formula: F, half: f64) -> Self {
        Hand {
            formula,
            domain: [[-half; 3], [half; 3]],
        }
    }

    #[inline(always)]
    fn along<A: Arithmetic, T: Parameter<A>>(
        formula: &F,
        a: A,
        bound: &[<T::Leaves as Leaves>::Linear; 3],
        t: T,
    ) -> Dual<A> {
        let zero = a.constant(&Interval::ZERO);
        let mut p = [a.number(0.0); 3];
        for (x, leaf) in p.iter_mut().zip(bound) {
            x.d = [t.linear(a, leaf), t.linear_slope(a, leaf), zero];
        }
        formula.f(a, p)
    }

    /// f at a point with its derivative along one axis.
    #[inline(always)]
    fn in_space<A: Arithmetic>(formula: &F, a: A, point: [A::Value; 3], axis: usize) -> Dual<A> {
        let mut p = [a.number(0.0); 3];
        for (k, x) in p.iter_mut().enumerate() {
            x.d[0] = point[k];
            if k == axis {
                x.d[1] = a.constant(&Interval::ONE);
            }
        }
        formula.f(a, p)
    }
}

impl<F: Formula> Surface for Hand<F> {
    const REPORT: Report = Report {
        name: F::NAME,
        degree: None,
        continuity: Continuity::Jumps,
        total: false,
        functions: &[],
        leaves: 3,
        polynomials: 0,
        surface_operations: 0,
        ray_operations: 0,
        segment: [Operations::NONE; 3],
        space: [Operations::NONE; 3],
    };
    type Prepared = F;
    type Bound<L: Leaves> = [L::Linear; 3];

    #[inline(always)]
    fn check(&self) -> Result<(), ParameterError> {
        Ok(())
    }
    #[inline(always)]
    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        Some(self.domain)
    }
    #[inline(always)]
    fn at(&self, point: [f64; 3]) -> f64 {
        use zeroset::interval::{Nearest, Scalar};
        Self::in_space(&self.formula, Nearest(Scalar), point, 0).d[0]
    }
    #[inline(always)]
    fn prepare(&self) -> F {
        self.formula
    }
    #[inline(always)]
    fn everything(_prepared: &F) -> Active {
        Active::default()
    }
    #[inline(always)]
    fn unbound<L: Leaves>(p: L::Packet) -> [L::Linear; 3] {
        [L::linear(p); 3]
    }
    #[inline(always)]
    fn bind_leaves<P: Packet>(
        p: P,
        _prepared: &F,
        rays: &Rays<P>,
        _active: &Active,
        bound: &mut [Linear<P>; 3],
    ) {
        for (axis, leaf) in bound.iter_mut().enumerate() {
            *leaf = Linear::new(p, rays.origin[axis], rays.direction[axis]);
        }
    }
    #[inline(always)]
    fn rebind<R: Rebind>(
        map: &R,
        from: &[<R::From as Leaves>::Linear; 3],
        _active: &Active,
        to: &mut [<R::To as Leaves>::Linear; 3],
    ) -> bool {
        *to = from.map(|leaf| map.linear(&leaf));
        true
    }
    #[inline(always)]
    fn value<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &F,
        bound: &[<T::Leaves as Leaves>::Linear; 3],
        t: T,
    ) -> Jet<A::Value, A::Packet, 1> {
        let f = Self::along(prepared, a, bound, t);
        Jet {
            d: [f.d[0]],
            flags: f.flags,
        }
    }
    #[inline(always)]
    fn slope<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &F,
        bound: &[<T::Leaves as Leaves>::Linear; 3],
        t: T,
    ) -> Jet<A::Value, A::Packet, 2> {
        let f = Self::along(prepared, a, bound, t);
        Jet {
            d: [f.d[0], f.d[1]],
            flags: f.flags,
        }
    }
    #[inline(always)]
    fn curvature<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &F,
        bound: &[<T::Leaves as Leaves>::Linear; 3],
        t: T,
    ) -> Jet<A::Value, A::Packet, 3> {
        let f = Self::along(prepared, a, bound, t);
        Jet {
            d: f.d,
            flags: f.flags,
        }
    }
    #[inline(always)]
    fn gradient<A: Arithmetic>(
        a: A,
        prepared: &F,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 4> {
        let x = Self::in_space(prepared, a, point, 0);
        let y = Self::in_space(prepared, a, point, 1);
        let z = Self::in_space(prepared, a, point, 2);
        Jet {
            d: [x.d[0], x.d[1], y.d[1], z.d[1]],
            flags: x.flags,
        }
    }
    #[inline(always)]
    fn hessian<A: Arithmetic>(
        _a: A,
        _prepared: &F,
        _point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 10> {
        unreachable!("the tracer does not use Hessians in space")
    }
}
