//! From contractors to verdicts: the first root along each ray of a packet, or all roots along one ray.

mod crawl;
mod field;
mod first;
mod floor;
mod line;
mod march;
mod quadric;
mod refine;
mod sharpen;
mod tangent;

pub(crate) use field::Along;
pub use field::{
    Enclosed, Evaluations, Field, differentiable, excluded, nonzero, twice_differentiable,
};
pub(crate) use first::{Job, Roots, Solver};
pub(crate) use march::Events;
pub(crate) use quadric::closed_form;
pub(crate) use sharpen::{Second, WIDE};

use refine::Refine;

use crate::contract::middle;
use crate::interval::{Interval, Packet};

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Evaluations of all kinds that one ray may take with one surface. A search gives the rest of its ray up, as
    /// [`Why::Budget`](crate::verdict::Why::Budget), when all but 1,000 of them are spent (or half, if there are fewer
    /// than 2,000): these finish what was found.
    pub budget: u32,
    /// Quadrics in closed form, proved by one Newton image, without a search.
    pub closed_forms: bool,
    /// Trace beams of rays before rays.
    pub beams: bool,
    /// Use the boxes of a scene that was [subdivided](crate::Scene::subdivided).
    pub space: bool,
    /// Visit only those rows of tables, and compute only those sides of choices, that can matter in a beam.
    pub thin: bool,
    /// Once a bracket with exactly one root is proved, converge in plain floats and certify the end; otherwise go on with
    /// enclosures.
    pub plain_convergence: bool,
    /// How far the intervals of roots are narrowed.
    pub narrowing: Narrowing,
}

/// How far the intervals of roots are narrowed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Narrowing {
    /// [`Double`](Self::Double) in pictures, [`Twice`](Self::Twice) for single rays.
    #[default]
    ByUse,
    /// As far as `f64` gets without more work: at most 5e-13 wide, some ten to a hundred units in the last place. More
    /// than a pixel can show.
    Double,
    /// To a unit in the last place or two, by one evaluation in twice the precision for each root. Where f calls functions that
    /// [`Fine`](crate::interval::Fine) has no finer than `f64`, as far as these allow.
    Twice,
}

impl Narrowing {
    /// In twice the precision?
    pub(crate) fn twice(self, picture: bool) -> bool {
        match self {
            Narrowing::ByUse => !picture,
            Narrowing::Double => false,
            Narrowing::Twice => true,
        }
    }
}

impl Settings {
    /// The number of evaluations after which a search gives up: what is at hand then is finished within the budget.
    pub(crate) fn limit(&self) -> f64 {
        let budget = f64::from(self.budget);
        budget - (0.5 * budget).min(1000.0)
    }
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            budget: 10_000,
            closed_forms: true,
            beams: true,
            space: true,
            thin: true,
            plain_convergence: true,
            narrowing: Narrowing::default(),
        }
    }
}

/// Segments that hold exactly one root each.
#[derive(Clone, Copy)]
pub(crate) struct Brackets<P: Packet> {
    /// The lanes that have one.
    pub found: P::M,
    /// f is continuous here, the ends have opposite certain signs or the Newton image lies inside, and one root is here.
    pub t: Interval<P::F>,
    /// f' over `t`; it may hold 0 where the root was proved otherwise.
    pub slope: Interval<P::F>,
    /// Does f rise through the root?
    pub rising: P::M,
    /// No other root lies before this; a search for the next goes on here.
    pub resume: P::F,
    /// Where the root may be: floats converge from here.
    pub guess: P::F,
}

impl<P: Packet> Brackets<P> {
    #[inline(always)]
    pub fn none(p: P) -> Self {
        let zero = p.splat(0.0);
        let t = Interval { lo: zero, hi: zero };
        Brackets {
            found: p.mask(0),
            t,
            slope: t,
            rising: p.mask(0),
            resume: zero,
            guess: zero,
        }
    }

    /// Takes over the lanes of `which`.
    #[inline(always)]
    pub fn put(
        &mut self,
        p: P,
        which: P::M,
        t: &Interval<P::F>,
        slope: &Interval<P::F>,
        rising: P::M,
        resume: P::F,
    ) {
        self.found = p.or(self.found, which);
        self.t = select(p, which, t, &self.t);
        self.slope = select(p, which, slope, &self.slope);
        self.rising = p.or(p.and(which, rising), p.and_not(self.rising, which));
        self.resume = p.select(which, resume, self.resume);
        self.guess = p.select(which, middle(p, t), self.guess);
    }

    /// Takes over the lanes of `which` from another set.
    #[inline(always)]
    pub fn join(&mut self, p: P, which: P::M, other: &Self) {
        self.put(p, which, &other.t, &other.slope, other.rising, other.resume);
        self.guess = p.select(which, other.guess, self.guess);
    }
}

/// Lane-wise `which ? yes : no`.
#[inline(always)]
pub(crate) fn select<P: Packet>(
    p: P,
    which: P::M,
    yes: &Interval<P::F>,
    no: &Interval<P::F>,
) -> Interval<P::F> {
    Interval {
        lo: p.select(which, yes.lo, no.lo),
        hi: p.select(which, yes.hi, no.hi),
    }
}
