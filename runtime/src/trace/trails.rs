//! All events along the rays of a tile, and on which side of the surface each ray is between them: for solids.

use core::marker::PhantomData;

use super::{Entries, FirstRoots, OnRays};
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::Rays;
use crate::render::tile::PacketRays;
use crate::solid::Side;
use crate::solve::{Evaluations, Events, Field, Settings, Solver};
use crate::span::Span8;
use crate::surface::{Continuity, Surface};
use crate::verdict::{Verdict, Why};

/// Where a ray's side is not certain: around events, as a rule around one root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    /// Between two gaps in which f is continuous, has no root, and has a certain sign.
    pub reach: Interval,
    /// The side before, if there is such a gap.
    pub before: Side,
    /// The side behind.
    pub after: Side,
    /// The number of the first verdict, and of the one behind the last.
    verdicts: [u32; 2],
}

/// What is known of one surface along the rays of a tile.
#[derive(Default)]
pub(crate) struct Trails {
    /// Where each packet's rays were searched.
    pub searched: Vec<Span8>,
    verdicts: Vec<Verdict>,
    /// In ascending order for each ray, ray after ray.
    marks: Vec<Mark>,
    /// For each ray, the end of its marks.
    ends: Vec<u32>,
    /// For each ray, the side where its search starts.
    start: Vec<Side>,
}

impl Trails {
    /// The marks of a ray, and the side before them.
    pub fn of(&self, packet: usize, lane: usize) -> (&[Mark], Side) {
        let ray = 8 * packet + lane;
        let first = match ray.checked_sub(1) {
            Some(before) => self.ends[before] as usize,
            None => 0,
        };
        (&self.marks[first..self.ends[ray] as usize], self.start[ray])
    }

    /// What happens within the reach of a mark, in ascending order; at least one verdict.
    pub fn verdicts(&self, mark: &Mark) -> &[Verdict] {
        &self.verdicts[mark.verdicts[0] as usize..mark.verdicts[1] as usize]
    }

    /// Ends a ray.
    fn finish(&mut self, start: Side) {
        self.start.push(start);
        self.ends.push(self.marks.len() as u32);
    }

    /// Writes down a ray that was searched over `over`.
    fn put(&mut self, over: Interval, pieces: &[Piece], why: Why) {
        let mut start = Side::Unknown;
        let mut first = self.verdicts.len();
        let (mut from, mut before) = (over.lo, Side::Unknown);
        let end = Piece::Gap(
            Interval {
                lo: over.hi,
                hi: over.hi,
            },
            Side::Unknown,
        );
        for piece in pieces.iter().chain([&end]) {
            let (gap, after) = match piece {
                Piece::Event(verdict) => {
                    self.verdicts.push(*verdict);
                    continue;
                }
                Piece::Gap(gap, side) => (gap, *side),
            };
            let quiet = self.verdicts.len() == first && from == gap.lo;
            if quiet && from == over.lo {
                start = after;
            } else if !quiet || before != after && after != Side::Unknown {
                let reach = Interval {
                    lo: from,
                    hi: gap.lo,
                };
                if self.verdicts.len() == first {
                    self.verdicts.push(Verdict::Unresolved { t: reach, why });
                }
                self.marks.push(Mark {
                    reach,
                    before,
                    after,
                    verdicts: [first as u32, self.verdicts.len() as u32],
                });
                first = self.verdicts.len();
            }
            (from, before) = (gap.hi, after);
        }
        self.finish(start);
    }
}

/// Finds the trails of a surface.
pub(crate) struct TrailsOfTile<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub settings: &'a Settings,
    pub packets: &'a [PacketRays],
    /// Where each packet's rays are to be searched.
    pub search: Vec<Span8>,
    pub counts: &'a mut Evaluations,
    pub surface: PhantomData<S>,
}

impl<S: Surface> Kernel for TrailsOfTile<'_, S> {
    type Output = Trails;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Trails {
        let active = S::everything(self.prepared);
        let mut bound = S::unbound::<P>(p);
        let mut trails = Trails::default();
        let mut lists: [Vec<Verdict>; 8] = Default::default();
        for (packet, search) in self.packets.iter().zip(&self.search) {
            lists.iter_mut().for_each(Vec::clear);
            let over = Interval {
                lo: p.lanes(search.lo),
                hi: p.lanes(search.hi),
            };
            let live = p.le(over.lo, over.hi);
            if p.any(live) {
                let end = p.select(live, over.hi, p.splat(-1.0));
                let rays = Rays::recentred(p, &packet.lines, p.lanes(packet.record.entry), end);
                let mut surface = OnRays {
                    entries: Entries::<S, P>::bind(p, self.prepared, &rays, &active, &mut bound),
                    counts: &mut *self.counts,
                    spent: p.splat(0.0),
                };
                all_events(
                    p,
                    &mut surface,
                    self.settings,
                    packet,
                    over,
                    live,
                    &mut lists,
                );
                let OnRays {
                    mut entries,
                    counts,
                    mut spent,
                } = surface;
                let mut sides = Sides {
                    field: Field::new(p, &mut entries, counts, &mut spent),
                    // Elsewhere a certain sign at one place does for a gap without a root.
                    patchy: !S::REPORT.total || S::REPORT.continuity == Continuity::Jumps,
                };
                sides.mark(search, &lists, &mut trails);
            } else {
                (0..8).for_each(|_| trails.finish(Side::Unknown));
            }
        }
        trails.searched = self.search;
        trails
    }
}

/// All events of a packet's rays, each list in ascending order.
#[inline(always)]
fn all_events<S: Surface, P: Packet>(
    p: P,
    surface: &mut OnRays<'_, S, P>,
    settings: &Settings,
    packet: &PacketRays,
    mut over: Interval<P::F>,
    live: P::M,
    lists: &mut [Vec<Verdict>; 8],
) {
    let zero = p.splat(0.0);
    over.lo = p.select(live, over.lo, zero);
    over.hi = p.select(live, over.hi, zero);
    let mut events = Events::default();
    let mut live = live;
    let solver = Solver::default();
    while p.any(live) {
        let job = FirstRoots::<S, P> {
            surface,
            settings,
            lines: &packet.lines,
            entry: p.lanes(packet.record.entry),
            over: &over,
            live,
            first: over.hi,
            known: None,
            first_only: false,
            twice: settings.narrowing.twice(true),
            by_sign: false,
            events: &mut events,
            cuts: None,
            solver,
        };
        let roots = job.find(p);
        let (lo, hi) = (p.to_array(roots.t.lo), p.to_array(roots.t.hi));
        let (hit, searched) = (p.bits(p.and(roots.hit, live)), p.bits(live));
        for (lane, list) in lists.iter_mut().enumerate() {
            if searched >> lane & 1 != 0 {
                events.of[lane].iter().for_each(|event| event.append(list));
            }
            if hit >> lane & 1 != 0 {
                let t = Interval {
                    lo: lo[lane],
                    hi: hi[lane],
                };
                Verdict::Root { t }.append(list);
            }
        }
        events.clear();
        let more = p.and(p.and(roots.hit, live), p.lt(roots.resume, over.hi));
        over.lo = p.select(more, roots.resume, over.lo);
        // What is kept back finishes one search, not the next.
        let tired = p.and(more, p.lt(p.splat(settings.limit()), surface.spent));
        if p.any(tired) {
            give_up(
                p.bits(tired),
                p.to_array(over.lo),
                p.to_array(over.hi),
                lists,
            );
        }
        live = p.and_not(more, tired);
    }
}

/// The rest of the rays of `tired` is open.
#[cold]
fn give_up(tired: u8, lo: [f64; 8], hi: [f64; 8], lists: &mut [Vec<Verdict>; 8]) {
    for (lane, list) in lists.iter_mut().enumerate() {
        if tired >> lane & 1 != 0 {
            let t = Interval {
                lo: lo[lane],
                hi: hi[lane],
            };
            let why = Why::Budget;
            Verdict::Unresolved { t, why }.append(list);
        }
    }
}

/// Where in a gap the sign of f is asked for, one place after the other.
const PLACES: [f64; 4] = [0.5, 0.25, 0.8125, 0.0625];
/// How often a gap in which f may be undefined is halved.
const DEPTH: u32 = 6;

/// Finds out on which side of a surface rays are.
struct Sides<'a, P: Packet> {
    field: Field<'a, P>,
    /// May f be undefined or discontinuous?
    patchy: bool,
}

impl<P: Packet> Sides<'_, P> {
    /// Asks for the side in each gap of each ray, and writes the marks of the packet's rays.
    fn mark(&mut self, search: &Span8, lists: &[Vec<Verdict>; 8], trails: &mut Trails) {
        let gaps = lists.iter().map(Vec::len).max().unwrap_or(0) + 1;
        // By gap, and in it by ray.
        let mut sides: Vec<[Side; 8]> = Vec::with_capacity(gaps);
        for number in 0..gaps {
            let gap = |lane: usize| gap(search.of(lane), &lists[lane], number);
            let gaps = [0, 1, 2, 3, 4, 5, 6, 7].map(gap);
            sides.push(self.at_places(&gaps));
        }
        // A gap without a certain sign is as good as none, if f exists there.
        let why = if self.patchy {
            Why::Undefined
        } else {
            Why::Floor
        };
        let mut pieces = Vec::new();
        for (lane, list) in lists.iter().enumerate() {
            let over = search.of(lane);
            if over.lo > over.hi {
                trails.finish(Side::Unknown);
                continue;
            }
            pieces.clear();
            for (number, sides) in sides.iter().enumerate().take(list.len() + 1) {
                match gap(over, list, number) {
                    Some(gap) if self.patchy => self.cut(lane, gap, DEPTH, &mut pieces),
                    Some(gap) if sides[lane] != Side::Unknown => {
                        pieces.push(Piece::Gap(gap, sides[lane]));
                    }
                    _ => {}
                }
                pieces.extend(list.get(number).map(|event| Piece::Event(*event)));
            }
            trails.put(over, &pieces, why);
        }
    }

    /// The side in a gap of each ray by the sign of f at a place in it, which holds for all of the gap if f is continuous
    /// there and has no root.
    fn at_places(&mut self, gaps: &[Option<Interval>; 8]) -> [Side; 8] {
        let p = self.field.p;
        let mut sides = [Side::Unknown; 8];
        let mut open = 0;
        for (lane, gap) in gaps.iter().enumerate() {
            open |= u8::from(gap.is_some()) << lane;
        }
        for place in PLACES {
            if open == 0 {
                break;
            }
            let at = gaps
                .map(|gap| gap.map_or(0.0, |g| (g.lo + place * (g.hi - g.lo)).clamp(g.lo, g.hi)));
            let f = self.field.point(p.lanes(at), p.mask(open));
            let doubtful = p.bits(p.or(f.flags.undefined, f.flags.empty));
            let inside = p.bits(p.lt(f.d[0].hi, p.splat(0.0))) & !doubtful;
            let outside = p.bits(p.lt(p.splat(0.0), f.d[0].lo)) & !doubtful;
            for (lane, side) in sides.iter_mut().enumerate() {
                if open >> lane & 1 != 0 {
                    *side = Side::of(inside >> lane & 1 != 0, outside >> lane & 1 != 0);
                }
            }
            open &= !(inside | outside);
        }
        sides
    }

    /// Cuts one ray's gap into pieces on which f is certainly defined, and either continuous or of one certain sign, as
    /// far as there are such.
    fn cut(&mut self, lane: usize, gap: Interval, depth: u32, pieces: &mut Vec<Piece>) {
        let p = self.field.p;
        let only = p.mask(1 << lane);
        let t = Interval {
            lo: p.splat(gap.lo),
            hi: p.splat(gap.hi),
        };
        let f = self.field.value(&t, only);
        let flag = |mask: P::M| p.bits(mask) >> lane & 1 != 0;
        let undefined = flag(p.or(f.flags.undefined, f.flags.empty));
        let inside = flag(p.lt(f.d[0].hi, p.splat(0.0)));
        let outside = flag(p.lt(p.splat(0.0), f.d[0].lo));
        let mut side = Side::of(inside, outside);
        if !undefined && !flag(f.flags.jump) && side == Side::Unknown {
            let mut gaps = [None; 8];
            gaps[lane] = Some(gap);
            side = self.at_places(&gaps)[lane];
        }
        if !undefined && side != Side::Unknown {
            pieces.push(Piece::Gap(gap, side));
        } else if depth == 0 || flag(f.flags.empty) {
            let why = Why::Undefined;
            pieces.push(Piece::Event(Verdict::Unresolved { t: gap, why }));
        } else {
            let middle = gap.mid();
            for (lo, hi) in [(gap.lo, middle), (middle, gap.hi)] {
                self.cut(lane, Interval { lo, hi }, depth - 1, pieces);
            }
        }
    }
}

/// A ray in order: gaps of certain sides, and events. What is between them is not certain.
enum Piece {
    Gap(Interval, Side),
    Event(Verdict),
}

/// The gap of this number between the events of a ray, unless it is empty.
fn gap(over: Interval, list: &[Verdict], number: usize) -> Option<Interval> {
    let end = |event: &Verdict| event.t().map_or(over.hi, |t| t.hi);
    let lo = match number.checked_sub(1) {
        Some(before) => end(list.get(before)?),
        None => over.lo,
    };
    let hi = list
        .get(number)
        .and_then(Verdict::t)
        .map_or(over.hi, |t| t.lo);
    (lo < hi).then_some(Interval { lo, hi })
}
