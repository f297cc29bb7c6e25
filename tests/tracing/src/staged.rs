//! Two surfaces as the compiler would write them: leaves along the ray, and little per segment.

use zeroset::interval::{Arithmetic, Interval, Jet, Leaves, Packet, Parameter, Quadratic, Rebind};
use zeroset::ray::Rays;
use zeroset::surface::{Active, Continuity, Operations, ParameterError, Report, Surface};

/// Σ wᵢ·exp(−|p − cᵢ|²·sᵢ) − level: blobs; with no blob a sphere of radius `level` in closed form.
#[derive(Clone)]
pub struct Blobs {
    /// Centre, sharpness s, and weight w of each.
    pub blobs: Vec<[f64; 5]>,
    /// What is subtracted.
    pub level: f64,
    /// The box, if it has one of its own.
    pub domain: Option<[[f64; 3]; 2]>,
}

impl Blobs {
    /// Some blobs in a cube of half width 2, from a fixed sequence.
    #[inline(always)]
    pub fn some(count: usize) -> Self {
        let mut state = 12345u64;
        let mut random = move || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let blobs = (0..count)
            .map(|_| {
                let mut place = || 2.4 * random() - 1.2;
                let centre = [place(), place(), place()];
                [centre[0], centre[1], centre[2], 3.0 + 5.0 * random(), 1.0]
            })
            .collect();
        Blobs {
            blobs,
            level: 0.5,
            domain: Some([[-2.0; 3], [2.0; 3]]),
        }
    }
}

/// |p − c|² along rays.
#[inline(always)]
fn distance<P: Packet>(p: P, rays: &Rays<P>, centre: [f64; 3], scale: f64) -> Quadratic<P> {
    let zero = p.constant(&Interval::ZERO);
    let (mut c0, mut c1, mut c2) = (zero, zero, zero);
    for (axis, &centre) in centre.iter().enumerate() {
        let o = p.sub(rays.origin[axis], p.constant(&Interval::point(centre)));
        let d = rays.direction[axis];
        c0 = p.add(c0, p.sqr(o));
        c1 = p.add(c1, p.mul(o, d));
        c2 = p.add(c2, p.sqr(d));
    }
    let scale = p.constant(&Interval::point(scale));
    let two = p.constant(&Interval::point(2.0));
    Quadratic::new(
        p,
        p.mul(c0, scale),
        p.mul(p.mul(c1, two), scale),
        p.mul(c2, scale),
    )
}

impl Surface for Blobs {
    const REPORT: Report = Report {
        name: "blobs",
        degree: None,
        continuity: Continuity::Smooth,
        total: true,
        functions: &[],
        leaves: 1,
        polynomials: 0,
        surface_operations: 0,
        ray_operations: 0,
        segment: [Operations::NONE; 3],
        space: [Operations::NONE; 3],
    };
    type Prepared = Blobs;
    type Bound<L: Leaves> = Vec<L::Quadratic>;

    #[inline(always)]
    fn check(&self) -> Result<(), ParameterError> {
        Ok(())
    }
    #[inline(always)]
    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        self.domain
    }
    #[inline(always)]
    fn at(&self, _point: [f64; 3]) -> f64 {
        unreachable!("the tracer does not use plain values in space")
    }
    #[inline(always)]
    fn prepare(&self) -> Blobs {
        self.clone()
    }
    #[inline(always)]
    fn everything(_prepared: &Blobs) -> Active {
        Active::default()
    }
    #[inline(always)]
    fn unbound<L: Leaves>(_p: L::Packet) -> Vec<L::Quadratic> {
        Vec::new()
    }
    #[inline(always)]
    fn bind_leaves<P: Packet>(
        p: P,
        prepared: &Blobs,
        rays: &Rays<P>,
        _active: &Active,
        bound: &mut Vec<Quadratic<P>>,
    ) {
        bound.clear();
        for b in &prepared.blobs {
            bound.push(distance(p, rays, [b[0], b[1], b[2]], -b[3]));
        }
    }
    #[inline(always)]
    fn rebind<R: Rebind>(
        map: &R,
        from: &Vec<<R::From as Leaves>::Quadratic>,
        _active: &Active,
        to: &mut Vec<<R::To as Leaves>::Quadratic>,
    ) -> bool {
        to.clear();
        to.extend(from.iter().map(|leaf| map.quadratic(leaf)));
        true
    }
    #[inline(always)]
    fn value<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Blobs,
        bound: &Vec<<T::Leaves as Leaves>::Quadratic>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 1> {
        let mut f = a.constant(&Interval::point(-prepared.level));
        for leaf in bound {
            f = a.add(f, a.exp(t.quadratic(a, leaf)));
        }
        Jet {
            d: [f],
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn slope<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Blobs,
        bound: &Vec<<T::Leaves as Leaves>::Quadratic>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 2> {
        let mut f = a.constant(&Interval::point(-prepared.level));
        let mut d = a.constant(&Interval::ZERO);
        for leaf in bound {
            let e = a.exp(t.quadratic(a, leaf));
            f = a.add(f, e);
            d = a.add(d, a.mul_pos(e, t.quadratic_slope(a, leaf)));
        }
        Jet {
            d: [f, d],
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn curvature<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Blobs,
        bound: &Vec<<T::Leaves as Leaves>::Quadratic>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 3> {
        let mut f = a.constant(&Interval::point(-prepared.level));
        let mut d = a.constant(&Interval::ZERO);
        let mut dd = d;
        for leaf in bound {
            let e = a.exp(t.quadratic(a, leaf));
            let s = t.quadratic_slope(a, leaf);
            f = a.add(f, e);
            d = a.add(d, a.mul_pos(e, s));
            let bend = a.add(a.sqr(s), t.quadratic_curvature(a, leaf));
            dd = a.add(dd, a.mul_pos(e, bend));
        }
        Jet {
            d: [f, d, dd],
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn gradient<A: Arithmetic>(
        a: A,
        prepared: &Blobs,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 4> {
        let zero = a.constant(&Interval::ZERO);
        let mut g = [
            a.constant(&Interval::point(-prepared.level)),
            zero,
            zero,
            zero,
        ];
        for b in &prepared.blobs {
            let mut square = zero;
            let mut away = [zero; 3];
            for k in 0..3 {
                away[k] = a.sub(point[k], a.constant(&Interval::point(b[k])));
                square = a.add(square, a.sqr(away[k]));
            }
            let e = a.exp(a.mul(a.constant(&Interval::point(-b[3])), square));
            g[0] = a.add(g[0], e);
            let factor = a.mul(a.constant(&Interval::point(-2.0 * b[3])), e);
            for k in 0..3 {
                g[k + 1] = a.add(g[k + 1], a.mul(factor, away[k]));
            }
        }
        Jet {
            d: g,
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn hessian<A: Arithmetic>(
        _a: A,
        _prepared: &Blobs,
        _point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 10> {
        unreachable!("the tracer does not use Hessians in space")
    }
}

/// |p|² − r² as one leaf.
#[derive(Clone, Copy)]
pub struct Ball {
    /// r
    pub radius: f64,
    /// The half width of the box.
    pub half: f64,
}

impl Surface for Ball {
    const REPORT: Report = Report {
        name: "ball",
        degree: Some(2),
        continuity: Continuity::Smooth,
        total: true,
        functions: &[],
        leaves: 1,
        polynomials: 0,
        surface_operations: 0,
        ray_operations: 0,
        segment: [Operations::NONE; 3],
        space: [Operations::NONE; 3],
    };
    type Prepared = Interval;
    type Bound<L: Leaves> = L::Quadratic;

    #[inline(always)]
    fn check(&self) -> Result<(), ParameterError> {
        Ok(())
    }
    #[inline(always)]
    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        Some([[-self.half; 3], [self.half; 3]])
    }
    #[inline(always)]
    fn at(&self, [x, y, z]: [f64; 3]) -> f64 {
        x * x + y * y + z * z - self.radius * self.radius
    }
    #[inline(always)]
    fn prepare(&self) -> Interval {
        use zeroset::interval::Scalar;
        Arithmetic::sqr(Scalar, Interval::point(self.radius))
    }
    #[inline(always)]
    fn everything(_prepared: &Interval) -> Active {
        Active::default()
    }
    #[inline(always)]
    fn unbound<L: Leaves>(p: L::Packet) -> L::Quadratic {
        L::quadratic(p)
    }
    #[inline(always)]
    fn bind_leaves<P: Packet>(
        p: P,
        prepared: &Interval,
        rays: &Rays<P>,
        _active: &Active,
        bound: &mut Quadratic<P>,
    ) {
        let leaf = distance(p, rays, [0.0; 3], 1.0);
        *bound = Quadratic::new(p, p.sub(leaf.c0, p.constant(prepared)), leaf.c1, leaf.c2);
    }
    #[inline(always)]
    fn rebind<R: Rebind>(
        map: &R,
        from: &<R::From as Leaves>::Quadratic,
        _active: &Active,
        to: &mut <R::To as Leaves>::Quadratic,
    ) -> bool {
        *to = map.quadratic(from);
        true
    }
    #[inline(always)]
    fn value<A: Arithmetic, T: Parameter<A>>(
        a: A,
        _prepared: &Interval,
        bound: &<T::Leaves as Leaves>::Quadratic,
        t: T,
    ) -> Jet<A::Value, A::Packet, 1> {
        Jet {
            d: [t.quadratic(a, bound)],
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn slope<A: Arithmetic, T: Parameter<A>>(
        a: A,
        _prepared: &Interval,
        bound: &<T::Leaves as Leaves>::Quadratic,
        t: T,
    ) -> Jet<A::Value, A::Packet, 2> {
        Jet {
            d: [t.quadratic(a, bound), t.quadratic_slope(a, bound)],
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn curvature<A: Arithmetic, T: Parameter<A>>(
        a: A,
        _prepared: &Interval,
        bound: &<T::Leaves as Leaves>::Quadratic,
        t: T,
    ) -> Jet<A::Value, A::Packet, 3> {
        let d = [
            t.quadratic(a, bound),
            t.quadratic_slope(a, bound),
            t.quadratic_curvature(a, bound),
        ];
        Jet {
            d,
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn gradient<A: Arithmetic>(
        a: A,
        prepared: &Interval,
        [x, y, z]: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 4> {
        let f = a.sub(
            a.add(a.add(a.sqr(x), a.sqr(y)), a.sqr(z)),
            a.constant(prepared),
        );
        Jet {
            d: [f, a.add(x, x), a.add(y, y), a.add(z, z)],
            flags: a.clear(),
        }
    }
    #[inline(always)]
    fn hessian<A: Arithmetic>(
        _a: A,
        _prepared: &Interval,
        _point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 10> {
        unreachable!("the tracer does not use Hessians in space")
    }
    #[inline(always)]
    fn quadric<L: Leaves>(bound: &L::Quadratic) -> Option<&L::Quadratic> {
        Some(bound)
    }
}
