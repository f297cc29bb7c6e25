//! Roots that `f64` cannot pin down: grazing rays, where the noise of f is divided by a small slope.

use super::{Along, Field};
use crate::interval::{Ball, Interval, Packet};
use crate::ray::Lines;

/// A root's interval that is wider than this gets a second look in twice the precision.
pub(crate) const WIDE: f64 = 5e-13;
/// How narrow the second look makes it.
const GOAL: f64 = 1e-13;

/// Rays whose roots' intervals are too wide.
pub(crate) struct Wide<'b, P: Packet> {
    pub field: Field<'b, P>,
    /// The packet's rays as given.
    pub lines: &'b Lines,
    /// Where t = 0 is on them.
    pub entry: P::F,
    /// Bit i is set for ray i.
    pub lanes: u8,
}

/// Bisects intervals that hold exactly one root each, at which f changes its sign. Certain signs alone move their ends.
#[cold]
pub(super) fn sharpen<P: Packet>(wide: Wide<'_, P>, t: &mut Interval<P::F>) {
    let Wide { field, lines, .. } = wide;
    let p = field.p;
    let entry = p.to_array(wide.entry);
    let (mut lo, mut hi) = (p.to_array(t.lo), p.to_array(t.hi));
    for lane in (0..8).filter(|lane| wide.lanes >> lane & 1 != 0) {
        let mut line = Line {
            along: field.along,
            origin: [0, 1, 2].map(|k| lines.origin[k][lane]),
            direction: [0, 1, 2].map(|k| lines.direction[k][lane]),
            entry: entry[lane],
            signs: 0,
        };
        let root = line.bisect(Interval {
            lo: lo[lane],
            hi: hi[lane],
        });
        (lo[lane], hi[lane]) = (root.lo, root.hi);
        field.counts.fine += line.signs;
    }
    *t = Interval {
        lo: p.lanes(lo),
        hi: p.lanes(hi),
    };
}

/// f along the exact ray origin + (entry + t)·direction.
struct Line<'a, P: Packet> {
    along: &'a dyn Along<P>,
    origin: [f64; 3],
    direction: [f64; 3],
    entry: f64,
    /// How many signs were asked for.
    signs: u64,
}

impl<P: Packet> Line<'_, P> {
    /// The sign of f at `t`, if it is certain.
    fn sign(&mut self, t: f64) -> Option<bool> {
        self.signs += 1;
        let t = Ball::sum(self.entry, t);
        let point = [0, 1, 2].map(|k| t.along(self.origin[k], self.direction[k]));
        let (f, flags) = self.along.fine(&point);
        let value = f.interval();
        let defined = !(flags.empty || flags.undefined || flags.jump);
        let certain = defined && (value.lo > 0.0 || value.hi < 0.0);
        certain.then_some(value.lo > 0.0)
    }

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
}
