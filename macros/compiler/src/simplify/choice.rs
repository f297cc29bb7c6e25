//! Comparisons and choices.

use crate::graph::{Graph, Id, Op, Undecided};
use crate::range::Range;

impl Graph {
    /// A comparison or a combination of them; its "value" is a truth.
    pub fn truth(&mut self, op: Op) -> Id {
        self.node(op, None, Range::LINE)
    }

    /// The derivative of |a|. Where the sign of a is known, |a| is no operation.
    pub fn abs_slope(&mut self, a: Id) -> Id {
        self.node(Op::AbsSlope(a), None, Range::new(-1.0, 1.0))
    }

    /// `condition ? yes : no`.
    pub fn choose(&mut self, condition: Id, yes: Id, no: Id, undecided: Undecided) -> Id {
        if self.rewrites() && self.info(condition).total {
            if yes == no {
                return self.by("c ? a : a = a", yes);
            }
            match self.decided(condition) {
                Some(true) => return self.by("choice decided", yes),
                Some(false) => return self.by("choice decided", no),
                None => {}
            }
        }
        let range = self.range(yes).hull(self.range(no));
        self.node(Op::Choose(condition, yes, no, undecided), None, range)
    }

    /// What the condition is, if the ranges of what it compares decide it.
    fn decided(&self, condition: Id) -> Option<bool> {
        match *self.op(condition) {
            Op::Less(a, b) => {
                let (a, b) = (self.range(a), self.range(b));
                (a.hi < b.lo || a.lo >= b.hi).then_some(a.hi < b.lo)
            }
            Op::LessOrEqual(a, b) => {
                let (a, b) = (self.range(a), self.range(b));
                (a.hi <= b.lo || a.lo > b.hi).then_some(a.hi <= b.lo)
            }
            Op::Both(a, b) => match (self.decided(a), self.decided(b)) {
                (Some(true), Some(true)) => Some(true),
                (Some(false), _) | (_, Some(false)) => Some(false),
                _ => None,
            },
            Op::Either(a, b) => match (self.decided(a), self.decided(b)) {
                (Some(false), Some(false)) => Some(false),
                (Some(true), _) | (_, Some(true)) => Some(true),
                _ => None,
            },
            _ => None,
        }
    }
}
