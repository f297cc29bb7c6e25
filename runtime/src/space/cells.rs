//! Parts of a box: the boxes that repeated halving along all axes makes of it. Together they are the whole box.

use crate::interval::{Arithmetic, Interval, Packet, Scalar};

/// A part of some level: the numbers of its lower corner, each from 0 to 2ˡ − 1.
pub(crate) type Place = [u32; 3];

/// The eight parts of a part, on the next level.
pub(crate) fn eight([x, y, z]: Place) -> [Place; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|k| [2 * x + (k & 1), 2 * y + (k >> 1 & 1), 2 * z + (k >> 2)])
}

/// Where the eight parts of a part lie, by axis: from i/2ˡ to (i + 1)/2ˡ of the whole box. These numbers are exact.
#[inline(always)]
pub(crate) fn cuts<P: Packet>(p: P, place: Place, level: u32) -> [Interval<P::F>; 3] {
    let parts = eight(place);
    let scale = 1.0 / f64::from(1u32 << level);
    let zero = p.splat(0.0);
    let mut cuts = [Interval { lo: zero, hi: zero }; 3];
    for (axis, cut) in cuts.iter_mut().enumerate() {
        let (mut lo, mut hi) = ([0.0; 8], [0.0; 8]);
        for (lane, part) in parts.iter().enumerate() {
            lo[lane] = f64::from(part[axis]) * scale;
            hi[lane] = f64::from(part[axis] + 1) * scale;
        }
        *cut = Interval {
            lo: p.lanes(lo),
            hi: p.lanes(hi),
        };
    }
    cuts
}

/// A box that is divided.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    pub low: [f64; 3],
    pub high: [f64; 3],
    /// The lengths of its sides.
    pub size: [Interval; 3],
}

impl Root {
    pub fn new([low, high]: [[f64; 3]; 2]) -> Self {
        let length = |k: usize| Scalar.sub(Interval::point(high[k]), Interval::point(low[k]));
        let size = [0, 1, 2].map(length);
        Root { low, high, size }
    }

    /// Lower and upper corner.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        [self.low, self.high]
    }

    /// Enclosures of the eight parts of a part, by axis, counted from the lower corner; the level is that of the parts.
    #[inline(always)]
    pub fn parts<P: Packet>(&self, p: P, place: Place, level: u32) -> [Interval<P::F>; 3] {
        let mut parts = cuts(p, place, level);
        for (part, size) in parts.iter_mut().zip(&self.size) {
            // Sizes are not negative.
            part.lo = p.max_f(p.mul_rd(part.lo, p.splat(size.lo)), p.splat(0.0));
            part.hi = p.mul_ru(part.hi, p.splat(size.hi));
        }
        parts
    }

    /// Enclosures of parts in space, by axis.
    pub fn boxes(&self, parts: &[Place; 8], level: u32) -> [[Interval; 8]; 3] {
        let scale = 1.0 / f64::from(1u32 << level);
        [0, 1, 2].map(|axis| {
            let low = Interval::point(self.low[axis]);
            let cut = |i: u32| {
                let part = Interval::point(f64::from(i) * scale);
                Scalar.add(low, Scalar.mul(self.size[axis], part))
            };
            parts.map(|part| cut(part[axis]).hull(&cut(part[axis] + 1)))
        })
    }
}
