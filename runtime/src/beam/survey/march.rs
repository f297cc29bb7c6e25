//! Eight beams from their front on: what certainly holds no root is passed.

use super::{Bundle, Found, Stretch};
use crate::beam::{Direction, Group, Slab, Towards};
use crate::interval::{Interval, Packet};
use crate::solve::{Enclosed, differentiable, excluded, nonzero};

/// Eight beams.
pub(super) struct Surveyor<'a, P: Packet> {
    pub p: P,
    pub surface: &'a dyn Bundle<P>,
    pub group: &'a Group<'a, P>,
    pub stretch: &'a Stretch<P>,
    /// Evaluations, each of eight beams.
    pub count: &'a mut u64,
}

/// The mean value form needs these.
pub(super) struct Sides<P: Packet> {
    pub by: [Interval<P::F>; 2],
    pub usable: P::M,
}

/// Beams are not split below so many of their widths: what is nearer is the business of the narrower beams inside.
const SHORTEST: f64 = 0.5;
/// The same where beams are to be excluded by all means.
const KEENLY: f64 = 0.35;

impl<P: Packet> Surveyor<'_, P> {
    #[inline(always)]
    pub(super) fn value(&mut self, over: &Slab<P::F>) -> Enclosed<P, 1> {
        *self.count += self.surface.parts();
        self.surface.value(self.p, over)
    }

    /// A piece and a little more, in all directions: the rays' own t differs by the frame's slack.
    #[inline(always)]
    pub(super) fn around(&self, front: P::F, back: P::F) -> Towards<P::F> {
        self.group.around(self.p, front, back)
    }

    #[inline(always)]
    pub(super) fn slope(&mut self, over: Slab<P::F>, direction: Direction) -> Enclosed<P, 2> {
        *self.count += self.surface.parts();
        let towards = self.group.towards(self.p, over, direction);
        self.surface.slope(self.p, &towards)
    }

    /// From the front: what is excluded is passed with steps that grow, what is not is tried again at a quarter of the length,
    /// down to the width of the beam. Beams that are that far wait for the others: a last look at all of them asks for
    /// derivatives, if beams are to be excluded by all means.
    #[inline(always)]
    pub(super) fn march(&mut self) -> Found<P> {
        let p = self.p;
        let Stretch {
            mut live,
            start,
            end,
            first,
            keenly,
            ..
        } = *self.stretch;
        let (mut open, mut waiting) = (p.none(), p.none());
        let mut front = start;
        let shortest = if keenly { KEENLY } else { SHORTEST };
        let shortest = p.mul_rn(self.group.width(p, front), p.splat(shortest));
        let mut length = p.max_f(first, shortest);
        let mut round = 0;
        while p.any(live) {
            let back = p.min_f(p.add_rn(front, length), end);
            let t = Interval {
                lo: front,
                hi: p.max_f(back, front),
            };
            let slab = self.group.slab(p, &t);
            let going = p.and_not(live, waiting);
            let none = if p.any(going) {
                let f = self.value(&slab);
                let none = excluded(p, &f.d[0], &f.flags, going);
                let failed = p.and_not(going, none);
                let part = p.mul_rn(length, p.splat(0.25));
                let short = p.and(failed, p.lt(part, shortest));
                waiting = p.or(waiting, short);
                length = p.select(p.and_not(failed, short), part, length);
                none
            } else {
                let none = if keenly {
                    let sides = self.sides(slab, waiting);
                    let f = self.mean(&t, &slab, &sides);
                    p.and(sides.usable, nonzero(p, &f))
                } else {
                    p.none()
                };
                open = p.or(open, p.and_not(waiting, none));
                live = none;
                waiting = p.none();
                none
            };
            front = p.select(none, t.hi, front);
            length = p.select(none, p.add_rn(length, length), length);
            live = p.and_not(live, p.and(none, p.le(end, front)));
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
    pub(super) fn sides(&mut self, slab: Slab<P::F>, live: P::M) -> Sides<P> {
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
    pub(super) fn mean(
        &mut self,
        t: &Interval<P::F>,
        slab: &Slab<P::F>,
        sides: &Sides<P>,
    ) -> Interval<P::F> {
        let p = self.p;
        let zero = p.splat(0.0);
        let middle = self.value(&Slab {
            t: *t,
            half: [zero; 2],
        });
        slab.mean(p, &middle.d[0], &sides.by)
    }

    /// A point of the middle ray, nearly, and a direction.
    #[inline(always)]
    pub(super) fn middle(&self, x: P::F, direction: Direction) -> Towards<P::F> {
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
}
