//! Where boxes lie on a picture, and how far from the camera.

use super::projection::{Grid, Projection};
use super::tree::{Parts, Tree};
use crate::beam::{self, Frame};
use crate::interval::{Isa, Kernel, Packet};
use crate::render::tile::CELL;
use crate::span::Span8;

/// A picture has at most so many squares; on larger ones they hold several cells.
const SQUARES: u64 = 1 << 18;

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

    /// First and last t of the boxes behind each part of a grid that begins at this pixel.
    pub fn spans(&self, corner: [u32; 2], grid: &beam::Grid) -> Span8 {
        let mut spans = Span8::EMPTY;
        for k in 0..8 {
            let place = [k % grid.columns, k / grid.columns];
            let corner = [0, 1].map(|axis| corner[axis] + place[axis] * grid.part[axis]);
            let [lo, hi] = self.over(corner, grid.part);
            (spans.lo[k as usize], spans.hi[k as usize]) = (lo, hi);
        }
        spans
    }

    /// First and last t of the boxes behind a rectangle of pixels.
    fn over(&self, corner: [u32; 2], size: [u32; 2]) -> [f64; 2] {
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

    /// Adds boxes that are seen in a rectangle of squares: first and last column, first and last row.
    fn add(&mut self, [left, right, top, bottom]: [u32; 4], t: [f64; 2]) {
        for row in top..=bottom {
            let row = (row * self.columns) as usize;
            for square in &mut self.squares[row + left as usize..=row + right as usize] {
                *square = hull(*square, t);
            }
        }
    }
}

/// Draws the boxes of a tree.
struct Draw<'a> {
    tree: &'a Tree,
    frame: &'a Frame,
    picture: [u32; 2],
    outline: &'a mut Outline,
}

impl Kernel for Draw<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        let Draw { tree, outline, .. } = self;
        let grid = Grid {
            side: outline.side,
            count: [outline.columns, outline.rows],
        };
        let projection = Projection::new(p, self.frame, &tree.root, self.picture, &grid);
        let mut everywhere = NOTHING;
        tree.walk(&mut |parts: &Parts| {
            let seen = projection.see(p, parts);
            let mut further = 0;
            for k in (0..8).filter(|k| seen.shown >> k & 1 != 0) {
                let squares = seen.squares.map(|side| side[k] as u32);
                let t = seen.t.map(|t| t[k]);
                let [left, right, top, bottom] = squares;
                let [width, height] = [right - left + 1, bottom - top + 1];
                if !parts.last && width.max(height) > 2 {
                    further |= 1 << k;
                } else if [width, height] == grid.count {
                    everywhere = hull(everywhere, t);
                } else {
                    outline.add(squares, t);
                }
            }
            further
        });
        if everywhere[0] <= everywhere[1] {
            let all = [0, outline.columns - 1, 0, outline.rows - 1];
            outline.add(all, everywhere);
        }
    }
}
