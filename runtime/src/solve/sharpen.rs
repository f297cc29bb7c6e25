//! A second look in twice the precision: at grazing rays, where the noise of f is divided by a small slope.

use super::{Along, Events, Field, twice_differentiable};
use crate::interval::{Ball, Interval, Lanes, Packet, Scalar};
use crate::ray::Lines;
use crate::verdict::Verdict;

/// A root's interval that is wider than this gets a second look in twice the precision.
pub(crate) const WIDE: f64 = 5e-13;
/// How narrow the second look makes it.
const GOAL: f64 = 1e-13;

/// How often a piece beside a sign change is halved.
const DEPTH: u32 = 4;

/// Rays that need a second look.
pub(crate) struct Second<'b, P: Packet> {
    pub field: Field<'b, P>,
    /// The packet's rays as given.
    pub lines: &'b Lines,
    /// Where t = 0 is on them.
    pub entry: P::F,
    /// Bit i is set if the interval of ray i's root is too wide.
    pub wide: u8,
    /// May events be decided by the second derivative?
    pub bends: bool,
    /// What was met before the roots.
    pub events: &'b mut Events,
}

/// Narrows roots, and decides tangencies, as far as twice the precision can.
#[cold]
pub(super) fn sharpen<P: Packet>(mut second: Second<'_, P>, t: &mut Interval<P::F>) {
    let p = second.field.p;
    let (mut lo, mut hi) = (p.to_array(t.lo), p.to_array(t.hi));
    let touched = if second.bends {
        second.events.touched
    } else {
        0
    };
    let wide = second.wide;
    for lane in (0..8).filter(|lane| wide >> lane & 1 != 0) {
        let root = second.on(lane, |line| {
            line.bisect(Interval {
                lo: lo[lane],
                hi: hi[lane],
            })
        });
        (lo[lane], hi[lane]) = (root.lo, root.hi);
    }
    *t = Interval {
        lo: p.lanes(lo),
        hi: p.lanes(hi),
    };
    for lane in (0..8).filter(|lane| touched >> lane & 1 != 0) {
        let events = second.events.take(lane);
        for event in events {
            second.event(lane, event);
        }
    }
}

impl<P: Packet> Second<'_, P> {
    /// Works on one exact ray, and counts.
    fn on<T>(&mut self, lane: usize, work: impl FnOnce(&mut Line<'_, P>) -> T) -> T {
        let mut line = Line {
            along: self.field.along,
            origin: [0, 1, 2].map(|k| self.lines.origin[k][lane]),
            direction: [0, 1, 2].map(|k| self.lines.direction[k][lane]),
            entry: self.field.p.to_array(self.entry)[lane],
            looks: 0,
        };
        let done = work(&mut line);
        self.field.counts.fine += line.looks;
        done
    }

    /// Puts an event back, or what it turns out to be.
    fn event(&mut self, lane: usize, event: Verdict) {
        match event {
            Verdict::Crossing { t } => {
                let event = match self.on(lane, |line| line.simple(&t)) {
                    Some(t) => Verdict::Root { t },
                    None => Verdict::Crossing {
                        t: self.narrow(lane, t),
                    },
                };
                self.events.push(lane, event);
            }
            Verdict::Tangent { t, .. } => match self.bend(lane, &t) {
                Some(bend) => {
                    let found = self.on(lane, |line| line.turn(&t, &bend));
                    found.tell(event, |verdict| self.events.push(lane, verdict));
                }
                None => self.events.push(lane, event),
            },
            _ => self.events.push(lane, event),
        }
    }

    /// Takes away what certainly holds no root from both sides of a sign change.
    fn narrow(&mut self, lane: usize, mut t: Interval) -> Interval {
        let signs = self.on(lane, |line| [line.sign(t.lo), line.sign(t.hi)]);
        let [Some(before), Some(behind)] = signs else {
            return t;
        };
        while before != behind && t.hi - t.lo > GOAL {
            let middle = t.lo + 0.5 * (t.hi - t.lo);
            let left = match self.on(lane, |line| line.sign(middle)) {
                Some(sign) => sign == before,
                None => break,
            };
            let (lo, hi) = if left { (t.lo, middle) } else { (middle, t.hi) };
            if !self.free(lane, Interval { lo, hi }, DEPTH) {
                break;
            }
            if left {
                t.lo = middle;
            } else {
                t.hi = middle;
            }
        }
        t
    }

    /// Is there no root in a piece at whose ends f has the same certain sign? If 0 ∉ f'', f' lies between its values at
    /// the ends; if these have the same sign, f lies between its own.
    fn free(&mut self, lane: usize, t: Interval, depth: u32) -> bool {
        let slopes = self.on(lane, |line| [line.slope(t.lo), line.slope(t.hi)]);
        if slopes[0].is_some() && slopes[0] == slopes[1] && self.bend(lane, &t).is_some() {
            return true;
        }
        if depth == 0 {
            return false;
        }
        let middle = t.lo + 0.5 * (t.hi - t.lo);
        let signs = self.on(lane, |line| [line.sign(t.lo), line.sign(middle)]);
        let halves = [(t.lo, middle), (middle, t.hi)];
        signs[0].is_some()
            && signs[0] == signs[1]
            && halves
                .into_iter()
                .all(|(lo, hi)| self.free(lane, Interval { lo, hi }, depth - 1))
    }

    /// f'' over a piece of one ray, if it exists there and is not 0.
    fn bend(&mut self, lane: usize, t: &Interval) -> Option<Interval> {
        let p = self.field.p;
        let only = p.mask(1 << lane);
        let t = Interval {
            lo: p.splat(t.lo),
            hi: p.splat(t.hi),
        };
        let f = self.field.curvature(&t, only);
        let exists = p.bits(twice_differentiable(p, &f.flags, only)) != 0;
        let bend = Interval {
            lo: p.to_array(f.d[2].lo)[lane],
            hi: p.to_array(f.d[2].hi)[lane],
        };
        (exists && !bend.contains(0.0)).then_some(bend)
    }
}

/// What is found out about a piece with one critical point and roots on both sides of it, if at all.
enum Turn {
    /// No root.
    None,
    /// The roots before and behind the critical point, each the only one on its side.
    Roots([Option<Interval>; 2]),
    /// Still a tangency, perhaps a narrower one.
    Tangent { t: Interval, residual: f64 },
    /// Nothing.
    Unknown,
}

impl Turn {
    fn tell(self, was: Verdict, mut push: impl FnMut(Verdict)) {
        match self {
            Turn::None => {}
            Turn::Roots(roots) => {
                for t in roots.into_iter().flatten() {
                    push(Verdict::Root { t });
                }
            }
            Turn::Tangent { t, residual } => push(Verdict::Tangent { t, residual }),
            Turn::Unknown => push(was),
        }
    }
}

/// f along the exact ray origin + (entry + t)·direction.
struct Line<'a, P: Packet> {
    along: &'a dyn Along<P>,
    origin: [f64; 3],
    direction: [f64; 3],
    entry: f64,
    /// How often f was evaluated.
    looks: u64,
}

impl<P: Packet> Line<'_, P> {
    /// f and f' at `t`, if f is certainly defined and continuous there.
    fn at(&mut self, t: f64) -> Option<[Interval; 2]> {
        self.over(Ball::sum(self.entry, t))
    }

    /// The same over a ball of parameters of the ray as given.
    fn over(&mut self, t: Ball) -> Option<[Interval; 2]> {
        self.looks += 1;
        let point = [0, 1, 2].map(|k| t.along(self.origin[k], self.direction[k]));
        let ([f, gradient @ ..], flags) = self.along.fine(&point);
        let defined = !(flags.empty || flags.undefined || flags.jump);
        let slope = Ball::dot(&gradient, &self.direction);
        defined.then_some([f.interval(), slope.interval()])
    }

    /// The sign of f at `t`, if it is certain.
    fn sign(&mut self, t: f64) -> Option<bool> {
        let [f, _] = self.at(t)?;
        (!f.contains(0.0)).then_some(f.lo > 0.0)
    }

    /// The root of a piece over which f has a slope, and at whose ends it has opposite signs.
    fn simple(&mut self, t: &Interval) -> Option<Interval> {
        let [_, slope] = self.over(Ball::span(self.entry, t))?;
        let change = self.sign(t.lo)? != self.sign(t.hi)?;
        (change && !slope.contains(0.0)).then(|| self.bisect(*t))
    }

    /// The sign of f' at `t`, if it is certain.
    fn slope(&mut self, t: f64) -> Option<bool> {
        let [_, slope] = self.at(t)?;
        (!slope.contains(0.0)).then_some(slope.lo > 0.0)
    }

    /// Bisects a piece at whose ends f has opposite signs. Certain signs alone move its ends.
    fn bisect(&mut self, root: Interval) -> Interval {
        let mut root = root;
        let Some(before) = self.sign(root.lo) else {
            return root;
        };
        if self.sign(root.hi) != Some(!before) {
            return root;
        }
        let goal = GOAL.max(4.0 * f64::EPSILON * root.hi);
        while root.hi - root.lo > goal {
            let middle = root.lo + 0.5 * (root.hi - root.lo);
            match self.sign(middle) {
                Some(sign) if sign == before => root.lo = middle,
                Some(_) => root.hi = middle,
                None => break,
            }
        }
        root
    }

    /// Let f'' > 0 (else mirror the signs), m = min f'', and c any point of T. Then f ≥ f(c) − f'(c)²/2m on T, which
    /// may exclude a root. If f(c) < 0, there is one root on each side of c whose end is positive, and none on a side
    /// whose end is negative. Else, as |f| ≤ r at the critical point, roots are within √(2r/m) of that, and it is
    /// within |f'(c)|/m of c.
    fn turn(&mut self, t: &Interval, bend: &Interval) -> Turn {
        let up = bend.lo > 0.0;
        let flattest = bend.lo.abs().min(bend.hi.abs());
        let c = self.lowest(t, 0.5 * (bend.lo + bend.hi));
        let Some([f, slope]) = self.at(c) else {
            return Turn::Unknown;
        };
        let [least, most] = if up { [f.lo, f.hi] } else { [-f.hi, -f.lo] };
        let steepest = slope.lo.abs().max(slope.hi.abs());
        let p = Scalar;
        let dip = p.div_ru(p.mul_ru(steepest, steepest), p.mul_rd(2.0, flattest));
        if least > dip {
            return Turn::None;
        }
        if most < 0.0 {
            return self.sides(t, c, up);
        }
        let residual = p.add_ru(least.abs().max(most.abs()), dip);
        let radius = p.sqrt_ru(p.div_ru(p.add_ru(residual, residual), flattest));
        let reach = p.add_ru(radius, p.div_ru(steepest, flattest));
        let t = Interval {
            lo: p.sub_rd(c, reach).max(t.lo),
            hi: p.add_ru(c, reach).min(t.hi),
        };
        if t.lo <= t.hi && residual.is_finite() {
            Turn::Tangent { t, residual }
        } else {
            Turn::Unknown
        }
    }

    /// Newton on f' with a guess of f'': a place near the critical point, without any guarantee.
    fn lowest(&mut self, t: &Interval, bend: f64) -> f64 {
        let mut c = 0.5 * (t.lo + t.hi);
        for _ in 0..6 {
            let Some([_, slope]) = self.at(c) else {
                break;
            };
            let next = (c - 0.5 * (slope.lo + slope.hi) / bend).clamp(t.lo, t.hi);
            if next == c || next.is_nan() {
                break;
            }
            c = next;
        }
        c
    }

    /// The roots of a piece in whose midst, at c, f is certainly on the other side of 0.
    fn sides(&mut self, t: &Interval, c: f64, up: bool) -> Turn {
        let (Some(before), Some(behind)) = (self.sign(t.lo), self.sign(t.hi)) else {
            return Turn::Unknown;
        };
        let left = (before == up).then(|| self.bisect(Interval { lo: t.lo, hi: c }));
        let right = (behind == up).then(|| self.bisect(Interval { lo: c, hi: t.hi }));
        Turn::Roots([left, right])
    }
}
