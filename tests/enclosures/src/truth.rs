//! Exact values of arithmetic operations.

use zeroset::interval::Interval;

use crate::exact::Exact;
use crate::operation::Operation;

/// The operations that have one: [`holds`] knows them.
pub const OPERATIONS: [Operation; 13] = [
    Operation::Neg,
    Operation::Abs,
    Operation::Min,
    Operation::Max,
    Operation::Add,
    Operation::Sub,
    Operation::Mul,
    Operation::MulPos,
    Operation::MulPosPos,
    Operation::Sqr,
    Operation::Div,
    Operation::Recip,
    Operation::Sqrt,
];

/// Is the exact value of the operation at (x, y) in the range? None where it is not defined.
///
/// # Panics
/// If there is no exact value of the operation.
pub fn holds(operation: Operation, x: f64, y: f64, range: Interval) -> Option<bool> {
    let (a, b) = (Exact::from(x), Exact::from(y));
    let inside = |value: Exact| Some(value.is_in(range.lo, range.hi));
    match operation {
        Operation::Neg => inside(a.neg()),
        Operation::Abs => inside(Exact::from(x.abs())),
        Operation::Min => inside(Exact::from(x.min(y))),
        Operation::Max => inside(Exact::from(x.max(y))),
        Operation::Add => inside(a.add(&b)),
        Operation::Sub => inside(a.add(&b.neg())),
        Operation::Mul | Operation::MulPos | Operation::MulPosPos => inside(a.mul(&b)),
        Operation::Sqr => inside(a.mul(&a)),
        Operation::Powi(n) => inside(a.powi(n)),
        Operation::Recip => quotient(&Exact::from(1.0), &a, range),
        Operation::Div => quotient(&a, &b, range),
        Operation::Sqrt if x < 0.0 => None,
        // lo ≤ √x ⟺ lo ≤ 0 or lo² ≤ x; hi ≥ √x ⟺ hi ≥ 0 and hi² ≥ x.
        Operation::Sqrt => {
            let above = range.lo <= 0.0 || Exact::from(range.lo).powi(2).add(&a.neg()).sign() <= 0;
            let below = range.hi == f64::INFINITY
                || (range.hi >= 0.0 && Exact::from(range.hi).powi(2).add(&a.neg()).sign() >= 0);
            Some(above && below)
        }
        other => panic!("no exact value for {other:?}"),
    }
}

/// lo ≤ n/d ≤ hi, by multiplication: n − lo·d and hi·d − n have the sign of d, or are 0.
fn quotient(n: &Exact, d: &Exact, range: Interval) -> Option<bool> {
    if d.sign() == 0 {
        return None;
    }
    let above = range.lo == f64::NEG_INFINITY
        || (range.lo.is_finite()
            && n.add(&Exact::from(range.lo).mul(d).neg()).sign() * d.sign() >= 0);
    let below = range.hi == f64::INFINITY
        || (range.hi.is_finite()
            && Exact::from(range.hi).mul(d).add(&n.neg()).sign() * d.sign() >= 0);
    Some(above && below)
}
