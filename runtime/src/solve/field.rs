//! The one place where a solver evaluates a surface: each entry point is a function of its own per instruction set,
//! and is counted.

use crate::interval::{At, Ball, Flags, Interval, Jet, Packet, Scalar};
use crate::surface::Active;

/// A surface along the rays of one packet. An object, so that a solver is compiled once per instruction set, and not
/// again for each surface: the call costs nothing beside an evaluation.
pub(crate) trait Along<P: Packet> {
    /// f over `t`.
    fn value(&mut self, p: P, t: &Interval<P::F>) -> Enclosed<P, 1>;
    /// f over `t` by plain interval arithmetic in space, for the lanes of `live`.
    fn natural(&self, p: P, t: &Interval<P::F>, live: P::M) -> Enclosed<P, 1>;
    /// f and f' over `t`.
    fn slope(&mut self, p: P, t: &Interval<P::F>) -> Enclosed<P, 2>;
    /// f, f' and f'' over `t`.
    fn curvature(&mut self, p: P, t: &Interval<P::F>) -> Enclosed<P, 3>;
    /// f at `t`.
    fn point(&self, p: P, t: &At<P::F>) -> Enclosed<P, 1>;
    /// f and f' at `t` in plain floats.
    fn float(&self, p: P, t: &At<P::F>) -> [P::F; 2];
    /// f and its gradient at a point of space in twice the precision.
    fn fine(&self, point: &[Ball; 3]) -> ([Ball; 4], Flags<Scalar>);
    /// f from the active rows and what the others add, if there are any others.
    fn fine_value(&self, point: &[Ball; 3]) -> Option<(Ball, Flags<Scalar>)>;
}

/// f along the rays of one packet, counted.
pub struct Field<'a, P: Packet> {
    pub(crate) p: P,
    pub(crate) along: &'a mut dyn Along<P>,
    pub(crate) counts: &'a mut Evaluations,
    /// Evaluations of all kinds that each ray took so far.
    pub(crate) spent: &'a mut P::F,
}

/// f and its first `N − 1` derivatives over the segments of a packet.
pub type Enclosed<P, const N: usize> = Jet<Interval<<P as crate::interval::Lanes>::F>, P, N>;

/// How often a surface was evaluated: per ray, that is, per lane that needed it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Evaluations {
    /// Enclosures of f over segments.
    pub value: u64,
    /// Enclosures of f and f' over segments.
    pub slope: u64,
    /// Enclosures of f, f' and f'' over segments.
    pub curvature: u64,
    /// Enclosures of f at points.
    pub point: u64,
    /// f and f' in plain floats.
    pub float: u64,
    /// f and f' at points, in twice the precision.
    pub fine: u64,
    /// Gradients in space, in plain floats.
    pub gradient: u64,
    /// Rays decided by the closed form of a quadric, without a search.
    pub closed: u64,
    /// Operands of solids that were not searched along a ray or a piece of it, because they cannot matter there: one by one
    /// and ray by ray, of rays that beams leave open.
    pub spared: u64,
    /// Operands of solids that were searched along a part of a ray only.
    pub shortened: u64,
    /// Rays whose only root a beam had separated: they are not searched.
    pub single: u64,
    /// Rays for which a surface was not evaluated because their tile or cell of the picture passes by its box, or by all
    /// boxes of its octree: surface by surface.
    pub apart: u64,
    /// Rays whose search for a surface was shortened to where boxes of its octree are.
    pub trimmed: u64,
    /// Rows of tables that packets of eight rays were bound to.
    pub rows: u64,
    /// Choices between two sides that were decided for packets of eight rays.
    pub decided: u64,
    /// Pieces of rays behind where lists of what is near hold, in which a beam has excluded all roots: they are not searched.
    pub empty: u64,
    /// Enclosures over beams, each counted once per packet of eight.
    pub beams: u64,
    /// Evaluations of all other kinds, each counted once per packet of eight.
    pub packets: u64,
}

impl Evaluations {
    /// All kinds of evaluations together; closed forms and what beams settle are none.
    pub fn total(&self) -> u64 {
        self.value
            + self.slope
            + self.curvature
            + self.point
            + self.float
            + self.fine
            + self.gradient
    }

    /// Counts what a packet is bound with.
    #[inline]
    pub(crate) fn note(&mut self, active: &Active) {
        self.rows += active
            .rows
            .iter()
            .map(|rows| rows.len() as u64)
            .sum::<u64>();
        let [decided, _] = active.choices();
        self.decided += u64::from(decided);
    }

    pub(crate) fn add(&mut self, other: &Evaluations) {
        self.value += other.value;
        self.slope += other.slope;
        self.curvature += other.curvature;
        self.point += other.point;
        self.float += other.float;
        self.fine += other.fine;
        self.gradient += other.gradient;
        self.closed += other.closed;
        self.spared += other.spared;
        self.shortened += other.shortened;
        self.single += other.single;
        self.apart += other.apart;
        self.trimmed += other.trimmed;
        self.rows += other.rows;
        self.decided += other.decided;
        self.empty += other.empty;
        self.beams += other.beams;
        self.packets += other.packets;
    }
}

impl<'a, P: Packet> Field<'a, P> {
    #[inline(always)]
    pub(crate) fn new(
        p: P,
        along: &'a mut dyn Along<P>,
        counts: &'a mut Evaluations,
        spent: &'a mut P::F,
    ) -> Self {
        Field {
            p,
            along,
            counts,
            spent,
        }
    }

    /// Counts an evaluation for the lanes that it serves: how many these are.
    #[inline(always)]
    fn served(&mut self, live: P::M) -> u64 {
        let p = self.p;
        let more = p.add_rn(*self.spent, p.splat(1.0));
        *self.spent = p.select(live, more, *self.spent);
        self.counts.packets += 1;
        u64::from(p.bits(live).count_ones())
    }

    /// f over `t`, for the lanes of `live`; other lanes hold anything.
    #[inline(always)]
    pub fn value(&mut self, t: &Interval<P::F>, live: P::M) -> Enclosed<P, 1> {
        self.counts.value += self.served(live);
        self.along.value(self.p, t)
    }

    /// f over `t` by plain interval arithmetic in space.
    pub fn natural(&mut self, t: &Interval<P::F>, live: P::M) -> Enclosed<P, 1> {
        self.counts.value += self.served(live);
        self.along.natural(self.p, t, live)
    }

    /// f and f' over `t`.
    #[inline(always)]
    pub fn slope(&mut self, t: &Interval<P::F>, live: P::M) -> Enclosed<P, 2> {
        self.counts.slope += self.served(live);
        self.along.slope(self.p, t)
    }

    /// f, f' and f'' over `t`.
    #[inline(always)]
    pub fn curvature(&mut self, t: &Interval<P::F>, live: P::M) -> Enclosed<P, 3> {
        self.counts.curvature += self.served(live);
        self.along.curvature(self.p, t)
    }

    /// f at `t`, enclosed.
    #[inline(always)]
    pub fn point(&mut self, t: P::F, live: P::M) -> Enclosed<P, 1> {
        self.counts.point += self.served(live);
        self.along.point(self.p, &At(t))
    }

    /// f and f' at `t` in plain floats, without any guarantee.
    #[inline(always)]
    pub fn float(&mut self, t: P::F, live: P::M) -> [P::F; 2] {
        self.counts.float += self.served(live);
        self.along.float(self.p, &At(t))
    }
}

/// Where f' may be used: f is certainly defined and continuous there (kinks are enclosed by a hull).
#[inline(always)]
pub fn differentiable<P: Packet>(p: P, flags: &Flags<P>, live: P::M) -> P::M {
    p.and_not(p.and_not(live, flags.undefined), flags.jump)
}

/// Where f'' may be used: no kinks either.
#[inline(always)]
pub fn twice_differentiable<P: Packet>(p: P, flags: &Flags<P>, live: P::M) -> P::M {
    p.and_not(differentiable(p, flags, live), flags.kink)
}

/// Where 0 ∉ F, or f is defined nowhere: there is no root, and no flag needs to be asked.
#[inline(always)]
pub fn excluded<P: Packet>(p: P, f: &Interval<P::F>, flags: &Flags<P>, live: P::M) -> P::M {
    p.and(live, p.or(flags.empty, nonzero(p, f)))
}

/// Where the enclosure does not hold 0.
#[inline(always)]
pub fn nonzero<P: Packet>(p: P, f: &Interval<P::F>) -> P::M {
    let zero = p.splat(0.0);
    p.or(p.lt(zero, f.lo), p.lt(f.hi, zero))
}
