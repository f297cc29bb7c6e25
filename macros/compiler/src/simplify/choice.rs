//! Comparisons and choices.

use crate::exact::Rational;
use crate::graph::{Graph, Id, Op, Sign, Undecided};

impl Graph {
    /// A comparison or a combination of them; its "value" is a truth.
    pub fn truth(&mut self, op: Op) -> Id {
        self.node(op, None, Sign::Unknown, false)
    }

    /// The derivative of |a|.
    pub fn abs_slope(&mut self, a: Id) -> Id {
        let literal = self.literal(a);
        if self.rewrites() && literal.is_some_and(Rational::is_positive) {
            return self.integer(1);
        }
        self.node(Op::AbsSlope(a), None, Sign::Unknown, false)
    }

    /// `condition ? yes : no`.
    pub fn choose(&mut self, condition: Id, yes: Id, no: Id, undecided: Undecided) -> Id {
        if self.rewrites() && yes == no && self.info(condition).total {
            return yes;
        }
        let (p, q) = (self.info(yes).sign, self.info(no).sign);
        let sign = if p == q { p } else { Sign::Unknown };
        self.node(Op::Choose(condition, yes, no, undecided), None, sign, false)
    }
}
