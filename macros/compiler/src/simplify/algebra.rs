//! Sums, products, quotients and powers.

use crate::exact::Rational;
use crate::graph::{Graph, Id, Op};
use crate::range::Range;
use crate::tree::FoldKind;

impl Graph {
    /// −a
    pub fn negate(&mut self, a: Id) -> Id {
        match self.op(a).clone() {
            _ if !self.rewrites() => self.plain_negate(a),
            Op::Literal(r) => self.number(-r),
            Op::Negate(inner) => self.by("--a = a", inner),
            Op::Subtract(b, c) => {
                let id = self.subtract(c, b);
                self.by("-(a - b) = b - a", id)
            }
            _ => self.plain_negate(a),
        }
    }

    fn plain_negate(&mut self, a: Id) -> Id {
        let info = self.info(a);
        let (degree, range) = (info.degree, info.range.negated());
        self.node(Op::Negate(a), degree, range)
    }

    /// a + b
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        match (self.op(a).clone(), self.op(b).clone()) {
            _ if !self.rewrites() => {}
            (Op::Literal(x), Op::Literal(y)) => {
                if let Some(id) = self.exact(&x + &y) {
                    return self.by("literals", id);
                }
            }
            (Op::Literal(x), _) if x.is_zero() => return self.by("0 + a = a", b),
            (_, Op::Literal(y)) if y.is_zero() => return self.by("0 + a = a", a),
            (_, Op::Negate(y)) => {
                let id = self.subtract(a, y);
                return self.by("a + -b = a - b", id);
            }
            (Op::Negate(x), _) => {
                let id = self.subtract(b, x);
                return self.by("a + -b = a - b", id);
            }
            _ if a == b => {
                let two = self.integer(2);
                let id = self.multiply(two, a);
                return self.by("a + a = 2a", id);
            }
            _ => {}
        }
        let range = self.range(a).plus(self.range(b));
        self.node(Op::Add(a, b), self.degree_of_sum(a, b), range)
    }

    /// a − b
    pub fn subtract(&mut self, a: Id, b: Id) -> Id {
        match (self.op(a).clone(), self.op(b).clone()) {
            _ if !self.rewrites() => {}
            (Op::Literal(x), Op::Literal(y)) => {
                if let Some(id) = self.exact(&x - &y) {
                    return self.by("literals", id);
                }
            }
            (Op::Literal(x), _) if x.is_zero() => {
                let id = self.negate(b);
                return self.by("0 - a = -a", id);
            }
            (_, Op::Literal(y)) if y.is_zero() => return self.by("a - 0 = a", a),
            (_, Op::Negate(y)) => {
                let id = self.add(a, y);
                return self.by("a - -b = a + b", id);
            }
            _ if a == b && self.info(a).total => {
                let id = self.integer(0);
                return self.by("a - a = 0", id);
            }
            _ => {}
        }
        let range = self.range(a).plus(self.range(b).negated());
        self.node(Op::Subtract(a, b), self.degree_of_sum(a, b), range)
    }

    fn degree_of_sum(&self, a: Id, b: Id) -> Option<u32> {
        Some(self.info(a).degree?.max(self.info(b).degree?))
    }

    /// a·b
    pub fn multiply(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        match (self.op(a).clone(), self.op(b).clone()) {
            _ if !self.rewrites() => {}
            (Op::Literal(x), Op::Literal(y)) => {
                if let Some(id) = self.exact(&x * &y) {
                    return self.by("literals", id);
                }
            }
            (Op::Literal(x), _) if x.is_zero() && self.info(b).total => {
                return self.by("0a = 0", a);
            }
            (_, Op::Literal(y)) if y.is_zero() && self.info(a).total => {
                return self.by("0a = 0", b);
            }
            _ if self.is_one(a) => return self.by("1a = a", b),
            _ if self.is_one(b) => return self.by("1a = a", a),
            _ if self.is(a, -1) => {
                let id = self.negate(b);
                return self.by("-1a = -a", id);
            }
            _ if self.is(b, -1) => {
                let id = self.negate(a);
                return self.by("-1a = -a", id);
            }
            (Op::Negate(x), Op::Negate(y)) => {
                let id = self.multiply(x, y);
                return self.by("(-a)(-b) = ab", id);
            }
            // A sign moves outward, where sums absorb it; literals absorb it at once.
            (Op::Literal(x), Op::Negate(y)) => {
                let c = self.number(-x);
                let id = self.multiply(c, y);
                return self.by("c(-a) = (-c)a", id);
            }
            (Op::Negate(x), Op::Literal(y)) => {
                let c = self.number(-y);
                let id = self.multiply(x, c);
                return self.by("c(-a) = (-c)a", id);
            }
            (Op::Negate(x), _) => {
                let p = self.multiply(x, b);
                let id = self.negate(p);
                return self.by("(-a)b = -(ab)", id);
            }
            (_, Op::Negate(y)) => {
                let p = self.multiply(a, y);
                let id = self.negate(p);
                return self.by("(-a)b = -(ab)", id);
            }
            (Op::Literal(x), Op::Multiply(p, q)) | (Op::Multiply(p, q), Op::Literal(x)) => {
                if let Some((c, rest)) = self.literal_factor(p, q)
                    && let Some(id) = self.exact(&x * &c)
                {
                    let id = self.multiply(id, rest);
                    return self.by("c(da) = (cd)a", id);
                }
            }
            _ if a == b => {
                let id = self.power(a, 2);
                return self.by("aa = a^2", id);
            }
            _ => {}
        }
        let range = self.range(a).times(self.range(b));
        let degree = self.degree_of_product(a, b);
        self.node(Op::Multiply(a, b), degree, range)
    }

    fn literal_factor(&self, p: Id, q: Id) -> Option<(Rational, Id)> {
        let first = self.literal(p).map(|r| (r.clone(), q));
        first.or_else(|| self.literal(q).map(|r| (r.clone(), p)))
    }

    fn degree_of_product(&self, a: Id, b: Id) -> Option<u32> {
        self.info(a).degree?.checked_add(self.info(b).degree?)
    }

    /// a/b
    pub fn divide(&mut self, a: Id, b: Id) -> Id {
        if let Some(y) = self.literal(b).cloned()
            && self.rewrites()
            && let Some(inverse) = y.reciprocal()
            && let Some(inverse) = self.exact(inverse)
        {
            let id = self.multiply(inverse, a);
            return self.by("a/c = (1/c)a", id);
        }
        // One reciprocal at the surface stage serves all rays, and keeps polynomials polynomial.
        if self.rewrites() && !self.varies(b) && self.varies(a) {
            let inverse = self.reciprocal(b);
            let id = self.multiply(a, inverse);
            return self.by("a/s = a(1/s)", id);
        }
        let range = self.range(a).times(self.range(b).inverse());
        self.node(Op::Divide(a, b), None, range)
    }

    /// 1/a
    pub fn reciprocal(&mut self, a: Id) -> Id {
        let one = self.integer(1);
        self.divide(one, a)
    }

    /// aⁿ for a whole n ≥ 0
    pub fn power(&mut self, a: Id, n: u32) -> Id {
        match (self.op(a).clone(), n) {
            _ if !self.rewrites() => {}
            (_, 1) => return self.by("a^1 = a", a),
            (_, 0) if self.info(a).total => {
                let id = self.integer(1);
                return self.by("a^0 = 1", id);
            }
            (Op::Literal(x), _) => {
                let bits = x.bits();
                if bits.saturating_mul(n.into()) <= 2 * super::LITERAL_BITS
                    && let Some(power) = i32::try_from(n).ok().and_then(|n| x.power(n))
                    && let Some(id) = self.exact(power)
                {
                    return self.by("literals", id);
                }
            }
            (Op::Negate(x), _) if n.is_multiple_of(2) => {
                let id = self.power(x, n);
                return self.by("(-a)^2n = a^2n", id);
            }
            (Op::Unary(crate::functions::Function::Abs, x), _) if n.is_multiple_of(2) => {
                let id = self.power(x, n);
                return self.by("|a|^2n = a^2n", id);
            }
            (Op::Power(x, m), _) => {
                if let Some(k) = m.checked_mul(n) {
                    let id = self.power(x, k);
                    return self.by("(a^m)^n = a^mn", id);
                }
            }
            _ => {}
        }
        let info = self.info(a);
        let degree = info.degree.and_then(|d| d.checked_mul(n));
        let range = info.range.power(n);
        self.node(Op::Power(a, n), degree, range)
    }

    /// a^b for any b: whole exponents are powers or their reciprocals, halves go through the square root (the same
    /// value on the same domain), the rest is exp(b·ln a) on its domain.
    pub fn raise(&mut self, a: Id, b: Id) -> Id {
        let Some(e) = self.rational(b) else {
            return self.real_power(a, b);
        };
        let doubled = &e + &e;
        let n = doubled
            .is_integer()
            .then(|| {
                doubled
                    .numerator()
                    .to_u64()
                    .and_then(|n| u32::try_from(n).ok())
            })
            .flatten();
        let Some(n) = n else {
            return self.real_power(a, b);
        };
        let magnitude = if n.is_multiple_of(2) {
            self.power(a, n / 2)
        } else {
            let root = self.unary(crate::functions::Function::Sqrt, a);
            self.power(root, n)
        };
        if e.is_negative() {
            self.reciprocal(magnitude)
        } else {
            magnitude
        }
    }

    /// exp(b·ln a) on a > 0, and 0 for a = 0 < b.
    pub fn real_power(&mut self, a: Id, b: Id) -> Id {
        self.node(Op::RealPower(a, b), None, Range::NONNEGATIVE)
    }

    /// The number of an expression of literals. Simplified, it is one literal already.
    fn rational(&self, id: Id) -> Option<Rational> {
        Some(match *self.op(id) {
            Op::Literal(ref r) => r.clone(),
            Op::Negate(a) => -self.rational(a)?,
            Op::Add(a, b) => &self.rational(a)? + &self.rational(b)?,
            Op::Subtract(a, b) => &self.rational(a)? - &self.rational(b)?,
            Op::Multiply(a, b) => &self.rational(a)? * &self.rational(b)?,
            Op::Divide(a, b) => self.rational(a)?.over(&self.rational(b)?)?,
            _ => return None,
        })
    }

    /// A fold, with the arguments as in [`Op::Fold`].
    pub fn fold(&mut self, kind: FoldKind, fold: usize, args: Vec<Id>) -> Id {
        let [first, rest @ ..] = args.as_slice() else {
            return self.integer(0);
        };
        let (first, order) = (*first, rest.len());
        if self.rewrites() && kind == FoldKind::Sum && self.is_zero(first) {
            return self.by("sum of 0 = 0", first);
        }
        if self.rewrites() && order > 0 && rest.iter().all(|d| self.is_zero(*d)) {
            return self.integer(0);
        }
        let info = self.info(first).clone();
        let degree = if kind == FoldKind::Sum && order == 0 {
            info.degree
        } else {
            None
        };
        let range = match (kind, order) {
            // Extremes are values of a row; sums and products have any number of rows, or none.
            (FoldKind::Minimum | FoldKind::Maximum, 0) => info.range,
            (_, 0) if info.range.is_nonnegative() => Range::NONNEGATIVE,
            (FoldKind::Sum, 0) if info.range.is_nonpositive() => Range::NONNEGATIVE.negated(),
            _ => Range::LINE,
        };
        let op = Op::Fold(kind, fold, args);
        let (total, scope) = self.of_operands(&op);
        let degree = if self.fixed(&op) { Some(0) } else { degree };
        // The rows come from this fold; what selects its table comes from the folds around it.
        let outer = self.chain(fold).without(fold);
        let scope = crate::graph::Scope(scope.without(fold).0 | outer.0);
        self.intern(op, |_| crate::graph::Info {
            degree,
            range,
            total,
            scope,
        })
    }
}
