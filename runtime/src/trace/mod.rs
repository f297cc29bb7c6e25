//! A surface's kernels: what a scene runs per tile, and what a program runs for one ray.

mod normals;
mod roots;
mod tile;

pub(crate) use normals::NormalsOfTile;
pub(crate) use roots::AllRoots;
pub(crate) use tile::TraceTile;

use crate::contract::Contractor;
use crate::interval::{Interval, Packet, Routine};
use crate::ray::Rays;
use crate::solve::{Brackets, Events, Field, Search, Settings, closed_form, march, refine};
use crate::surface::{Active, Surface};

/// The ray stage, a function of its own.
struct Bind<'a, S: Surface, P: Packet> {
    prepared: &'a S::Prepared,
    rays: &'a Rays<P>,
    active: &'a Active,
    bound: &'a mut S::Bound<P>,
}

impl<S: Surface, P: Packet> Routine<P> for Bind<'_, S, P> {
    type Output = ();
    #[inline(always)]
    fn call(self, p: P) {
        S::bind(p, self.prepared, self.rays, self.active, self.bound);
    }
}

/// The first certain roots of a packet.
struct Roots<P: Packet> {
    hit: P::M,
    t: Interval<P::F>,
    resume: P::F,
}

/// The first root of each live ray in `over`: by closed form where there is one, by the march otherwise.
#[inline(always)]
fn first_roots<S: Surface, C: Contractor, P: Packet>(
    field: &mut Field<'_, S, P>,
    settings: &Settings,
    over: Interval<P::F>,
    live: P::M,
    first_only: bool,
    events: &mut Events,
) -> Roots<P> {
    let p = field.p;
    let mut live = live;
    let mut roots = Roots {
        hit: p.mask(0),
        t: over,
        resume: over.hi,
    };
    if settings.closed_forms
        && let Some(leaf) = S::quadric(field.bound)
    {
        let first = closed_form(p, leaf).first_in(p, leaf, &over);
        roots = Roots {
            hit: p.and(live, first.hit),
            t: first.root,
            resume: first.resume,
        };
        live = p.and_not(live, first.decided);
        if !p.any(live) {
            return roots;
        }
    }
    let limit = field.counts.packets + u64::from(settings.budget);
    let search = Search {
        over,
        live,
        limit,
        first_only,
    };
    let found: Brackets<P> = march::<S, C, P>(field, &search, events);
    if p.any(found.found) {
        let t = refine(field, &found, settings.plain_convergence);
        roots.t = crate::solve::select(p, found.found, &t, &roots.t);
        roots.resume = p.select(found.found, found.resume, roots.resume);
        roots.hit = p.or(roots.hit, found.found);
    }
    roots
}
