//! How much of a box a solid fills.

use super::Solid;
use super::trace::PreparedSolid;
use super::tree::Side;
use crate::interval::{Arithmetic, Interval, Isa, Scalar};
use crate::render::RenderError;
use crate::scene::{Scene, Trace};

/// Parts of a box's volume, each enclosed; together they are the whole box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volume {
    /// What is certainly inside of the solid.
    pub inside: Interval,
    /// What is certainly outside of it, or on no operand's side at all.
    pub outside: Interval,
    /// The cells that hold the boundary, or that enclosures do not tell from it.
    pub undecided: Interval,
}

/// Cells of the current depth: the lower corner's numbers.
type Cell = [u32; 3];

impl Solid {
    /// Divides a box into eight, and each part that is neither certainly inside nor certainly outside again, `depth` times
    /// (at most 16). The volume of the solid in the box is between `inside.lo` and `inside.hi + undecided.hi`. Cells are
    /// those of the exact box, as their enclosures hold them.
    ///
    /// # Errors
    /// If a parameter of an operand or the box is not valid, or the instruction set is not there.
    pub fn volume(&self, within: [[f64; 3]; 2], depth: u32) -> Result<Volume, RenderError> {
        Scene::check_box(&within, "the volume")?;
        self.check().map_err(crate::scene::SceneError::from)?;
        let isa = Isa::detect()?;
        let prepared = self.ready();
        let mut cells: Vec<Cell> = vec![[0; 3]];
        let mut whole = Interval::ONE;
        for (&lo, &hi) in within[0].iter().zip(&within[1]) {
            let [lo, hi] = [lo, hi].map(Interval::point);
            whole = Scalar.mul(whole, Scalar.sub(hi, lo));
        }
        let share = |count: usize, level: u32| {
            // Powers of two and counts below 2⁴⁸ are exact.
            let part = (0..level).fold(count as f64, |part, _| part * 0.125);
            Scalar.mul(whole, Interval::point(part))
        };
        let (mut inside, mut outside) = (Interval::ZERO, Interval::ZERO);
        let depth = depth.min(16);
        for level in 1..=depth {
            let mut open = Vec::new();
            let (mut full, mut empty) = (0, 0);
            for cell in cells {
                let parts = eight(cell);
                let sides = prepared.sides(isa, &boxes(&parts, level, &within));
                for (part, side) in parts.into_iter().zip(sides) {
                    match side {
                        Side::In => full += 1,
                        Side::Out => empty += 1,
                        Side::Unknown => open.push(part),
                    }
                }
            }
            inside = Scalar.add(inside, share(full, level));
            outside = Scalar.add(outside, share(empty, level));
            cells = open;
        }
        Ok(Volume {
            inside,
            outside,
            undecided: share(cells.len(), depth),
        })
    }
}

fn eight([x, y, z]: Cell) -> [Cell; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|k| [2 * x + (k & 1), 2 * y + (k >> 1 & 1), 2 * z + (k >> 2)])
}

/// Enclosures of cells: from low + (high − low)·i/2ˡ to the same with i + 1.
fn boxes(cells: &[Cell; 8], level: u32, [low, high]: &[[f64; 3]; 2]) -> [[Interval; 8]; 3] {
    let p = Scalar;
    [0, 1, 2].map(|axis| {
        let (lo, hi) = (Interval::point(low[axis]), Interval::point(high[axis]));
        let length = p.sub(hi, lo);
        let scale = 1.0 / f64::from(1u32 << level);
        let cut = |i: u32| p.add(lo, p.mul(length, Interval::point(f64::from(i) * scale)));
        cells.map(|cell| cut(cell[axis]).hull(&cut(cell[axis] + 1)))
    })
}

impl PreparedSolid<'_> {
    /// The sides of eight boxes.
    fn sides(&self, isa: Isa, boxes: &[[Interval; 8]; 3]) -> [Side; 8] {
        self.node
            .sides(&mut |index| self.leaves[index].boxes(isa, boxes))
    }
}
