//! Fast automatic differentiation on the graph: top-down (reverse) in space, forward along the ray.
//!
//! Both read the same table, `Graph::partials`: the partial derivatives of an operation by its operands, as nodes.
//! The forward values are shared because the graph is hash-consed. The gradient costs one sweep whatever the number of
//! variables (Baur and Strassen 1983); sweeping over the gradient's own nodes gives the Hessian.

use crate::functions::Function;
use crate::graph::{Graph, Id, Info, Op, Undecided, operands};
use crate::range::Range;
use crate::tree::FoldKind;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

impl Graph {
    /// The partial derivatives by the operands that vary. Choices and folds are not in this table: they are treated
    /// where they occur, because a branch that is not taken must not contribute.
    fn partials(&mut self, id: Id) -> Vec<(Id, Id)> {
        let one = self.integer(1);
        match self.op(id).clone() {
            Op::Negate(a) => {
                let minus = self.integer(-1);
                vec![(a, minus)]
            }
            Op::Add(a, b) => vec![(a, one), (b, one)],
            Op::Subtract(a, b) => {
                let minus = self.integer(-1);
                vec![(a, one), (b, minus)]
            }
            Op::Multiply(a, b) => vec![(a, b), (b, a)],
            Op::Divide(a, b) => {
                // (a/b)_b = −(a/b)/b
                let by_a = self.reciprocal(b);
                let quotient = self.multiply(id, by_a);
                let by_b = self.negate(quotient);
                vec![(a, by_a), (b, by_b)]
            }
            Op::Power(a, n) => {
                // n·aⁿ⁻¹
                let lower = self.power(a, n.saturating_sub(1));
                let n = self.integer(n.into());
                vec![(a, self.multiply(n, lower))]
            }
            Op::RealPower(a, b) => self.partials_of_real_power(id, a, b),
            Op::Unary(Function::Abs, a) => vec![(a, self.abs_slope(a))],
            Op::Unary(f, a) => vec![(a, self.derivative(f, id, a))],
            Op::Binary(Function::Hypot, a, b) => {
                let (by_a, by_b) = (self.divide(a, id), self.divide(b, id));
                vec![(a, by_a), (b, by_b)]
            }
            Op::Binary(Function::Atan2, a, b) => {
                // The angle of (b, a): (b da − a db)/(a² + b²)
                let (p, q) = (self.power(a, 2), self.power(b, 2));
                let square = self.add(p, q);
                let by_a = self.divide(b, square);
                let quotient = self.divide(a, square);
                let by_b = self.negate(quotient);
                vec![(a, by_a), (b, by_b)]
            }
            _ => vec![],
        }
    }

    /// (aᵇ)_a = b·aᵇ⁻¹ and (aᵇ)_b = aᵇ·ln a
    fn partials_of_real_power(&mut self, id: Id, a: Id, b: Id) -> Vec<(Id, Id)> {
        let mut all = Vec::new();
        if self.varies(a) {
            let one = self.integer(1);
            let exponent = self.subtract(b, one);
            let lower = self.raise(a, exponent);
            all.push((a, self.multiply(b, lower)));
        }
        if self.varies(b) {
            let log = self.unary(Function::Ln, a);
            all.push((b, self.multiply(id, log)));
        }
        all
    }

    /// The derivative of a function of one argument; `id` is its value.
    fn derivative(&mut self, f: Function, id: Id, a: Id) -> Id {
        let one = self.integer(1);
        match f {
            Function::Exp => id,
            Function::Sin => self.unary(Function::Cos, a),
            Function::Sinh => self.unary(Function::Cosh, a),
            Function::Cosh => self.unary(Function::Sinh, a),
            Function::Cos => {
                let sin = self.unary(Function::Sin, a);
                self.negate(sin)
            }
            Function::ExpM1 => self.unary(Function::Exp, a),
            Function::Exp2 => {
                let log = self.log_of(2);
                self.multiply(id, log)
            }
            Function::Ln => self.reciprocal(a),
            Function::Ln1p => {
                let shifted = self.add(one, a);
                self.reciprocal(shifted)
            }
            Function::Log2 | Function::Log10 => {
                let log = self.log_of(if f == Function::Log2 { 2 } else { 10 });
                let scaled = self.multiply(a, log);
                self.reciprocal(scaled)
            }
            Function::Sqrt => {
                // 1/(2√a)
                let two = self.integer(2);
                let twice = self.multiply(two, id);
                self.reciprocal(twice)
            }
            Function::Cbrt => {
                // 1/(3 ∛a²)
                let three = self.integer(3);
                let square = self.power(id, 2);
                let product = self.multiply(three, square);
                self.reciprocal(product)
            }
            Function::Tan => {
                let square = self.power(id, 2);
                self.add(one, square)
            }
            Function::Tanh => {
                let square = self.power(id, 2);
                self.subtract(one, square)
            }
            Function::Atan | Function::Asinh => {
                let square = self.power(a, 2);
                let sum = self.add(one, square);
                let root = if f == Function::Asinh {
                    self.unary(Function::Sqrt, sum)
                } else {
                    sum
                };
                self.reciprocal(root)
            }
            Function::Asin | Function::Acos | Function::Atanh => {
                let square = self.power(a, 2);
                let rest = self.subtract(one, square);
                let root = if f == Function::Atanh {
                    rest
                } else {
                    self.unary(Function::Sqrt, rest)
                };
                let value = self.reciprocal(root);
                if f == Function::Acos {
                    self.negate(value)
                } else {
                    value
                }
            }
            Function::Acosh => {
                let square = self.power(a, 2);
                let rest = self.subtract(square, one);
                let root = self.unary(Function::Sqrt, rest);
                self.reciprocal(root)
            }
            // These never stand in a unary node.
            Function::Abs
            | Function::Recip
            | Function::Atan2
            | Function::Hypot
            | Function::Min
            | Function::Max
            | Function::Clamp => self.integer(0),
        }
    }

    fn log_of(&mut self, n: i64) -> Id {
        let n = self.integer(n);
        self.unary(Function::Ln, n)
    }

    /// The truth that says that the first operand of `min` or `max` is the result.
    fn first_wins(&mut self, f: Function, a: Id, b: Id) -> Id {
        let (a, b) = if f == Function::Min { (a, b) } else { (b, a) };
        self.truth(Op::Less(a, b))
    }

    /// d/dt of a node along the ray, where leaves know their own slope: `leaf(k, order)` is the node of leaf k's
    /// derivative of that order.
    pub fn along(
        &mut self,
        id: Id,
        memo: &mut HashMap<Id, Id>,
        leaf: &dyn Fn(&mut Graph, usize, u8) -> Id,
    ) -> Id {
        if !self.varies(id) {
            return self.integer(0);
        }
        if let Some(&known) = memo.get(&id) {
            return known;
        }
        let slope = match self.op(id).clone() {
            Op::Leaf(k, order, _) => leaf(self, k, order + 1),
            // Its degree is higher than any order that is asked for.
            Op::Polynomial(k, order, of) => {
                let info = self.info(id).clone();
                let degree = info.degree.map(|d| d.saturating_sub(1));
                self.polynomial(
                    k,
                    order + 1,
                    of,
                    Info {
                        degree,
                        range: Range::LINE,
                        ..info
                    },
                )
            }
            Op::Choose(c, a, b, undecided) => {
                let (a, b) = (self.along(a, memo, leaf), self.along(b, memo, leaf));
                self.choose(c, a, b, undecided)
            }
            Op::Binary(f @ (Function::Min | Function::Max), a, b) => {
                let wins = self.first_wins(f, a, b);
                let (a, b) = (self.along(a, memo, leaf), self.along(b, memo, leaf));
                self.choose(wins, a, b, Undecided::Kink)
            }
            Op::Fold(kind, fold, args) => {
                let slopes: Vec<Id> = args.iter().map(|a| self.along(*a, memo, leaf)).collect();
                self.fold_slope(kind, fold, &args, &slopes)
            }
            _ => {
                let mut sum = self.integer(0);
                for (operand, partial) in self.partials(id) {
                    let slope = self.along(operand, memo, leaf);
                    // Nothing comes from there, also where the partial derivative is not defined.
                    if self.is_zero(slope) {
                        continue;
                    }
                    let term = self.multiply(partial, slope);
                    sum = self.add(sum, term);
                }
                sum
            }
        };
        memo.insert(id, slope);
        slope
    }

    /// The derivative of a fold whose arguments have these derivatives.
    fn fold_slope(&mut self, kind: FoldKind, fold: usize, args: &[Id], slopes: &[Id]) -> Id {
        match (kind, args, slopes) {
            (FoldKind::Sum, [_], [d]) => self.fold(kind, fold, vec![*d]),
            (FoldKind::Product, [b, b_u], [b_v, b_uv]) => {
                self.fold(kind, fold, vec![*b, *b_u, *b_v, *b_uv])
            }
            (FoldKind::Minimum | FoldKind::Maximum, [b, _], [_, d]) | (_, [b], [d]) => {
                self.fold(kind, fold, vec![*b, *d])
            }
            // Third derivatives are not taken.
            _ => self.integer(0),
        }
    }

    /// The derivatives of `root` by x, y and z, by one sweep from the root down.
    pub fn gradient(&mut self, root: Id) -> [Id; 3] {
        if !self.varies(root) {
            return [self.integer(0); 3];
        }
        self.slopes(root).1
    }

    /// Pushes adjoints down to the nodes that `enter` refuses and to those without operands; returns their adjoints.
    fn sweep(
        &mut self,
        mut pending: BTreeMap<Id, Id>,
        enter: &dyn Fn(&Graph, Id) -> bool,
    ) -> BTreeMap<Id, Id> {
        let mut done: BTreeMap<Id, Id> = BTreeMap::new();
        // Polynomials below what is none.
        let mut maximal = HashSet::new();
        // The largest id first: every use of a node has a larger id, so its adjoint is complete when it is taken.
        while let Some((id, adjoint)) = pending.pop_last() {
            if operands(self.op(id)).is_empty() || !enter(self, id) {
                let sum = done.get(&id).copied();
                let sum = sum.map_or(adjoint, |s| self.add(s, adjoint));
                done.insert(id, sum);
                continue;
            }
            let shares = if maximal.contains(&id) {
                self.through(id, adjoint)
            } else {
                self.shares(id, adjoint)
            };
            if self.info(id).degree.is_none() {
                let operands = shares.iter().map(|s| s.0);
                maximal.extend(operands.filter(|a| self.info(*a).degree.is_some()));
            }
            for (operand, share) in shares {
                if self.varies(operand) && !self.is_zero(share) {
                    let sum = pending.get(&operand).copied();
                    let sum = sum.map_or(share, |s| self.add(s, share));
                    pending.insert(operand, sum);
                }
            }
        }
        done
    }

    /// What a node's adjoint gives to each operand (for a fold: to each node outside the loop).
    fn shares(&mut self, id: Id, adjoint: Id) -> Vec<(Id, Id)> {
        match self.op(id).clone() {
            Op::Choose(c, a, b, undecided) => self.split(c, a, b, adjoint, undecided),
            Op::Binary(f @ (Function::Min | Function::Max), a, b) => {
                let wins = self.first_wins(f, a, b);
                self.split(wins, a, b, adjoint, Undecided::Kink)
            }
            Op::Fold(kind, fold, args) => self.shares_of_fold(kind, fold, &args, adjoint),
            _ => {
                let partials = self.partials(id);
                partials
                    .into_iter()
                    .map(|(operand, p)| (operand, self.multiply(adjoint, p)))
                    .collect()
            }
        }
    }

    /// A polynomial below other operations hands its adjoint on to x, y and z at once: one product with each of its own
    /// derivatives, where each of its operations would have one. What is inside a loop then has a sum for each of them, and
    /// not for each power.
    fn through(&mut self, polynomial: Id, adjoint: Id) -> Vec<(Id, Id)> {
        let (axes, slopes) = self.slopes(polynomial);
        let mut all = Vec::new();
        for (axis, slope) in axes.into_iter().zip(slopes) {
            if !self.is_zero(slope) {
                all.push((axis, self.multiply(adjoint, slope)));
            }
        }
        all
    }

    /// A choice hands on the choice of both sides' derivatives: where it is open, that is their hull. (Were each side given
    /// the adjoint under the same condition, an open one would add up two intervals that hold 0.)
    fn split(&mut self, c: Id, a: Id, b: Id, adjoint: Id, undecided: Undecided) -> Vec<(Id, Id)> {
        let (axes, yes) = self.slopes(a);
        let (_, no) = self.slopes(b);
        let mut all = Vec::new();
        for (axis, (yes, no)) in axes.into_iter().zip(yes.into_iter().zip(no)) {
            if !(self.is_zero(yes) && self.is_zero(no)) {
                let slope = self.choose(c, yes, no, undecided);
                all.push((axis, self.multiply(adjoint, slope)));
            }
        }
        all
    }

    /// x, y and z, and a node's derivatives by them.
    fn slopes(&mut self, id: Id) -> ([Id; 3], [Id; 3]) {
        let axes = [0, 1, 2].map(|k| self.input(Op::Coordinate(k)));
        if let Some(&known) = self.slopes.get(&id) {
            return (axes, known);
        }
        let one = self.integer(1);
        let found = self.sweep(BTreeMap::from([(id, one)]), &|_, _| true);
        let zero = self.integer(0);
        let slopes = axes.map(|axis| found.get(&axis).copied().unwrap_or(zero));
        self.slopes.insert(id, slopes);
        (axes, slopes)
    }

    /// A sweep inside the loop gives each row's derivatives by the nodes outside; a fold of those, times the adjoint,
    /// is their share.
    fn shares_of_fold(
        &mut self,
        kind: FoldKind,
        fold: usize,
        args: &[Id],
        adjoint: Id,
    ) -> Vec<(Id, Id)> {
        let inner: Vec<BTreeMap<Id, Id>> =
            args.iter().map(|a| self.row_gradient(fold, *a)).collect();
        let outside: BTreeSet<Id> = inner.iter().flat_map(|m| m.keys().copied()).collect();
        let zero = self.integer(0);
        let mut all = Vec::new();
        for node in outside {
            let slopes: Vec<Id> = inner
                .iter()
                .map(|m| m.get(&node).copied().unwrap_or(zero))
                .collect();
            let folded = self.fold_slope(kind, fold, args, &slopes);
            all.push((node, self.multiply(adjoint, folded)));
        }
        all
    }

    fn row_gradient(&mut self, fold: usize, body: Id) -> BTreeMap<Id, Id> {
        let one = self.integer(1);
        let mut adjoints = BTreeMap::new();
        if self.varies(body) {
            adjoints.insert(body, one);
        }
        self.sweep(adjoints, &|graph, id| graph.info(id).scope.has(fold))
    }
}
