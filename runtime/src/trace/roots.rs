//! All roots along one ray.

use core::marker::PhantomData;

use super::{Bind, FirstRoots};
use crate::camera::Ray;
use crate::contract::Contractor;
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::{Lines, Rays, clip};
use crate::solve::{Evaluations, Events, Field, Settings};
use crate::surface::Surface;
use crate::verdict::Verdict;

/// The ordered list of events along one ray inside a box.
pub(crate) struct AllRoots<'a, S: Surface, C> {
    prepared: &'a S::Prepared,
    settings: &'a Settings,
    domain: &'a [[f64; 3]; 2],
    ray: &'a Ray,
    solver: PhantomData<C>,
}

impl<'a, S: Surface, C: Contractor> AllRoots<'a, S, C> {
    pub fn new(
        prepared: &'a S::Prepared,
        settings: &'a Settings,
        domain: &'a [[f64; 3]; 2],
        ray: &'a Ray,
    ) -> Self {
        AllRoots {
            prepared,
            settings,
            domain,
            ray,
            solver: PhantomData,
        }
    }
}

impl<S: Surface, C: Contractor> Kernel for AllRoots<'_, S, C> {
    type Output = (f64, Vec<Verdict>, Evaluations);

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Self::Output {
        let mut counts = Evaluations::default();
        let lines = Lines::same(self.ray);
        let span = clip(p, &lines, self.domain);
        if p.bits(p.le(span.near, span.far)) & 1 == 0 {
            return (0.0, Vec::new(), counts);
        }
        let entry = p.to_array(span.near)[0];
        let length = p.sub_ru(span.far, span.near);
        let rays = Rays::recentred(p, &lines, span.near, length);
        let active = S::everything(self.prepared);
        let mut bound = S::unbound(p);
        p.call(Bind::<S, P> {
            prepared: self.prepared,
            rays: &rays,
            active: &active,
            bound: &mut bound,
        });
        let mut field = Field::<S, P> {
            p,
            prepared: self.prepared,
            bound: &bound,
            counts: &mut counts,
        };
        let mut found = Vec::new();
        let mut events = Events::default();
        let mut over = Interval {
            lo: p.splat(0.0),
            hi: length,
        };
        let one = p.mask(1);
        loop {
            let job = FirstRoots::<S, C, P> {
                field: &mut field,
                settings: self.settings,
                lines: &lines,
                entry: span.near,
                over: &over,
                live: one,
                first_only: false,
                events: &mut events,
                solver: PhantomData,
            };
            let roots = p.call(job);
            for verdict in &events.of[0] {
                verdict.append(&mut found);
            }
            events.clear();
            if p.bits(roots.hit) & 1 == 0 {
                break;
            }
            let t = Interval {
                lo: p.to_array(roots.t.lo)[0],
                hi: p.to_array(roots.t.hi)[0],
            };
            Verdict::Root { t }.append(&mut found);
            over.lo = roots.resume;
            if p.bits(p.lt(over.lo, over.hi)) & 1 == 0 {
                break;
            }
        }
        (entry, found, counts)
    }
}
