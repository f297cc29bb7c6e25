//! What is certain for all rays of a beam: where there is no root, and where there is exactly one on each ray.

mod behind;
mod choose;
mod march;
mod single;

pub(crate) use behind::{Behind, Pieces};

use super::{Frame, Grid, Group, Hint, Rows, Shift, Single, Slab, Thin, Towards};
use crate::interval::{Interval, Packet, Routine, back_ends};
use crate::solve::{Enclosed, Settings, select};
use crate::span::Span8;
use crate::surface::{Active, Regions, Work};
use behind::LookBehind;
use march::Surveyor;

/// A surface over eight beams. An object, so that the survey is compiled once per instruction set.
pub(crate) trait Bundle<P: Packet> {
    /// How many surfaces one evaluation looks at.
    fn parts(&self) -> u64 {
        1
    }
    /// Moves the picture's leaves to other beams, for these rows.
    fn shift(&mut self, p: P, shift: &Shift<P>, active: &Active);
    /// f over a piece.
    fn value(&self, p: P, over: &Slab<P::F>) -> Enclosed<P, 1>;
    /// f and a derivative over a piece.
    fn slope(&self, p: P, over: &Towards<P::F>) -> Enclosed<P, 2>;
    /// The terms of these beams' rows over a piece.
    fn terms(&self, p: P, over: &Towards<P::F>, to: &mut Thin);
    /// The regions of the surface's code.
    fn regions(&self) -> &'static Regions {
        &Regions::NONE
    }
    /// What evaluations along rays cost.
    fn work(&self) -> &'static Work {
        &Work::UNKNOWN
    }
    /// Do rays find their roots in closed form with these beams' rows?
    fn is_closed(&self) -> bool {
        false
    }
    /// Do rays cost so much that beams are worth a second try?
    fn is_dear(&self) -> bool {
        false
    }
}

/// A picture's frame, and the surface's box in it.
#[derive(Clone, Copy)]
pub(crate) struct Space<'a> {
    pub frame: &'a Frame,
    pub domain: &'a [[f64; 3]; 2],
}

/// Eight beams to be surveyed.
pub(crate) struct Request<'a> {
    pub space: Space<'a>,
    /// Where the upper left pixel is; see [`Group::new`].
    pub corner: [f64; 2],
    pub grid: &'a Grid,
    /// The beams that are of interest.
    pub live: u8,
    /// Where they are of interest, in t.
    pub within: Span8,
    /// What is known about all of them.
    pub known: &'a Hint,
    /// The rows that matter in them.
    pub rows: &'a Rows,
    pub settings: &'a Settings,
}

/// What is found out about eight beams.
#[derive(Default)]
pub(crate) struct Findings {
    pub hints: [Hint; 8],
    /// The rows that matter in each, if it is open.
    pub rows: [Rows; 8],
    /// Those of interest that pass by the surface's box.
    pub apart: u8,
    /// Evaluations, counted once for all eight.
    pub count: u64,
    /// Room for what lies behind what is near.
    pub pieces: Pieces,
    thin: Thin,
}

/// The survey, compiled here for each instruction set.
#[derive(Clone, Copy)]
pub(crate) struct Scout<P: Packet> {
    survey: fn(P, &mut dyn Bundle<P>, &Request, &mut Findings),
    behind: fn(P, &mut dyn Bundle<P>, &Behind, &mut Pieces) -> u64,
}

back_ends!(SCOUTS: Scout::READY);

impl<P: Packet> Scout<P> {
    const READY: Self = Scout {
        survey: |p, surface, request, findings| {
            p.call(Survey {
                surface,
                request,
                findings,
            });
        },
        behind: |p, surface, beam, pieces| {
            p.call(LookBehind {
                surface,
                beam,
                pieces,
            })
        },
    };

    fn found() -> Option<&'static Self> {
        SCOUTS.iter().find_map(|scout| scout.downcast_ref::<Self>())
    }

    /// Looks at each beam.
    pub fn survey(p: P, surface: &mut dyn Bundle<P>, request: &Request, findings: &mut Findings) {
        match Self::found() {
            Some(scout) => (scout.survey)(p, surface, request, findings),
            // All back-ends are listed; one that were not would know nothing.
            None => findings.know(&Hint::OPEN, request.rows),
        }
    }
}

impl Findings {
    /// Nothing is in any beam.
    pub fn close(&mut self) {
        self.hints = [Hint::CLOSED; 8];
    }

    /// Nothing is in any other beams.
    pub fn keep(&mut self, beams: u8) {
        for (k, hint) in self.hints.iter_mut().enumerate() {
            hint.open &= beams >> k & 1 != 0;
        }
    }

    /// The same of all beams.
    pub fn know(&mut self, hint: &Hint, rows: &Rows) {
        self.hints = [*hint; 8];
        self.rows.iter_mut().for_each(|own| own.copy(rows));
    }
}

struct Survey<'a, 'b, P: Packet> {
    surface: &'a mut dyn Bundle<P>,
    request: &'a Request<'b>,
    findings: &'a mut Findings,
}

impl<P: Packet> Routine<P> for Survey<'_, '_, P> {
    type Output = ();

    #[inline(always)]
    fn call(mut self, p: P) {
        self.findings.apart = 0;
        for part in 0..P::PARTS {
            self.part(p.part(part));
        }
    }
}

impl<P: Packet> Survey<'_, '_, P> {
    /// Looks at the beams that are the token's own.
    #[inline(always)]
    fn part(&mut self, p: P) {
        let Request {
            space: Space { frame, domain },
            corner,
            grid,
            live,
            within,
            known,
            rows,
            ..
        } = *self.request;
        let group = Group::new(p, frame, corner, grid);
        let mut span = group.span(p, domain);
        let near = p.splat(frame.near);
        let wanted = Interval {
            lo: p.max_f(span.lo, p.sub_rd(p.lanes(within.lo), near)),
            hi: p.min_f(span.hi, p.sub_ru(p.lanes(within.hi), near)),
        };
        span = select(p, p.mask(live), &wanted, &span);
        let start = p.splat((known.front - frame.near).max(0.0));
        let start = p.max_f(start, span.lo);
        let last = p.max_f(span.hi, start);
        let reach = p.splat(rows.reach - frame.near);
        let near = Stretch {
            live: p.and(p.mask(live), p.le(start, span.hi)),
            start,
            end: p.max_f(p.min_f(last, reach), start),
            last,
            first: p.splat(known.length.min(0.25 * (frame.far - frame.near))),
            keenly: grid.whole,
        };
        self.findings.apart |= live & p.bits(p.all()) & !p.bits(near.live);
        if !p.any(near.live) {
            p.own()
                .for_each(|lane| self.findings.hints[lane].open = false);
            return;
        }
        let mut found = self.look(p, &group, &near, &rows.near, rows.reach == f64::INFINITY);
        let passed = p.and_not(p.and(near.live, p.lt(near.end, last)), found.open);
        if p.any(passed) {
            let behind = Stretch {
                live: passed,
                start: near.end,
                end: last,
                first: found.length,
                ..near
            };
            let more = self.look(p, &group, &behind, &rows.all, true);
            found.join(p, passed, &more);
        }
        found.tell(p, frame, &mut self.findings.hints);
    }

    /// Looks along a stretch with these rows, and notes which rows matter where beams are open.
    #[inline(always)]
    fn look(
        &mut self,
        p: P,
        group: &Group<P>,
        stretch: &Stretch<P>,
        active: &Active,
        to_the_end: bool,
    ) -> Found<P> {
        self.surface.shift(p, &group.shift(p), active);
        let mut surveyor = Surveyor {
            p,
            surface: self.surface,
            group,
            stretch,
            count: &mut self.findings.count,
        };
        let mut found = surveyor.march();
        // Closed forms need no bracket. Whole pixels may be full, and what is known of them spares the beams inside.
        let Request { settings, grid, .. } = self.request;
        let closed = settings.closed_forms && !grid.whole && surveyor.surface.is_closed();
        if p.any(found.open) && !closed {
            surveyor.prove_single(&mut found);
        }
        let t = Interval {
            lo: found.front,
            hi: found.back,
        };
        found.inside = p.and(found.one, group.inside(p, &t, self.request.space.domain));
        let (thin, rows) = (&mut self.findings.thin, &mut self.findings.rows);
        if !self.request.settings.thin
            || !self.request.rows.worthwhile(grid.whole)
            || !active.is_open()
        {
            let open = p.bits(found.open);
            let open = rows
                .iter_mut()
                .enumerate()
                .filter(|(k, _)| open >> k & 1 != 0);
            open.for_each(|(_, rows)| {
                rows.copy(self.request.rows);
                if to_the_end {
                    // Those of this look come first.
                    rows.near.clone_from(active);
                    rows.reach = f64::INFINITY;
                }
            });
        } else if p.any(found.open) {
            let frame = self.request.space.frame;
            surveyor.choose(
                &found,
                frame,
                thin,
                (self.request.rows, active, to_the_end),
                rows,
            );
        }
        found
    }
}

/// Where eight beams are looked at; t counts from the frame's `near`.
#[derive(Clone, Copy)]
struct Stretch<P: Packet> {
    /// The beams that are looked at.
    live: P::M,
    /// No root lies before this.
    start: P::F,
    /// Where the look ends, …
    end: P::F,
    /// … and what lies behind this is of no interest.
    last: P::F,
    /// How long the first step is.
    first: P::F,
    /// Are derivatives worth their price to exclude a beam? They are where that spares eight beams inside, not where it spares
    /// eight rays.
    keenly: bool,
}

/// What is known about eight beams.
#[derive(Clone, Copy)]
struct Found<P: Packet> {
    /// Beams in which a root may be.
    open: P::M,
    /// No point of the beam before this is a root.
    front: P::F,
    /// Where the search stopped: a length that could not be excluded at the front.
    length: P::F,
    /// Beams whose every ray has exactly one root between `front` and `back`, with certain signs of f near both, …
    one: P::M,
    back: P::F,
    /// … and this derivative along it.
    slope: Interval<P::F>,
    /// Beams that are in the surface's box between `front` and `back`.
    inside: P::M,
    /// Where the roots may be.
    plane: [P::F; 3],
}

impl<P: Packet> Found<P> {
    /// Takes over what was found about the beams of `lanes`.
    #[inline(always)]
    fn join(&mut self, p: P, lanes: P::M, other: &Self) {
        let mask = |own: P::M, other: P::M| p.or(p.and_not(own, lanes), p.and(other, lanes));
        self.open = mask(self.open, other.open);
        self.one = mask(self.one, other.one);
        self.inside = mask(self.inside, other.inside);
        self.front = p.select(lanes, other.front, self.front);
        self.length = p.select(lanes, other.length, self.length);
        self.back = p.select(lanes, other.back, self.back);
        self.slope = select(p, lanes, &other.slope, &self.slope);
        for (own, other) in self.plane.iter_mut().zip(&other.plane) {
            *own = p.select(lanes, *other, *own);
        }
    }

    /// From the frame's t to the rays', which differ by the frame's slack.
    #[inline(always)]
    fn tell(&self, p: P, frame: &Frame, hints: &mut [Hint; 8]) {
        let near = p.splat(frame.near);
        let slack = p.splat(frame.slack);
        let free = p.to_array(p.sub_rd(p.add_rd(self.front, near), slack));
        let first = p.to_array(p.add_rd(p.add_rd(self.front, slack), near));
        let last = p.to_array(p.add_ru(p.sub_ru(self.back, slack), near));
        let length = p.to_array(self.length);
        let (lo, hi) = (p.to_array(self.slope.lo), p.to_array(self.slope.hi));
        let [at, right, up] = self.plane.map(|x| p.to_array(x));
        let (open, one) = (p.bits(self.open), p.bits(self.one));
        let inside = p.bits(self.inside);
        for lane in p.own() {
            hints[lane] = Hint {
                open: open >> lane & 1 != 0,
                front: free[lane],
                length: length[lane],
                single: (one >> lane & 1 != 0).then_some(Single {
                    t: [first[lane], last[lane]],
                    slope: [lo[lane], hi[lane]],
                    inside: inside >> lane & 1 != 0,
                    plane: [at[lane] + frame.near, right[lane], up[lane]],
                }),
            };
        }
    }
}
