//! The rays of a tile against one surface.

use core::marker::PhantomData;

use super::beams::OverGroup;
use super::{Bind, Entries, FirstRoots, OnRays};
use crate::beam::{Bundle, Findings, Grid, Hint, Request, Rows, Scout, Single, Space};
use crate::contract::Contractor;
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::{Rays, clip};
use crate::render::tile::{CELLS, Event, PACKETS_OF_CELL, PacketRays, Tile, View};
use crate::scene::TileJob;
use crate::solid::Span8;
use crate::solve::{Brackets, Events, Roots, Settings};
use crate::space::Outline;
use crate::surface::{Active, Surface};
use crate::verdict::Verdict;

/// Traces one surface through a tile, and keeps what is nearer than what the tile holds.
pub(crate) struct TraceTile<'a, S: Surface, C> {
    pub prepared: &'a S::Prepared,
    pub job: &'a TileJob<'a>,
    /// What is known about the whole tile.
    pub hint: Hint,
    /// The rows that matter there.
    pub rows: &'a Rows,
    pub tile: &'a mut Tile,
    pub solver: PhantomData<C>,
}

impl<S: Surface, C: Contractor> Kernel for TraceTile<'_, S, C> {
    type Output = ();
    const IN_PARTS: bool = true;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let TileJob { beams, index, .. } = *self.job;
        let mut trace = Packets::<S, C, P>::new(p, self.prepared, self.job, index, self.tile);
        let over = match (beams, self.hint.single) {
            (Some(beams), None) => OverGroup::<S, P>::new(p, self.prepared, beams.leaves),
            _ => None,
        };
        let known = (&self.hint, self.rows);
        // Where a beam has found all roots there is nothing to add.
        let outline = self.job.outline.filter(|_| !self.hint.is_full());
        match (over, beams) {
            (Some(mut over), Some(beams)) => {
                trace.cells(Some((&mut over, beams.space)), known, outline);
            }
            _ => trace.cells(None, known, outline),
        }
    }
}

/// Packet after packet of a tile.
pub(super) struct Packets<'a, S: Surface, C, P: Packet> {
    p: P,
    prepared: &'a S::Prepared,
    settings: &'a Settings,
    /// The surface's box, if it is not the scene's.
    own: Option<&'a [[f64; 3]; 2]>,
    index: u16,
    view: &'a View<'a>,
    /// All rows of its tables.
    everything: &'a Active,
    tile: &'a mut Tile,
    bound: S::Bound<P>,
    events: Events,
    solver: PhantomData<C>,
}

impl<'a, S: Surface, C: Contractor, P: Packet> Packets<'a, S, C, P> {
    #[inline(always)]
    pub fn new(
        p: P,
        prepared: &'a S::Prepared,
        job: &'a TileJob<'a>,
        index: u16,
        tile: &'a mut Tile,
    ) -> Self {
        Packets {
            p,
            prepared,
            settings: job.settings,
            own: (*job.domain != tile.domain).then_some(job.domain),
            index,
            view: job.view,
            everything: &job.everything.all,
            tile,
            bound: S::unbound::<P>(p),
            events: Events::default(),
            solver: PhantomData,
        }
    }

    /// Traces the packets that may show something, as beams through the cells and, where these do not suffice, through the
    /// packets tell. Without beams, or where all is known, nothing is looked at again.
    #[inline(always)]
    fn cells(
        &mut self,
        mut surface: Option<(&mut dyn Bundle<P>, Space)>,
        (hint, rows): (&Hint, &Rows),
        outline: Option<&Outline>,
    ) {
        let (mut cells, mut packets) = (Findings::default(), Findings::default());
        let spans = self.tile.spans(outline);
        let all = self.tile.cells();
        let open = (0..CELLS).filter(|k| spans.lo[*k] <= spans.hi[*k]);
        let open = all & open.fold(0, |open, k| open | 1 << k);
        match &mut surface {
            _ if open == 0 => cells.close(),
            Some(surface) => {
                let part = (self.tile.corner, open, spans);
                self.look(
                    surface,
                    &Tile::GRID_OF_CELLS,
                    part,
                    (hint, rows),
                    &mut cells,
                );
            }
            None => {
                cells.know(hint, rows);
                cells.keep(open);
            }
        }
        let apart = cells.apart | all & !open;
        let apart = (0..CELLS).filter(|k| apart >> k & 1 != 0);
        self.tile.counts.apart += apart.map(|k| self.tile.pixels(k)).sum::<u64>();
        let mut missed = 0;
        for (cell, (hint, rows)) in cells.hints.iter().zip(&cells.rows).enumerate() {
            let first = cell * PACKETS_OF_CELL;
            let within = [spans.lo[cell], spans.hi[cell]];
            missed |= u8::from(!hint.open) << cell;
            self.tile.full |= u8::from(hint.is_full()) << cell;
            if !hint.open {
                continue;
            }
            let looked = match &mut surface {
                Some(surface) if hint.single.is_none() => {
                    let within = Span8 {
                        lo: [within[0]; 8],
                        hi: [within[1]; 8],
                    };
                    let corner = self.tile.corner_of(first);
                    let part = (corner, self.tile.packets_of(cell), within);
                    self.look(
                        surface,
                        &Tile::GRID_OF_PACKETS,
                        part,
                        (hint, rows),
                        &mut packets,
                    );
                    true
                }
                _ => false,
            };
            for k in 0..PACKETS_OF_CELL {
                let (hint, rows) = if looked {
                    (&packets.hints[k], &packets.rows[k])
                } else {
                    (hint, rows)
                };
                if hint.open {
                    self.packet(first + k, hint, rows, within);
                }
            }
        }
        core::mem::swap(&mut cells.rows, self.tile.rows(self.index));
        self.tile.missed &= missed;
        self.tile.counts.beams += cells.count + packets.count;
    }

    #[inline(always)]
    fn look(
        &self,
        (surface, space): &mut (&mut dyn Bundle<P>, Space),
        grid: &Grid,
        (corner, live, within): ([u32; 2], u8, Span8),
        (known, rows): (&Hint, &Rows),
        findings: &mut Findings,
    ) {
        let request = Request {
            space: *space,
            corner: self.view.begin(corner, grid),
            grid,
            live,
            within,
            known,
            rows,
            thin: self.settings.thin,
        };
        Scout::survey(self.p, *surface, &request, findings);
    }

    /// Traces a packet of the tile, of which this much is known: first where few rows of tables matter, and where the
    /// octree's boxes are. Rays that pass the former, or meet what is no certain root, are searched with all rows that matter;
    /// those that meet it again, along all of their length.
    #[inline(always)]
    fn packet(&mut self, number: usize, hint: &Hint, rows: &Rows, within: [f64; 2]) {
        self.tile.enter(self.p, self.view, number);
        for part in 0..P::PARTS {
            self.p = self.p.part(part);
            self.part(number, hint, rows, within);
        }
    }

    #[inline(always)]
    fn part(&mut self, number: usize, hint: &Hint, rows: &Rows, within: [f64; 2]) {
        let p = self.p;
        let mut left = Left {
            lanes: p.not(p.none()),
            from: p.splat(0.0),
            spent: p.splat(0.0),
        };
        let mut look = Look {
            active: &rows.near,
            reach: rows.reach,
            within,
        };
        loop {
            left = self.search(number, hint, &look, &left);
            if look.is_whole() || !p.any(left.lanes) {
                return;
            }
            if look.reach < f64::INFINITY {
                look.active = &rows.all;
                look.reach = f64::INFINITY;
            } else {
                // Beams left out rows as far as the boxes reach, and no further.
                look.active = self.everything;
                look.within = ANYWHERE;
            }
        }
    }

    /// Searches where a look asks for it; what is left to be searched then.
    #[inline(always)]
    fn search(&mut self, number: usize, hint: &Hint, look: &Look, left: &Left<P>) -> Left<P> {
        let p = self.p;
        let packet = &mut self.tile.packets[number];
        let (mut over, live) = segment(p, packet, self.own);
        let entry = p.lanes(packet.record.entry);
        over.lo = p.max_f(over.lo, p.sub_rd(p.splat(hint.front), entry));
        over.lo = p.max_f(over.lo, left.from);
        let wanted = p.and(p.and(live, left.lanes), p.le(over.lo, over.hi));
        let [first, last] = look.within.map(|t| p.splat(t));
        let boxes = Interval {
            lo: p.max_f(over.lo, p.sub_rd(first, entry)),
            hi: p.min_f(over.hi, p.sub_ru(last, entry)),
        };
        let cut = p.or(p.lt(over.lo, boxes.lo), p.lt(boxes.hi, over.hi));
        self.tile.counts.trimmed += u64::from(p.bits(p.and(wanted, cut)).count_ones());
        over = boxes;
        let wanted = p.and(wanted, p.le(over.lo, over.hi));
        let behind = over.hi;
        over.hi = p.min_f(behind, p.sub_rd(p.splat(look.reach), entry));
        let live = p.and(wanted, p.le(over.lo, over.hi));
        let mut left = Left {
            lanes: p.and(wanted, p.lt(over.hi, behind)),
            from: p.max_f(over.lo, over.hi),
            spent: left.spent,
        };
        if !p.any(live) {
            return left;
        }
        let known = match &hint.single {
            Some(single) => Some(self.brackets(number, single, &over, live)),
            None => None,
        };
        let first = hint.length;
        let piece = Piece {
            over,
            live,
            known,
            first,
        };
        let roots = self.roots(number, look.active, piece, &mut left.spent);
        let packet = &mut self.tile.packets[number];
        let mut hit = roots.hit;
        if self.events.touched != 0 && !look.is_whole() {
            // What the ends of the search, or rows that were left out, may have caused is looked at again.
            let again = p.and(live, p.mask(self.events.touched));
            self.events.clear();
            hit = p.and_not(hit, again);
            left.lanes = p.or(left.lanes, again);
            left.from = p.select(again, p.splat(0.0), left.from);
        }
        left.lanes = p.and_not(left.lanes, hit);
        keep(p, packet, hit, &roots.t, self.index);
        if self.events.touched != 0 {
            let events = (&mut self.events, &mut self.tile.events);
            collect(packet, number as u16, self.index, events);
        }
        left
    }

    /// Finds the roots of a packet whose rays have one each: on which rays it did. It does not on those that leave the box
    /// where the roots are.
    #[inline(always)]
    pub fn only(&mut self, number: usize, single: &Single, active: &Active) -> u8 {
        let p = self.p;
        let (over, live) = segment(p, &self.tile.packets[number], self.own);
        let known = self.brackets(number, single, &over, live);
        if !p.any(known.found) {
            return 0;
        }
        let piece = Piece {
            over: known.t,
            live: known.found,
            known: Some(known),
            first: f64::INFINITY,
        };
        let roots = self.roots(number, active, piece, &mut p.splat(0.0));
        let packet = &mut self.tile.packets[number];
        keep(p, packet, roots.hit, &roots.t, self.index);
        if self.events.touched != 0 {
            let events = (&mut self.events, &mut self.tile.events);
            collect(packet, number as u16, self.index, events);
        }
        p.bits(known.found)
    }

    /// The brackets of the rays that stay in the box while they are in the piece that holds their only root.
    #[inline(always)]
    fn brackets(
        &self,
        number: usize,
        single: &Single,
        over: &Interval<P::F>,
        live: P::M,
    ) -> Brackets<P> {
        let p = self.p;
        let entry = p.lanes(self.tile.packets[number].record.entry);
        let mut known = brackets(p, single, entry, over, live);
        let corner = self.tile.corner_of(number);
        let start = p.sub_rn(self.view.linear(p, corner, &single.plane), entry);
        known.guess = p.min_f(p.max_f(start, known.t.lo), known.t.hi);
        known
    }

    /// The roots of a packet's rays over a piece.
    #[inline(always)]
    fn roots(
        &mut self,
        number: usize,
        active: &Active,
        piece: Piece<P>,
        spent: &mut P::F,
    ) -> Roots<P> {
        let p = self.p;
        let Piece {
            mut over,
            live,
            known,
            first,
        } = piece;
        over.lo = p.select(live, over.lo, p.splat(0.0));
        over.hi = p.select(live, over.hi, p.splat(0.0));
        let end = p.select(live, over.hi, p.splat(-1.0));
        let packet = &self.tile.packets[number];
        let entry = p.lanes(packet.record.entry);
        let rays = Rays::recentred(p, &packet.lines, entry, end);
        self.tile.counts.note(active);
        p.call(Bind::<S, P> {
            prepared: self.prepared,
            rays: &rays,
            active,
            bound: &mut self.bound,
        });
        // A closed form needs no bracket.
        let closed = self.settings.closed_forms && S::quadric(&self.bound).is_some();
        let known = known.filter(|_| !closed);
        let single = known.as_ref().map_or(p.none(), |known| known.found);
        self.tile.counts.single += u64::from(p.bits(single).count_ones());
        let mut surface = OnRays {
            entries: Entries::<S, P> {
                prepared: self.prepared,
                bound: &self.bound,
                rays: &rays,
            },
            counts: &mut self.tile.counts,
            spent: *spent,
        };
        let job = FirstRoots::<S, P> {
            surface: &mut surface,
            settings: self.settings,
            lines: &packet.lines,
            entry,
            over: &over,
            live: p.and_not(live, single),
            first: p.splat(first),
            known: known.as_ref(),
            first_only: true,
            twice: self.settings.narrowing.twice(true),
            events: &mut self.events,
            cuts: None,
            solver: C::solver(),
        };
        let roots = job.find(p);
        *spent = surface.spent;
        roots
    }
}

/// Where rays of a packet are searched.
struct Piece<P: Packet> {
    over: Interval<P::F>,
    live: P::M,
    /// Those with one root.
    known: Option<Brackets<P>>,
    /// How long the first steps are.
    first: f64,
}

/// All of a ray.
const ANYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// How rays are searched; parameters count from the camera.
struct Look<'a> {
    /// The rows of tables that matter, …
    active: &'a Active,
    /// … namely up to here.
    reach: f64,
    /// Elsewhere boxes tell that there is no root.
    within: [f64; 2],
}

impl Look<'_> {
    /// Is all of each ray searched that is of interest?
    fn is_whole(&self) -> bool {
        self.reach == f64::INFINITY && self.within == ANYWHERE
    }
}

/// Rays that are still to be searched, from where, and the evaluations that they took so far.
struct Left<P: Packet> {
    lanes: P::M,
    from: P::F,
    spent: P::F,
}

/// The brackets of the rays that stay in the box while they are in the piece that holds their only root.
#[inline(always)]
fn brackets<P: Packet>(
    p: P,
    single: &Single,
    entry: P::F,
    over: &Interval<P::F>,
    live: P::M,
) -> Brackets<P> {
    let t = Interval {
        lo: p.sub_rd(p.splat(single.t[0]), entry),
        hi: p.sub_ru(p.splat(single.t[1]), entry),
    };
    let inside = p.and(p.le(over.lo, t.lo), p.le(t.hi, over.hi));
    let slope = Interval {
        lo: p.splat(single.slope[0]),
        hi: p.splat(single.slope[1]),
    };
    let mut known = Brackets::none(p);
    let rising = p.lt(p.splat(0.0), slope.lo);
    known.put(p, p.and(live, inside), &t, &slope, rising, t.hi);
    known
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

/// How far behind a root another surface is searched, relatively: beyond what noise hides of a root in the same place.
const TIED: f64 = 1.0 / (1u64 << 40) as f64;

/// Keeps the nearer root of each ray. Where it overlaps the nearest one so far their order is open, and the one that begins
/// first is shown.
#[inline(always)]
fn keep<P: Packet>(p: P, packet: &mut PacketRays, hit: P::M, t: &Interval<P::F>, index: u16) {
    let record = &mut packet.record;
    let (old_lo, old_hi) = (p.lanes(record.lo), p.lanes(record.hi));
    let nearer = p.and(hit, p.lt(t.lo, old_lo));
    let apart = p.or(p.lt(t.hi, old_lo), p.lt(old_hi, t.lo));
    let tied = p.bits(p.and_not(hit, apart));
    let nearer_bits = p.bits(nearer);
    record.tied = (record.tied & !p.bits(p.and(nearer, apart))) | tied;
    record.shown |= nearer_bits;
    p.store(p.select(nearer, t.lo, old_lo), &mut record.lo);
    p.store(p.select(nearer, t.hi, old_hi), &mut record.hi);
    let limit = p.lanes(packet.limit);
    // A little further, so that a root of another surface in the same place can be proved too, and told to be tied.
    let more = p.mul_ru(p.splat(8.0), p.sub_ru(t.hi, t.lo));
    let more = p.max_f(more, p.mul_ru(t.hi, p.splat(TIED)));
    let end = p.add_ru(t.hi, more);
    let limit = p.select(hit, p.min_f(limit, end), limit);
    p.store(limit, &mut packet.limit);
    for lane in p.own() {
        if nearer_bits >> lane & 1 != 0 {
            record.surface[lane] = index;
        }
    }
}

/// Moves a packet's events to the tile. Nothing behind a certain hit is of interest.
#[cold]
fn collect(
    packet: &mut PacketRays,
    number: u16,
    index: u16,
    (events, all): (&mut Events, &mut Vec<Event>),
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
