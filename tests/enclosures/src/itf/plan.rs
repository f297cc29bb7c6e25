//! Which of our operations a case is for.

use zeroset::interval::Interval;

use super::{Case, Set};
use crate::operation::Operation;

/// What to do with a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plan {
    /// An operation, with operands; those of one operand ignore the second.
    Run(Operation, Interval, Interval),
    /// Newton's division: the numerator and the divisor.
    Divide(Interval, Interval),
    /// Nothing, and why.
    Skip(&'static str),
}

/// Why a case is left out.
pub const ABSENT: &str = "no such operation";
/// Why a case is left out.
pub const EMPTY: &str = "empty is a flag here, never an operand";
/// Why a case is left out.
pub const NO_INTERVAL: &str = "not about intervals";

/// The standard's name of an operation that is called something else here.
fn ours(name: &str) -> &str {
    match name {
        "log" => "ln",
        "expm1" => "exp_m1",
        "logp1" | "log1p" => "ln_1p",
        other => other,
    }
}

/// The operation for a case. `pown` takes any whole exponent; `mulRevToPair` is Newton's division.
pub fn plan(case: &Case) -> Plan {
    let operation = match (case.name.as_str(), &case.operands[..]) {
        ("pown", [_, Set::Number(n)]) if n.fract() == 0.0 && n.abs() < 1e6 => {
            Operation::Pown(*n as i32)
        }
        ("rootn", [_, Set::Number(2.0)]) => Operation::Sqrt,
        ("rootn", [_, Set::Number(3.0)]) => Operation::Cbrt,
        ("convexHull", _) => Operation::Hull,
        ("intersection", _) => Operation::Intersect,
        // The operation has no operands of its own; those of the case are read below.
        ("mulRevToPair", _) => Operation::Div,
        (name, _) => match Operation::named(ours(name)) {
            Some(operation) => operation,
            None => return Plan::Skip(ABSENT),
        },
    };
    let mut intervals = Vec::new();
    for operand in &case.operands {
        match operand {
            Set::Some(a) => intervals.push(*a),
            Set::Number(_) => {}
            Set::Empty | Set::Nai => return Plan::Skip(EMPTY),
            Set::Other(_) => return Plan::Skip(NO_INTERVAL),
        }
    }
    let known = |set: &Set| matches!(set, Set::Some(_) | Set::Empty);
    if !case.results.iter().all(known) {
        return Plan::Skip(NO_INTERVAL);
    }
    match (case.name.as_str(), &intervals[..]) {
        // The divisor comes first.
        ("mulRevToPair", &[den, num]) => Plan::Divide(num, den),
        (_, &[a]) => Plan::Run(operation, a, a),
        (_, &[a, b]) => Plan::Run(operation, a, b),
        _ => Plan::Skip(ABSENT),
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;

    fn of(statement: &str) -> Plan {
        plan(&parse("x.itl", statement).unwrap()[0])
    }

    #[test]
    fn cases_find_their_operation() {
        let one = Interval::ONE;
        assert_eq!(of("log [1] = [0];"), Plan::Run(Operation::Ln, one, one));
        assert_eq!(
            of("pown [1] -3 = [1];"),
            Plan::Run(Operation::Pown(-3), one, one)
        );
        assert_eq!(
            of("mulRevToPair [1] [0] = [0] [empty];"),
            Plan::Divide(Interval::ZERO, one)
        );
        assert_eq!(of("neg [empty] = [empty];"), Plan::Skip(EMPTY));
        assert_eq!(of("ceil [1] = [1];"), Plan::Skip(ABSENT));
        assert_eq!(of("fma [1] [1] [1] = [2];"), Plan::Skip(ABSENT));
        assert_eq!(of("min [1] [1] = true;"), Plan::Skip(NO_INTERVAL));
    }
}
