//! A surface's kernels: what a scene runs per tile, and what a program runs for one ray.

mod normals;
mod roots;
mod tile;

pub(crate) use normals::NormalsOfTile;
pub(crate) use roots::{AlongRay, Trail};
pub(crate) use tile::TraceTile;

use crate::contract::Contractor;
use core::marker::PhantomData;

use crate::interval::{Interval, Packet, Routine};
use crate::ray::{Lines, Rays};
use crate::solve::{
    Brackets, Events, Field, Line, Refine, Search, Settings, WIDE, closed_form, march, select,
    sharpen,
};
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

/// The first root of each live ray in `over`: by closed form where there is one, by the march otherwise. A function of
/// its own, which tiles and single rays share.
struct FirstRoots<'b, 'f, S: Surface, C, P: Packet> {
    field: &'b mut Field<'f, S, P>,
    settings: &'b Settings,
    lines: &'b Lines,
    entry: P::F,
    over: &'b Interval<P::F>,
    live: P::M,
    first_only: bool,
    events: &'b mut Events,
    /// Where the first ray's search went on, for those who keep account.
    cuts: Option<&'b mut Vec<f64>>,
    solver: PhantomData<C>,
}

impl<S: Surface, C: Contractor, P: Packet> Routine<P> for FirstRoots<'_, '_, S, C, P> {
    type Output = Roots<P>;

    #[inline(always)]
    fn call(mut self, p: P) -> Roots<P> {
        let mut roots = self.found(p);
        let width = p.sub_ru(roots.t.hi, roots.t.lo);
        let wide = p.and(roots.hit, p.lt(p.splat(WIDE), width));
        if p.any(wide) {
            self.sharpened(p, p.bits(wide), &mut roots);
        }
        roots
    }
}

impl<S: Surface, C: Contractor, P: Packet> FirstRoots<'_, '_, S, C, P> {
    /// Twice the precision for the lanes of `wide`.
    #[cold]
    fn sharpened(&mut self, p: P, wide: u8, roots: &mut Roots<P>) {
        let entry = p.to_array(self.entry);
        let (mut lo, mut hi) = (p.to_array(roots.t.lo), p.to_array(roots.t.hi));
        for lane in (0..8).filter(|lane| wide >> lane & 1 != 0) {
            let line = Line {
                origin: [0, 1, 2].map(|k| self.lines.origin[k][lane]),
                direction: [0, 1, 2].map(|k| self.lines.direction[k][lane]),
                entry: entry[lane],
            };
            let root = Interval {
                lo: lo[lane],
                hi: hi[lane],
            };
            let root = sharpen::<S>(
                self.field.prepared,
                &line,
                root,
                &mut self.field.counts.fine,
            );
            (lo[lane], hi[lane]) = (root.lo, root.hi);
        }
        roots.t = Interval {
            lo: p.lanes(lo),
            hi: p.lanes(hi),
        };
    }

    #[inline(always)]
    fn found(&mut self, p: P) -> Roots<P> {
        let FirstRoots {
            field,
            settings,
            over,
            events,
            cuts,
            first_only,
            ..
        } = self;
        let (over, first_only) = (*over, *first_only);
        let mut live = self.live;
        let mut roots = Roots {
            hit: p.mask(0),
            t: *over,
            resume: over.hi,
        };
        if settings.closed_forms
            && let Some(leaf) = S::quadric(field.bound)
        {
            let first = closed_form(p, leaf, live).first_in(p, leaf, over);
            roots = Roots {
                hit: p.and(live, first.hit),
                t: first.root,
                resume: first.resume,
            };
            let decided = p.and(live, first.decided);
            field.counts.closed += u64::from(p.bits(decided).count_ones());
            live = p.and_not(live, decided);
            if !p.any(live) {
                return roots;
            }
        }
        let limit = field.counts.packets + u64::from(settings.budget);
        let search = Search {
            over: *over,
            live,
            limit,
            first_only,
        };
        let found: Brackets<P> = march::<S, C, P>(field, &search, events, cuts.as_deref_mut());
        if p.any(found.found) {
            let t = p.call(Refine {
                field,
                brackets: &found,
                plain_convergence: settings.plain_convergence,
            });
            roots.t = select(p, found.found, &t, &roots.t);
            roots.resume = p.select(found.found, found.resume, roots.resume);
            roots.hit = p.or(roots.hit, found.found);
        }
        roots
    }
}
