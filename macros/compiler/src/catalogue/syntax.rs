//! Tokens of the language in the wrong place.

use crate::diagnostic::{Diagnostic, Place};

messages! {
    /// Nothing at all.
    no_formula() "expected a formula";
    /// `x^2 +`
    value_after() "expected a value after this";
    /// `* x`
    value_found(found: &str) "expected a value, found `{found}`";
    /// `x y`, `2(x + y)`
    juxtaposed() "expected an operator before this" => "use `*`";
    /// `x @ y`
    unexpected(found: &str) "expected an operator, found `{found}`";
    /// `x^2 = 1,`
    last_comma() "expected an operator, found `,`" => "remove the `,`";
    /// `x, y`
    comma() "expected an operator, found `,`" => "a formula is one value, not a list of them";
    /// `t[0, 1]`
    index_comma() "expected an operator, found `,`" => "each index has its own brackets: `t[i][j]`";
    /// `1,5`
    decimal_comma(instead: &str) "expected an operator, found `,`" => "a decimal is written with a point: `{instead}`";
    /// `x if x > 0 else y`
    value_before_if() "an `if` stands before its values" => "write `if … {{ a }} else {{ b }}`";
    /// `x = y = z`
    second_equation() "a formula has at most one `=`";
    /// `sin(x = 1)`
    equation_inside() "an equation is not a value" => "an equation stands alone: `f = g`";
    /// `x + y;`
    discarded() "the formula's value is discarded" => "remove the `;`";
    /// `a = x + y; a^2`
    discarded_binding(name: &str) "the formula's value is discarded" => "name it: `let {name} = …;`";
    /// `x + y; x`
    discarded_early() "this value is discarded" => "a formula has one value: name this one with `let`, or remove it";
    /// `/// text` before a `let`
    attribute_inside() "attributes are not possible inside a formula" => "a comment begins with `//`";
    /// `let a = x^2 a`
    let_end() "expected `;` at the end of this `let`";
    /// `let mut a = x;`
    let_mut() "bindings in a formula cannot be `mut`" => "remove `mut`";
    /// `let 2 = x;`
    let_name(found: &str) "expected a name after `let`, found `{found}`";
    /// `let [a, b] = t;`
    let_pattern(example: &str) "a `let` names one value" => "write `{example}`";
    /// `let a: f64 = x;`
    let_type() "bindings in a formula carry no type" => "remove the type";
    /// `let a x;`
    let_equals(name: &str) "expected `=` after `let {name}`";
    /// `if x > 0 { y }`
    no_else() "this `if` has no `else`" => "a value is needed everywhere: `else {{ … }}`";
    /// `if { x }`
    no_condition() "expected a comparison after this";
    /// `if x > 0 y`, `sum(i in 0..3) x`
    block() "expected a block after this" => "put the value in braces: `{{ … }}`";
    /// `0 < x < 1`
    chained() "comparisons cannot be chained" => "write `a < x && x < b`";
    /// `for i in 0..8 { … }`
    loop_statement() "loops are not formulas" => "write `sum(i in 0..8) {{ … }}`";
    /// `match x { … }`
    match_statement() "`match` is not part of a formula" => "write `if … {{ … }} else {{ … }}`";
    /// `0..=7`
    inclusive_range(instead: &str) "ranges here are half open" => "write `{instead}`";
    /// `mean(i in 0..8) { … }`
    not_a_fold(name: &str) "`{name}` cannot fold" => "the folds are `sum`, `prod`, `min` and `max`";
    /// `sum(i in 0..8, j in 0..8) { … }`
    two_patterns() "a fold runs over one range or table" => "put one fold inside another";
    /// `sum([1, x] in t) { … }`
    pattern() "expected a name or `_`";
    /// `x.length`, `x.sqrt`
    member(name: &str, method: &str) "a number has no member `{name}`"
        => "a method is called with brackets: `x.{method}()`";
    /// `p.x`, `t.0`
    component(name: &str) "there is no `.{name}` here"
        => "the coordinates are `x`, `y` and `z`, the numbers of a table `t[0]`, `t[1]` and so on";
    /// `let f(t) = t^2;`, `fn f(t: f64) -> f64 { t*t }`
    function_inside() "functions cannot be defined inside a formula" => "name values with `let`";
    /// `let f = |t| t^2;`
    closure() "a formula has no closures" => "name values with `let`";
    /// `return x^2`
    return_value() "`return` is not part of a formula" => "remove it: the last value is the formula's";
    /// `const A = 2;`
    not_let(word: &str, name: &str) "`{word}` is not part of a formula" => "write `let {name} = …;`";
    /// `use std::f64::consts::PI;`
    import_inside() "a formula imports nothing" => "its functions and constants are known without `use`";
    /// `struct A; x = 1 struct B; y = 1`
    second_surface() "a macro call holds one surface" => "write another `implicit! {{ … }}` for this one";
    /// `sin^2(x)`
    power_of_function(name: &str, power: &str) "a power stands behind the brackets of a function"
        => "write `{name}(…)^{power}`";
    /// `sum i in 0..8 { … }`
    fold_brackets(name: &str) "expected brackets after `{name}`" => "write `{name}(i in 0..8) {{ … }}`";
    /// `sum(i = 0..8) { … }`, `sum(a, b in t) { … }`
    fold_header(instead: &str) "expected a name, `in`, and a range or a table" => "write `{instead}`";
    /// `sum(i in 0..8, i*x)`
    fold_value(name: &str) "the value of a fold stands in a block behind its brackets"
        => "write `{name}(…) {{ … }}`";
    /// `if x > 0 { y } elif z > 0 { z } else { x }`
    else_if(word: &str) "`{word}` is not part of a formula" => "write `else if`";
    /// 2,000 `let`s, each made of the one before.
    lets_too_deep(most: u32) "the `let`s up to here are nested deeper than {most} levels"
        => "fold over a range or a table";
    /// 300 brackets.
    too_deep(most: u16) "this formula is nested deeper than {most} levels" => "name parts of it with `let`";
}
