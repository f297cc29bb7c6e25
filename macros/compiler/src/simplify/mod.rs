//! Constructors of nodes. Each rewrites to an expression with the same real value on the same domain, or not at all.
//!
//! "The same domain" is why `0·a` becomes 0 only where `a` is total, and why `a/a` and `(a·b)/b` stay as they are.

mod algebra;
mod balance;
mod choice;
mod functions;

use crate::exact::Rational;
use crate::functions::Function;
use crate::graph::{Graph, Id, Info, Op, Scope};
use crate::range::Range;
use crate::tree::FoldKind;

/// Literals larger than this stay operations of the surface stage.
const LITERAL_BITS: u64 = 4096;

/// The identities that constructors apply, by name: one with the same real value on the same domain each. `c` and `d` are
/// literals, `s` a value of the surface stage, and f is even, or odd.
pub const RULES: &[&str] = &[
    "literals",
    "--a = a",
    "-(a - b) = b - a",
    "0 + a = a",
    "a + -b = a - b",
    "a + a = 2a",
    "0 - a = -a",
    "a - 0 = a",
    "a - -b = a + b",
    "a - a = 0",
    "0a = 0",
    "1a = a",
    "-1a = -a",
    "(-a)(-b) = ab",
    "c(-a) = (-c)a",
    "(-a)b = -(ab)",
    "c(da) = (cd)a",
    "aa = a^2",
    "a/c = (1/c)a",
    "a/s = a(1/s)",
    "a^1 = a",
    "a^0 = 1",
    "(-a)^2n = a^2n",
    "|a|^2n = a^2n",
    "(a^m)^n = a^mn",
    "sum of 0 = 0",
    "f(literal)",
    "|a| = a",
    "|a| = -a",
    "f(-a) = f(a)",
    "f(-a) = -f(a)",
    "min, max decided",
    "min(min(a, b), c) = min(a, min(b, c))",
    "c ? a : a = a",
    "choice decided",
];

impl Graph {
    /// Notes that a rule was applied, which gave `id`.
    fn by(&mut self, rule: &'static str, id: Id) -> Id {
        *self.applied.entry(rule).or_default() += 1;
        id
    }

    /// An exact number.
    pub fn number(&mut self, r: Rational) -> Id {
        let range = Range::of(&r);
        self.intern(Op::Literal(r), |_| Info {
            degree: Some(0),
            range,
            total: true,
            scope: Scope::default(),
        })
    }

    /// A whole number.
    pub fn integer(&mut self, n: i64) -> Id {
        self.number(Rational::from(n))
    }

    /// A node without operands that is neither a number nor a leaf.
    pub fn input(&mut self, op: Op) -> Id {
        let (degree, range, scope) = match op {
            Op::Coordinate(_) => (Some(1), Range::LINE, Scope::default()),
            Op::Pi => (Some(0), Range::new(3.0, 4.0), Scope::default()),
            Op::Row(f, _) | Op::Counter(f) => (Some(0), Range::LINE, self.chain(f)),
            Op::Field(_, ref indices) => (Some(0), Range::LINE, self.chain_of(indices)),
            _ => (None, Range::LINE, Scope::default()),
        };
        self.intern(op, |_| Info {
            degree,
            range,
            total: true,
            scope,
        })
    }

    /// The folds that a fold's rows depend on, itself included.
    pub fn chain(&self, fold: usize) -> Scope {
        self.folds.get(fold).map_or(Scope::of(fold), |f| f.chain)
    }

    /// The folds whose counters are in `indices`.
    pub fn chain_of(&self, indices: &[crate::tree::Index]) -> Scope {
        indices.iter().fold(Scope::default(), |s, i| match i {
            crate::tree::Index::Counter(f, _) => s.union(self.chain(*f)),
            crate::tree::Index::Constant(_) => s,
        })
    }

    pub(crate) fn is(&self, id: Id, n: i64) -> bool {
        self.literal(id).is_some_and(|r| *r == Rational::from(n))
    }

    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.literal(id).is_some_and(Rational::is_zero)
    }

    pub(crate) fn is_one(&self, id: Id) -> bool {
        self.literal(id).is_some_and(Rational::is_one)
    }

    pub(crate) fn nonnegative(&self, id: Id) -> bool {
        self.range(id).is_nonnegative()
    }

    /// A number, if it is small enough to stay exact.
    fn exact(&mut self, r: Rational) -> Option<Id> {
        (r.bits() <= LITERAL_BITS).then(|| self.number(r))
    }

    /// Bounds of a node's value.
    pub(crate) fn range(&self, id: Id) -> Range {
        self.info(id).range
    }

    /// Is the operation defined, with all derivatives, wherever its operands are? What is not total may be where the
    /// operands cannot leave its domain.
    pub fn is_regular(&self, op: &Op) -> bool {
        let range = |id: &Id| self.range(*id);
        match op {
            Op::Divide(_, b) => range(b).is_nonzero(),
            Op::RealPower(a, _) => range(a).is_positive(),
            Op::Unary(Function::Sqrt | Function::Ln | Function::Log2 | Function::Log10, a) => {
                range(a).is_positive()
            }
            Op::Unary(Function::Cbrt | Function::Abs, a) => range(a).is_nonzero(),
            Op::Unary(Function::Ln1p, a) => range(a).lo > -1.0,
            Op::Unary(Function::Acosh, a) => range(a).lo > 1.0,
            Op::Unary(Function::Asin | Function::Acos | Function::Atanh, a) => {
                range(a).is_inside(-1.0, 1.0)
            }
            Op::Binary(Function::Atan2, _, b) => range(b).is_positive(),
            Op::Binary(Function::Hypot, a, b) => range(a).is_nonzero() || range(b).is_nonzero(),
            Op::Unary(f, _) | Op::Binary(f, ..) => f.entry().total && f.entry().smooth,
            Op::Choose(..) | Op::AbsSlope(_) => false,
            Op::Fold(kind, ..) => matches!(kind, FoldKind::Sum | FoldKind::Product),
            _ => true,
        }
    }

    /// Is the operation defined wherever its operands are?
    fn is_defined(&self, op: &Op) -> bool {
        match op {
            Op::Unary(Function::Sqrt, a) => self.nonnegative(*a),
            Op::Divide(..) | Op::RealPower(..) => self.is_regular(op),
            Op::Unary(f, _) | Op::Binary(f, ..) => f.entry().total || self.is_regular(op),
            _ => true,
        }
    }

    /// A node whose degree and range the caller knows; totality and scope are those of the operands.
    fn node(&mut self, op: Op, degree: Option<u32>, range: Range) -> Id {
        let (total, scope) = self.of_operands(&op);
        let total = total && self.is_defined(&op);
        // What does not depend on the point is a value of the surface stage, whatever the operation is.
        let degree = if self.fixed(&op) { Some(0) } else { degree };
        self.intern(op, |_| Info {
            degree,
            range,
            total,
            scope,
        })
    }

    fn fixed(&self, op: &Op) -> bool {
        crate::graph::operands(op).iter().all(|a| !self.varies(*a))
    }

    fn of_operands(&self, op: &Op) -> (bool, Scope) {
        let mut total = true;
        let mut scope = Scope::default();
        for a in crate::graph::operands(op) {
            total &= self.info(a).total;
            scope = scope.union(self.info(a).scope);
        }
        (total, scope)
    }

    /// A polynomial over a segment, or its slope (`order` 1) or curvature (2).
    pub fn polynomial(&mut self, k: usize, order: u8, of: Id, info: Info) -> Id {
        self.intern(Op::Polynomial(k, order, of), |_| info)
    }

    /// A leaf of the ray stage, or its slope (`order` 1) or curvature (2).
    pub fn leaf(&mut self, leaf: usize, order: u8, of: Id, info: Info) -> Id {
        self.intern(Op::Leaf(leaf, order, of), |_| info)
    }
}
