//! Enclosures of a graph over a box, by the runtime's scalar intervals.

use std::collections::HashMap;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use zeroset::interval::{Arithmetic, Flags, Interval, Scalar, Truth, Undecided};
use zeroset_compiler::exact::Rational;
use zeroset_compiler::functions::Function;
use zeroset_compiler::graph::{Graph, Id, Op, operands};

type Marks = Flags<Scalar>;

/// A node's value: a number, or whether a condition holds.
#[derive(Clone, Copy)]
enum Value {
    Number(Interval),
    Truth(Truth<Scalar>),
}

/// A deliberately wrong rewrite, for the control: a node that counts as another.
pub type Wrong = fn(&Op) -> Option<Id>;

/// The range of `root` over the box, and whether it is certainly defined nowhere there.
///
/// # Panics
/// If the graph has fields or folds.
pub fn enclose(graph: &Graph, root: Id, over: &[Interval; 3], wrong: Wrong) -> (Interval, bool) {
    let mut known: HashMap<Id, (Value, Marks)> = HashMap::new();
    for id in graph.reachable(&[root], |_| false) {
        let node = match wrong(graph.op(id)) {
            Some(other) => known[&other],
            None => operation(graph, id, over, &known),
        };
        known.insert(id, node);
    }
    match known[&root] {
        (Value::Number(f), flags) => (
            f,
            flags.empty != <Scalar as Arithmetic>::clear(Scalar).empty,
        ),
        (Value::Truth(_), _) => panic!("a formula that is a condition"),
    }
}

fn operation(
    graph: &Graph,
    id: Id,
    over: &[Interval; 3],
    known: &HashMap<Id, (Value, Marks)>,
) -> (Value, Marks) {
    let p = Scalar;
    let op = graph.op(id);
    let number = |id: &Id| match known[id].0 {
        Value::Number(n) => n,
        Value::Truth(_) => panic!("a condition where a number should be"),
    };
    let truth = |id: &Id| match known[id].0 {
        Value::Truth(t) => t,
        Value::Number(_) => panic!("a number where a condition should be"),
    };
    let all = operands(op)
        .iter()
        .fold(p.clear(), |flags, a| p.join(flags, known[a].1));
    let plain = |n: Interval| (Value::Number(n), all);
    let partial = |(n, own): (Interval, Marks)| (Value::Number(n), p.join(all, own));
    let (value, flags) = match op {
        Op::Literal(r) => plain(literal(r)),
        Op::Pi => plain(zeroset::__private::PI.enclosure),
        Op::Coordinate(k) => plain(over[*k]),
        Op::Negate(a) => plain(Arithmetic::neg(p, number(a))),
        Op::Add(a, b) => plain(Arithmetic::add(p, number(a), number(b))),
        Op::Subtract(a, b) => plain(Arithmetic::sub(p, number(a), number(b))),
        Op::Multiply(a, b) => plain(Arithmetic::mul(p, number(a), number(b))),
        Op::Divide(a, b) => partial(Arithmetic::div(p, number(a), number(b))),
        Op::Power(a, n) => plain(Arithmetic::powi(p, number(a), *n)),
        Op::RealPower(a, b) => partial(Arithmetic::pow(p, number(a), number(b))),
        Op::Unary(f, a) => unary(*f, number(a), all),
        Op::Binary(f, a, b) => binary(*f, number(a), number(b), all),
        Op::Less(a, b) => (Value::Truth(Arithmetic::less(p, number(a), number(b))), all),
        Op::LessOrEqual(a, b) => (
            Value::Truth(Arithmetic::less_or_equal(p, number(a), number(b))),
            all,
        ),
        Op::Both(a, b) => (Value::Truth(Arithmetic::both(p, truth(a), truth(b))), all),
        Op::Either(a, b) => (Value::Truth(Arithmetic::either(p, truth(a), truth(b))), all),
        Op::Choose(c, a, b, _) => {
            let taken = p.branch(truth(c), known[a].1, known[b].1, Undecided::Jump);
            let chosen = p.choose(truth(c), number(a), number(b));
            (Value::Number(chosen), p.join(taken, known[c].1))
        }
        op => panic!("no formula here has {op:?}"),
    };
    // What the compiler proved to be ≥ 0 is cut there, as in generated code.
    match value {
        Value::Number(n) if graph.info(id).range.is_nonnegative() => {
            (Value::Number(p.nonneg(n)), flags)
        }
        value => (value, flags),
    }
}

fn unary(f: Function, a: Interval, flags: Marks) -> (Value, Marks) {
    let p = Scalar;
    let plain = |n: Interval| (n, p.clear());
    let (n, own) = match f.entry().name {
        "abs" => plain(Arithmetic::abs(p, a)),
        "sqrt" => Arithmetic::sqrt(p, a),
        "recip" => Arithmetic::recip(p, a),
        "exp" => plain(Arithmetic::exp(p, a)),
        "exp2" => plain(Arithmetic::exp2(p, a)),
        "exp_m1" => plain(Arithmetic::exp_m1(p, a)),
        "ln" => Arithmetic::ln(p, a),
        "ln_1p" => Arithmetic::ln_1p(p, a),
        "log2" => Arithmetic::log2(p, a),
        "log10" => Arithmetic::log10(p, a),
        "sin" => plain(Arithmetic::sin(p, a)),
        "cos" => plain(Arithmetic::cos(p, a)),
        "tan" => Arithmetic::tan(p, a),
        "asin" => Arithmetic::asin(p, a),
        "acos" => Arithmetic::acos(p, a),
        "atan" => plain(Arithmetic::atan(p, a)),
        "sinh" => plain(Arithmetic::sinh(p, a)),
        "cosh" => plain(Arithmetic::cosh(p, a)),
        "tanh" => plain(Arithmetic::tanh(p, a)),
        "asinh" => plain(Arithmetic::asinh(p, a)),
        "acosh" => Arithmetic::acosh(p, a),
        "atanh" => Arithmetic::atanh(p, a),
        "cbrt" => plain(Arithmetic::cbrt(p, a)),
        name => panic!("no function of one argument is called {name}"),
    };
    (Value::Number(n), p.join(flags, own))
}

fn binary(f: Function, a: Interval, b: Interval, flags: Marks) -> (Value, Marks) {
    let p = Scalar;
    let (n, own) = match f.entry().name {
        "min" => (Arithmetic::min(p, a, b), p.clear()),
        "max" => (Arithmetic::max(p, a, b), p.clear()),
        "hypot" => (Arithmetic::hypot(p, a, b), p.clear()),
        "atan2" => Arithmetic::atan2(p, a, b),
        name => panic!("no function of two arguments is called {name}"),
    };
    (Value::Number(n), p.join(flags, own))
}

/// The tightest interval in `f64`, or one unit more.
fn literal(r: &Rational) -> Interval {
    let r: BigRational = r.to_string().parse().expect("a fraction");
    let x = r.to_f64().expect("a number");
    let is_exact = x.is_finite() && crate::truth::exact(x) == r;
    Interval {
        lo: if is_exact { x } else { x.next_down() },
        hi: if is_exact { x } else { x.next_up() },
    }
}
