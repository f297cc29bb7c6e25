//! A surface's entry points, each a function of its own per instruction set.

use crate::interval::{
    Arithmetic, At, Ball, Fine, Flags, Interval, Jet, Nearest, Packet, Routine, Scalar,
};
use crate::ray::Rays;
use crate::solve::{Along, Enclosed};
use crate::surface::{Active, Surface};

/// A surface bound to the rays of one packet.
pub(crate) struct Entries<'a, S: Surface, P: Packet> {
    prepared: &'a S::Prepared,
    pub bound: &'a mut S::Bound<P>,
    rays: &'a Rays<P>,
    active: &'a Active,
    /// What only segments need is bound when the first is looked at: many rays need none.
    whole: bool,
}

impl<'a, S: Surface, P: Packet> Entries<'a, S, P> {
    /// Binds a surface to rays, with its active rows.
    #[inline(always)]
    pub fn bind(
        p: P,
        prepared: &'a S::Prepared,
        rays: &'a Rays<P>,
        active: &'a Active,
        bound: &'a mut S::Bound<P>,
    ) -> Self {
        p.call(Leaves::<S, P> {
            prepared,
            rays,
            active,
            bound,
        });
        Entries {
            prepared,
            bound,
            rays,
            active,
            whole: false,
        }
    }

    /// Ready for segments.
    #[inline(always)]
    fn whole(&mut self, p: P) -> &Self {
        if !self.whole {
            p.call(Series { of: self });
            self.whole = true;
        }
        self
    }
}

/// The ray stage, a function of its own, …
struct Leaves<'a, S: Surface, P: Packet> {
    prepared: &'a S::Prepared,
    rays: &'a Rays<P>,
    active: &'a Active,
    bound: &'a mut S::Bound<P>,
}

impl<S: Surface, P: Packet> Routine<P> for Leaves<'_, S, P> {
    type Output = ();
    #[inline(always)]
    fn call(self, p: P) {
        S::bind_leaves(p, self.prepared, self.rays, self.active, self.bound);
    }
}

/// … and the part that only segments need.
struct Series<'b, 'a, S: Surface, P: Packet> {
    of: &'b mut Entries<'a, S, P>,
}

impl<S: Surface, P: Packet> Routine<P> for Series<'_, '_, S, P> {
    type Output = ();
    #[inline(always)]
    fn call(self, p: P) {
        let Entries {
            prepared,
            bound,
            rays,
            ..
        } = self.of;
        S::bind_series(p, prepared, rays, bound);
    }
}

/// Forwards to routines that enter the instruction set: over segments, and at points.
macro_rules! entries {
    (
        over $t:ty { $($name:ident -> $out:ty = $routine:ident;)* }
        at $at:ty { $($point:ident -> $value:ty = $look:ident;)* }
    ) => {
        $(#[inline]
        fn $name(&mut self, p: P, t: &$t) -> $out {
            p.call($routine { of: self.whole(p), t })
        })*
        $(#[inline]
        fn $point(&self, p: P, t: &$at) -> $value {
            p.call($look { of: self, t })
        })*
    };
}

impl<S: Surface, P: Packet> Along<P> for Entries<'_, S, P> {
    entries! {
        over Interval<P::F> {
            value -> Enclosed<P, 1> = Value;
            slope -> Enclosed<P, 2> = Slope;
            curvature -> Enclosed<P, 3> = Curvature;
        }
        at At<P::F> {
            point -> Enclosed<P, 1> = Point;
            float -> [P::F; 2] = Float;
        }
    }

    fn natural(&self, p: P, t: &Interval<P::F>, live: P::M) -> Enclosed<P, 1> {
        let part = |x: &Interval<P::F>| (p.to_array(x.lo), p.to_array(x.hi));
        let (t, live) = (part(t), p.bits(live));
        let [origin, direction] =
            [self.rays.origin, self.rays.direction].map(|v| v.map(|x| part(&x)));
        let one = |(lo, hi): &([f64; 8], [f64; 8]), lane: usize| Interval {
            lo: lo[lane],
            hi: hi[lane],
        };
        let mut bounds = [[f64::NEG_INFINITY; 8], [f64::INFINITY; 8]];
        let mut flags = [0u8; 4];
        for lane in (0..8).filter(|lane| live >> lane & 1 != 0) {
            let point = [0, 1, 2].map(|k| {
                let way = Scalar.mul(one(&t, lane), one(&direction[k], lane));
                Scalar.add(one(&origin[k], lane), way)
            });
            let f = in_space::<S>(self.prepared, &point);
            (bounds[0][lane], bounds[1][lane]) = (f.d[0].lo, f.d[0].hi);
            let Flags {
                empty,
                undefined,
                jump,
                kink,
            } = f.flags;
            for (bits, flag) in flags.iter_mut().zip([empty, undefined, jump, kink]) {
                *bits |= u8::from(flag) << lane;
            }
        }
        let [empty, undefined, jump, kink] = flags.map(|bits| p.mask(bits));
        Jet {
            d: [Interval {
                lo: p.lanes(bounds[0]),
                hi: p.lanes(bounds[1]),
            }],
            flags: Flags {
                empty,
                undefined,
                jump,
                kink,
            },
        }
    }

    fn fine(&self, point: &[Ball; 3]) -> ([Ball; 4], Flags<Scalar>) {
        if self.active.tells_all::<S>() {
            fine_in_space::<S>(self.prepared, self.active, point)
        } else {
            fine_in_space::<S>(self.prepared, &S::everything(self.prepared), point)
        }
    }

    fn fine_value(&self, point: &[Ball; 3]) -> Option<(Ball, Flags<Scalar>)> {
        if self.active.tells_all::<S>() {
            return None;
        }
        let everything = S::everything(self.prepared);
        let fewer = !self.active.by_sign && self.active.is_less_than(&everything);
        fewer.then(|| {
            let ([f, ..], flags) = fine_in_space::<S>(self.prepared, self.active, point);
            (f, flags)
        })
    }
}

/// f over a box, in scalars: the same function for all instruction sets, so it is compiled once.
#[inline(never)]
fn in_space<S: Surface>(prepared: &S::Prepared, point: &[Interval; 3]) -> Jet<Interval, Scalar, 1> {
    let f = S::gradient(Scalar, prepared, *point);
    Jet {
        d: [f.d[0]],
        flags: f.flags,
    }
}

/// f and its gradient in twice the precision, likewise.
#[inline(never)]
fn fine_in_space<S: Surface>(
    prepared: &S::Prepared,
    active: &Active,
    point: &[Ball; 3],
) -> ([Ball; 4], Flags<Scalar>) {
    let f = S::seen(Fine, prepared, active, *point);
    (f.d, f.flags)
}

macro_rules! routine {
    ($name:ident, $t:ty, $out:ty, $p:ident => $arithmetic:expr, $entry:ident $($part:tt)*) => {
        struct $name<'a, S: Surface, P: Packet> {
            of: &'a Entries<'a, S, P>,
            t: &'a $t,
        }

        impl<S: Surface, P: Packet> Routine<P> for $name<'_, S, P> {
            type Output = $out;
            #[inline(always)]
            fn call(self, $p: P) -> $out {
                S::$entry($arithmetic, self.of.prepared, self.of.bound, *self.t) $($part)*
            }
        }
    };
}

routine!(Value, Interval<P::F>, Enclosed<P, 1>, p => p, value);
routine!(Slope, Interval<P::F>, Enclosed<P, 2>, p => p, slope);
routine!(Curvature, Interval<P::F>, Enclosed<P, 3>, p => p, curvature);
routine!(Point, At<P::F>, Enclosed<P, 1>, p => p, value);
routine!(Float, At<P::F>, [P::F; 2], p => Nearest(p), slope.d);
