//! Elementary functions.

use crate::exact::Rational;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Sign};

impl Graph {
    /// A function of one argument.
    pub fn unary(&mut self, f: Function, a: Id) -> Id {
        if let Some(r) = self.literal(a).cloned()
            && self.rewrites()
            && let Some(value) = exact_value(f, &r)
        {
            return self.number(value);
        }
        match (f, self.info(a).sign, self.op(a).clone()) {
            // No operation of its own.
            (Function::Recip, _, _) => return self.reciprocal(a),
            _ if !self.rewrites() => {}
            (Function::Abs, Sign::NonNegative, _) => return a,
            (Function::Abs, Sign::NonPositive, _) => return self.negate(a),
            (Function::Abs | Function::Cos | Function::Cosh, _, Op::Negate(b)) => {
                return self.unary(f, b);
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
                _,
                Op::Negate(b),
            ) => {
                let value = self.unary(f, b);
                return self.negate(value);
            }
            _ => {}
        }
        let sign = sign_of_value(f, self.info(a).sign);
        let partial = match f {
            // The compiler may know that the argument is in the domain.
            Function::Sqrt => !self.nonnegative(a),
            _ => !f.entry().total,
        };
        self.node(Op::Unary(f, a), None, sign, partial)
    }

    /// `min`, `max`, `hypot`, `atan2`.
    pub fn binary(&mut self, f: Function, a: Id, b: Id) -> Id {
        if self.rewrites()
            && matches!(f, Function::Min | Function::Max)
            && let (Some(x), Some(y)) = (self.literal(a), self.literal(b))
        {
            return if (x < y) == (f == Function::Min) {
                a
            } else {
                b
            };
        }
        if self.rewrites() && matches!(f, Function::Min | Function::Max) && a == b {
            return a;
        }
        let (p, q) = (self.info(a).sign, self.info(b).sign);
        let sign = match f {
            Function::Hypot => Sign::NonNegative,
            Function::Max if p == Sign::NonNegative || q == Sign::NonNegative => Sign::NonNegative,
            Function::Min if p == Sign::NonPositive || q == Sign::NonPositive => Sign::NonPositive,
            Function::Max | Function::Min if p == q => p,
            _ => Sign::Unknown,
        };
        self.node(Op::Binary(f, a, b), None, sign, !f.entry().total)
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

fn sign_of_value(f: Function, a: Sign) -> Sign {
    match f {
        Function::Sqrt
        | Function::Abs
        | Function::Exp
        | Function::Exp2
        | Function::Cosh
        | Function::Acos => Sign::NonNegative,
        Function::Acosh => Sign::NonNegative,
        Function::Cbrt
        | Function::Atan
        | Function::Asin
        | Function::Sinh
        | Function::Tanh
        | Function::Asinh
        | Function::Atanh
        | Function::ExpM1
        | Function::Ln1p => a,
        _ => Sign::Unknown,
    }
}
