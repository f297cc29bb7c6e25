//! A surface in its cube, seen by a camera, behind one object-safe trait.

use std::cell::Cell;
use std::collections::BinaryHeap;

use zeroset::camera::{Camera, Ray, Sampling};
use zeroset::contract::{Auto, Bisection, Halley, Newton, Tightened};
use zeroset::glam::{DVec3, dvec3};
use zeroset::interval::{Interval, Isa, Kernel, Packet, Scalar};
use zeroset::ray::Rays;
use zeroset::{Scene, Surface};

use crate::SIZE;
use crate::methods::{Method, Search};
use crate::ours::Solver;
use crate::probe::{Bound, Counted, Probe};

/// A surface that methods are compared on.
pub trait Subject {
    /// Its name, as in the truth.
    fn name(&self) -> &'static str;
    /// Half the width of its cube.
    fn half(&self) -> f64;
    /// The degree, if f is a polynomial.
    fn degree(&self) -> Option<u32>;
    /// This library's solvers that are compiled for it; the default is the first.
    fn solvers(&self) -> &'static [Solver];
    /// A scene for this library, with one of them.
    fn scene(&self, solver: Solver) -> Scene;
    /// The least L ≥ |∇f| in the cube that enclosures find.
    fn lipschitz(&self) -> f64;
    /// The roots that a method finds.
    fn trace(&self, isa: Isa, packets: &[Eight], method: Method, tolerance: f64) -> Traced;

    /// The same camera for all: above, in front and to the right.
    fn camera(&self) -> Camera {
        let from = dvec3(3.1, 2.3, 1.7) * self.half();
        Camera::perspective(from, DVec3::ZERO, DVec3::Z, 40.0).expect("a camera")
    }

    /// A pixel's ray.
    fn ray(&self, x: u32, y: u32) -> Ray {
        self.camera().ray(x, y, SIZE, SIZE, Sampling::Centre)
    }

    /// All rays of a picture, in blocks of 4 × 2 pixels, as this library takes them.
    fn packets(&self) -> Vec<Eight> {
        let half = self.half();
        let (columns, rows) = (SIZE / 4, SIZE / 2);
        let lipschitz = self.lipschitz();
        (0..columns * rows)
            .map(|number| {
                let corner = [number % columns * 4, number / columns * 2];
                let rays = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| {
                    let ray = self.ray(corner[0] + k % 4, corner[1] + k / 4);
                    (ray, clip(&ray, half))
                });
                Eight {
                    corner,
                    origin: [0, 1, 2].map(|axis| rays.map(|(ray, _)| ray.origin[axis])),
                    direction: [0, 1, 2].map(|axis| rays.map(|(ray, _)| ray.direction[axis])),
                    entry: rays.map(|(_, [near, _])| near),
                    end: rays.map(|(_, [near, far])| if near <= far { far - near } else { -1.0 }),
                    unit: rays.map(|(ray, _)| half / ray.direction.length()),
                    reach: rays.map(|(ray, _)| 1.0 / (lipschitz * ray.direction.length())),
                }
            })
            .collect()
    }
}

/// Eight rays.
pub struct Eight {
    /// The upper left pixel.
    pub corner: [u32; 2],
    origin: [[f64; 8]; 3],
    direction: [[f64; 8]; 3],
    /// Where they enter the cube; t counts from here.
    pub entry: [f64; 8],
    /// Where they leave it; negative where they miss it.
    end: [f64; 8],
    /// Half the width of the cube, in units of t.
    pub unit: [f64; 8],
    /// How far a ray may go for each unit of |f|.
    reach: [f64; 8],
}

/// What a method finds.
#[derive(Default)]
pub struct Traced {
    /// For each packet, t from the entry; NaN where there is no root.
    pub t: Vec<[f64; 8]>,
    /// How often f, with or without its derivative or bounds, was evaluated for a ray.
    pub evaluations: u64,
}

/// Where a ray is in the cube, for t ≥ 0.
fn clip(ray: &Ray, half: f64) -> [f64; 2] {
    let (mut near, mut far) = (0.0f64, f64::INFINITY);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        let ends = [(-half - o) / d, (half - o) / d];
        near = near.max(ends[0].min(ends[1]));
        far = far.min(ends[0].max(ends[1]));
    }
    [near, far]
}

/// A surface with its name and its cube, for all of this library's solvers or for the default one.
pub struct Named<S, const ALL: bool> {
    /// As in the truth.
    pub name: &'static str,
    /// Half the width of its cube.
    pub half: f64,
    /// The surface.
    pub surface: S,
}

/// Chooses the solvers: what is not chosen is not compiled.
trait Solve<S> {
    const SOLVERS: &'static [Solver];
    fn with(solver: Solver, surface: S) -> Scene;
}

struct Choice<const ALL: bool>;

impl<S: Surface + 'static> Solve<S> for Choice<false> {
    const SOLVERS: &'static [Solver] = &[Solver::Auto];
    fn with(_solver: Solver, surface: S) -> Scene {
        Scene::new().with_solver::<Auto, S>(surface)
    }
}

impl<S: Surface + 'static> Solve<S> for Choice<true> {
    const SOLVERS: &'static [Solver] = &Solver::ALL;
    fn with(solver: Solver, surface: S) -> Scene {
        let scene = Scene::new();
        match solver {
            Solver::Auto => scene.with_solver::<Auto, S>(surface),
            Solver::Bisection => scene.with_solver::<Bisection, S>(surface),
            Solver::Newton => scene.with_solver::<Newton, S>(surface),
            Solver::Tightened => scene.with_solver::<Tightened, S>(surface),
            Solver::Halley => scene.with_solver::<Halley, S>(surface),
        }
    }
}

impl<S: Surface + Clone + 'static, const ALL: bool> Subject for Named<S, ALL>
where
    Choice<ALL>: Solve<S>,
{
    fn name(&self) -> &'static str {
        self.name
    }

    fn half(&self) -> f64 {
        self.half
    }

    fn degree(&self) -> Option<u32> {
        S::REPORT.degree
    }

    fn solvers(&self) -> &'static [Solver] {
        <Choice<ALL> as Solve<S>>::SOLVERS
    }

    fn scene(&self, solver: Solver) -> Scene {
        let half = self.half;
        Choice::<ALL>::with(solver, self.surface.clone()).within([-half; 3], [half; 3])
    }

    fn lipschitz(&self) -> f64 {
        let prepared = self.surface.prepare();
        let steepest = |cell: &[Interval; 3]| {
            let [_, x, y, z] = S::gradient(Scalar, &prepared, *cell).d;
            let greatest = [x, y, z].map(|d| d.lo.abs().max(d.hi.abs()));
            greatest.iter().map(|d| d * d).sum::<f64>().sqrt()
        };
        least_bound(self.half, steepest)
    }

    fn trace(&self, isa: Isa, packets: &[Eight], method: Method, tolerance: f64) -> Traced {
        let prepared = self.surface.prepare();
        isa.run(Run::<S> {
            prepared: &prepared,
            packets,
            method,
            tolerance,
        })
    }
}

/// A cell, and a bound in it.
struct Steep(f64, [Interval; 3]);

impl PartialEq for Steep {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Steep {}
impl PartialOrd for Steep {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Steep {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The cell with the greatest bound is halved along its longest side, until the bound is within a twentieth of what is
/// reached at a cell's middle, or often enough.
fn least_bound(half: f64, steepest: impl Fn(&[Interval; 3]) -> f64) -> f64 {
    let whole = [Interval {
        lo: -half,
        hi: half,
    }; 3];
    let mut cells = BinaryHeap::from([Steep(steepest(&whole), whole)]);
    let mut reached = 0.0f64;
    for _ in 0..20_000 {
        let Some(Steep(bound, cell)) = cells.pop() else {
            break;
        };
        reached = reached.max(steepest(&cell.map(|side| {
            let middle = side.mid();
            Interval {
                lo: middle,
                hi: middle,
            }
        })));
        if bound <= reached * 1.05 {
            return bound;
        }
        let wide = |k: &usize| cell[*k].hi - cell[*k].lo;
        let axis = (0..3)
            .max_by(|a, b| wide(a).total_cmp(&wide(b)))
            .unwrap_or(0);
        let middle = cell[axis].mid();
        let (mut lower, mut upper) = (cell, cell);
        (lower[axis].hi, upper[axis].lo) = (middle, middle);
        cells.push(Steep(steepest(&lower), lower));
        cells.push(Steep(steepest(&upper), upper));
    }
    cells.pop().map_or(reached, |cell| cell.0)
}

struct Run<'a, S: Surface> {
    prepared: &'a S::Prepared,
    packets: &'a [Eight],
    method: Method,
    tolerance: f64,
}

impl<S: Surface> Kernel for Run<'_, S> {
    type Output = Traced;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Traced {
        let active = S::everything(self.prepared);
        let count = Cell::new(0);
        let mut probe = Bound::<S, P> {
            prepared: self.prepared,
            bound: S::unbound::<P>(p),
        };
        let mut traced = Traced::default();
        traced.t.reserve(self.packets.len());
        for eight in self.packets {
            let entry = p.lanes(eight.entry);
            let end = p.lanes(eight.end);
            if !p.any(p.le(p.splat(0.0), end)) {
                traced.t.push([f64::NAN; 8]);
                continue;
            }
            let [o, d] = [&eight.origin, &eight.direction];
            let [x, y, z] = [0, 1, 2].map(|k| p.lanes(d[k]));
            let rays = Rays::<P> {
                origin: [
                    p.recentre(entry, x, p.lanes(o[0])),
                    p.recentre(entry, y, p.lanes(o[1])),
                    p.recentre(entry, z, p.lanes(o[2])),
                ],
                direction: [p.point(x), p.point(y), p.point(z)],
                end,
            };
            S::bind(p, self.prepared, &rays, &active, &mut probe.bound);
            let counted = Counted {
                probe: &probe as &dyn Probe<P>,
                count: &count,
            };
            let t = p.call(Search {
                method: self.method,
                probe: &counted,
                end,
                tolerance: p.mul_rn(p.splat(self.tolerance), p.lanes(eight.unit)),
                reach: p.lanes(eight.reach),
            });
            traced.t.push(p.to_array(t));
        }
        traced.evaluations = count.get();
        traced
    }
}
