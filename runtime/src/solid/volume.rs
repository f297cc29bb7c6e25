//! How much of a box a solid fills.

use super::Solid;
use super::trace::PreparedSolid;
use super::tree::Side;
use crate::interval::{Arithmetic, Interval, Isa, Scalar};
use crate::render::RenderError;
use crate::scene::{Scene, Trace};
use crate::space::{Place, Root, eight};

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
        let mut cells: Vec<Place> = vec![[0; 3]];
        let root = Root::new(within);
        let whole = root
            .size
            .into_iter()
            .fold(Interval::ONE, |a, b| Scalar.mul(a, b));
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
                let sides = prepared.sides(isa, &root.boxes(&parts, level));
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

impl PreparedSolid<'_> {
    /// The sides of eight boxes.
    pub fn sides(&self, isa: Isa, boxes: &[[Interval; 8]; 3]) -> [Side; 8] {
        self.node
            .sides(&mut |index| self.leaves[index].boxes(isa, boxes))
    }
}
