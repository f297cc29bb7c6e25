//! Names that mean nothing, or something else.

use crate::diagnostic::{Diagnostic, Place};

messages! {
    /// `qqq`
    unknown(name: &str) "cannot find `{name}` in this formula" => "declare a field `{name}: f64`, or a `let`";
    /// `radus`
    unknown_similar(name: &str, similar: &str) "cannot find `{name}` in this formula"
        => "a name that looks like it is in scope: `{similar}`";
    /// `xy`
    unknown_product(name: &str, product: &str) "cannot find `{name}` in this formula"
        => "a product is written out: `{product}`";
    /// `x2`
    unknown_power(name: &str, power: &str) "cannot find `{name}` in this formula"
        => "a power is written with `^`: `{power}`";
    /// `PI`
    unknown_constant(name: &str, constant: &str) "cannot find `{name}` in this formula"
        => "the constant is `{constant}`";
    /// `f = x^2 - 1`, `f(x, y, z) = x^2 - 1`
    named_formula(name: &str) "cannot find `{name}` in this formula"
        => "a formula has no name: write its value alone, without `{name}` and `=`";
    /// `inf`
    not_finite(name: &str) "cannot find `{name}` in this formula" => "the numbers of a formula are finite";
    /// `e`
    unknown_e(name: &str) "cannot find `{name}` in this formula" => "write `exp(1)`, or declare a field `{name}`";
    /// A loop variable outside of its fold, or a `let` before it.
    out_of_scope(name: &str) "cannot find `{name}` in this formula"
        => "`{name}` is declared elsewhere and is not in scope here";
    /// `x·y`
    middle_dot(name: &str, instead: &str) "`{name}` is one name, because `·` may be part of a name"
        => "write `{instead}`";
    /// `sin + x`
    function_as_value(name: &str) "`{name}` is a function" => "write `{name}(…)`";
    /// `sum + x`
    fold_as_value(name: &str) "`{name}` is a fold" => "write `{name}(i in 0..8) {{ … }}`";
    /// `qqq(x)`
    unknown_function(name: &str) "cannot find function `{name}`"
        => "if `{name}` is a number, multiplication is written out: `{name}*(…)`";
    /// `sine(x)`
    unknown_function_similar(name: &str, similar: &str) "cannot find function `{name}`"
        => "a function with a similar name exists: `{similar}`";
    /// `pow(x, 2)`
    unknown_function_instead(name: &str, instead: &str) "cannot find function `{name}`" => "write `{instead}`";
    /// `log(x)`
    ambiguous_log() "`log` has several meanings" => "use `ln`, `log2` or `log10`";
    /// `x(y + 1)`
    call_of_number(name: &str) "`{name}` is a number, not a function"
        => "multiplication is written out: `{name}*(…)`";
    /// `floor(x)`
    jumps(name: &str) "`{name}` is not available" => "it jumps, so its derivative has no enclosure";
    /// `atan2(y)`
    arity(name: &str, takes: &str, given: &str) "`{name}` takes {takes}, but {given} given";
    /// `max(x, y, z)`
    arity_fold(name: &str, takes: &str, given: &str) "`{name}` takes {takes}, but {given} given"
        => "nest the calls, or fold a table: `{name}(a in t) {{ … }}`";
    /// `hypot(x, y, z)`
    arity_hypot(name: &str, takes: &str, given: &str) "`{name}` takes {takes}, but {given} given"
        => "write `sqrt(a^2 + b^2 + c^2)`";
    /// `t.len()`
    length_of_table() "the length of a table is not a number of the formula"
        => "fold over the table: `sum(a in t) {{ … }}`";
    /// `let x = y;`
    hides_coordinate(name: &str) "`{name}` hides the coordinate `{name}`" => "choose another name";
    /// `let pi = 3;`
    hides_constant(name: &str) "`{name}` hides the constant `{name}`" => "choose another name";
    /// `let r = 1;` with a field `r`
    hides_field(name: &str) "`{name}` hides the field `{name}`" => "choose another name";
    /// `sum([a, a] in t) { … }`
    pattern_twice(name: &str) "`{name}` stands twice in this pattern" => "use `_` for a number that is not needed";
}
