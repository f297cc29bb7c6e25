//! The rays of a tile against one surface.

use core::marker::PhantomData;

use super::{Bind, Entries, FirstRoots, OnRays};
use crate::contract::Contractor;
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::{Rays, clip};
use crate::render::tile::{Event, PacketRays, Tile};
use crate::solve::{Events, Settings};
use crate::surface::Surface;
use crate::verdict::Verdict;

/// Traces one surface through a tile, and keeps what is nearer than what the tile holds.
pub(crate) struct TraceTile<'a, S: Surface, C> {
    prepared: &'a S::Prepared,
    settings: &'a Settings,
    domain: &'a [[f64; 3]; 2],
    index: u16,
    tile: &'a mut Tile,
    solver: PhantomData<C>,
}

impl<'a, S: Surface, C: Contractor> TraceTile<'a, S, C> {
    pub fn new(
        prepared: &'a S::Prepared,
        settings: &'a Settings,
        domain: &'a [[f64; 3]; 2],
        index: u16,
        tile: &'a mut Tile,
    ) -> Self {
        TraceTile {
            prepared,
            settings,
            domain,
            index,
            tile,
            solver: PhantomData,
        }
    }
}

impl<S: Surface, C: Contractor> Kernel for TraceTile<'_, S, C> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let TraceTile {
            prepared,
            settings,
            domain,
            index,
            tile,
            ..
        } = self;
        let active = S::everything(prepared);
        let mut bound = S::unbound(p);
        let mut events = Events::default();
        let own = (*domain != tile.domain).then_some(domain);
        let solver = C::solver();
        for (number, packet) in tile.packets.iter_mut().enumerate() {
            let (over, live) = segment(p, packet, own);
            if !p.any(live) {
                continue;
            }
            let end = p.select(live, over.hi, p.splat(-1.0));
            let rays = Rays::recentred(p, &packet.lines, p.lanes(packet.record.entry), end);
            p.call(Bind::<S, P> {
                prepared,
                rays: &rays,
                active: &active,
                bound: &mut bound,
            });
            let mut surface = OnRays {
                entries: Entries::<S, P> {
                    prepared,
                    bound: &bound,
                },
                counts: &mut tile.counts,
            };
            let job = FirstRoots::<S, P> {
                surface: &mut surface,
                settings,
                lines: &packet.lines,
                entry: p.lanes(packet.record.entry),
                over: &over,
                live,
                first_only: true,
                events: &mut events,
                cuts: None,
                solver,
            };
            let roots = job.find(p);
            keep(p, packet, roots.hit, &roots.t, index);
            if events.touched != 0 {
                collect(packet, number as u16, index, &mut events, &mut tile.events);
            }
        }
    }
}

/// The part of each ray that is still of interest, inside the surface's own box if that is not the scene's.
#[inline(always)]
pub(crate) fn segment<P: Packet>(
    p: P,
    packet: &PacketRays,
    own: Option<&[[f64; 3]; 2]>,
) -> (Interval<P::F>, P::M) {
    let zero = p.splat(0.0);
    let limit = p.lanes(packet.limit);
    let mut live = p.le(zero, limit);
    let (mut start, mut end) = (zero, limit);
    if let Some(domain) = own {
        let entry = p.lanes(packet.record.entry);
        let span = clip(p, &packet.lines, domain);
        start = p.max_f(p.sub_rd(span.near, entry), zero);
        end = p.min_f(p.sub_ru(span.far, entry), limit);
        live = p.and(live, p.and(p.le(span.near, span.far), p.le(start, end)));
    }
    (
        Interval {
            lo: p.select(live, start, zero),
            hi: p.select(live, end, zero),
        },
        live,
    )
}

/// Keeps the nearer root of each ray. The search ended at the nearest one so far, so a new one begins no later than that
/// ends; where they overlap their order is open, and the one that begins first is shown.
#[inline(always)]
fn keep<P: Packet>(p: P, packet: &mut PacketRays, hit: P::M, t: &Interval<P::F>, index: u16) {
    let record = &mut packet.record;
    let (old_lo, old_hi) = (p.lanes(record.lo), p.lanes(record.hi));
    let nearer = p.and(hit, p.lt(t.lo, old_lo));
    let apart = p.or(p.lt(t.hi, old_lo), p.lt(old_hi, t.lo));
    let tied = p.bits(p.and_not(hit, apart));
    let nearer_bits = p.bits(nearer);
    record.tied = (record.tied & !p.bits(p.and(hit, apart))) | tied;
    record.shown |= nearer_bits;
    record.lo = p.to_array(p.select(nearer, t.lo, old_lo));
    record.hi = p.to_array(p.select(nearer, t.hi, old_hi));
    let limit = p.lanes(packet.limit);
    packet.limit = p.to_array(p.select(hit, p.min_f(limit, t.hi), limit));
    for (lane, surface) in record.surface.iter_mut().enumerate() {
        if nearer_bits >> lane & 1 != 0 {
            *surface = index;
        }
    }
}

/// Moves a packet's events to the tile. Nothing behind a certain hit is of interest.
#[cold]
fn collect(
    packet: &mut PacketRays,
    number: u16,
    index: u16,
    events: &mut Events,
    all: &mut Vec<Event>,
) {
    for lane in 0..8u8 {
        let i = usize::from(lane);
        if events.touched >> lane & 1 == 0 {
            continue;
        }
        packet.record.special |= 1 << lane;
        for &verdict in &events.of[i] {
            all.push(Event {
                packet: number,
                lane,
                surface: index,
                verdict,
            });
            if let Verdict::Crossing { t } | Verdict::Root { t } = verdict {
                packet.limit[i] = packet.limit[i].min(t.hi);
            }
        }
    }
    events.clear();
}
