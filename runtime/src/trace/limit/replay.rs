//! The evaluations of a plan once more, and nothing else: this is timed.

use super::super::Entries;
use super::super::beams::{OverGroup, WithBeams};
use super::super::normals::{Gradient, points};
use super::plan::{OfPacket, Plan};
use super::{Part, compiled};
use crate::beam::{Bundle, Group};
use crate::interval::{At, Interval, Kernel, Packet};
use crate::ray::Rays;
use crate::render::tile::{PacketRays, View};
use crate::solve::{Along, excluded, nonzero};
use crate::surface::Surface;

/// Evaluates a plan up to a part, and counts the lanes that do not prove what they should.
pub(super) struct Replay<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub view: &'a View<'a>,
    pub beams: WithBeams<'a>,
    pub plan: &'a Plan,
    pub upto: Part,
}

impl<S: Surface> Kernel for Replay<'_, S> {
    type Output = u64;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> u64 {
        if const { compiled::<P>() } {
            self.groups(p);
            if self.upto > Part::Beams {
                return self.packets(p);
            }
        }
        0
    }
}

impl<S: Surface> Replay<'_, S> {
    #[inline(always)]
    fn groups<P: Packet>(&self, p: P) {
        let Some(mut over) = OverGroup::<S, P>::new(p, self.prepared, self.beams.leaves) else {
            return;
        };
        for of in &self.plan.groups {
            let group = Group::new(p, self.beams.space.frame, of.corner, of.grid);
            over.shift(p, &group.shift(p), &self.plan.actives[of.active]);
            let t = Interval {
                lo: p.lanes(of.t[0]),
                hi: p.lanes(of.t[1]),
            };
            let slab = group.slab(p, &t);
            std::hint::black_box(p.bits(nonzero(p, &over.value(p, &slab).d[0])));
        }
    }

    #[inline(always)]
    fn packets<P: Packet>(&self, p: P) -> u64 {
        let mut bound = S::unbound::<P>(p);
        let mut packet = PacketRays::default();
        let mut failed = 0;
        for of in &self.plan.packets {
            let passing = self.upto >= Part::Passing && !of.passing.is_empty();
            if of.hits == 0 && !passing {
                continue;
            }
            let (view, lines) = (self.view, &mut packet.lines);
            view.camera
                .rays(p, of.corner, view.picture, view.sampling, lines);
            packet.enter(p, of.inside, self.beams.space.domain);
            let (entry, limit) = (p.lanes(packet.record.entry), p.lanes(packet.limit));
            let rays = Rays::recentred(p, &packet.lines, entry, limit);
            let active = &self.plan.actives[of.active];
            let mut field = Entries::<S, P>::bind(p, self.prepared, &rays, active, &mut bound);
            if self.upto >= Part::Ways {
                failed += self.free(p, &mut field, p.mask(of.hits), of.ways.clone());
            }
            if self.upto >= Part::Ends && of.hits != 0 {
                failed += ends(p, &mut field, of);
            }
            if self.upto >= Part::Gradients && of.hits != 0 {
                (packet.record.lo, packet.record.hi) = (of.root[0], of.root[1]);
                let point = points(p, &packet);
                let f = p.call(Gradient::<S, P> {
                    prepared: self.prepared,
                    active: &self.plan.actives[of.active],
                    point: &point,
                });
                std::hint::black_box(p.to_array(f[1]));
            }
            if passing {
                failed += self.free(p, &mut field, p.mask(of.passed), of.passing.clone());
            }
        }
        failed
    }

    /// f over pieces.
    #[inline(always)]
    fn free<P: Packet>(
        &self,
        p: P,
        field: &mut Entries<S, P>,
        lanes: P::M,
        pieces: std::ops::Range<usize>,
    ) -> u64 {
        let mut failed = 0;
        for piece in &self.plan.pieces[pieces] {
            let t = Interval {
                lo: p.lanes(piece[0]),
                hi: p.lanes(piece[1]),
            };
            let f = field.value(p, &t);
            let meant = p.and(p.lt(t.lo, t.hi), lanes);
            let free = excluded(p, &f.d[0], &f.flags, meant);
            failed += u64::from(p.bits(p.and_not(meant, free)).count_ones());
        }
        failed
    }
}

/// f at both ends of the roots' intervals, and its slope around them. (How wide f is at an end may hide its sign: the
/// render has seen to that with the slope, and it is not counted.)
#[inline(always)]
fn ends<S: Surface, P: Packet>(p: P, field: &mut Entries<S, P>, of: &OfPacket) -> u64 {
    let [lo, hi] = of.root.map(|x| p.lanes(x));
    let signs = [lo, hi].map(|t| nonzero(p, &field.point(p, &At(t)).d[0]));
    std::hint::black_box(p.bits(p.and(signs[0], signs[1])));
    let around = Interval {
        lo: p.lanes(of.around[0]),
        hi: p.lanes(of.around[1]),
    };
    let monotone = nonzero(p, &field.slope(p, &around).d[1]);
    u64::from(p.bits(p.and_not(p.mask(of.hits), monotone)).count_ones())
}
