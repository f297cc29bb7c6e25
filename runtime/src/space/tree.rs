//! One surface's boxes.

use std::sync::Arc;

use rayon::prelude::*;

use super::cells::{Place, Root, eight};
use super::divide::{Boxes, Cell, Division};
use super::{Census, Subdivision};
use crate::beam::Frame;
use crate::interval::{Interval, Isa, Lanes, Scalar};
use crate::scene::Prepared;

/// So many boxes are divided at a time by one thread.
const RUN: usize = 32;

/// Boxes inside boxes, as far as they may hold roots.
pub(crate) struct Tree {
    pub root: Root,
    /// The boxes of each level that were divided; the first is the whole box.
    levels: Vec<Vec<Divided>>,
}

/// A box that was divided.
struct Divided {
    place: Place,
    /// The parts that may hold roots …
    open: u8,
    /// … and where the first of them is on the next level, if it was divided too.
    first: u32,
}

/// Parts of a box, on a walk through a tree.
pub(crate) struct Parts {
    /// The box.
    pub place: Place,
    /// The level of its parts.
    pub level: u32,
    /// Those that may hold roots.
    pub open: u8,
    /// They are not divided further.
    pub last: bool,
}

impl Tree {
    /// Divides a box again and again, and leaves out what certainly holds no root of the surface.
    pub fn grow(
        surface: &dyn Prepared,
        isa: Isa,
        domain: &[[f64; 3]; 2],
        how: &Subdivision,
        census: &mut Census,
    ) -> Tree {
        let root = Root::new(around(domain));
        let leaves = surface.leaves(isa, &Frame::axes_from(root.low));
        let mut tree = Tree {
            root,
            levels: Vec::new(),
        };
        let mut cells: Vec<Cell> = vec![([0; 3], Arc::new(surface.everything()))];
        let depth = how.depth.clamp(1, 16);
        for level in 1..=depth {
            if level > 1 && 8 * cells.len() > how.boxes {
                break;
            }
            let divide = |cells: &[Cell]| {
                let boxes = Boxes {
                    root: &tree.root,
                    level,
                    cells,
                    thin: level < depth,
                };
                surface.divide(isa, leaves.as_deref(), &boxes)
            };
            let runs: Option<Vec<Division>> = cells.par_chunks(RUN).map(divide).collect();
            let Some(runs) = runs else { break };
            census.boxes += 8 * cells.len() as u64;
            census.evaluations += runs.iter().map(|run| run.evaluations).sum::<u64>();
            cells = tree.add_level(&cells, runs);
        }
        if tree.levels.is_empty() {
            // Nothing can be told of this surface: its box is all that is known.
            tree.levels.push(vec![Divided {
                place: [0; 3],
                open: !0,
                first: 0,
            }]);
        }
        census.open += tree.last_parts();
        tree
    }

    /// Takes over a level; the parts that may hold roots are the next one.
    fn add_level(&mut self, cells: &[Cell], runs: Vec<Division>) -> Vec<Cell> {
        let masks = runs.iter().flat_map(|run| run.open.iter().copied());
        let mut first = 0;
        let level = cells.iter().zip(masks).map(|((place, _), open)| {
            let divided = Divided {
                place: *place,
                open,
                first,
            };
            first += open.count_ones();
            divided
        });
        self.levels.push(level.collect());
        runs.into_iter().flat_map(|run| run.parts).collect()
    }

    /// How many boxes of the deepest level may hold roots.
    pub fn last_parts(&self) -> u64 {
        let last = self.levels.last().into_iter().flatten();
        last.map(|divided| u64::from(divided.open.count_ones()))
            .sum()
    }

    /// Goes through the boxes that may hold roots, from large to small: into those parts that `visit` returns. Where
    /// parts are the last ones, what it returns does not matter.
    pub fn walk(&self, visit: &mut impl FnMut(&Parts) -> u8) {
        self.walk_from(0, 0, visit);
    }

    fn walk_from(&self, level: usize, index: usize, visit: &mut impl FnMut(&Parts) -> u8) {
        let divided = &self.levels[level][index];
        if divided.open == 0 {
            return;
        }
        let last = level + 1 == self.levels.len();
        let wanted = visit(&Parts {
            place: divided.place,
            level: level as u32 + 1,
            open: divided.open,
            last,
        });
        if last {
            return;
        }
        let mut next = divided.first as usize;
        for k in 0..8 {
            if divided.open >> k & 1 != 0 {
                if wanted >> k & 1 != 0 {
                    self.walk_from(level + 1, next, visit);
                }
                next += 1;
            }
        }
    }

    /// The smallest boxes that may hold roots.
    pub fn boxes(&self) -> Vec<[[f64; 3]; 2]> {
        let mut boxes = Vec::new();
        self.walk(&mut |parts| {
            if parts.last {
                let sides = self.root.boxes(&eight(parts.place), parts.level);
                let open = (0..8).filter(|k| parts.open >> k & 1 != 0);
                boxes.extend(open.map(|k| corners(&sides, k)));
            }
            parts.open
        });
        boxes
    }

    /// Does none of the boxes that may hold roots meet this one?
    pub fn is_free(&self, [low, high]: &[[f64; 3]; 2]) -> bool {
        let mut free = true;
        self.walk(&mut |parts| {
            let sides = self.root.boxes(&eight(parts.place), parts.level);
            let meets = |k: &usize| {
                (0..3)
                    .all(|axis| sides[axis][*k].lo <= high[axis] && low[axis] <= sides[axis][*k].hi)
            };
            let met = (0..8)
                .filter(|k| free && parts.open >> k & 1 != 0)
                .filter(meets)
                .fold(0, |met, k| met | 1 << k);
            free &= !(parts.last && met != 0);
            met
        });
        free
    }

    /// Calls the smallest box of this number empty, whatever it holds: for negative controls alone.
    #[cfg(feature = "unrounded")]
    pub fn forget(&mut self, mut number: u32) {
        let last = self.levels.last_mut().into_iter().flatten();
        for divided in last {
            let own = divided.open.count_ones();
            if number < own {
                let bit = (0..8).filter(|k| divided.open >> k & 1 != 0);
                let bit = bit.skip(number as usize).map(|k| 1u8 << k).next();
                divided.open &= !bit.unwrap_or(0);
                return;
            }
            number -= own;
        }
    }
}

/// Lower and upper corner of one of eight boxes.
fn corners(sides: &[[Interval; 8]; 3], k: usize) -> [[f64; 3]; 2] {
    [
        [0, 1, 2].map(|axis| sides[axis][k].lo),
        [0, 1, 2].map(|axis| sides[axis][k].hi),
    ]
}

/// A little more than a box: rays are searched a little beyond it, so that what lies on its faces is found.
fn around([low, high]: &[[f64; 3]; 2]) -> [[f64; 3]; 2] {
    let sizes = (0..3).map(|k| Scalar.sub_ru(high[k], low[k]));
    let all = sizes.fold(0.0, |a, b| Scalar.add_ru(a, b));
    let more = Scalar.mul_ru(all, 1.0 / (1u64 << 40) as f64);
    [
        low.map(|x| Scalar.sub_rd(x, more)),
        high.map(|x| Scalar.add_ru(x, more)),
    ]
}
