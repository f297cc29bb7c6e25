//! The rays of one packet of a tile against one surface.

use core::marker::PhantomData;

use super::nearest::{collect, keep, segment};
use super::{Entries, FirstRoots, OnRays};
use crate::beam::{Behind, Bundle, Hint, Pieces, Rows, Scout, Single, Space};
use crate::contract::Contractor;
use crate::interval::{Interval, Packet};
use crate::ray::Rays;
use crate::render::tile::{PACKET, Tile, View};
use crate::scene::TileJob;
use crate::solve::{Brackets, Events, Roots, Settings};
use crate::surface::{Active, Surface};
use crate::verdict::Verdict;

/// Packet after packet of a tile.
pub(super) struct Packets<'a, S: Surface, C, P: Packet> {
    pub(super) p: P,
    prepared: &'a S::Prepared,
    pub(super) settings: &'a Settings,
    /// The surface's box, if it is not the scene's.
    own: Option<&'a [[f64; 3]; 2]>,
    pub(super) index: u16,
    pub(super) view: &'a View<'a>,
    /// All rows of its tables.
    everything: &'a Active,
    pub(super) tile: &'a mut Tile,
    bound: Box<S::Bound<P>>,
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
        let bound = tile.room(|| S::unbound::<P>(p));
        Packets {
            p,
            prepared,
            settings: job.settings,
            own: (*job.domain != tile.domain).then_some(job.domain),
            index,
            view: job.view,
            everything: &job.everything.all,
            tile,
            bound,
            events: Events::default(),
            solver: PhantomData,
        }
    }

    /// Gives the room back.
    pub fn done(self) {
        self.tile.rooms.push(self.bound);
    }

    /// Traces a packet of the tile: first where few rows of tables matter, and where the octree's boxes are. Rays that pass
    /// the former are searched behind it, piece by piece, or with all rows that matter; those that meet what is no certain root
    /// with all of these, too, and if they meet it again, with all that there are, where no boxes are either: each from shortly
    /// in front of it.
    #[inline(always)]
    pub(super) fn part(
        &mut self,
        number: usize,
        (hint, rows, within): Known,
        behind: &mut Option<LooksBehind<'_, P>>,
    ) {
        let p = self.p;
        let mut left = Left::all(p);
        let mut look = Look {
            active: &rows.near,
            reach: rows.reach,
            within,
            separated: true,
        };
        self.search(number, hint, &look, &mut left);
        // Sums are told with what is left out of them near the front.
        if let Some(behind) = behind
            && look.reach < f64::INFINITY
            && rows.all.rest.is_empty()
            && p.any(left.lanes)
        {
            self.behind(number, (rows, within), behind, &mut left);
        }
        while !look.is_whole::<S>() && left.begin_again(p) {
            look.separated &= !rows.near.by_sign;
            if look.reach < f64::INFINITY {
                look.active = &rows.all;
                look.reach = f64::INFINITY;
            } else {
                // Beams left out rows as far as the boxes reach, and no further.
                look.active = self.everything;
                look.within = ANYWHERE;
            }
            self.search(number, hint, &look, &mut left);
        }
    }

    /// Searches behind what is near, piece by piece. Those that meet what is no certain root are left.
    #[inline(always)]
    fn behind(
        &mut self,
        number: usize,
        (rows, within): (&Rows, [f64; 2]),
        looks: &mut LooksBehind<'_, P>,
        left: &mut Left<P>,
    ) {
        let p = self.p;
        if !looks.ready {
            let beam = Behind {
                space: looks.space,
                corner: self.view.plane(self.tile.corner_of(number)),
                size: PACKET,
                within: [rows.reach, within[1]],
                active: &rows.all,
            };
            let LooksBehind {
                surface, pieces, ..
            } = looks;
            let Some(count) = Scout::look_behind(p, &mut **surface, &beam, pieces) else {
                return;
            };
            self.tile.counts.beams += count;
            looks.ready = true;
        }
        let entry = p.lanes(self.tile.packets[number].record.entry);
        for piece in 0..8 {
            let reach = looks.pieces.end[piece];
            if !p.any(left.lanes) {
                break;
            }
            if looks.pieces.open >> piece & 1 == 0 {
                self.tile.counts.empty += u64::from(p.bits(left.lanes).count_ones());
                left.skip(p, p.sub_rd(p.splat(reach), entry));
                continue;
            }
            let look = Look {
                active: &looks.pieces.active[piece],
                reach,
                within,
                separated: false,
            };
            self.search(number, &Hint::OPEN, &look, left);
        }
        left.lanes = p.none();
    }

    /// Searches where a look asks for it; what is left to be searched then.
    #[inline(always)]
    fn search(&mut self, number: usize, hint: &Hint, look: &Look, left: &mut Left<P>) {
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
        left.lanes = p.and(wanted, p.lt(over.hi, behind));
        left.from = p.select(wanted, p.max_f(over.lo, over.hi), left.from);
        if !p.any(live) {
            return;
        }
        let piece = Piece {
            over,
            live,
            known: match &hint.single {
                Some(single) if look.separated => Some(self.brackets(number, single, &over, live)),
                _ => None,
            },
            first: hint.length,
        };
        let roots = self.roots(number, look.active, piece, &mut left.spent);
        let mut hit = roots.hit;
        let unclear = p.or(p.mask(self.events.touched), roots.vague);
        if p.any(unclear) && !look.is_whole::<S>() {
            // What the ends of the search, or rows that were left out, may have caused is looked at again.
            let mut again = p.and(live, unclear);
            if look.active.tells_all::<S>() {
                let settled = p.mask(self.settled(&over));
                again = p.and_not(again, p.and_not(settled, roots.vague));
            }
            let from = self.in_front(&roots);
            self.events.forget(p.bits(again));
            hit = p.and_not(hit, again);
            left.lanes = p.and_not(left.lanes, again);
            left.again = p.or(left.again, again);
            left.from = p.select(again, from, left.from);
        }
        left.lanes = p.and_not(left.lanes, hit);
        self.hold(number, hit, &roots.t);
    }

    /// The rays that met something, none of it near the ends of the search: no other search tells more of it.
    #[cold]
    fn settled(&self, over: &Interval<P::F>) -> u8 {
        let (lo, hi) = (self.p.to_array(over.lo), self.p.to_array(over.hi));
        let is_inside = |lane: usize, event: &Verdict| {
            let run_up = RUN_UP * hi[lane];
            event
                .t()
                .is_some_and(|t| lo[lane] + run_up < t.lo && t.hi + run_up < hi[lane])
        };
        let settled = (0..8).filter(|&lane| {
            let met = &self.events.of[lane];
            !met.is_empty() && met.iter().all(|event| is_inside(lane, event))
        });
        settled.map(|lane| 1 << lane).sum()
    }

    /// Shortly in front of what each ray met first: up to there it is known to be free.
    #[cold]
    fn in_front(&self, roots: &Roots<P>) -> P::F {
        let p = self.p;
        let (lo, hi) = (p.to_array(roots.t.lo), p.to_array(roots.t.hi));
        p.lanes(core::array::from_fn(|lane| {
            let root = Interval {
                lo: lo[lane],
                hi: hi[lane],
            };
            let event = self.events.of[lane].first().and_then(Verdict::t);
            let met = event.unwrap_or(root);
            met.lo - RUN_UP * met.hi
        }))
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
        let found = known.found;
        let piece = Piece {
            over: known.t,
            live: found,
            known: Some(known),
            first: f64::INFINITY,
        };
        let roots = self.roots(number, active, piece, &mut p.splat(0.0));
        self.hold(number, roots.hit, &roots.t);
        p.bits(found)
    }

    /// Keeps what a packet met.
    #[inline(always)]
    fn hold(&mut self, number: usize, hit: P::M, t: &Interval<P::F>) {
        let packet = &mut self.tile.packets[number];
        keep(self.p, packet, hit, t, self.index);
        if self.events.touched != 0 {
            let events = (&mut self.events, &mut self.tile.events);
            collect(packet, number as u16, self.index, events);
        }
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
        let t = Interval {
            lo: p.sub_rd(p.splat(single.t[0]), entry),
            hi: p.sub_ru(p.splat(single.t[1]), entry),
        };
        let inside = p.and(p.le(over.lo, t.lo), p.le(t.hi, over.hi));
        let slope = Interval {
            lo: p.splat(single.slope[0]),
            hi: p.splat(single.slope[1]),
        };
        let rising = p.lt(p.splat(0.0), slope.lo);
        let mut known = Brackets::none(p);
        known.put(p, p.and(live, inside), &t, &slope, rising, t.hi);
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
        let entries = Entries::bind(p, self.prepared, &rays, active, &mut *self.bound);
        // A closed form needs no bracket.
        let closed = self.settings.closed_forms && S::quadric::<P>(entries.bound).is_some();
        let known = known.filter(|_| !closed);
        let single = known.as_ref().map_or(p.none(), |known| known.found);
        self.tile.counts.single += u64::from(p.bits(single).count_ones());
        let mut surface = OnRays {
            entries,
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
            by_sign: active.by_sign && !active.tells_all::<S>(),
            events: &mut self.events,
            cuts: None,
            solver: C::solver(),
        };
        let roots = job.find(p);
        *spent = surface.spent;
        roots
    }
}

/// What is known of a packet: about its rays, which rows matter, and where boxes are.
pub(super) type Known<'a> = (&'a Hint, &'a Rows, [f64; 2]);

/// Looks at what lies behind what is near.
pub(super) struct LooksBehind<'a, P: Packet> {
    pub surface: &'a mut dyn Bundle<P>,
    pub space: Space<'a>,
    pub pieces: &'a mut Pieces,
    /// Are these the packet's?
    pub ready: bool,
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

/// How far in front of what it met a ray is searched again, relatively: so f has a certain sign there.
const RUN_UP: f64 = 1.0 / (1u64 << 20) as f64;

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
    /// Is f what it was when beams separated roots? With the rows that come first it is.
    separated: bool,
}

impl Look<'_> {
    /// Is all of each ray searched that is of interest?
    fn is_whole<S: Surface>(&self) -> bool {
        let active = self.active;
        let own = !active.by_sign || active.tells_all::<S>();
        own && self.reach == f64::INFINITY && self.within == ANYWHERE
    }
}

/// Rays that are still to be searched, …
struct Left<P: Packet> {
    lanes: P::M,
    /// … and those of which it is open what they met, …
    again: P::M,
    /// … from where, …
    from: P::F,
    /// … and the evaluations that they took so far.
    spent: P::F,
}

impl<P: Packet> Left<P> {
    #[inline(always)]
    fn all(p: P) -> Self {
        Left {
            lanes: p.not(p.none()),
            again: p.none(),
            from: p.splat(0.0),
            spent: p.splat(0.0),
        }
    }

    /// There is nothing before this.
    #[inline(always)]
    fn skip(&mut self, p: P, to: P::F) {
        self.from = p.select(self.lanes, p.max_f(self.from, to), self.from);
    }

    /// Searches all of them next; are there any?
    #[inline(always)]
    fn begin_again(&mut self, p: P) -> bool {
        self.lanes = p.or(self.lanes, self.again);
        self.again = p.none();
        p.any(self.lanes)
    }
}
