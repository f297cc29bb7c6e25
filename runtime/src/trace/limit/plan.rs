//! Which evaluations prove a picture, found beforehand and without hurry.

use super::super::Entries;
use super::super::beams::{OverGroup, WithBeams};
use super::{Counts, compiled};
use crate::beam::{Bundle, Findings, Grid, Group, Hint, Request, Rows, Scout};
use crate::interval::{Interval, Kernel, Packet};
use crate::ray::Rays;
use crate::render::Rendering;
use crate::render::tile::{
    BLOCK, CELLS, GRID_OF_TILES, PACKETS_OF_CELL, TILE, TILES_OF_BLOCK, Tile, View, blocks,
};
use crate::solve::{Along, Settings, differentiable, excluded, nonzero};
use crate::span::Span8;
use crate::surface::{Active, Surface};
use crate::verdict::Verdict;

/// Bounds of eight intervals.
pub(super) type Bounds = [[f64; 8]; 2];

/// What proves a picture.
#[derive(Default)]
pub(super) struct Plan {
    /// Rows and sides of choices; neighbours have the same.
    pub actives: Vec<Active>,
    pub groups: Vec<OfGroup>,
    pub packets: Vec<OfPacket>,
    /// Pieces of all packets.
    pub pieces: Vec<Bounds>,
    pub counts: Counts,
}

/// Eight beams.
pub(super) struct OfGroup {
    pub corner: [f64; 2],
    pub grid: &'static Grid,
    pub active: usize,
    /// Where they are free.
    pub t: Bounds,
}

/// Eight rays.
pub(super) struct OfPacket {
    pub corner: [u32; 2],
    pub inside: u8,
    pub active: usize,
    /// Rays with a root, …
    pub hits: u8,
    /// … its interval, …
    pub root: Bounds,
    /// … and one around it in which f is monotone.
    pub around: Bounds,
    /// The pieces that cover the ways to the roots, …
    pub ways: std::ops::Range<usize>,
    /// … and those that cover the ways of rays that pass: …
    pub passing: std::ops::Range<usize>,
    /// … of these.
    pub passed: u8,
}

/// A packet is not covered by more pieces.
const MOST: usize = 100;

/// Finds what proves a picture.
pub(super) struct Make<'a, S: Surface> {
    pub prepared: &'a S::Prepared,
    pub view: &'a View<'a>,
    pub beams: WithBeams<'a>,
    pub settings: &'a Settings,
    pub picture: &'a Rendering,
    pub plan: &'a mut Plan,
}

impl<S: Surface> Kernel for Make<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> bool {
        if const { compiled::<P>() } {
            let Some(mut over) = OverGroup::<S, P>::new(p, self.prepared, self.beams.leaves) else {
                return false;
            };
            let mut bound = S::unbound::<P>(p);
            let mut tile = Tile::default();
            let everything = Rows::everything(S::everything(self.prepared));
            let mut maker = Maker::<S, P> {
                p,
                make: self,
                over: &mut over,
                bound: &mut bound,
            };
            for number in 0..blocks(maker.make.view.picture) {
                maker.block(number, &everything, &mut tile);
            }
            return true;
        }
        false
    }
}

struct Maker<'a, 'b, S: Surface, P: Packet> {
    p: P,
    make: Make<'a, S>,
    over: &'b mut OverGroup<'a, S, P>,
    bound: &'b mut S::Bound<P>,
}

impl<S: Surface, P: Packet> Maker<'_, '_, S, P> {
    fn block(&mut self, number: u32, everything: &Rows, tile: &mut Tile) {
        let picture = self.make.view.picture;
        let columns = picture[0].div_ceil(BLOCK[0]);
        let corner = [number % columns * BLOCK[0], number / columns * BLOCK[1]];
        let place = |k: usize| {
            let (x, y) = (
                k as u32 % GRID_OF_TILES.columns,
                k as u32 / GRID_OF_TILES.columns,
            );
            [corner[0] + x * TILE[0], corner[1] + y * TILE[1]]
        };
        let inside = |k: &usize| place(*k)[0] < picture[0] && place(*k)[1] < picture[1];
        let live = (0..TILES_OF_BLOCK)
            .filter(inside)
            .fold(0, |bits, k| bits | 1 << k);
        let tiles = self.look(&GRID_OF_TILES, corner, live, (&Hint::OPEN, everything));
        for k in (0..TILES_OF_BLOCK).filter(|k| tiles.hints[*k].open) {
            tile.begin(self.make.view, place(k), *self.make.beams.space.domain);
            self.tile((&tiles.hints[k], &tiles.rows[k]), tile);
        }
    }

    fn tile(&mut self, known: (&Hint, &Rows), tile: &mut Tile) {
        let cells = self.look(&Tile::GRID_OF_CELLS, tile.corner, tile.cells(), known);
        for cell in (0..CELLS).filter(|cell| cells.hints[*cell].open) {
            let first = cell * PACKETS_OF_CELL;
            let known = (&cells.hints[cell], &cells.rows[cell]);
            let corner = tile.corner_of(first);
            let grid = &Tile::GRID_OF_PACKETS;
            let packets = self.look(grid, corner, tile.packets_of(cell), known);
            for k in (0..PACKETS_OF_CELL).filter(|k| packets.hints[*k].open) {
                self.packet(first + k, (&packets.hints[k], &packets.rows[k]), tile);
            }
        }
    }

    /// What the render's survey tells; where it looks at all.
    fn look(
        &mut self,
        grid: &'static Grid,
        corner: [u32; 2],
        live: u8,
        (hint, rows): (&Hint, &Rows),
    ) -> Findings {
        let p = self.p;
        let mut findings = Findings::default();
        if hint.single.is_some() {
            findings.know(hint, rows);
            return findings;
        }
        let space = self.make.beams.space;
        let corner = self.make.view.begin(corner, grid);
        let request = Request {
            space,
            corner,
            grid,
            live,
            within: Span8::ALL,
            known: hint,
            rows,
            settings: self.make.settings,
        };
        Scout::survey(p, self.over as &mut dyn Bundle<P>, &request, &mut findings);
        let near = space.frame.near;
        let span = Group::new(p, space.frame, corner, grid).span(p, space.domain);
        let (start, end) = (p.to_array(span.lo), p.to_array(span.hi));
        let mut t = [[0.0; 8]; 2];
        for lane in 0..8 {
            let from = start[lane].max(hint.front - near);
            let found = &findings.hints[lane];
            let to = if found.open {
                found.front - near
            } else {
                end[lane]
            };
            (t[0][lane], t[1][lane]) = (from, to.max(from));
        }
        let active = self.make.plan.active(&rows.near);
        self.make.plan.groups.push(OfGroup {
            corner,
            grid,
            active,
            t,
        });
        self.make.plan.counts.groups += 1;
        findings
    }

    fn packet(&mut self, number: usize, (hint, rows): (&Hint, &Rows), tile: &mut Tile) {
        let p = self.p;
        tile.enter(p, self.make.view, number);
        let packet = &tile.packets[number];
        let corner = tile.corner_of(number);
        let seen = Seen::new(self.make.picture, corner);
        let entry = packet.record.entry;
        let near =
            (0..8).all(|k| seen.hits >> k & 1 == 0 || entry[k] + seen.root[1][k] <= rows.reach);
        let near = near && seen.passing == 0;
        let active = if near { &rows.near } else { &rows.all };
        let rays = Rays::recentred(p, &packet.lines, p.lanes(entry), p.lanes(packet.limit));
        let mut field = Entries::<S, P>::bind(p, self.make.prepared, &rays, active, self.bound);
        let front = p.sub_rd(p.splat(hint.front), p.lanes(entry));
        let front = p.max_f(front, p.splat(0.0));
        let root = Interval {
            lo: p.lanes(seen.root[0]),
            hi: p.lanes(seen.root[1]),
        };
        let hits = p.mask(seen.hits);
        let (around, monotone) = around(p, &mut field, p.min_f(front, root.lo), &root, hits);
        let way = Interval {
            lo: front,
            hi: around,
        };
        let plan = &mut *self.make.plan;
        let first = plan.pieces.len();
        let covered = cover(p, &mut field, &way, p.and(hits, monotone), &mut plan.pieces);
        let proved = p.bits(covered);
        let ways = first..plan.pieces.len();
        let rest = Interval {
            lo: front,
            hi: p.lanes(packet.limit),
        };
        let passing = p.and(p.mask(seen.passing), p.le(front, rest.hi));
        let passed = cover(p, &mut field, &rest, passing, &mut plan.pieces);
        plan.counts.hits += u64::from(proved.count_ones());
        plan.counts.left += u64::from((seen.hits & !proved).count_ones());
        plan.counts.left += u64::from((p.bits(passing) & !p.bits(passed)).count_ones());
        plan.counts.packets += u64::from(proved != 0);
        plan.counts.pieces += (ways.end - ways.start) as u64;
        plan.counts.passing += u64::from(p.bits(passed) != 0);
        plan.counts.more += (plan.pieces.len() - ways.end) as u64;
        let active = plan.active(active);
        plan.packets.push(OfPacket {
            corner,
            inside: seen.inside,
            active,
            hits: proved,
            root: seen.root,
            around: [p.to_array(around), seen.root[1]],
            passed: p.bits(passed),
            passing: ways.end..plan.pieces.len(),
            ways,
        });
    }
}

/// What a picture shows in a packet.
struct Seen {
    inside: u8,
    hits: u8,
    passing: u8,
    root: Bounds,
}

impl Seen {
    fn new(picture: &Rendering, corner: [u32; 2]) -> Self {
        let mut seen = Seen {
            inside: 0,
            hits: 0,
            passing: 0,
            root: [[0.0; 8]; 2],
        };
        for lane in 0..8u32 {
            let (x, y) = (corner[0] + lane % 4, corner[1] + lane / 4);
            if x >= picture.width() || y >= picture.height() {
                continue;
            }
            seen.inside |= 1 << lane;
            match picture.answer(x, y).first {
                Verdict::Root { t } => {
                    seen.hits |= 1 << lane;
                    seen.root[0][lane as usize] = t.lo;
                    seen.root[1][lane as usize] = t.hi;
                }
                Verdict::Miss => seen.passing |= 1 << lane,
                _ => {}
            }
        }
        seen
    }
}

/// The longest piece before each root on which f is monotone up to it: where that begins, and the lanes that have one.
fn around<P: Packet>(
    p: P,
    field: &mut dyn Along<P>,
    front: P::F,
    root: &Interval<P::F>,
    hits: P::M,
) -> (P::F, P::M) {
    let mut monotone = |lo: P::F, lanes: P::M| {
        let f = field.slope(p, &Interval { lo, hi: root.hi });
        p.and(differentiable(p, &f.flags, lanes), nonzero(p, &f.d[1]))
    };
    let mut good = root.lo;
    let mut bad = front;
    let sure = monotone(good, hits);
    let whole = monotone(front, sure);
    good = p.select(whole, front, good);
    // Halved in the distance from the root, and then between.
    let mut open = p.and_not(sure, whole);
    let mut length = p.sub_rn(root.lo, front);
    for _ in 0..50 {
        length = p.mul_rn(length, p.splat(0.5));
        let lo = p.max_f(p.sub_rn(root.lo, length), front);
        let fits = monotone(lo, open);
        good = p.select(fits, lo, good);
        bad = p.select(p.and_not(open, fits), lo, bad);
        open = p.and_not(open, fits);
        if !p.any(open) {
            break;
        }
    }
    for _ in 0..6 {
        let middle = p.mul_rn(p.splat(0.5), p.add_rn(good, bad));
        let between = p.and(sure, p.and(p.lt(bad, middle), p.lt(middle, good)));
        let fits = monotone(middle, between);
        good = p.select(fits, middle, good);
        bad = p.select(p.and_not(between, fits), middle, bad);
    }
    // Together with what is found for the others: a polynomial's hull is used where it tells for all lanes.
    let mut proved = monotone(good, sure);
    for _ in 0..50 {
        let failed = p.and_not(sure, proved);
        if !p.any(failed) {
            break;
        }
        let middle = p.mul_rn(p.splat(0.5), p.add_rn(good, root.lo));
        good = p.select(failed, middle, good);
        proved = monotone(good, sure);
    }
    (good, proved)
}

/// The fewest pieces that cover the ways, each as long as f over it excludes a root; the lanes that are covered.
fn cover<P: Packet>(
    p: P,
    field: &mut dyn Along<P>,
    way: &Interval<P::F>,
    lanes: P::M,
    pieces: &mut Vec<Bounds>,
) -> P::M {
    let mut free = |lo: P::F, hi: P::F, lanes: P::M| {
        let f = field.value(p, &Interval { lo, hi });
        excluded(p, &f.d[0], &f.flags, lanes)
    };
    let mut front = way.lo;
    let mut lost = p.none();
    let mut open = p.and(lanes, p.lt(front, way.hi));
    let zero = p.splat(0.0);
    for _ in 0..MOST {
        if !p.any(open) {
            break;
        }
        let whole = free(front, way.hi, open);
        let mut good = p.select(whole, way.hi, front);
        let mut bad = way.hi;
        let mut failed = p.and_not(open, whole);
        let mut length = p.sub_rn(way.hi, front);
        for _ in 0..40 {
            if !p.any(failed) {
                break;
            }
            length = p.mul_rn(length, p.splat(0.5));
            let back = p.add_rn(front, length);
            let fits = free(front, back, failed);
            good = p.select(fits, back, good);
            failed = p.and_not(failed, fits);
            bad = p.select(failed, back, bad);
        }
        for _ in 0..7 {
            let middle = p.mul_rn(p.splat(0.5), p.add_rn(good, bad));
            let between = p.and(p.lt(good, middle), p.lt(middle, bad));
            let between = p.and(between, p.and_not(p.and_not(open, whole), failed));
            let fits = free(front, middle, between);
            good = p.select(fits, middle, good);
            bad = p.select(p.and_not(between, fits), middle, bad);
        }
        // As it is evaluated later, and together: a polynomial's hull is used where it tells for all lanes.
        let mut piece = [zero; 2];
        for _ in 0..50 {
            piece = [front, good].map(|x| p.select(open, x, zero));
            failed = p.and_not(open, free(piece[0], piece[1], open));
            if !p.any(failed) {
                break;
            }
            let middle = p.mul_rn(p.splat(0.5), p.add_rn(front, good));
            good = p.select(failed, middle, good);
        }
        lost = p.or(lost, failed);
        open = p.and_not(open, failed);
        if p.any(open) {
            // A lane that is given up says nothing here, but stays for the sake of the others.
            pieces.push(piece.map(|x| p.to_array(x)));
        }
        front = p.select(open, good, front);
        open = p.and(open, p.lt(front, way.hi));
    }
    p.and_not(p.and_not(lanes, lost), open)
}

impl Plan {
    /// The index of these rows and sides.
    fn active(&mut self, active: &Active) -> usize {
        let recent = self.actives.len().saturating_sub(32);
        let same = self.actives[recent..].iter().rposition(|a| a == active);
        match same {
            Some(k) => recent + k,
            None => {
                self.actives.push(active.clone());
                self.actives.len() - 1
            }
        }
    }
}
