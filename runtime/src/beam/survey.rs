//! What is certain for all rays of a beam: where there is no root, and where there is exactly one on each ray.

use super::{Direction, Frame, Grid, Group, Hint, Rows, Shift, Single, Slab, Thin, Towards};
use crate::interval::{Interval, Packet, Routine, back_ends};
use crate::solve::{Enclosed, differentiable, excluded, nonzero, select};
use crate::surface::Active;

/// A surface over eight beams. An object, so that the survey is compiled once per instruction set.
pub(crate) trait Bundle<P: Packet> {
    /// Moves the picture's leaves to other beams, for these rows.
    fn shift(&mut self, p: P, shift: &Shift<P>, active: &Active);
    /// f over a piece.
    fn value(&self, p: P, over: &Slab<P::F>) -> Enclosed<P, 1>;
    /// f and a derivative over a piece.
    fn slope(&self, p: P, over: &Towards<P::F>) -> Enclosed<P, 2>;
    /// The terms of these beams' rows over a piece.
    fn terms(&self, p: P, over: &Towards<P::F>, to: &mut Thin);
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
    /// What is known about all of them.
    pub known: &'a Hint,
    /// The rows that matter in them.
    pub rows: &'a Rows,
    /// Choose among these rows?
    pub thin: bool,
}

/// What is found out about eight beams.
#[derive(Default)]
pub(crate) struct Findings {
    pub hints: [Hint; 8],
    /// The rows that matter in each, if it is open.
    pub rows: [Rows; 8],
    /// Evaluations, counted once for all eight.
    pub count: u64,
    thin: Thin,
}

/// The survey, compiled here for each instruction set.
#[derive(Clone, Copy)]
pub(crate) struct Scout<P: Packet>(fn(P, &mut dyn Bundle<P>, &Request, &mut Findings));

back_ends!(SCOUTS: Scout::READY);

impl<P: Packet> Scout<P> {
    const READY: Self = Scout(|p, surface, request, findings| {
        p.call(Survey {
            surface,
            request,
            findings,
        });
    });

    /// Looks at each beam.
    pub fn survey(p: P, surface: &mut dyn Bundle<P>, request: &Request, findings: &mut Findings) {
        match SCOUTS.iter().find_map(|scout| scout.downcast_ref::<Self>()) {
            Some(scout) => scout.0(p, surface, request, findings),
            // All back-ends are listed; one that were not would know nothing.
            None => findings.know(&Hint::OPEN, request.rows),
        }
    }
}

impl Findings {
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
        let Request {
            space: Space { frame, domain },
            corner,
            grid,
            live,
            known,
            rows,
            ..
        } = *self.request;
        let group = Group::new(p, frame, corner, grid);
        let span = group.span(p, domain);
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
        };
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
        self.findings.hints = found.hints(p, frame);
    }
}

impl<P: Packet> Survey<'_, '_, P> {
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
        if p.any(found.open) {
            surveyor.prove_single(&mut found);
        }
        let t = Interval {
            lo: found.front,
            hi: found.back,
        };
        found.inside = p.and(found.one, group.inside(p, &t, self.request.space.domain));
        let (thin, rows) = (&mut self.findings.thin, &mut self.findings.rows);
        if !self.request.thin || !active.is_open() {
            let open = p.bits(found.open);
            let open = rows
                .iter_mut()
                .enumerate()
                .filter(|(k, _)| open >> k & 1 != 0);
            open.for_each(|(_, rows)| rows.copy(self.request.rows));
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
}

/// Eight beams.
struct Surveyor<'a, P: Packet> {
    p: P,
    surface: &'a dyn Bundle<P>,
    group: &'a Group<'a, P>,
    stretch: &'a Stretch<P>,
    /// Evaluations, each of eight beams.
    count: &'a mut u64,
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
    fn hints(&self, p: P, frame: &Frame) -> [Hint; 8] {
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
        let mut hints = [Hint::OPEN; 8];
        for (lane, hint) in hints.iter_mut().enumerate() {
            *hint = Hint {
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
        hints
    }
}

/// The mean value form needs these.
struct Sides<P: Packet> {
    by: [Interval<P::F>; 2],
    usable: P::M,
}

/// Beams are not split below so many of their widths: what is nearer is the business of the narrower beams inside.
const SHORTEST: f64 = 0.5;

/// How many widths of a beam are near its front.
const REACH: f64 = 6.0;

impl<P: Packet> Surveyor<'_, P> {
    #[inline(always)]
    fn value(&mut self, over: &Slab<P::F>) -> Enclosed<P, 1> {
        *self.count += 1;
        self.surface.value(self.p, over)
    }

    /// A piece and a little more, in all directions: the rays' own t differs by the frame's slack.
    #[inline(always)]
    fn around(&self, front: P::F, back: P::F) -> Towards<P::F> {
        let p = self.p;
        let slack = p.splat(8.0 * self.group.slack());
        let t = Interval {
            lo: p.max_f(p.sub_rd(front, slack), p.splat(0.0)),
            hi: p.add_ru(back, slack),
        };
        self.group
            .towards(p, self.group.slab(p, &t), Direction::Any)
    }

    /// Chooses the rows that matter in the open beams among those of `active`, which hold to the end of the stretch or of
    /// all: up to a few widths from the front or behind the only root, and on all of the rest.
    #[inline(always)]
    fn choose(
        &self,
        found: &Found<P>,
        frame: &Frame,
        thin: &mut Thin,
        (given, active, to_the_end): (&Rows, &Active, bool),
        rows: &mut [Rows; 8],
    ) {
        let p = self.p;
        let open = p.bits(found.open);
        let lanes = move || (0..8).filter(move |lane| open >> lane & 1 != 0);
        let Stretch { end, last, .. } = *self.stretch;
        let width = self.group.width(p, found.front);
        let ahead = p.add_rn(found.front, p.mul_rn(width, p.splat(REACH)));
        let reach = p.min_f(p.select(found.one, found.back, ahead), end);
        if !active.rest.is_empty() {
            let front = self.middle(found.front, Direction::Any);
            thin.measure(|to| self.surface.terms(p, &front, to));
        }
        thin.weigh(active, |to| {
            self.surface.terms(p, &self.around(found.front, reach), to)
        });
        let all = p.or(found.inside, p.le(last, reach));
        let reach = p.select(
            all,
            p.splat(f64::INFINITY),
            p.add_rd(reach, p.splat(frame.near)),
        );
        let reach = p.to_array(reach);
        let mut all = p.bits(all);
        for lane in lanes() {
            thin.choose(active, lane, &mut rows[lane].near);
            rows[lane].all.clone_from(&given.all);
            rows[lane].reach = reach[lane];
            // Nothing is left out: it holds as far as before.
            if rows[lane].near == *active {
                rows[lane].reach = if to_the_end {
                    f64::INFINITY
                } else {
                    given.reach
                };
                all |= 1 << lane;
            }
        }
        if to_the_end && open & !all != 0 {
            thin.weigh(active, |to| {
                self.surface.terms(p, &self.around(found.front, last), to)
            });
            for lane in lanes().filter(|lane| all >> lane & 1 == 0) {
                thin.choose(active, lane, &mut rows[lane].all);
            }
        }
    }

    #[inline(always)]
    fn slope(&mut self, over: Slab<P::F>, direction: Direction) -> Enclosed<P, 2> {
        *self.count += 1;
        let towards = self.group.towards(self.p, over, direction);
        self.surface.slope(self.p, &towards)
    }

    /// From the front: what is excluded is passed with steps that grow, what is not is tried again at a quarter of the length,
    /// down to the width of the beam.
    #[inline(always)]
    fn march(&mut self) -> Found<P> {
        let p = self.p;
        let Stretch {
            mut live,
            start,
            end,
            first,
            ..
        } = *self.stretch;
        let mut open = p.none();
        let mut front = start;
        let shortest = p.mul_rn(self.group.width(p, front), p.splat(SHORTEST));
        let mut length = p.max_f(first, shortest);
        let mut round = 0;
        while p.any(live) {
            let back = p.min_f(p.add_rn(front, length), end);
            let t = Interval {
                lo: front,
                hi: p.max_f(back, front),
            };
            let slab = self.group.slab(p, &t);
            let f = self.value(&slab);
            let mut none = excluded(p, &f.d[0], &f.flags, live);
            let short = p.le(length, p.mul_rn(shortest, p.splat(4.0)));
            let rest = p.and(p.and_not(live, none), short);
            if p.any(rest) {
                let sides = self.sides(slab, rest);
                let f = self.mean(&t, &slab, &sides);
                let certain = p.and(sides.usable, nonzero(p, &f));
                none = p.or(none, p.and(rest, certain));
            }
            front = p.select(none, t.hi, front);
            live = p.and_not(live, p.and(none, p.le(end, front)));
            let failed = p.and_not(live, none);
            let part = p.mul_rn(length, p.splat(0.25));
            let stuck = p.and(failed, p.lt(part, shortest));
            open = p.or(open, stuck);
            live = p.and_not(live, stuck);
            let longer = p.select(none, p.add_rn(length, length), part);
            length = p.select(live, longer, length);
            round += 1;
            if round == 200 {
                open = p.or(open, live);
                break;
            }
        }
        Found {
            open,
            front,
            length,
            one: p.none(),
            back: end,
            slope: Interval {
                lo: front,
                hi: front,
            },
            inside: p.none(),
            plane: [front; 3],
        }
    }

    /// The derivatives by x and y over a slab.
    #[inline(always)]
    fn sides(&mut self, slab: Slab<P::F>, live: P::M) -> Sides<P> {
        let p = self.p;
        let x = self.slope(slab, Direction::Right);
        let y = self.slope(slab, Direction::Up);
        let usable = differentiable(p, &x.flags, live);
        Sides {
            by: [x.d[1], y.d[1]],
            usable: differentiable(p, &y.flags, usable),
        }
    }

    /// f over `t`, which is part of where the sides' derivatives hold: f(t, 0, 0) ± |x|·|f_x| ± |y|·|f_y|.
    #[inline(always)]
    fn mean(&mut self, t: &Interval<P::F>, slab: &Slab<P::F>, sides: &Sides<P>) -> Interval<P::F> {
        let p = self.p;
        let zero = p.splat(0.0);
        let middle = self.value(&Slab {
            t: *t,
            half: [zero; 2],
        });
        let x = p.mul_nonneg_ru(slab.half[0], p.magnitude(sides.by[0]));
        let y = p.mul_nonneg_ru(slab.half[1], p.magnitude(sides.by[1]));
        let around = p.add_ru(x, y);
        Interval {
            lo: p.sub_rd(middle.d[0].lo, around),
            hi: p.add_ru(middle.d[0].hi, around),
        }
    }

    /// Every ray of a beam has exactly one root in a piece if f has opposite certain signs on its two end faces, is continuous
    /// between them, and strictly monotone along all rays.
    #[inline(always)]
    fn prove_single(&mut self, found: &mut Found<P>) {
        let p = self.p;
        let front = found.front;
        let root = self.guess(front);
        let ahead = p.sub_rn(root, front);
        let back = p.add_rn(root, p.mul_rn(ahead, p.splat(1.25)));
        let slack = p.splat(8.0 * self.group.slack());
        let back = p.max_f(p.add_rn(back, slack), front);
        let likely = p.and(
            found.open,
            p.and(p.le(back, self.stretch.end), p.lt(front, back)),
        );
        if !p.any(likely) {
            return;
        }
        let back = p.select(likely, back, front);
        let t = Interval {
            lo: front,
            hi: back,
        };
        let slab = self.group.slab(p, &t);
        let along = self.slope(slab, Direction::Along);
        let smooth = differentiable(p, &along.flags, likely);
        let steep = p.and(smooth, nonzero(p, &along.d[1]));
        if !p.any(steep) {
            return;
        }
        let sides = self.sides(slab, steep);
        let slack = p.splat(2.0 * self.group.slack());
        let first = Interval {
            lo: front,
            hi: p.add_ru(front, slack),
        };
        let last = Interval {
            lo: p.sub_rd(back, slack),
            hi: back,
        };
        let before = self.mean(&first, &slab, &sides);
        let behind = self.mean(&last, &slab, &sides);
        let zero = p.splat(0.0);
        let rises = p.and(p.lt(before.hi, zero), p.lt(zero, behind.lo));
        let falls = p.and(p.lt(zero, before.lo), p.lt(behind.hi, zero));
        let one = p.and(p.and(steep, sides.usable), p.or(rises, falls));
        found.one = one;
        found.back = p.select(one, back, found.back);
        found.slope = select(p, one, &along.d[1], &found.slope);
        if p.any(one) {
            found.plane = self.plane(root);
        }
    }

    /// The tangential plane at a root of the middle ray: t there, and its change per pixel.
    #[inline(always)]
    fn plane(&mut self, root: P::F) -> [P::F; 3] {
        let p = self.p;
        let [along, right, up] = [Direction::Along, Direction::Right, Direction::Up]
            .map(|direction| self.plainly(root, direction)[1]);
        let scale = p.neg_f(p.div_rn(self.group.pixel(p, root), along));
        let [right, up] = [p.mul_rn(right, scale), p.mul_rn(up, scale)];
        let [x, y] = self.group.pixels;
        let at = p.sub_rn(root, p.add_rn(p.mul_rn(x, right), p.mul_rn(y, up)));
        [at, right, up]
    }

    /// A point of the middle ray, nearly, and a direction.
    #[inline(always)]
    fn middle(&self, x: P::F, direction: Direction) -> Towards<P::F> {
        let zero = self.p.splat(0.0);
        let over = Slab {
            t: Interval { lo: x, hi: x },
            half: [zero; 2],
        };
        Towards {
            over,
            direction,
            tilt: zero,
            turn: [zero; 2],
        }
    }

    /// f and its derivative in a direction on the middle ray, nearly.
    #[inline(always)]
    fn plainly(&mut self, x: P::F, direction: Direction) -> [P::F; 2] {
        let p = self.p;
        let half = p.splat(0.5);
        *self.count += 1;
        let f = self.surface.slope(p, &self.middle(x, direction));
        f.d.map(|f| p.mul_rn(half, p.add_rn(f.lo, f.hi)))
    }

    /// Where the middle ray's root may be: a few Newton steps from the front, which prove nothing.
    #[inline(always)]
    fn guess(&mut self, front: P::F) -> P::F {
        let p = self.p;
        let mut x = front;
        for _ in 0..4 {
            let [value, slope] = self.plainly(x, Direction::Along);
            let next = p.sub_rn(x, p.div_rn(value, slope));
            // A step that leads nowhere, or is no number, is not taken.
            let fine = p.and(p.le(front, next), p.le(next, self.stretch.end));
            x = p.select(fine, next, x);
        }
        x
    }
}
