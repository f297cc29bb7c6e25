//! A surface along the rays of one packet, for methods in plain floats: an object, so that a method is compiled once per
//! instruction set.

use std::cell::Cell;

use zeroset::Surface;
use zeroset::interval::{At, Interval, Nearest, Packet, Routine};

/// f along eight rays.
pub trait Probe<P: Packet> {
    /// f at `t`.
    fn value(&self, p: P, t: P::F) -> P::F;
    /// f and f' at `t`.
    fn slope(&self, p: P, t: P::F) -> [P::F; 2];
    /// Bounds of f' over `t`.
    fn bounds(&self, p: P, t: &Interval<P::F>) -> Interval<P::F>;
}

/// A probe that counts how many rays each evaluation serves.
pub struct Counted<'a, P: Packet> {
    /// What is counted.
    pub probe: &'a dyn Probe<P>,
    /// How many so far.
    pub count: &'a Cell<u64>,
}

impl<P: Packet> Counted<'_, P> {
    fn add(&self, p: P, live: P::M) {
        let served = u64::from(p.bits(live).count_ones());
        self.count.set(self.count.get() + served);
    }

    /// f at `t`, for the rays of `live`.
    #[inline(always)]
    pub fn value(&self, p: P, t: P::F, live: P::M) -> P::F {
        self.add(p, live);
        self.probe.value(p, t)
    }

    /// f and f' at `t`.
    #[inline(always)]
    pub fn slope(&self, p: P, t: P::F, live: P::M) -> [P::F; 2] {
        self.add(p, live);
        self.probe.slope(p, t)
    }

    /// Bounds of f' over `t`.
    #[inline(always)]
    pub fn bounds(&self, p: P, t: &Interval<P::F>, live: P::M) -> Interval<P::F> {
        self.add(p, live);
        self.probe.bounds(p, t)
    }
}

/// A surface bound to rays.
pub struct Bound<'a, S: Surface, P: Packet> {
    /// After the surface stage.
    pub prepared: &'a S::Prepared,
    /// After the ray stage.
    pub bound: S::Bound<P>,
}

struct Value<'a, S: Surface, P: Packet>(&'a Bound<'a, S, P>, P::F);
struct Slope<'a, S: Surface, P: Packet>(&'a Bound<'a, S, P>, P::F);
struct Bounds<'a, S: Surface, P: Packet>(&'a Bound<'a, S, P>, Interval<P::F>);

impl<S: Surface, P: Packet> Routine<P> for Value<'_, S, P> {
    type Output = P::F;
    #[inline(always)]
    fn call(self, p: P) -> P::F {
        S::value(Nearest(p), self.0.prepared, &self.0.bound, At(self.1)).d[0]
    }
}

impl<S: Surface, P: Packet> Routine<P> for Slope<'_, S, P> {
    type Output = [P::F; 2];
    #[inline(always)]
    fn call(self, p: P) -> [P::F; 2] {
        S::slope(Nearest(p), self.0.prepared, &self.0.bound, At(self.1)).d
    }
}

impl<S: Surface, P: Packet> Routine<P> for Bounds<'_, S, P> {
    type Output = Interval<P::F>;
    #[inline(always)]
    fn call(self, p: P) -> Interval<P::F> {
        S::slope(p, self.0.prepared, &self.0.bound, self.1).d[1]
    }
}

impl<S: Surface, P: Packet> Probe<P> for Bound<'_, S, P> {
    fn value(&self, p: P, t: P::F) -> P::F {
        p.call(Value(self, t))
    }
    fn slope(&self, p: P, t: P::F) -> [P::F; 2] {
        p.call(Slope(self, t))
    }
    fn bounds(&self, p: P, t: &Interval<P::F>) -> Interval<P::F> {
        p.call(Bounds(self, *t))
    }
}
