//! The computation graph: hash-consed, in topological order, printable as text.

use crate::exact::Rational;
use crate::functions::Function;
use crate::range::Range;
use crate::tree::{FoldKind, Index};
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;

/// A node. Operands have smaller ids than the nodes that use them.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Id(pub u32);

/// A set of folds, by their index: the loops that a node stands in.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub struct Scope(pub u64);

impl Scope {
    /// The set of one fold.
    pub fn of(fold: usize) -> Scope {
        Scope(1 << (fold % 64))
    }
    /// Is the fold in it?
    pub fn has(self, fold: usize) -> bool {
        self.0 & Scope::of(fold).0 != 0
    }
    /// Both together.
    pub fn union(self, other: Scope) -> Scope {
        Scope(self.0 | other.0)
    }
    /// Without one fold.
    pub fn without(self, fold: usize) -> Scope {
        Scope(self.0 & !Scope::of(fold).0)
    }
    /// Is every fold of `self` in `other`?
    pub fn within(self, other: Scope) -> bool {
        self.0 & !other.0 == 0
    }
    /// Its folds. Outer folds have smaller indices than those inside them, so this is also the order of nesting.
    pub fn folds(self) -> impl Iterator<Item = usize> {
        (0..64).filter(move |&f| self.has(f))
    }
}

/// What an undecided choice means, as in the runtime's `Undecided`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[allow(missing_docs)]
pub enum Undecided {
    Kink,
    Jump,
}

/// An operation.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    /// An exact number.
    Literal(Rational),
    /// π.
    Pi,
    /// x, y, z are 0, 1, 2.
    Coordinate(usize),
    /// A number field, or an element of a table.
    Field(usize, Vec<Index>),
    /// The current row of a fold: its number, or one of its columns.
    Row(usize, Option<usize>),
    /// The current index of a fold over a range.
    Counter(usize),
    /// −a
    Negate(Id),
    /// a + b
    Add(Id, Id),
    /// a − b
    Subtract(Id, Id),
    /// a·b
    Multiply(Id, Id),
    /// a/b on b ≠ 0
    Divide(Id, Id),
    /// aⁿ
    Power(Id, u32),
    /// aᵇ on a > 0, and 0 for a = 0 < b
    RealPower(Id, Id),
    /// A function of one argument (`Abs` too).
    Unary(Function, Id),
    /// `Min`, `Max`, `Hypot`, `Atan2`.
    Binary(Function, Id, Id),
    /// The derivative of |a|.
    AbsSlope(Id),
    /// a < b: a truth, not a number.
    Less(Id, Id),
    /// a ≤ b: a truth.
    LessOrEqual(Id, Id),
    /// Both truths.
    Both(Id, Id),
    /// Either truth.
    Either(Id, Id),
    /// The first truth decides between the two numbers.
    Choose(Id, Id, Id, Undecided),
    /// A fold. `Sum`: `[body]`. `Product`: `[b]`, with derivatives `[b, b_u]` and `[b, b_u, b_v, b_uv]`.
    /// `Minimum`, `Maximum`: `[b]`, and `[b, d]` for the d of the row whose b is least or greatest.
    Fold(FoldKind, usize, Vec<Id>),
    /// A leaf of the ray stage (index into the stage's leaves): value, slope or curvature along the ray. The node that it
    /// stands for is part of its name: two formulas' leaves, or two rounds', are never taken for one another.
    Leaf(usize, u8, Id),
    /// A polynomial of higher degree over a segment (index into the stage's polynomials): value, slope or curvature; and
    /// the node that it stands for.
    Polynomial(usize, u8, Id),
}

/// What is known about a node's value.
#[derive(Clone, Debug)]
pub struct Info {
    /// Degree in x, y, z; 0 for what does not depend on the point; `None` if it is no polynomial.
    pub degree: Option<u32>,
    /// Bounds of its value.
    pub range: Range,
    /// Is it defined for all points and all values of the fields?
    pub total: bool,
    /// The folds whose current row it depends on.
    pub scope: Scope,
}

/// A fold that the graph knows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fold {
    /// What it runs over.
    pub over: Over,
    /// The folds whose counters select its table, itself included.
    pub chain: Scope,
}

/// The iterations of a fold, without source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Over {
    /// `start..end`.
    Range(i64, i64),
    /// The rows of a field, or of one of its elements.
    Table(usize, Vec<Index>),
}

/// The graph.
#[derive(Clone, Default, Debug)]
pub struct Graph {
    ops: Vec<Op>,
    info: Vec<Info>,
    known: HashMap<Op, Id>,
    /// Derivatives by x, y and z that were asked for.
    pub(crate) slopes: HashMap<Id, [Id; 3]>,
    as_written: bool,
    /// How often each of [`RULES`](crate::simplify::RULES) was applied.
    pub applied: BTreeMap<&'static str, usize>,
    /// All folds, outer before inner.
    pub folds: Vec<Fold>,
}

impl Graph {
    /// A graph that shares nodes but rewrites nothing: what a formula says, for comparison.
    pub fn as_written() -> Self {
        Graph {
            as_written: true,
            ..Graph::default()
        }
    }

    /// May constructors replace an expression by an equal one?
    pub(crate) fn rewrites(&self) -> bool {
        !self.as_written
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.ops.len()
    }
    /// Has it no nodes?
    pub fn is_empty(&self) -> bool {
        self.ops.is_empty()
    }
    /// A node's operation.
    pub fn op(&self, id: Id) -> &Op {
        &self.ops[id.0 as usize]
    }
    /// What is known about a node.
    pub fn info(&self, id: Id) -> &Info {
        &self.info[id.0 as usize]
    }
    /// A node's number, if it is a literal.
    pub fn literal(&self, id: Id) -> Option<&Rational> {
        match self.op(id) {
            Op::Literal(r) => Some(r),
            _ => None,
        }
    }

    /// Does the node depend on the point?
    pub fn varies(&self, id: Id) -> bool {
        self.info(id).degree != Some(0)
    }

    /// The node for `op`, made if it is new. Simplifying constructors are in `simplify`.
    pub fn intern(&mut self, op: Op, info: impl FnOnce(&Graph) -> Info) -> Id {
        if let Some(&id) = self.known.get(&op) {
            return id;
        }
        let info = info(self);
        let id = self.push(op.clone(), info);
        self.known.insert(op, id);
        id
    }

    /// A new node, shared with nothing.
    pub(crate) fn push(&mut self, op: Op, info: Info) -> Id {
        let id = Id(self.ops.len() as u32);
        self.ops.push(op);
        self.info.push(info);
        id
    }

    /// All nodes that `roots` need, in ascending order; `stop` ends the search at a node (which is included).
    pub fn reachable(&self, roots: &[Id], stop: impl Fn(Id) -> bool) -> Vec<Id> {
        let mut seen = vec![false; self.len()];
        let mut todo = roots.to_vec();
        while let Some(id) = todo.pop() {
            if std::mem::replace(&mut seen[id.0 as usize], true) || stop(id) {
                continue;
            }
            todo.extend(operands(self.op(id)));
        }
        (0..self.len() as u32)
            .map(Id)
            .filter(|id| seen[id.0 as usize])
            .collect()
    }

    /// The nodes that `roots` need, one a line.
    pub fn text(&self, roots: &[(&str, Id)]) -> String {
        let ids: Vec<Id> = roots.iter().map(|r| r.1).collect();
        let mut out = String::new();
        for id in self.reachable(&ids, |_| false) {
            let _ = writeln!(out, "{} = {}", name(id), self.op_text(id));
        }
        for (label, id) in roots {
            let _ = writeln!(out, "{label}: {}", name(*id));
        }
        out
    }

    fn op_text(&self, id: Id) -> String {
        let list = |ids: &[Id]| ids.iter().map(|i| name(*i)).collect::<Vec<_>>().join(" ");
        match self.op(id) {
            Op::Literal(r) => r.to_string(),
            Op::Pi => "pi".into(),
            Op::Coordinate(c) => ["x", "y", "z"].get(*c).copied().unwrap_or("?").into(),
            Op::Field(f, i) if i.is_empty() => format!("field {f}"),
            Op::Field(f, i) => format!("field {f} at {i:?}"),
            Op::Row(f, None) => format!("row of fold {f}"),
            Op::Row(f, Some(c)) => format!("column {c} of fold {f}"),
            Op::Counter(f) => format!("counter of fold {f}"),
            Op::Power(a, n) => format!("power {} {n}", name(*a)),
            Op::Unary(f, a) => format!("{} {}", f.entry().name, name(*a)),
            Op::Binary(f, a, b) => format!("{} {}", f.entry().name, list(&[*a, *b])),
            Op::Choose(c, a, b, u) => format!("choose {} ({u:?})", list(&[*c, *a, *b])),
            Op::Fold(k, f, b) => format!("{k:?} over fold {f}: {}", list(b)).to_lowercase(),
            Op::Leaf(k, n, _) => format!("leaf {k}{}", "'".repeat(*n as usize)),
            Op::Polynomial(k, n, _) => format!("polynomial {k}{}", "'".repeat(*n as usize)),
            op => {
                let word = match op {
                    Op::Negate(_) => "negate",
                    Op::Add(..) => "add",
                    Op::Subtract(..) => "subtract",
                    Op::Multiply(..) => "multiply",
                    Op::Divide(..) => "divide",
                    Op::RealPower(..) => "real power",
                    Op::AbsSlope(_) => "abs slope",
                    Op::Less(..) => "less",
                    Op::LessOrEqual(..) => "less or equal",
                    Op::Both(..) => "both",
                    _ => "either",
                };
                format!("{word} {}", list(&operands(op)))
            }
        }
    }
}

/// A node's name in texts.
fn name(id: Id) -> String {
    format!("n{}", id.0)
}

/// The places of an operation's operands; `$iter` goes over those of a fold.
macro_rules! places {
    ($op:expr, $iter:ident) => {
        match $op {
            Op::Literal(_)
            | Op::Pi
            | Op::Coordinate(_)
            | Op::Field(..)
            | Op::Row(..)
            | Op::Counter(_)
            | Op::Leaf(..)
            | Op::Polynomial(..) => vec![],
            Op::Negate(a) | Op::Power(a, _) | Op::Unary(_, a) | Op::AbsSlope(a) => vec![a],
            Op::Add(a, b)
            | Op::Subtract(a, b)
            | Op::Multiply(a, b)
            | Op::Divide(a, b)
            | Op::RealPower(a, b)
            | Op::Binary(_, a, b)
            | Op::Less(a, b)
            | Op::LessOrEqual(a, b)
            | Op::Both(a, b)
            | Op::Either(a, b) => vec![a, b],
            Op::Choose(c, a, b, _) => vec![c, a, b],
            Op::Fold(_, _, all) => all.$iter().collect(),
        }
    };
}

/// The operands of an operation.
pub fn operands(op: &Op) -> Vec<Id> {
    places!(op, iter).into_iter().copied().collect()
}

/// The same, to be replaced.
pub fn operands_mut(op: &mut Op) -> Vec<&mut Id> {
    places!(op, iter_mut)
}
