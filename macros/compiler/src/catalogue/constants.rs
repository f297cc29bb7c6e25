//! Constants for which an operation is not defined.

use crate::diagnostic::{Diagnostic, Place};

messages! {
    /// `x/(2 - 2)`
    division_by_zero() "division by zero";
    /// `sqrt(-2)`
    root_of_negative() "square root of a negative number";
    /// `(-8)^(1/3)`
    power_of_negative() "a negative number has no real power with this exponent" => "for a cube root use `cbrt`";
    /// `ln(0)`
    undefined(name: &str, domain: &str) "`{name}` is not defined at this number" => "it is defined for {domain}";
    /// `clamp(x, 1, 0)`
    clamp_bounds() "the bounds of this `clamp` are the wrong way round" => "write `clamp(value, lower, upper)`";
    /// `x^1e9`
    exponent_too_large(most: u32) "this exponent is too large" => "exponents go up to {most}";
    /// `0..n`
    fold_bounds() "bounds of a fold must be whole-number constants";
    /// `4..4`
    range_empty() "this range is empty";
    /// 65 folds
    too_many_folds(most: usize) "this formula has more than {most} folds" => "fold over one longer table";
    /// `0..1e18`
    range_too_long(most: i64) "bounds of a fold lie between -{most} and {most}";
}
