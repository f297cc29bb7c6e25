//! A surface's kernels: what a scene runs per tile, and what a program runs for one ray.

mod beams;
mod entries;
#[cfg(feature = "limit")]
pub mod limit;
mod lone;
mod nearest;
mod normals;
mod packet;
mod range;
mod roots;
mod survey;
mod tile;
mod trails;

pub(crate) use beams::{
    AssembleLeaves, AssembleOperand, DivideBoxes, Leaves, OnPicture, Operand, SurveyGrid, WithBeams,
};
pub(crate) use lone::{Lone, TraceLone};
pub(crate) use nearest::segment;
pub(crate) use normals::NormalsOfTile;
pub(crate) use range::RangeAlong;
pub(crate) use roots::AlongRay;
pub use roots::Trail;
pub(crate) use survey::{Beam, BeamOf, SideOfBoxes, Survey, eighth};
pub(crate) use tile::TraceTile;
pub(crate) use trails::{Mark, Trails, TrailsOfTile};

use crate::interval::{Interval, Packet};
use crate::ray::Lines;
use crate::solve::{
    Brackets, Evaluations, Events, Field, Job, Roots, Second, Settings, Solver, WIDE, closed_form,
    select,
};
use crate::surface::Surface;
use entries::Entries;

/// A surface bound to the rays of one packet, and the count of its evaluations.
struct OnRays<'a, S: Surface, P: Packet> {
    entries: Entries<'a, S, P>,
    counts: &'a mut Evaluations,
    /// Evaluations that each ray took so far.
    spent: P::F,
}

/// The first root of each live ray in `over`: by closed form where there is one, by a solver otherwise.
struct FirstRoots<'b, 'f, S: Surface, P: Packet> {
    surface: &'b mut OnRays<'f, S, P>,
    settings: &'b Settings,
    lines: &'b Lines,
    entry: P::F,
    over: &'b Interval<P::F>,
    live: P::M,
    /// How long the first steps are.
    first: P::F,
    /// Rays with exactly one root, of which it is known where: they are not searched.
    known: Option<&'b Brackets<P>>,
    first_only: bool,
    /// Narrow the intervals of roots in twice the precision?
    twice: bool,
    /// Are events, and roots that are too wide, left as they are? Twice the precision is for f itself, not for what has its
    /// sign only.
    by_sign: bool,
    events: &'b mut Events,
    /// Where the first ray's search went on, for those who keep account.
    cuts: Option<&'b mut Vec<f64>>,
    solver: Solver<P>,
}

impl<S: Surface, P: Packet> FirstRoots<'_, '_, S, P> {
    #[inline(always)]
    fn find(mut self, p: P) -> Roots<P> {
        let mut roots = self.found(p);
        let width = p.sub_ru(roots.t.hi, roots.t.lo);
        if self.by_sign {
            roots.vague = p.and(roots.hit, p.lt(p.splat(WIDE), width));
            return roots;
        }
        let goal = if self.twice {
            p.mul_rn(roots.t.hi, p.splat(2.0 * f64::EPSILON))
        } else {
            p.splat(WIDE)
        };
        let wide = p.and(roots.hit, p.lt(goal, width));
        if p.any(wide) || self.events.touched != 0 {
            let OnRays {
                entries,
                counts,
                spent,
            } = self.surface;
            let second = Second {
                field: Field::new(p, entries, counts, spent),
                lines: self.lines,
                entry: self.entry,
                end: self.over.hi,
                wide: p.bits(wide),
                goal,
                bends: self.solver.bends,
                budget: self.settings.budget,
                events: self.events,
            };
            self.solver.sharpen(second, &mut roots.t);
        }
        roots
    }

    #[inline(always)]
    fn found(&mut self, p: P) -> Roots<P> {
        let mut live = self.live;
        let mut closed = None;
        if self.settings.closed_forms
            && p.any(live)
            && let Some(leaf) = S::quadric::<P>(self.surface.entries.bound)
        {
            let first = closed_form(p, leaf, self.over, live);
            let roots = Roots {
                hit: p.and(live, first.hit),
                t: first.root,
                resume: first.resume,
                vague: p.none(),
            };
            let decided = p.and(live, first.decided);
            self.surface.counts.closed += u64::from(p.bits(decided).count_ones());
            live = p.and_not(live, decided);
            if !p.any(live) && self.known.is_none() {
                return roots;
            }
            closed = Some(roots);
        }
        let found = self.searched(p, live);
        match closed {
            None => found,
            Some(roots) => Roots {
                hit: p.or(roots.hit, found.hit),
                t: select(p, found.hit, &found.t, &roots.t),
                resume: p.select(found.hit, found.resume, roots.resume),
                vague: p.none(),
            },
        }
    }

    /// What the solver finds for the rays of `live`.
    #[inline(always)]
    fn searched(&mut self, p: P, live: P::M) -> Roots<P> {
        let OnRays {
            entries,
            counts,
            spent,
        } = &mut *self.surface;
        self.solver.search(Job {
            field: Field::new(p, entries, counts, spent),
            settings: self.settings,
            over: self.over,
            live,
            first: self.first,
            known: self.known,
            first_only: self.first_only,
            events: self.events,
            cuts: self.cuts.as_deref_mut(),
        })
    }
}
