//! What an enclosure may say beside its range.

use super::{Lanes, Packet};

/// Masks over the lanes of an enclosure. Excluding by a range needs none of them but `empty`; everything that uses a
/// derivative needs `undefined` and `jump` clear, and second-order steps need `kink` clear too.
#[derive(Clone, Copy)]
pub struct Flags<P: Lanes> {
    /// The function is certainly defined nowhere over the operand: there is no root.
    pub empty: P::M,
    /// The function may be undefined somewhere over the operand.
    pub undefined: P::M,
    /// The function may be discontinuous over the operand, where it is defined.
    pub jump: P::M,
    /// The derivative may be discontinuous over the operand (it is then enclosed by a hull).
    pub kink: P::M,
}

/// A comparison of enclosures: certainly true, certainly false, or neither.
#[derive(Clone, Copy)]
pub struct Truth<P: Lanes> {
    /// Lanes where it certainly holds.
    pub yes: P::M,
    /// Lanes where it certainly does not hold.
    pub no: P::M,
}

/// What an undecided choice means for the function that it is part of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Undecided {
    /// The branches agree on the border, and their derivatives too.
    Smooth,
    /// The branches agree on the border, their derivatives may not.
    Kink,
    /// The branches may disagree.
    Jump,
}

/// A value with its first `N − 1` derivatives and their flags, over a segment or at a point.
#[derive(Clone, Copy)]
pub struct Jet<V: Copy, P: Packet, const N: usize> {
    /// `d[k]` encloses the k-th derivative.
    pub d: [V; N],
    /// `empty` speaks of the value alone; the others of the value and all derivatives here.
    pub flags: Flags<P>,
}
