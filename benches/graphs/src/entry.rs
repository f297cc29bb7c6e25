//! One pass of an entry point over packets of segments.

use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::width::{Widths, widths};
use zeroset::Surface;
use zeroset::interval::{self, Interval, Isa, Kernel, Packet, Routine};
use zeroset::ray::Rays;

/// An entry point of a surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Entry {
    /// f over a segment of a ray.
    Value,
    /// f and f'.
    Slope,
    /// f, f' and f''.
    Curvature,
    /// f in space: the part of the gradient that needs no derivative.
    SpaceValue,
    /// f and its gradient in space.
    Gradient,
    /// f, its gradient and its Hessian in space.
    Hessian,
}

/// Packets per pass: their segments stay in the first-level cache.
pub const PACKETS: usize = 64;

/// Evaluates one entry point of a surface; a compiled surface without its type.
pub trait Evaluate {
    /// How long so many passes take over the same packets of segments inside the cube of this half side.
    fn time(&self, entry: Entry, half: f64, passes: u32) -> Duration;
    /// How wide its enclosures are: see [`widths`].
    fn widths(&self, half: f64, width: f64, count: usize) -> Vec<Widths>;
    /// The operations along a ray, in space, and how many leaves there are.
    fn report(&self) -> zeroset::surface::Report;
}

impl<S: Surface> Evaluate for S {
    fn time(&self, entry: Entry, half: f64, passes: u32) -> Duration {
        isa().run(Pass {
            surface: self,
            entry,
            half,
            passes,
        })
    }

    fn widths(&self, half: f64, width: f64, count: usize) -> Vec<Widths> {
        widths(self, half, width, count)
    }

    fn report(&self) -> zeroset::surface::Report {
        S::REPORT
    }
}

/// The processor path that is measured.
///
/// # Panics
/// If `ZEROSET_ISA` names one that is not there.
pub fn isa() -> Isa {
    let isa = Isa::detect().expect("a processor path");
    assert!(
        compiled(isa.name()),
        "{isa} was not compiled: set ZEROSET_ISA when this is built"
    );
    isa
}

/// Is code made for this path? All would take rustc minutes: those with vectors, or the one that `ZEROSET_ISA` names.
const fn compiled(name: &str) -> bool {
    match option_env!("ZEROSET_ISA") {
        Some(only) => equal(name, only),
        None => equal(name, "avx512") || equal(name, "avx2"),
    }
}

const fn equal(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut same = a.len() == b.len();
    let mut i = 0;
    while same && i < a.len() {
        same = a[i] == b[i];
        i += 1;
    }
    same
}

struct Pass<'a, S> {
    surface: &'a S,
    entry: Entry,
    half: f64,
    passes: u32,
}

impl<S: Surface> Kernel for Pass<'_, S> {
    type Output = Duration;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Duration {
        if const { compiled(P::NAME) } {
            return measure(p, &self);
        }
        Duration::ZERO
    }
}

#[inline(always)]
fn measure<S: Surface, P: Packet>(p: P, pass: &Pass<S>) -> Duration {
    let prepared = pass.surface.prepare();
    let mut bound = S::unbound::<P>(p);
    let rays = rays(p, pass.half);
    S::bind(p, &prepared, &rays, &S::everything(&prepared), &mut bound);
    let mut random = Random(7);
    let segments: Vec<_> = (0..PACKETS).map(|_| segment(p, &mut random)).collect();
    let boxes: Vec<[_; 3]> = (0..PACKETS)
        .map(|_| std::array::from_fn(|_| random.interval(p, pass.half)))
        .collect();
    let (prepared, bound) = (&prepared, &bound);
    let start = Instant::now();
    for _ in 0..pass.passes {
        for k in 0..PACKETS {
            let (t, at) = (&segments[k], &boxes[k]);
            match pass.entry {
                Entry::Value => _ = black_box(p.call(Value::<S, P> { prepared, bound, t })),
                Entry::Slope => _ = black_box(p.call(Slope::<S, P> { prepared, bound, t })),
                Entry::Curvature => _ = black_box(p.call(Curvature::<S, P> { prepared, bound, t })),
                Entry::SpaceValue => _ = black_box(p.call(SpaceValue::<S, P> { prepared, at })),
                Entry::Gradient => _ = black_box(p.call(Gradient::<S, P> { prepared, at })),
                Entry::Hessian => _ = black_box(p.call(Hessian::<S, P> { prepared, at })),
            }
        }
    }
    start.elapsed()
}

/// f and its first `N − 1` derivatives.
type Jet<P, const N: usize> = interval::Jet<Interval<<P as interval::Lanes>::F>, P, N>;

/// Declares an entry point as a function of its own per surface, as the tracer calls it.
macro_rules! routines {
    ($($name:ident { $($field:ident: $kind:ty),* } -> $out:ty = $p:ident $prepared:ident => $body:expr;)*) => {
        $(struct $name<'a, S: Surface, P: Packet> {
            $prepared: &'a S::Prepared,
            $($field: &'a $kind),*
        }

        impl<S: Surface, P: Packet> Routine<P> for $name<'_, S, P> {
            type Output = $out;

            #[inline(always)]
            fn call(self, $p: P) -> $out {
                let $name { $prepared, $($field),* } = self;
                $body
            }
        })*
    };
}

routines! {
    Value { bound: S::Bound<P>, t: Interval<P::F> } -> Jet<P, 1> = p prepared => S::value(p, prepared, bound, *t);
    Slope { bound: S::Bound<P>, t: Interval<P::F> } -> Jet<P, 2> = p prepared => S::slope(p, prepared, bound, *t);
    Curvature { bound: S::Bound<P>, t: Interval<P::F> } -> Jet<P, 3> =
        p prepared => S::curvature(p, prepared, bound, *t);
    SpaceValue { at: [Interval<P::F>; 3] } -> Interval<P::F> = p prepared => S::gradient(p, prepared, *at).d[0];
    Gradient { at: [Interval<P::F>; 3] } -> Jet<P, 4> = p prepared => S::gradient(p, prepared, *at);
    Hessian { at: [Interval<P::F>; 3] } -> Jet<P, 10> = p prepared => S::hessian(p, prepared, *at);
}

/// Numbers in [0, 1) from a fixed seed.
pub struct Random(pub u64);

impl Random {
    /// The next one.
    pub fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// An interval inside [−half, half] in each lane, between 2⁻⁸ and ¼ of it wide.
    fn interval<P: Packet>(&mut self, p: P, half: f64) -> Interval<P::F> {
        let (mut lo, mut hi) = ([0.0; 8], [0.0; 8]);
        for (lo, hi) in lo.iter_mut().zip(&mut hi) {
            let width = half * (2.0 + 6.0 * self.number()).exp2().recip();
            *lo = (2.0 * half - width) * self.number() - half;
            *hi = *lo + width;
        }
        Interval {
            lo: p.lanes(lo),
            hi: p.lanes(hi),
        }
    }
}

/// Eight rays from the face z = −half, into the cube.
fn rays<P: Packet>(p: P, half: f64) -> Rays<P> {
    let mut random = Random(3);
    let mut lanes = |scale: f64| {
        let mut all = [0.0; 8];
        all.iter_mut()
            .for_each(|x| *x = half * scale * (2.0 * random.number() - 1.0));
        p.point(p.lanes(all))
    };
    let flat = |x: f64| p.point(p.splat(x));
    Rays {
        origin: [lanes(0.6), lanes(0.6), flat(-half)],
        direction: [lanes(0.4), lanes(0.4), flat(2.0 * half)],
        end: p.splat(1.0),
    }
}

/// A piece of each ray.
fn segment<P: Packet>(p: P, random: &mut Random) -> Interval<P::F> {
    let t = random.interval(p, 0.5);
    let half = p.splat(0.5);
    Interval {
        lo: p.add_rn(t.lo, half),
        hi: p.add_rn(t.hi, half),
    }
}
