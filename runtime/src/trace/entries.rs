//! A surface's entry points, each a function of its own per instruction set.

use crate::interval::{At, Ball, Fine, Flags, Interval, Nearest, Packet, Routine, Scalar};
use crate::solve::{Along, Enclosed};
use crate::surface::Surface;

/// A surface bound to the rays of one packet.
pub(crate) struct Entries<'a, S: Surface, P: Packet> {
    pub prepared: &'a S::Prepared,
    pub bound: &'a S::Bound<P>,
}

/// Forwards to routines that enter the instruction set.
macro_rules! entries {
    ($($name:ident($t:ty) -> $out:ty = $routine:ident;)*) => {
        $(#[inline]
        fn $name(&self, p: P, t: &$t) -> $out {
            p.call($routine { of: self, t })
        })*
    };
}

impl<S: Surface, P: Packet> Along<P> for Entries<'_, S, P> {
    entries! {
        value(Interval<P::F>) -> Enclosed<P, 1> = Value;
        slope(Interval<P::F>) -> Enclosed<P, 2> = Slope;
        curvature(Interval<P::F>) -> Enclosed<P, 3> = Curvature;
        point(At<P::F>) -> Enclosed<P, 1> = Point;
        float(At<P::F>) -> [P::F; 2] = Float;
    }

    fn fine(&self, point: &[Ball; 3]) -> ([Ball; 4], Flags<Scalar>) {
        let f = S::gradient(Fine, self.prepared, *point);
        (f.d, f.flags)
    }
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
