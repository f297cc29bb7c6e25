//! The 256 ray functions that both figures look at.

use zeroset::interval::{At, Interval, Scalar};
use zeroset::ray::Rays;
use zeroset::surface::Surface;

use crate::family::{Form, SumOfExpQuadrics, quadratics};
use crate::random::Random;

/// How many ray functions there are; the first half is of negative definite quadratics.
pub const COUNT: usize = 256;
/// The seed of all of them, whatever the picture's seed is.
pub const SEED: u64 = 256;
/// Exponentials per function.
const TERMS: usize = 8;
/// T has the widths 2⁻ᵏ of the way through the box, k from 0 to this.
pub const NARROWEST: usize = 20;

type Prepared = <SumOfExpQuadrics as Surface>::Prepared;
type Bound = <SumOfExpQuadrics as Surface>::Bound<Scalar>;

/// f along one ray, t ∈ [0, 1] from face to face of the box, with a root, and a segment T of each width around it.
pub struct RayFunction {
    /// Of which half it is.
    pub form: Form,
    /// Segments of the widths 2⁰, 2⁻¹, …: each holds the root, at a random place.
    pub segments: Vec<Interval>,
    origin: [f64; 3],
    direction: [f64; 3],
    prepared: Prepared,
    bound: Bound,
}

/// All of them.
pub fn functions() -> Vec<RayFunction> {
    let mut random = Random::new(SEED);
    let form = |k| match k {
        0..128 => Form::NegativeDefinite,
        _ => Form::Indefinite,
    };
    (0..COUNT)
        .map(|k| RayFunction::new(&mut random, form(k)))
        .collect()
}

impl RayFunction {
    /// A random sum and a random ray through it. The level is the sum's value at a random place of the ray, so that f
    /// has a root there.
    fn new(random: &mut Random, form: Form) -> Self {
        let axis = random.below(3) as usize;
        let mut end = |face: f64| {
            let mut p = [0; 3].map(|_| random.between(-1.0, 1.0));
            p[axis] = face;
            p
        };
        let (origin, exit) = (end(-1.0), end(1.0));
        let direction = [0, 1, 2].map(|k| exit[k] - origin[k]);
        let root = random.between(0.0, 1.0);
        let terms = quadratics(random, TERMS, form);
        let mut surface = SumOfExpQuadrics { terms, level: 0.0 };
        surface.level = -surface.at([0, 1, 2].map(|k| origin[k] + root * direction[k]));
        let segments = (0..=NARROWEST)
            .map(|k| {
                let width = 1.0 / (1u64 << k) as f64;
                let lo = (root - width * random.between(0.0, 1.0)).clamp(0.0, 1.0 - width);
                let hi = lo + width;
                Interval { lo, hi }
            })
            .collect();
        let prepared = surface.prepare();
        let bound = bind(&prepared, origin, direction);
        RayFunction {
            form,
            segments,
            origin,
            direction,
            prepared,
            bound,
        }
    }

    /// The staged enclosure of f(T).
    pub fn value(&self, t: Interval) -> Interval {
        SumOfExpQuadrics::value(Scalar, &self.prepared, &self.bound, t).d[0]
    }

    /// f at one t, enclosed.
    pub fn at(&self, t: f64) -> Interval {
        SumOfExpQuadrics::value(Scalar, &self.prepared, &self.bound, At(t)).d[0]
    }

    /// f and f' at one t, enclosed.
    pub fn slope_at(&self, t: f64) -> [Interval; 2] {
        SumOfExpQuadrics::slope(Scalar, &self.prepared, &self.bound, At(t)).d
    }

    /// Staged enclosures of f and f' over T.
    pub fn slope(&self, t: Interval) -> [Interval; 2] {
        SumOfExpQuadrics::slope(Scalar, &self.prepared, &self.bound, t).d
    }

    /// Staged enclosures of f, f' and f'' over T. The family is smooth and defined everywhere: no flag is ever set.
    pub fn curvature(&self, t: Interval) -> zeroset::solve::Enclosed<Scalar, 3> {
        SumOfExpQuadrics::curvature(Scalar, &self.prepared, &self.bound, t)
    }

    /// Plain interval arithmetic: the formula as written, in space, over x = o + T·d, y and z alike.
    pub fn plain(&self, t: Interval) -> Interval {
        use zeroset::interval::Arithmetic;
        let point = [0, 1, 2].map(|k| {
            let (o, d) = (exact(self.origin[k]), exact(self.direction[k]));
            Scalar.add(o, Scalar.mul(t, d))
        });
        SumOfExpQuadrics::gradient(Scalar, &self.prepared, point).d[0]
    }
}

fn exact(x: f64) -> Interval {
    Interval { lo: x, hi: x }
}

/// The ray stage.
fn bind(prepared: &Prepared, origin: [f64; 3], direction: [f64; 3]) -> Bound {
    let rays = Rays::<Scalar> {
        origin: origin.map(exact),
        direction: direction.map(exact),
        end: 1.0,
    };
    let mut bound = SumOfExpQuadrics::unbound::<Scalar>(Scalar);
    let all = SumOfExpQuadrics::everything(prepared);
    SumOfExpQuadrics::bind(Scalar, prepared, &rays, &all, &mut bound);
    bound
}
