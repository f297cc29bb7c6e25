//! A surface over a whole tile, or over boxes: is it certainly somewhere else? For solids.

use core::marker::PhantomData;

use super::Entries;
use crate::interval::{Interval, Kernel, Packet, Routine};
use crate::ray::Rays;
use crate::render::tile::PacketRays;
use crate::solid::Side;
use crate::solve::{Along, Enclosed, Evaluations, Field};
use crate::surface::Surface;

/// All rays of a tile in one: each ray's origin, where it enters the box, and direction lie in these.
#[derive(Clone, Copy)]
pub(crate) struct Beam {
    pub origin: [Interval; 3],
    pub direction: [Interval; 3],
    /// The last t of interest on any ray.
    pub end: f64,
}

/// Makes the beam of a tile's rays; nothing if there are none.
pub(crate) struct BeamOf<'a> {
    pub packets: &'a [PacketRays],
}

impl Kernel for BeamOf<'_> {
    type Output = Option<Beam>;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Option<Beam> {
        let nothing = Interval {
            lo: f64::INFINITY,
            hi: f64::NEG_INFINITY,
        };
        let mut beam = Beam {
            origin: [nothing; 3],
            direction: [nothing; 3],
            end: -1.0,
        };
        for packet in self.packets {
            let limit = p.lanes(packet.limit);
            let rays = Rays::recentred(p, &packet.lines, p.lanes(packet.record.entry), limit);
            let live = p.bits(p.le(p.splat(0.0), limit));
            if live == 0 {
                continue;
            }
            let ends = packet.limit.iter().copied();
            beam.end = ends.fold(beam.end, f64::max);
            let parts = beam.origin.iter_mut().chain(&mut beam.direction);
            for (hull, part) in parts.zip(rays.origin.iter().chain(&rays.direction)) {
                let (lo, hi) = (p.to_array(part.lo), p.to_array(part.hi));
                for lane in (0..8).filter(|lane| live >> lane & 1 != 0) {
                    *hull = hull.hull(&Interval {
                        lo: lo[lane],
                        hi: hi[lane],
                    });
                }
            }
        }
        (beam.end >= 0.0).then_some(beam)
    }
}

/// On which side of a surface a beam is, on each eighth of its length.
pub(crate) struct Survey<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub beam: &'a Beam,
    pub counts: &'a mut Evaluations,
    pub surface: PhantomData<S>,
}

/// The eighth of this number of [0, end].
pub(crate) fn eighth(end: f64, number: usize) -> Interval {
    // An eighth of a double is one, and its multiples are rounded the same way on both sides of a cut.
    let cut = |k: usize| if k == 8 { end } else { end * 0.125 * k as f64 };
    Interval {
        lo: cut(number),
        hi: cut(number + 1),
    }
}

impl<S: Surface> Kernel for Survey<'_, S> {
    type Output = [Side; 8];

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [Side; 8] {
        let spread = |part: &Interval| p.constant(part);
        let rays = Rays {
            origin: self.beam.origin.each_ref().map(spread),
            direction: self.beam.direction.each_ref().map(spread),
            end: p.splat(self.beam.end),
        };
        let (mut bound, active) = (S::unbound::<P>(p), S::everything(self.prepared));
        let mut entries = Entries::<S, P>::bind(p, self.prepared, &rays, &active, &mut bound);
        let pieces = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| eighth(self.beam.end, k));
        let t = Interval {
            lo: p.lanes(pieces.map(|piece| piece.lo)),
            hi: p.lanes(pieces.map(|piece| piece.hi)),
        };
        let mut spent = p.splat(0.0);
        let mut field = Field::new(
            p,
            &mut entries as &mut dyn Along<P>,
            self.counts,
            &mut spent,
        );
        // One evaluation for all rays of the tile.
        let f = field.value(&t, p.mask(1));
        sides(p, &f)
    }
}

/// The sides that enclosures of f prove.
#[inline(always)]
fn sides<P: Packet>(p: P, f: &Enclosed<P, 1>) -> [Side; 8] {
    let zero = p.splat(0.0);
    let doubtful = p.or(f.flags.undefined, f.flags.empty);
    let inside = p.bits(p.and_not(p.lt(f.d[0].hi, zero), doubtful));
    let outside = p.bits(p.and_not(p.lt(zero, f.d[0].lo), doubtful));
    [0, 1, 2, 3, 4, 5, 6, 7].map(|k| Side::of(inside >> k & 1 != 0, outside >> k & 1 != 0))
}

/// On which side of a surface eight boxes are.
pub(crate) struct SideOfBoxes<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    /// The sides of the boxes, by axis.
    pub boxes: &'a [[Interval; 8]; 3],
    pub surface: PhantomData<S>,
}

/// f and its gradient over boxes, a function of its own.
struct Gradient<'a, S: Surface, P: Packet> {
    prepared: &'a S::Prepared,
    point: &'a [Interval<P::F>; 3],
}

impl<S: Surface, P: Packet> Routine<P> for Gradient<'_, S, P> {
    type Output = Enclosed<P, 4>;
    #[inline(always)]
    fn call(self, p: P) -> Enclosed<P, 4> {
        S::gradient(p, self.prepared, *self.point)
    }
}

impl<S: Surface> Kernel for SideOfBoxes<'_, S> {
    type Output = [Side; 8];

    /// By the enclosure of f, and by the mean value form f(c) + ∇f·(X − c) where f has a gradient.
    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [Side; 8] {
        let prepared = self.prepared;
        let point = self.boxes.each_ref().map(|axis| Interval {
            lo: p.lanes(axis.map(|side| side.lo)),
            hi: p.lanes(axis.map(|side| side.hi)),
        });
        let over = p.call(Gradient::<S, P> {
            prepared,
            point: &point,
        });
        let centre = self.boxes.each_ref().map(|axis| {
            let middle = p.lanes(axis.map(|side| side.mid()));
            Interval {
                lo: middle,
                hi: middle,
            }
        });
        let at = p.call(Gradient::<S, P> {
            prepared,
            point: &centre,
        });
        let mut mean = at.d[0];
        for k in 0..3 {
            let way = p.sub(point[k], centre[k]);
            mean = p.add(mean, p.mul(over.d[k + 1], way));
        }
        let [natural, ..] = over.d;
        let smooth = over.flags.sound(p);
        let tight = Interval {
            lo: p.select(smooth, p.max_f(mean.lo, natural.lo), natural.lo),
            hi: p.select(smooth, p.min_f(mean.hi, natural.hi), natural.hi),
        };
        let f = Enclosed {
            d: [tight],
            flags: over.flags,
        };
        sides(p, &f)
    }
}
