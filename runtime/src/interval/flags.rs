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

impl<P: Lanes> Flags<P> {
    /// No flag in any lane.
    #[inline(always)]
    pub fn none(p: P) -> Self {
        let none = p.none();
        Flags {
            empty: none,
            undefined: none,
            jump: none,
            kink: none,
        }
    }

    /// The flags of an operation whose operands have these: a function of a function that is nowhere defined is nowhere
    /// defined, and so with the others.
    #[inline(always)]
    pub fn join(self, p: P, other: Self) -> Self {
        Flags {
            empty: p.or(self.empty, other.empty),
            undefined: p.or(self.undefined, other.undefined),
            jump: p.or(self.jump, other.jump),
            kink: p.or(self.kink, other.kink),
        }
    }

    /// Lanes where the function is certainly defined and continuous: where arguments by the mean value theorem hold for
    /// its first derivative.
    #[inline(always)]
    pub fn sound(self, p: P) -> P::M {
        p.not(p.or(p.or(self.empty, self.undefined), self.jump))
    }
}

impl<P: Lanes> Truth<P> {
    /// Both hold.
    #[inline(always)]
    pub fn both(self, p: P, other: Self) -> Self {
        Truth {
            yes: p.and(self.yes, other.yes),
            no: p.or(self.no, other.no),
        }
    }

    /// One holds at least.
    #[inline(always)]
    pub fn either(self, p: P, other: Self) -> Self {
        Truth {
            yes: p.or(self.yes, other.yes),
            no: p.and(self.no, other.no),
        }
    }

    /// The opposite.
    #[inline(always)]
    pub fn negate(self) -> Self {
        Truth {
            yes: self.no,
            no: self.yes,
        }
    }

    /// The flags of a choice between two branches: those of the taken one; where undecided, those of both (`empty` only
    /// if both are), and what `undecided` says.
    #[inline(always)]
    pub fn branch(self, p: P, yes: Flags<P>, no: Flags<P>, undecided: Undecided) -> Flags<P> {
        // A branch's flags count unless the other one is certain.
        let open = p.not(p.or(self.yes, self.no));
        let (y, n) = (p.not(self.no), p.not(self.yes));
        let empty = p.or(
            p.and(open, p.and(yes.empty, no.empty)),
            p.or(p.and(self.yes, yes.empty), p.and(self.no, no.empty)),
        );
        // A branch that is empty while the other is not is a domain that was left.
        let partly = p.and_not(p.and(open, p.or(yes.empty, no.empty)), empty);
        let mut flags = Flags {
            empty,
            undefined: p.or(
                partly,
                p.or(p.and(y, yes.undefined), p.and(n, no.undefined)),
            ),
            jump: p.or(p.and(y, yes.jump), p.and(n, no.jump)),
            kink: p.or(p.and(y, yes.kink), p.and(n, no.kink)),
        };
        match undecided {
            Undecided::Smooth => {}
            Undecided::Kink => flags.kink = p.or(flags.kink, open),
            Undecided::Jump => {
                flags.jump = p.or(flags.jump, open);
                flags.kink = p.or(flags.kink, open);
            }
        }
        flags
    }
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
