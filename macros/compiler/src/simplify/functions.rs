//! Elementary functions.

use crate::exact::Rational;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op};

impl Graph {
    /// A function of one argument.
    pub fn unary(&mut self, f: Function, a: Id) -> Id {
        if let Some(r) = self.literal(a).cloned()
            && self.rewrites()
            && let Some(value) = exact_value(f, &r)
        {
            let id = self.number(value);
            return self.by("f(literal)", id);
        }
        let range = self.range(a);
        match (f, self.op(a).clone()) {
            // No operation of its own.
            (Function::Recip, _) => return self.reciprocal(a),
            _ if !self.rewrites() => {}
            (Function::Abs, _) if range.is_nonnegative() => return self.by("|a| = a", a),
            (Function::Abs, _) if range.is_nonpositive() => {
                let id = self.negate(a);
                return self.by("|a| = -a", id);
            }
            (Function::Abs | Function::Cos | Function::Cosh, Op::Negate(b)) => {
                let id = self.unary(f, b);
                return self.by("f(-a) = f(a)", id);
            }
            // Odd functions: the sign moves outward.
            (
                Function::Sin
                | Function::Tan
                | Function::Asin
                | Function::Atan
                | Function::Sinh
                | Function::Tanh
                | Function::Asinh
                | Function::Atanh
                | Function::Cbrt,
                Op::Negate(b),
            ) => {
                let value = self.unary(f, b);
                let id = self.negate(value);
                return self.by("f(-a) = -f(a)", id);
            }
            _ => {}
        }
        self.node(Op::Unary(f, a), None, range.mapped(f))
    }

    /// `min`, `max`, `hypot`, `atan2`.
    pub fn binary(&mut self, f: Function, a: Id, b: Id) -> Id {
        if self.rewrites()
            && matches!(f, Function::Min | Function::Max)
            && let Some(known) = self.extreme(f == Function::Min, a, b)
        {
            return self.by("min, max decided", known);
        }
        let range = self.range(a).mapped_with(f, self.range(b));
        self.node(Op::Binary(f, a, b), None, range)
    }

    /// The operand that the minimum or the maximum is, if that is certain and the other one is always defined.
    fn extreme(&self, least: bool, a: Id, b: Id) -> Option<Id> {
        let below = |a: Id, b: Id| self.range(a).hi <= self.range(b).lo;
        let (wins, other) = match (a == b, below(a, b), below(b, a)) {
            (true, ..) => return Some(a),
            (_, true, _) => (a, b),
            (_, _, true) => (b, a),
            _ => return None,
        };
        let (wins, other) = if least { (wins, other) } else { (other, wins) };
        self.info(other).total.then_some(wins)
    }
}

/// The value at a rational point, where it is rational and cheap to know.
fn exact_value(f: Function, r: &Rational) -> Option<Rational> {
    match f {
        Function::Abs => Some(r.abs()),
        Function::Sqrt => r.exact_root(),
        Function::Exp | Function::Exp2 | Function::Cos | Function::Cosh if is(r, 0) => {
            Some(whole(1))
        }
        Function::Sin
        | Function::Tan
        | Function::Asin
        | Function::Atan
        | Function::Sinh
        | Function::Tanh
        | Function::Asinh
        | Function::Atanh
        | Function::Cbrt
        | Function::ExpM1
        | Function::Ln1p
            if is(r, 0) =>
        {
            Some(whole(0))
        }
        Function::Ln | Function::Log2 | Function::Log10 if is(r, 1) => Some(whole(0)),
        _ => None,
    }
}

fn whole(n: i64) -> Rational {
    Rational::from(n)
}

fn is(r: &Rational, n: i64) -> bool {
    *r == whole(n)
}
