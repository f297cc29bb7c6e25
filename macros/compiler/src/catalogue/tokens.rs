//! Tokens that are not part of the language.

use crate::diagnostic::{Diagnostic, Place};

messages! {
    /// `x**2`
    double_star() "`**` is not an operator here" => "powers are written `^`";
    /// `|x|`
    bars() "bars do not delimit an absolute value" => "write `abs(x)`";
    /// `a | b`, `a & b`
    bit_operator(operator: &str) "`{operator}` is not defined on numbers"
        => "for a union write `min(a, b)`, for an intersection `max(a, b)`";
    /// `x << 2`
    shift(operator: &str) "`{operator}` is not defined on numbers" => "multiply by a power: `2^n`";
    /// `!x`
    not(operator: &str) "`{operator}` is not defined on numbers" => "the complement of a solid is `-f`";
    /// `x % 2`
    remainder() "`%` is not available" => "a remainder jumps, so its derivative has no enclosure";
    /// `a == b`
    double_equals(operator: &str) "`{operator}` is not part of a formula"
        => "write an equation with a single `=`";
    /// `if a == b { … }`
    equality_test(operator: &str) "`{operator}` cannot be tested"
        => "compare with `<`, `<=`, `>` or `>=`";
    /// `a += y`
    assignment(operator: &str) "`{operator}` assigns, and a formula has no variables to assign" => "use `let`";
    /// `if x > 0 and y > 0 { … }`
    word_operator(word: &str, operator: &str) "`{word}` is not an operator here" => "write `{operator}`";
    /// `if not x > 0 { … }`
    word_not() "`not` is not an operator here" => "turn the comparison around: `x <= 0` for `not x > 0`";
    /// `"x^2 + y^2"`
    quoted() "text is not a value" => "a formula stands without quotes";
    /// `c ? a : b`
    ternary() "`?` is not an operator here" => "write `if c {{ a }} else {{ b }}`";
    /// `f64::sin(x)`
    path(instead: &str) "paths are not known inside a formula" => "write `{instead}`";
    /// `S.r`
    member_of_surface(surface: &str, field: &str) "`{surface}` is no value of the formula"
        => "fields stand by their names alone: `{field}`";
    /// `self.r`
    this() "a formula has no `self`" => "fields stand by their names alone";
    /// `vec![x]`
    macro_call() "macros cannot be called inside a formula";
    /// `x as f64`
    cast() "numbers in a formula carry no type" => "remove the cast";
    /// `2f32*x`
    typed_number(digits: &str) "numbers in a formula carry no type" => "write `{digits}`";
    /// `2x`
    number_runs_into_name(number: &str, name: &str) "expected an operator between `{number}` and `{name}`"
        => "`{number}*{name}`";
    /// `0x10`
    radix(value: &str) "numbers in a formula are decimal" => "write `{value}`";
    /// `1e400`
    number_too_large() "this number is larger than any `f64`";
    /// `1e-400`
    number_too_small() "this number is closer to zero than any `f64`";
    /// A number with thousands of digits.
    number_too_long(most: usize) "this number has more than {most} digits";
}
