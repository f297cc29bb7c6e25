//! All roots along one ray, or the first.

use core::marker::PhantomData;

use super::{Entries, FirstRoots, OnRays, bound};
use crate::camera::Ray;
use crate::contract::Contractor;
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::{Lines, Rays, clip};
use crate::solve::{Evaluations, Events, Settings};
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
    pub domain: &'a [[f64; 3]; 2],
    pub ray: &'a Ray,
    /// End at the first certain root?
    pub first_only: bool,
    pub solver: PhantomData<C>,
}

impl<S: Surface, C: Contractor> Kernel for AlongRay<'_, S, C> {
    type Output = Trail;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Trail {
        let mut counts = Evaluations::default();
        let lines = Lines::same(self.ray);
        let span = clip(p, &lines, self.domain);
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
        let bound = bound::<S, P>(p, self.prepared, &rays);
        let mut surface = OnRays {
            entries: Entries::<S, P> {
                prepared: self.prepared,
                bound: &bound,
                rays: &rays,
            },
            counts: &mut counts,
            spent: p.splat(0.0),
        };
        let mut events = Events::default();
        let solver = C::solver();
        let mut over = Interval {
            lo: p.splat(0.0),
            hi: length,
        };
        let one = p.mask(1);
        loop {
            let job = FirstRoots::<S, P> {
                surface: &mut surface,
                settings: self.settings,
                lines: &lines,
                entry: span.near,
                over: &over,
                live: one,
                first: length,
                known: None,
                first_only: self.first_only,
                twice: self.settings.narrowing.twice(false),
                events: &mut events,
                cuts: Some(&mut trail.cuts),
                solver,
            };
            let roots = job.find(p);
            for verdict in &events.of[0] {
                verdict.append(&mut trail.events);
            }
            events.clear();
            if p.bits(roots.hit) & 1 == 0 {
                break;
            }
            let t = Interval {
                lo: p.to_array(roots.t.lo)[0],
                hi: p.to_array(roots.t.hi)[0],
            };
            Verdict::Root { t }.append(&mut trail.events);
            over.lo = roots.resume;
            let rest = Interval {
                lo: p.to_array(over.lo)[0],
                hi: p.to_array(over.hi)[0],
            };
            if self.first_only || rest.lo >= rest.hi {
                break;
            }
            // What is kept back finishes one search, not the next.
            if p.to_array(surface.spent)[0] > self.settings.limit() {
                let why = Why::Budget;
                Verdict::Unresolved { t: rest, why }.append(&mut trail.events);
                break;
            }
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
