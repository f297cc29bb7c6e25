//! Operands that fit the first-level cache.

use zeroset::interval::{Interval, Packet};

/// Eight lower and eight upper bounds.
pub type Bounds = [[f64; 8]; 2];

/// Operands and results of eight intervals, in whole lines of the cache: a load that straddles two lines, or one from an
/// address that differs from a store's by a multiple of 4 KiB, would be timed otherwise.
#[repr(align(64))]
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Of random signs, a tenth across 0: no branch predictor learns them.
    pub a: Bounds,
    /// As `a`.
    pub b: Bounds,
    /// Between 0.05 and 0.95, inside the domain of every function but arcosh.
    pub c: Bounds,
    /// The results.
    pub out: Bounds,
}

/// 256 intervals.
pub const ROWS: usize = 32;

/// Always the same operands.
pub fn rows() -> Vec<Row> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut bounds = |least: f64, greatest: f64, width: f64| {
        let (mut lo, mut hi) = ([0.0; 8], [0.0; 8]);
        for (lo, hi) in lo.iter_mut().zip(&mut hi) {
            *lo = least + (greatest - least) * next();
            *hi = *lo + width * next();
        }
        [lo, hi]
    };
    let row = |_| Row {
        a: bounds(-2.2, 2.0, 0.4),
        b: bounds(-2.2, 2.0, 0.4),
        c: bounds(0.05, 0.9, 0.05),
        out: [[0.0; 8]; 2],
    };
    (0..ROWS).map(row).collect()
}

/// Eight intervals as a packet.
#[inline(always)]
pub fn load<P: Packet>(p: P, x: &Bounds) -> Interval<P::F> {
    Interval {
        lo: p.lanes(x[0]),
        hi: p.lanes(x[1]),
    }
}
