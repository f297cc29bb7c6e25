//! A surface in another place: the image of f = 0 under affine maps.

use glam::{DAffine3, DVec3};

use crate::interval::{
    Arithmetic, Ball, Fine, Flags, Interval, Jet, Lanes, Leaves, Packet, Parameter, Rebind, Scalar,
};
use crate::ray::Rays;
use crate::surface::{Active, ParameterError, Regions, Report, Surface, Terms, Work};

/// The surface f(A₁⁻¹(… Aₙ⁻¹(x))) = 0, for exact affine maps with `f64` entries; as it is without any.
///
/// A ray keeps its parameter under an affine map, so t means the same in each operand's own space. Its origin and
/// direction there are no `f64`s: they are enclosed, and what is proved holds for all rays in the enclosure, thus for
/// the exact one.
pub(crate) struct Placed<S> {
    surface: S,
    /// In the order in which they were applied.
    maps: Vec<DAffine3>,
}

/// The surface stage, with the way from space to the surface's own space.
pub(crate) struct Ready<T> {
    own: T,
    /// Nothing where there is no map: as bounds that are neighbours, and in twice the precision.
    inward: Option<(Inward<Interval>, Inward<Ball>)>,
}

/// x ↦ M·(x − c), from space to a surface's own space.
#[derive(Clone, Copy)]
struct Inward<V> {
    /// By rows.
    matrix: [[V; 3]; 3],
    centre: [V; 3],
}

impl<S> Placed<S> {
    pub fn new(surface: S) -> Self {
        Placed {
            surface,
            maps: Vec::new(),
        }
    }

    /// Moves it once more.
    pub fn place(&mut self, map: DAffine3) {
        self.maps.push(map);
    }
}

#[inline(always)]
fn dot<A: Arithmetic>(a: A, u: [A::Value; 3], v: [A::Value; 3]) -> A::Value {
    a.add(
        a.add(a.mul(u[0], v[0]), a.mul(u[1], v[1])),
        a.mul(u[2], v[2]),
    )
}

fn cross<A: Arithmetic>(a: A, u: [A::Value; 3], v: [A::Value; 3]) -> [A::Value; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a.sub(a.mul(u[i], v[j]), a.mul(u[j], v[i])))
}

#[inline(always)]
fn column<T: Copy>(m: &[[T; 3]; 3], k: usize) -> [T; 3] {
    [m[0][k], m[1][k], m[2][k]]
}

/// M = L₁⁻¹ … Lₙ⁻¹ by Cramer's rule (the rows of L⁻¹ are the cross products of L's columns over its determinant), and
/// c = Aₙ(… A₁(0)). The flags say `undefined` if a determinant may be 0.
fn inward<A: Arithmetic>(a: A, maps: &[DAffine3]) -> (Inward<A::Value>, Flags<A::Packet>) {
    let number = |x: f64| a.constant(&Interval { lo: x, hi: x });
    let vector = |v: DVec3| v.to_array().map(number);
    let unit = |k: usize| [0, 1, 2].map(|j| number(if j == k { 1.0 } else { 0.0 }));
    let mut matrix = [0, 1, 2].map(unit);
    let mut centre = [number(0.0); 3];
    let mut flags = a.clear();
    for map in maps {
        let linear = map.matrix3;
        let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis].map(vector);
        let yz = cross(a, y, z);
        let (scale, singular) = a.recip(dot(a, x, yz));
        flags = a.join(flags, singular);
        let inverse = [yz, cross(a, z, x), cross(a, x, y)].map(|row| row.map(|v| a.mul(v, scale)));
        let product = |row: [A::Value; 3]| [0, 1, 2].map(|k| dot(a, row, column(&inverse, k)));
        matrix = matrix.map(product);
        let moved = [0, 1, 2].map(|k| dot(a, column(&[x, y, z], k), centre));
        let shift = vector(map.translation);
        centre = [0, 1, 2].map(|k| a.add(moved[k], shift[k]));
    }
    (Inward { matrix, centre }, flags)
}

impl Inward<Interval> {
    /// By two number systems: twice the precision makes bounds that are neighbours, and single numbers with optimal
    /// rounding keep exact what is exact, such as the matrix of a translation.
    fn of(maps: &[DAffine3]) -> (Self, Inward<Ball>) {
        let (fine, (exact, _)) = (inward(Fine, maps).0, inward(Scalar, maps));
        let both =
            |fine: &Ball, exact: Interval| fine.interval().intersect(&exact).unwrap_or(exact);
        let three =
            |fine: &[Ball; 3], exact: [Interval; 3]| [0, 1, 2].map(|k| both(&fine[k], exact[k]));
        let bounds = Inward {
            matrix: [0, 1, 2].map(|k| three(&fine.matrix[k], exact.matrix[k])),
            centre: three(&fine.centre, exact.centre),
        };
        (bounds, fine)
    }

    /// M·v, where products with 0 and 1 are none.
    #[inline(always)]
    fn turn<P: Packet>(&self, p: P, v: &[Interval<P::F>; 3]) -> [Interval<P::F>; 3] {
        let mut turned = [p.constant(&Interval::ZERO); 3];
        for (row, sum) in self.matrix.iter().zip(&mut turned) {
            let mut first = true;
            for (entry, part) in row.iter().zip(v) {
                if *entry == Interval::ZERO {
                    continue;
                }
                let part = if *entry == Interval::ONE {
                    *part
                } else {
                    p.mul(p.constant(entry), *part)
                };
                *sum = if first { part } else { p.add(*sum, part) };
                first = false;
            }
        }
        turned
    }

    /// The same rays in the surface's own space.
    #[inline(always)]
    fn rays<P: Packet>(&self, p: P, rays: &Rays<P>) -> Rays<P> {
        let mut from = rays.origin;
        for (x, c) in from.iter_mut().zip(&self.centre) {
            if *c != Interval::ZERO {
                *x = p.sub(*x, p.constant(c));
            }
        }
        Rays {
            origin: self.turn(p, &from),
            direction: self.turn(p, &rays.direction),
            end: rays.end,
        }
    }
}

impl<S: Surface> Placed<S> {
    /// Finite maps that can be inverted.
    fn check_maps(&self) -> Result<(), ParameterError> {
        let finite = self.maps.iter().all(|map| map.is_finite());
        if finite && !inward(Fine, &self.maps).1.undefined {
            return Ok(());
        }
        Err(ParameterError::Placement {
            surface: S::REPORT.name,
        })
    }
}

/// The smallest box around the image of a box, rounded outward.
fn moved(map: &DAffine3, [low, high]: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
    let p = Scalar;
    let linear = map.matrix3;
    let columns = [linear.x_axis, linear.y_axis, linear.z_axis].map(|v| v.to_array());
    let shift = map.translation.to_array();
    let mut image = [shift; 2];
    for i in 0..3 {
        for (k, column) in columns.iter().enumerate() {
            let m = Interval::point(column[i]);
            let side = Interval {
                lo: low[k],
                hi: high[k],
            };
            let part = p.mul(m, side);
            image[0][i] = p.add_rd(image[0][i], part.lo);
            image[1][i] = p.add_ru(image[1][i], part.hi);
        }
    }
    image
}

impl<S: Surface> Surface for Placed<S> {
    const REPORT: Report = S::REPORT;
    type Prepared = Ready<S::Prepared>;
    type Bound<L: Leaves> = S::Bound<L>;

    fn check(&self) -> Result<(), ParameterError> {
        self.surface.check()?;
        self.check_maps()
    }

    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        let own = self.surface.domain()?;
        Some(self.maps.iter().fold(own, |domain, map| moved(map, domain)))
    }

    fn at(&self, point: [f64; 3]) -> f64 {
        let back = |x: DVec3, map: &DAffine3| map.inverse().transform_point3(x);
        let own = self.maps.iter().rev().fold(point.into(), back);
        self.surface.at(own.to_array())
    }

    fn prepare(&self) -> Self::Prepared {
        Ready {
            own: self.surface.prepare(),
            inward: (!self.maps.is_empty()).then(|| Inward::of(&self.maps)),
        }
    }

    fn everything(prepared: &Self::Prepared) -> Active {
        S::everything(&prepared.own)
    }

    #[inline(always)]
    fn unbound<L: Leaves>(p: L::Packet) -> Self::Bound<L> {
        S::unbound::<L>(p)
    }

    #[inline(always)]
    fn bind_leaves<P: Packet>(
        p: P,
        prepared: &Self::Prepared,
        rays: &Rays<P>,
        active: &Active,
        bound: &mut Self::Bound<P>,
    ) {
        let rays = own_rays(p, prepared, rays);
        S::bind_leaves(p, &prepared.own, &rays, active, bound);
    }

    #[inline(always)]
    fn bind_series<P: Packet>(
        p: P,
        prepared: &Self::Prepared,
        rays: &Rays<P>,
        bound: &mut Self::Bound<P>,
    ) {
        let rays = own_rays(p, prepared, rays);
        S::bind_series(p, &prepared.own, &rays, bound);
    }

    #[inline(always)]
    fn rebind<R: Rebind>(
        map: &R,
        from: &Self::Bound<R::From>,
        active: &Active,
        to: &mut Self::Bound<R::To>,
    ) -> bool {
        S::rebind(map, from, active, to)
    }

    #[inline(always)]
    fn terms<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
        to: &mut impl Terms<A>,
    ) {
        S::terms(a, &prepared.own, bound, t, to);
    }

    #[inline(always)]
    fn value<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 1> {
        S::value(a, &prepared.own, bound, t)
    }

    #[inline(always)]
    fn slope<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 2> {
        S::slope(a, &prepared.own, bound, t)
    }

    #[inline(always)]
    fn curvature<A: Arithmetic, T: Parameter<A>>(
        a: A,
        prepared: &Self::Prepared,
        bound: &Self::Bound<T::Leaves>,
        t: T,
    ) -> Jet<A::Value, A::Packet, 3> {
        S::curvature(a, &prepared.own, bound, t)
    }

    /// ∇(f ∘ (M(x − c))) = Mᵀ∇f.
    #[inline(always)]
    fn gradient<A: Arithmetic>(
        a: A,
        prepared: &Self::Prepared,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 4> {
        let Some(inward) = stored(a, prepared) else {
            return S::gradient(a, &prepared.own, point);
        };
        let mut jet = S::gradient(a, &prepared.own, inward.point(a, point));
        let [_, slope @ ..] = jet.d;
        for k in 0..3 {
            jet.d[k + 1] = dot(a, column(&inward.matrix, k), slope);
        }
        jet
    }

    /// The Hessian becomes MᵀHM.
    #[inline(always)]
    fn hessian<A: Arithmetic>(
        a: A,
        prepared: &Self::Prepared,
        point: [A::Value; 3],
    ) -> Jet<A::Value, A::Packet, 10> {
        let Some(inward) = stored(a, prepared) else {
            return S::hessian(a, &prepared.own, point);
        };
        let mut jet = S::hessian(a, &prepared.own, inward.point(a, point));
        let [value, gx, gy, gz, xx, xy, xz, yy, yz, zz] = jet.d;
        let columns = [0, 1, 2].map(|k| column(&inward.matrix, k));
        let [x, y, z] = columns.map(|c| dot(a, c, [gx, gy, gz]));
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let bent = columns.map(|c| rows.map(|row| dot(a, row, c)));
        let entry = |i: usize, k: usize| dot(a, columns[i], bent[k]);
        jet.d = [
            value,
            x,
            y,
            z,
            entry(0, 0),
            entry(0, 1),
            entry(0, 2),
            entry(1, 1),
            entry(1, 2),
            entry(2, 2),
        ];
        jet
    }

    const REGIONS: Regions = S::REGIONS;
    const WORK: Work = S::WORK;

    fn quadric<L: Leaves>(bound: &Self::Bound<L>) -> Option<&L::Quadratic> {
        S::quadric::<L>(bound)
    }
}

impl<V: Copy> Inward<V> {
    #[inline(always)]
    fn point<A: Arithmetic<Value = V>>(&self, a: A, point: [V; 3]) -> [V; 3] {
        let mut from = point;
        for (x, centre) in from.iter_mut().zip(&self.centre) {
            *x = a.sub(*x, *centre);
        }
        let mut own = from;
        for (x, row) in own.iter_mut().zip(&self.matrix) {
            *x = dot(a, *row, from);
        }
        own
    }
}

#[inline(always)]
fn own_rays<T, P: Packet>(p: P, prepared: &Ready<T>, rays: &Rays<P>) -> Rays<P> {
    match &prepared.inward {
        None => *rays,
        Some((inward, _)) => inward.rays(p, rays),
    }
}

/// The way inward as numbers of a system, if there is a map.
#[inline(always)]
fn stored<T, A: Arithmetic>(a: A, prepared: &Ready<T>) -> Option<Inward<A::Value>> {
    let (bounds, fine) = prepared.inward.as_ref()?;
    let mut stored = Inward {
        matrix: [[a.constant(&Interval::ZERO); 3]; 3],
        centre: [a.constant(&Interval::ZERO); 3],
    };
    for i in 0..3 {
        stored.centre[i] = a.stored(&bounds.centre[i], &fine.centre[i]);
        for k in 0..3 {
            stored.matrix[i][k] = a.stored(&bounds.matrix[i][k], &fine.matrix[i][k]);
        }
    }
    Some(stored)
}
