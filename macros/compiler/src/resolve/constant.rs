//! Exact arithmetic on constants, so far as the numbers stay small.

use crate::exact::Rational;
use crate::functions::Function;
use crate::tree::Operator;

/// The most bits of a numerator or denominator.
const MOST_BITS: u64 = 4096;

/// The number, unless it has become too long.
fn bounded(value: Rational) -> Option<Rational> {
    (value.bits() <= MOST_BITS).then_some(value)
}

/// `a ∘ b`, if it is defined and rational.
pub(super) fn binary(operator: Operator, a: &Rational, b: &Rational) -> Option<Rational> {
    match operator {
        Operator::Add => bounded(a + b),
        Operator::Subtract => bounded(a - b),
        Operator::Multiply => bounded(a * b),
        Operator::Divide => bounded(a.over(b)?),
        Operator::Power => power(a, b),
    }
}

/// `base^exponent` for a whole exponent.
fn power(base: &Rational, exponent: &Rational) -> Option<Rational> {
    if !exponent.is_integer() {
        return None;
    }
    let exponent = i32::try_from(exponent.to_i64()?).ok()?;
    if base.is_zero() && exponent < 0 {
        return None;
    }
    if base.is_one() || exponent == 0 {
        return Some(Rational::from(1));
    }
    // The result has about this many bits: refuse before it is computed.
    if base
        .bits()
        .checked_mul(u64::from(exponent.unsigned_abs()))?
        > MOST_BITS + u64::from(exponent.unsigned_abs())
    {
        return None;
    }
    bounded(base.power(exponent)?)
}

/// `function(arguments)`, where that is rational for rational arguments.
pub(super) fn call(function: Function, arguments: &[Option<Rational>]) -> Option<Rational> {
    match (function, arguments) {
        (Function::Abs, [Some(a)]) => Some(a.abs()),
        (Function::Recip, [Some(a)]) => a.reciprocal(),
        (Function::Min, [Some(a), Some(b)]) => Some(a.min(b).clone()),
        (Function::Max, [Some(a), Some(b)]) => Some(a.max(b).clone()),
        _ => None,
    }
}

/// For what arguments a function is defined, if this one is not among them.
pub(super) fn outside(function: Function, argument: &Rational) -> Option<&'static str> {
    let one = Rational::from(1);
    let (defined, domain) = match function {
        Function::Ln | Function::Log2 | Function::Log10 => {
            (argument.is_positive(), "numbers above 0")
        }
        Function::Ln1p => (*argument > -one, "numbers above -1"),
        Function::Asin | Function::Acos => (argument.abs() <= one, "numbers from -1 to 1"),
        Function::Acosh => (*argument >= one, "numbers from 1 on"),
        Function::Atanh => (argument.abs() < one, "numbers between -1 and 1"),
        _ => return None,
    };
    (!defined).then_some(domain)
}
