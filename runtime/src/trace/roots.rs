//! All roots along one ray, or the first.

use core::marker::PhantomData;

use super::{Entries, FirstRoots, OnRays};
use crate::contract::Contractor;
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::{Lines, Rays, clip};
use crate::scene::Search;
use crate::solve::{Evaluations, Events, Settings, Solver};
use crate::surface::Surface;
use crate::verdict::{Verdict, Why};

/// What is known about one ray and one surface.
#[derive(Clone, Debug, Default)]
pub struct Trail {
    /// The parameter from which t counts.
    pub entry: f64,
    /// The last t inside the box; nothing if the ray misses it.
    pub end: Option<f64>,
    /// What was met, in ascending order. Elsewhere on [0, `end`] f certainly has no root, up to where the search ended.
    pub events: Vec<Verdict>,
    /// Where the search went on: pieces between these were excluded one by one.
    pub cuts: Vec<f64>,
    /// What it took.
    pub evaluations: Evaluations,
}

/// The ordered list of events along one ray inside a box.
pub(crate) struct AlongRay<'a, S: Surface, C> {
    pub prepared: &'a S::Prepared,
    pub settings: &'a Settings,
    pub search: &'a Search<'a>,
    /// End at the first certain root?
    pub first_only: bool,
    pub solver: PhantomData<C>,
}

impl<S: Surface, C: Contractor> Kernel for AlongRay<'_, S, C> {
    type Output = Trail;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Trail {
        let mut counts = Evaluations::default();
        let lines = Lines::same(self.search.ray);
        let span = clip(p, &lines, self.search.domain);
        if p.bits(p.le(span.near, span.far)) & 1 == 0 {
            return Trail::default();
        }
        let length = p.sub_ru(span.far, span.near);
        let mut trail = Trail {
            entry: p.to_array(span.near)[0],
            end: Some(p.to_array(length)[0]),
            ..Trail::default()
        };
        let rays = Rays::recentred(p, &lines, span.near, length);
        let (mut bound, active) = (S::unbound::<P>(p), S::everything(self.prepared));
        let mut surface = OnRays {
            entries: Entries::<S, P>::bind(p, self.prepared, &rays, &active, &mut bound),
            counts: &mut counts,
            spent: p.splat(0.0),
        };
        let entry = span.near;
        let whole = Interval {
            lo: p.splat(0.0),
            hi: length,
        };
        let mut over = match self.search.within {
            None => whole,
            Some([first, last]) => Interval {
                lo: p.max_f(p.sub_rd(p.splat(first), entry), whole.lo),
                hi: p.min_f(p.sub_ru(p.splat(last), entry), whole.hi),
            },
        };
        if p.bits(p.le(over.lo, over.hi)) & 1 == 0 {
            return trail;
        }
        loop {
            let t = over;
            let searched = Searched::<S, P> {
                surface: &mut surface,
                settings: self.settings,
                lines: &lines,
                entry,
                first_only: self.first_only,
                solver: C::solver(),
            };
            searched.along(p, t, &mut trail);
            // What the ends of a shorter search may have caused is looked at again.
            let plain = trail
                .events
                .iter()
                .all(|e| matches!(e, Verdict::Root { .. }));
            let all = p.bits(p.and(p.le(t.lo, whole.lo), p.le(whole.hi, t.hi))) & 1 != 0;
            if plain || all {
                break;
            }
            trail.events.clear();
            trail.cuts.clear();
            over = whole;
        }
        trail.evaluations = counts;
        // Where searches meet, events may have become one.
        let end = p.to_array(length)[0];
        for event in &mut trail.events {
            *event = event.unless_vague(end);
        }
        if self.first_only {
            let first = trail.events.iter().position(Verdict::is_certain_hit);
            trail
                .events
                .truncate(first.map_or(usize::MAX, |hit| hit + 1));
        }
        trail
    }
}

/// A search along the first ray of a packet.
struct Searched<'b, 'f, S: Surface, P: Packet> {
    surface: &'b mut OnRays<'f, S, P>,
    settings: &'b Settings,
    lines: &'b Lines,
    entry: P::F,
    first_only: bool,
    solver: Solver<P>,
}

impl<S: Surface, P: Packet> Searched<'_, '_, S, P> {
    /// Root after root.
    #[inline(always)]
    fn along(self, p: P, mut over: Interval<P::F>, trail: &mut Trail) {
        let mut events = Events::default();
        let number = |x: P::F| p.to_array(x)[0];
        loop {
            let job = FirstRoots::<S, P> {
                surface: &mut *self.surface,
                settings: self.settings,
                lines: self.lines,
                entry: self.entry,
                over: &over,
                live: p.mask(1),
                first: over.hi,
                known: None,
                first_only: self.first_only,
                twice: self.settings.narrowing.twice(false),
                by_sign: false,
                events: &mut events,
                cuts: Some(&mut trail.cuts),
                solver: self.solver,
            };
            let roots = job.find(p);
            for verdict in &events.of[0] {
                verdict.append(&mut trail.events);
            }
            events.clear();
            if p.bits(roots.hit) & 1 == 0 {
                return;
            }
            let t = Interval {
                lo: number(roots.t.lo),
                hi: number(roots.t.hi),
            };
            Verdict::Root { t }.append(&mut trail.events);
            over.lo = roots.resume;
            let rest = Interval {
                lo: number(over.lo),
                hi: number(over.hi),
            };
            if self.first_only || rest.lo >= rest.hi {
                return;
            }
            // What is kept back finishes one search, not the next.
            if number(self.surface.spent) > self.settings.limit() {
                let why = Why::Budget;
                Verdict::Unresolved { t: rest, why }.append(&mut trail.events);
                return;
            }
        }
    }
}
