//! A second look in twice the precision: at grazing rays, where the noise of f is divided by a small slope.

use super::line::{Line, Turn};
use super::{Events, Field, differentiable, twice_differentiable};
use crate::interval::{Interval, Packet};
use crate::ray::Lines;
use crate::verdict::{Verdict, Why};

/// A root's interval that is wider than this gets a second look in twice the precision.
pub(crate) const WIDE: f64 = 5e-13;
/// How narrow the second look makes a sign change.
const GOAL: f64 = 1e-13;

/// How often a piece beside a sign change is halved.
const DEPTH: u32 = 4;

/// How many looks one event takes at most.
const LOOKS: f64 = 250.0;

/// Rays that need a second look.
pub(crate) struct Second<'b, P: Packet> {
    pub field: Field<'b, P>,
    /// The packet's rays as given.
    pub lines: &'b Lines,
    /// Where t = 0 is on them.
    pub entry: P::F,
    /// Where the search ends.
    pub end: P::F,
    /// Bit i is set if the interval of ray i's root is too wide, …
    pub wide: u8,
    /// … that is, wider than this.
    pub goal: P::F,
    /// May events be decided by the second derivative?
    pub bends: bool,
    /// Evaluations that one ray may take.
    pub budget: u32,
    /// What was met before the roots.
    pub events: &'b mut Events,
}

/// Narrows roots, and decides tangencies, as far as twice the precision can.
#[cold]
pub(super) fn sharpen<P: Packet>(mut second: Second<'_, P>, t: &mut Interval<P::F>) {
    let touched = second.events.touched;
    if second.wide != 0 {
        second.roots(t);
    }
    let hopeless = if second.bends {
        second.hopeless(touched)
    } else {
        [None; 8]
    };
    for lane in lanes(touched) {
        let events = second.events.take(lane);
        for event in events {
            if hopeless[lane].is_some() && event.t() == hopeless[lane] {
                second.events.push(lane, event);
            } else {
                second.event(lane, event);
            }
        }
        let end = second.field.p.to_array(second.end)[lane];
        for event in &mut second.events.of[lane] {
            *event = event.unless_vague(end);
        }
    }
}

/// The lanes of a mask's bits.
fn lanes(bits: u8) -> impl Iterator<Item = usize> {
    (0..8).filter(move |lane| bits >> lane & 1 != 0)
}

/// As narrow as a root's interval is made, nearly.
fn is_narrow(t: &Interval) -> bool {
    t.hi - t.lo <= 2.0 * f64::EPSILON * t.hi
}

impl<P: Packet> Second<'_, P> {
    /// Works on one exact ray, and counts.
    fn on<T>(&mut self, lane: usize, work: impl FnOnce(&mut Line<'_, P>) -> T) -> T {
        let p = self.field.p;
        let mut line = Line {
            along: &*self.field.along,
            origin: [0, 1, 2].map(|k| self.lines.origin[k][lane]),
            direction: [0, 1, 2].map(|k| self.lines.direction[k][lane]),
            entry: p.to_array(self.entry)[lane],
            looks: 0,
        };
        let done = work(&mut line);
        self.field.counts.fine += line.looks;
        let mut spent = p.to_array(*self.field.spent);
        spent[lane] += line.looks as f64;
        *self.field.spent = p.lanes(spent);
        done
    }

    /// May this ray be looked at once more?
    fn affords(&self, lane: usize) -> bool {
        let spent = self.field.p.to_array(*self.field.spent)[lane];
        spent + LOOKS <= f64::from(self.budget)
    }

    /// Newton images while each at least halves a root's interval: one by the active rows where that is enough, else by
    /// all. What is wide then is bisected.
    fn roots(&mut self, t: &mut Interval<P::F>) {
        let p = self.field.p;
        let mut open = self.wide;
        let mut roots = ends(p, t);
        let goals = p.to_array(self.goal);
        for round in 0..4 {
            if open == 0 {
                break;
            }
            let slopes = self.slopes(&packet(p, &roots), open);
            for lane in lanes(open) {
                let before = roots[lane];
                let mut image = |near| {
                    slopes[lane].and_then(|d| self.on(lane, |line| line.image(&before, &d, near)))
                };
                if round == 0
                    && let Some(enough) = image(true).filter(|t| t.width() <= goals[lane])
                {
                    roots[lane] = enough;
                    open &= !(1 << lane);
                    self.wide &= !(1 << lane);
                    continue;
                }
                roots[lane] = image(false).unwrap_or(before);
                let halved = roots[lane].width() <= 0.5 * before.width();
                if !halved || is_narrow(&roots[lane]) {
                    open &= !(1 << lane);
                }
            }
        }
        for lane in lanes(self.wide) {
            if !is_narrow(&roots[lane]) {
                let wide = roots[lane];
                roots[lane] = self.on(lane, |line| line.bisect(wide));
            }
        }
        *t = packet(p, &roots);
    }

    /// f' over the segments of some rays, where it may be used and is not 0.
    fn slopes(&mut self, t: &Interval<P::F>, rays: u8) -> [Option<Interval>; 8] {
        let p = self.field.p;
        let rays = p.mask(rays);
        let f = self.field.slope(t, rays);
        let usable = p.bits(differentiable(p, &f.flags, rays));
        let slopes = ends(p, &f.d[1]);
        let mut found = [None; 8];
        for lane in lanes(usable) {
            found[lane] = Some(slopes[lane]).filter(|d| !d.contains(0.0));
        }
        found
    }

    /// The first piece that is open on each of these rays, if f is a line there or has a kink: no second look tells more.
    fn hopeless(&mut self, rays: u8) -> [Option<Interval>; 8] {
        let p = self.field.p;
        let floor = |event: &&Verdict| matches!(event, Verdict::Unresolved { why, .. } if *why == Why::Floor);
        let mut open = [None; 8];
        for lane in lanes(rays) {
            let event = self.events.of[lane].iter().find(floor);
            open[lane] = event.and_then(Verdict::t);
        }
        let some = lanes(rays).filter(|lane| open[*lane].is_some());
        let some = p.mask(some.map(|lane| 1 << lane).sum());
        if !p.any(some) {
            return open;
        }
        let t = open.map(|t| t.unwrap_or(Interval { lo: 0.0, hi: 0.0 }));
        let f = self.field.curvature(&packet(p, &t), some);
        let bends = ends(p, &f.d[2]);
        for lane in lanes(p.bits(twice_differentiable(p, &f.flags, some))) {
            if bends[lane] != (Interval { lo: 0.0, hi: 0.0 }) {
                open[lane] = None;
            }
        }
        open
    }

    /// Puts an event back, or what it turns out to be.
    fn event(&mut self, lane: usize, event: Verdict) {
        match event {
            _ if !self.bends || !self.affords(lane) => self.events.push(lane, event),
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
            Verdict::Unresolved { t, why: Why::Floor } => match self.separate(lane, &t) {
                Some(roots) => {
                    for t in roots.into_iter().flatten() {
                        self.events.push(lane, Verdict::Root { t });
                    }
                }
                None => self.events.push(lane, event),
            },
            _ => self.events.push(lane, event),
        }
    }

    /// All roots of an open piece, at most two, if twice the precision tells. At a kink it does not: that stays in one of the
    /// parts, however short they are.
    fn separate(&mut self, lane: usize, t: &Interval) -> Option<[Option<Interval>; 2]> {
        let bend = self.second_derivative(lane, t)?;
        let before = self.on(lane, |line| line.sign(t.lo))?;
        let change = self.on(lane, |line| line.sign(t.hi))? != before;
        if !change && self.free(lane, *t, DEPTH) {
            return Some([None; 2]);
        }
        if bend.contains(0.0) {
            return None;
        }
        self.on(lane, |line| {
            if change {
                return Some([Some(line.bisect(*t)), None]);
            }
            match line.turn(t, &bend) {
                Turn::None => Some([None; 2]),
                Turn::Roots(roots) => Some(roots),
                Turn::Tangent { .. } | Turn::Unknown => None,
            }
        })
    }

    /// Takes away what certainly holds no root from both sides of a sign change.
    fn narrow(&mut self, lane: usize, mut t: Interval) -> Interval {
        let signs = self.on(lane, |line| [line.sign(t.lo), line.sign(t.hi)]);
        let [Some(before), Some(behind)] = signs else {
            return t;
        };
        while before != behind && t.hi - t.lo > GOAL && self.affords(lane) {
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
        if depth == 0 || !self.affords(lane) {
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
        let bend = self.second_derivative(lane, t)?;
        (!bend.contains(0.0)).then_some(bend)
    }

    /// f'' over a piece of one ray, if it exists there.
    fn second_derivative(&mut self, lane: usize, t: &Interval) -> Option<Interval> {
        let p = self.field.p;
        let only = p.mask(1 << lane);
        let t = Interval {
            lo: p.splat(t.lo),
            hi: p.splat(t.hi),
        };
        let f = self.field.curvature(&t, only);
        let exists = p.bits(twice_differentiable(p, &f.flags, only)) != 0;
        exists.then(|| Interval {
            lo: p.to_array(f.d[2].lo)[lane],
            hi: p.to_array(f.d[2].hi)[lane],
        })
    }
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

/// A packet's segments one by one.
fn ends<P: Packet>(p: P, t: &Interval<P::F>) -> [Interval; 8] {
    let (lo, hi) = (p.to_array(t.lo), p.to_array(t.hi));
    core::array::from_fn(|lane| Interval {
        lo: lo[lane],
        hi: hi[lane],
    })
}

fn packet<P: Packet>(p: P, t: &[Interval; 8]) -> Interval<P::F> {
    Interval {
        lo: p.lanes(t.map(|t| t.lo)),
        hi: p.lanes(t.map(|t| t.hi)),
    }
}
