//! From boxes to squares of a picture.

use super::cells::{Root, cuts};
use super::tree::Parts;
use crate::beam::Frame;
use crate::interval::{Interval, Packet, Routine};

/// Roots in a box are looked for this part of its depth before and behind it, too: on its faces they would be at the end of
/// a search.
pub(super) const MARGIN: f64 = 0.125;

/// A part of a pixel: boxes that end between two squares are in both.
const TOUCH: f64 = 1.0 / 1024.0;

/// The squares of a picture.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    /// The side of a square in pixels, a power of two.
    pub side: u32,
    /// Columns and rows.
    pub count: [u32; 2],
}

/// Where eight boxes are seen.
pub(super) struct Seen {
    /// Those that are in the picture and before the camera.
    pub shown: u8,
    /// The first and the last t, and a little more.
    pub t: [[f64; 8]; 2],
    /// The first and the last column, the first and the last row of squares.
    pub squares: [[f64; 8]; 4],
}

/// From a tree's boxes to the picture.
pub(super) struct Projection<'a, P: Packet> {
    grid: &'a Grid,
    perspective: bool,
    /// The tree's lower corner in the frame's coordinates: t, right and up, …
    low: [Interval<P::F>; 3],
    /// … and its sides, each by axis.
    sides: [[Interval<P::F>; 3]; 3],
    slack: P::F,
    pixel: Interval<P::F>,
    /// The middle of the picture, in pixels.
    middle: [P::F; 2],
}

impl<'a, P: Packet> Projection<'a, P> {
    #[inline(always)]
    pub fn new(p: P, frame: &Frame, root: &Root, picture: [u32; 2], grid: &'a Grid) -> Self {
        let point = |x: f64| p.point(p.splat(x));
        let rows = frame.inverse.map(|row| row.map(|x| p.constant(&x)));
        let low = [0, 1, 2].map(|k| p.sub(point(root.low[k]), point(frame.from[k])));
        let sides = root.size.map(|side| p.constant(&side));
        Projection {
            grid,
            perspective: frame.perspective,
            low: rows.map(|row| {
                let [x, y, z] = [0, 1, 2].map(|k| p.mul(row[k], low[k]));
                p.add(p.add(x, y), z)
            }),
            sides: rows.map(|row| [0, 1, 2].map(|k| p.mul(row[k], sides[k]))),
            slack: p.splat(frame.slack),
            pixel: point(frame.pixel),
            middle: picture.map(|n| p.splat(0.5 * f64::from(n))),
        }
    }

    /// Where parts of a box are seen.
    pub fn see(&self, p: P, parts: &Parts) -> Seen {
        p.call(See { by: self, parts })
    }
}

struct See<'a, 'b, P: Packet> {
    by: &'a Projection<'b, P>,
    parts: &'a Parts,
}

impl<P: Packet> Routine<P> for See<'_, '_, P> {
    type Output = Seen;

    /// The frame's coordinates of a point are linear: interval arithmetic gives their exact ranges over a box, up to
    /// rounding. A ray's point is within the slack of where its pixel says.
    #[inline(always)]
    fn call(self, p: P) -> Seen {
        let (by, parts) = (self.by, self.parts);
        let cuts = cuts(p, parts.place, parts.level);
        let mut place = by.low;
        for (place, sides) in place.iter_mut().zip(&by.sides) {
            for (cut, side) in cuts.iter().zip(sides) {
                *place = p.add(*place, from_to(p, cut, side));
            }
            *place = widened(p, *place, by.slack);
        }
        let [t, x, y] = place;
        let columns = by.touched(p, by.on_picture(p, x, &t), 0);
        let rows = by.touched(p, p.neg(by.on_picture(p, y, &t)), 1);
        let beside = p.or(columns.beside, rows.beside);
        let shown = p.and_not(p.not(beside), p.lt(t.hi, p.splat(0.0)));
        let depth = p.mul_ru(p.sub_ru(t.hi, t.lo), p.splat(MARGIN));
        let t = widened(p, t, depth);
        // What is not a number may be anywhere.
        let t = p.select_interval(p.le(t.lo, t.hi), t, p.entire());
        let squares = [columns.first, columns.last, rows.first, rows.last];
        Seen {
            shown: parts.open & p.bits(shown),
            t: [p.to_array(t.lo), p.to_array(t.hi)],
            squares: squares.map(|x| p.to_array(x)),
        }
    }
}

/// The squares that boxes touch on one axis of the picture.
struct Touched<P: Packet> {
    first: P::F,
    last: P::F,
    /// None of them.
    beside: P::M,
}

impl<P: Packet> Projection<'_, P> {
    /// Where the rays are that pass at `side`, in pixels from the middle: the pixel at a has a·t there in a perspective view,
    /// and a in an orthographic one. Boxes that reach behind a perspective camera may be anywhere.
    #[inline(always)]
    fn on_picture(&self, p: P, side: Interval<P::F>, t: &Interval<P::F>) -> Interval<P::F> {
        if !self.perspective {
            return p.i_div(side, self.pixel);
        }
        let before = p.lt(p.splat(0.0), t.lo);
        let one = p.point(p.splat(1.0));
        let a = p.i_div(side, p.select_interval(before, *t, one));
        p.select_interval(before, p.i_div(a, self.pixel), p.entire())
    }

    /// The squares of a range of pixels, which count from the middle. Of what is not a number all are touched.
    #[inline(always)]
    fn touched(&self, p: P, pixels: Interval<P::F>, axis: usize) -> Touched<P> {
        let zero = p.splat(0.0);
        let middle = self.middle[axis];
        let from_edge = Interval {
            lo: p.add_rd(middle, pixels.lo),
            hi: p.add_ru(middle, pixels.hi),
        };
        let at = widened(p, from_edge, p.splat(TOUCH));
        // A power of two: the quotient is exact.
        let part = p.splat(1.0 / f64::from(self.grid.side));
        let (lo, hi) = (p.mul_rn(at.lo, part), p.mul_rn(at.hi, part));
        let count = f64::from(self.grid.count[axis]);
        let last = p.splat(count - 1.0);
        Touched {
            first: p.min_f(p.max_f(p.floor_f(lo), zero), last),
            last: p.max_f(p.min_f(p.floor_f(hi), last), zero),
            beside: p.or(p.lt(hi, zero), p.lt(p.splat(count), lo)),
        }
    }
}

/// c·a for all c between two numbers that are not negative.
#[inline(always)]
fn from_to<P: Packet>(p: P, c: &Interval<P::F>, a: &Interval<P::F>) -> Interval<P::F> {
    Interval {
        lo: p.min_f(p.mul_rd(c.lo, a.lo), p.mul_rd(c.hi, a.lo)),
        hi: p.max_f(p.mul_ru(c.lo, a.hi), p.mul_ru(c.hi, a.hi)),
    }
}

#[inline(always)]
fn widened<P: Packet>(p: P, a: Interval<P::F>, by: P::F) -> Interval<P::F> {
    Interval {
        lo: p.sub_rd(a.lo, by),
        hi: p.add_ru(a.hi, by),
    }
}
