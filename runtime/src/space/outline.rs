//! Where boxes lie on a picture, and how far from the camera.

use super::cells::{Place, Root};
use super::tree::{Parts, Tree};
use crate::beam::Frame;
use crate::interval::{Interval, Isa, Kernel, Packet};
use crate::render::tile::CELL;

/// A picture has at most so many squares; on larger ones they hold several cells.
const SQUARES: u64 = 1 << 18;

/// Roots in a box are looked for this part of its depth before and behind it, too: on its faces they would be at the end of
/// a search.
pub(super) const MARGIN: f64 = 0.125;

/// A part of a pixel: boxes that end between two squares are in both.
const TOUCH: f64 = 1.0 / 1024.0;

/// For each square of a picture, the first and the last t of the boxes that lie there, in the camera's and in the rays' own
/// t; crossed if there are none.
pub(crate) struct Outline {
    /// The side of a square in pixels.
    side: u32,
    columns: u32,
    rows: u32,
    squares: Vec<[f64; 2]>,
}

/// No box.
pub(crate) const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

fn hull(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

impl Outline {
    /// A tree's boxes as seen by a camera.
    pub fn new(isa: Isa, tree: &Tree, frame: &Frame, picture: [u32; 2]) -> Outline {
        let mut side = CELL[0];
        let count = |side: u32| picture.map(|n| u64::from(n.div_ceil(side)));
        while count(side).iter().product::<u64>() > SQUARES {
            side *= 2;
        }
        let [columns, rows] = count(side).map(|n| n as u32);
        let mut outline = Outline {
            side,
            columns,
            rows,
            squares: vec![NOTHING; (columns * rows) as usize],
        };
        isa.run(Draw {
            tree,
            frame,
            picture,
            outline: &mut outline,
        });
        outline
    }

    /// First and last t of the boxes behind a rectangle of pixels.
    pub fn over(&self, corner: [u32; 2], size: [u32; 2]) -> [f64; 2] {
        let [first, last] = [corner, [corner[0] + size[0] - 1, corner[1] + size[1] - 1]];
        let last = [
            (last[0] / self.side).min(self.columns - 1),
            (last[1] / self.side).min(self.rows - 1),
        ];
        let mut span = NOTHING;
        for y in first[1] / self.side..=last[1] {
            for x in first[0] / self.side..=last[0] {
                span = hull(span, self.squares[(y * self.columns + x) as usize]);
            }
        }
        span
    }

    /// The squares that a range of pixels touches, on one axis with so many; nothing if it is beside the picture.
    fn touched(&self, pixels: &Interval, count: u32) -> Option<[u32; 2]> {
        let side = f64::from(self.side);
        let beside = pixels.hi < 0.0 || pixels.lo > side * f64::from(count);
        let last = f64::from(count - 1);
        let first = (pixels.lo / side).floor().max(0.0).min(last);
        let end = (pixels.hi / side).floor().min(last).max(0.0);
        (!beside).then_some([first as u32, end as u32])
    }
}

/// Draws the boxes of a tree.
struct Draw<'a> {
    tree: &'a Tree,
    frame: &'a Frame,
    picture: [u32; 2],
    outline: &'a mut Outline,
}

/// Where eight boxes are seen: t, and pixels from the left and from above.
struct Seen {
    t: [Interval; 8],
    pixels: [[Interval; 8]; 2],
}

impl Kernel for Draw<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let Draw {
            tree,
            frame,
            picture,
            outline,
        } = self;
        let mut everywhere = NOTHING;
        let scene = Projection::new(p, frame, &tree.root, picture);
        tree.walk(&mut |parts: &Parts| {
            let seen = scene.see(p, parts.place, parts.level);
            let mut further = 0;
            for k in (0..8).filter(|k| parts.open >> k & 1 != 0) {
                let t = seen.t[k];
                if t.hi < 0.0 {
                    continue;
                }
                let (x, y) = (&seen.pixels[0][k], &seen.pixels[1][k]);
                let at = (
                    outline.touched(x, outline.columns),
                    outline.touched(y, outline.rows),
                );
                let (Some([left, right]), Some([top, bottom])) = at else {
                    continue;
                };
                let small = right - left <= 1 && bottom - top <= 1;
                if !parts.last && !small {
                    further |= 1 << k;
                } else if right - left + 1 == outline.columns && bottom - top + 1 == outline.rows {
                    everywhere = hull(everywhere, [t.lo, t.hi]);
                } else {
                    for row in top..=bottom {
                        let row = (row * outline.columns) as usize;
                        for square in
                            &mut outline.squares[row + left as usize..=row + right as usize]
                        {
                            *square = hull(*square, [t.lo, t.hi]);
                        }
                    }
                }
            }
            further
        });
        if everywhere[0] <= everywhere[1] {
            let squares = outline.squares.iter_mut();
            squares.for_each(|square| *square = hull(*square, everywhere));
        }
    }
}

/// From a tree's boxes to the picture.
struct Projection<'a, P: Packet> {
    root: &'a Root,
    perspective: bool,
    /// From the camera to the tree's lower corner.
    low: [Interval<P::F>; 3],
    /// From space to t, right and up.
    rows: [[Interval<P::F>; 3]; 3],
    slack: P::F,
    pixel: Interval<P::F>,
    /// The middle of the picture, in pixels.
    middle: [P::F; 2],
}

impl<'a, P: Packet> Projection<'a, P> {
    #[inline(always)]
    fn new(p: P, frame: &Frame, root: &'a Root, picture: [u32; 2]) -> Self {
        let point = |x: f64| p.point(p.splat(x));
        Projection {
            root,
            perspective: frame.perspective,
            low: [0, 1, 2].map(|k| p.sub(point(root.low[k]), point(frame.from[k]))),
            rows: frame.inverse.map(|row| row.map(|x| p.constant(&x))),
            slack: p.splat(frame.slack),
            pixel: point(frame.pixel),
            middle: picture.map(|n| p.splat(0.5 * f64::from(n))),
        }
    }

    /// Eight parts of a box. The frame's coordinates of a point are linear: interval arithmetic gives their exact ranges
    /// over a box, up to rounding. A ray's point is within the slack of where its pixel says.
    #[inline(always)]
    fn see(&self, p: P, place: Place, level: u32) -> Seen {
        let parts = self.root.parts(p, place, level);
        let place = [0, 1, 2].map(|k| p.add(self.low[k], parts[k]));
        let [t, x, y] = self.rows.map(|row| {
            let [a, b, c] = [0, 1, 2].map(|k| p.mul(row[k], place[k]));
            self.widened(p, p.add(p.add(a, b), c), self.slack)
        });
        let [x, y] = [x, y].map(|side| self.on_picture(p, side, &t));
        let depth = p.mul_ru(p.sub_ru(t.hi, t.lo), p.splat(MARGIN));
        Seen {
            t: arrays(p, self.widened(p, t, depth)),
            pixels: [
                arrays(p, self.counted(p, self.middle[0], x)),
                arrays(p, self.counted(p, self.middle[1], p.neg(y))),
            ],
        }
    }

    #[inline(always)]
    fn widened(&self, p: P, a: Interval<P::F>, by: P::F) -> Interval<P::F> {
        Interval {
            lo: p.sub_rd(a.lo, by),
            hi: p.add_ru(a.hi, by),
        }
    }

    /// Where the rays are that pass at `side`: the pixel at a has a·t there in a perspective view, and a in an orthographic
    /// one. Boxes that reach behind a perspective camera may be anywhere.
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

    /// Counted from the edge of the picture.
    #[inline(always)]
    fn counted(&self, p: P, middle: P::F, a: Interval<P::F>) -> Interval<P::F> {
        let from = Interval {
            lo: p.add_rd(middle, a.lo),
            hi: p.add_ru(middle, a.hi),
        };
        self.widened(p, from, p.splat(TOUCH))
    }
}

/// The lanes one by one; what is not a number may be anything.
#[inline(always)]
fn arrays<P: Packet>(p: P, a: Interval<P::F>) -> [Interval; 8] {
    let (lo, hi) = (p.to_array(a.lo), p.to_array(a.hi));
    [0, 1, 2, 3, 4, 5, 6, 7].map(|k| Interval::try_new(lo[k], hi[k]).unwrap_or(Interval::ENTIRE))
}
