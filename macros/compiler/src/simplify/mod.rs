//! Constructors of nodes. Each rewrites to an expression with the same real value on the same domain, or not at all.
//!
//! "The same domain" is why `0·a` becomes 0 only where `a` is total, and why `a/a` and `(a·b)/b` stay as they are.

mod algebra;
mod choice;
mod functions;

use crate::exact::Rational;
use crate::graph::{Graph, Id, Info, Op, Scope, Sign};

/// Literals larger than this stay operations of the surface stage.
const LITERAL_BITS: u64 = 4096;

impl Graph {
    /// An exact number.
    pub fn number(&mut self, r: Rational) -> Id {
        let sign = crate::graph::sign_of(&r);
        self.intern(Op::Literal(r), |_| Info {
            degree: Some(0),
            sign,
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
        let (degree, sign, scope) = match op {
            Op::Coordinate(_) => (Some(1), Sign::Unknown, Scope::default()),
            Op::Pi => (Some(0), Sign::NonNegative, Scope::default()),
            Op::Row(f, _) | Op::Counter(f) => (Some(0), Sign::Unknown, self.chain(f)),
            Op::Field(_, ref indices) => (Some(0), Sign::Unknown, self.chain_of(indices)),
            _ => (None, Sign::Unknown, Scope::default()),
        };
        self.intern(op, |_| Info {
            degree,
            sign,
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
        self.info(id).sign == Sign::NonNegative
    }

    /// A number, if it is small enough to stay exact.
    fn exact(&mut self, r: Rational) -> Option<Id> {
        (r.bits() <= LITERAL_BITS).then(|| self.number(r))
    }

    /// A node whose degree, sign and partiality the caller knows; totality and scope are those of the operands.
    fn node(&mut self, op: Op, degree: Option<u32>, sign: Sign, partial: bool) -> Id {
        let (total, scope) = self.of_operands(&op);
        // What does not depend on the point is a value of the surface stage, whatever the operation is.
        let degree = if self.fixed(&op) { Some(0) } else { degree };
        self.intern(op, |_| Info {
            degree,
            sign,
            total: total && !partial,
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
    pub fn polynomial(&mut self, k: usize, order: u8, info: Info) -> Id {
        self.intern(Op::Polynomial(k, order), |_| info)
    }

    /// A leaf of the ray stage, or its slope (`order` 1) or curvature (2).
    pub fn leaf(&mut self, leaf: usize, order: u8, info: Info) -> Id {
        self.intern(Op::Leaf(leaf, order), |_| info)
    }
}
