//! One exact ray in twice the precision.

use super::Along;
use crate::interval::{Arithmetic, Ball, Flags, Interval, Lanes, Packet, Scalar};

/// What is found out about a piece with one critical point and roots on both sides of it, if at all.
pub(super) enum Turn {
    /// No root.
    None,
    /// The roots before and behind the critical point, each the only one on its side.
    Roots([Option<Interval>; 2]),
    /// Still a tangency, perhaps a narrower one.
    Tangent { t: Interval, residual: f64 },
    /// Nothing.
    Unknown,
}

/// f along the exact ray origin + (entry + t)·direction.
pub(super) struct Line<'a, P: Packet> {
    pub along: &'a dyn Along<P>,
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    pub entry: f64,
    /// How often f was evaluated.
    pub looks: u64,
}

/// Is f certainly defined and continuous?
fn continuous(flags: &Flags<Scalar>) -> bool {
    !(flags.empty || flags.undefined || flags.jump)
}

impl<P: Packet> Line<'_, P> {
    /// f and f' at `t`, if f is certainly defined and continuous there.
    fn at(&mut self, t: f64) -> Option<[Interval; 2]> {
        self.over(Ball::sum(self.entry, t))
    }

    /// The same over a ball of parameters of the ray as given.
    fn over(&mut self, t: Ball) -> Option<[Interval; 2]> {
        self.looks += 1;
        let ([f, gradient @ ..], flags) = self.along.fine(&self.point(t));
        let slope = Ball::dot(&gradient, &self.direction);
        continuous(&flags).then_some([f.interval(), slope.interval()])
    }

    /// f at `t` by the active rows, if there are others.
    fn near(&mut self, t: f64) -> Option<Interval> {
        let point = self.point(Ball::sum(self.entry, t));
        let (f, flags) = self.along.fine_value(&point)?;
        self.looks += 1;
        continuous(&flags).then(|| f.interval())
    }

    fn point(&self, t: Ball) -> [Ball; 3] {
        [0, 1, 2].map(|k| t.along(self.origin[k], self.direction[k]))
    }

    /// The sign of f at `t`, if it is certain.
    pub fn sign(&mut self, t: f64) -> Option<bool> {
        let [f, _] = self.at(t)?;
        (!f.contains(0.0)).then_some(f.lo > 0.0)
    }

    /// The root of a piece over which f has a slope, and at whose ends it has opposite signs.
    pub fn simple(&mut self, t: &Interval) -> Option<Interval> {
        let [_, slope] = self.over(Ball::span(self.entry, t))?;
        let change = self.sign(t.lo)? != self.sign(t.hi)?;
        (change && !slope.contains(0.0)).then(|| self.bisect(*t))
    }

    /// The sign of f' at `t`, if it is certain.
    pub fn slope(&mut self, t: f64) -> Option<bool> {
        let [_, slope] = self.at(t)?;
        (!slope.contains(0.0)).then_some(slope.lo > 0.0)
    }

    /// The Newton image of a piece that holds one root and over which f' is enclosed, intersected with the piece: by the
    /// mean value theorem the root is in c − f(c)/f'. What remains is in proportion to the square of the piece's width, so
    /// that one image leaves an ulp or two. Nothing where f' may be 0, and nothing by the active rows if they are all.
    pub fn image(&mut self, t: &Interval, slope: &Interval, near: bool) -> Option<Interval> {
        let p = Scalar;
        let c = t.lo + 0.5 * (t.hi - t.lo);
        let f = if near { self.near(c)? } else { self.at(c)?[0] };
        let (step, _) = p.div(f, *slope);
        let lo = p.sub_rd(c, step.hi).max(t.lo);
        let hi = p.sub_ru(c, step.lo).min(t.hi);
        (!slope.contains(0.0) && lo <= hi).then_some(Interval { lo, hi })
    }

    /// Bisects a piece at whose ends f has opposite signs. Certain signs alone move its ends.
    pub fn bisect(&mut self, root: Interval) -> Interval {
        let mut root = root;
        let Some(before) = self.sign(root.lo) else {
            return root;
        };
        if self.sign(root.hi) != Some(!before) {
            return root;
        }
        for _ in 0..100 {
            if root.hi - root.lo <= 2.0 * f64::EPSILON * root.hi {
                break;
            }
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
    pub fn turn(&mut self, t: &Interval, bend: &Interval) -> Turn {
        let up = bend.lo > 0.0;
        let flattest = bend.lo.abs().min(bend.hi.abs());
        let Some((c, [f, slope])) = self.lowest(t, 0.5 * (bend.lo + bend.hi)) else {
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

    /// Newton on f' with a guess of f'': a place near the critical point, without any guarantee, with f and f' there.
    fn lowest(&mut self, t: &Interval, bend: f64) -> Option<(f64, [Interval; 2])> {
        let mut c = 0.5 * (t.lo + t.hi);
        let mut found = self.at(c)?;
        for _ in 0..6 {
            let [_, slope] = found;
            let next = (c - 0.5 * (slope.lo + slope.hi) / bend).clamp(t.lo, t.hi);
            if next.is_nan() || (next - c).abs() <= 2.0 * f64::EPSILON * c {
                break;
            }
            c = next;
            found = self.at(c)?;
        }
        Some((c, found))
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
