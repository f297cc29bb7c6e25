//! Numbers, tables and comparisons in each other's place.

use crate::diagnostic::{Diagnostic, Place};

messages! {
    /// `t*x`
    table_as_number(shape: &str) "expected a number, found {shape}";
    /// `x[0]`
    number_indexed() "a number has no elements" => "only fields that are tables can be indexed";
    /// `t(0)`
    table_called(name: &str) "`{name}` is a table, not a function" => "write `{name}[…]`";
    /// `t[r]`
    index() "this index is not known when the formula is compiled"
        => "an index is a whole number, or the variable of a fold over a range plus a constant";
    /// `r[i]` of a row `r`
    row_index() "a row can only be indexed by a whole number"
        => "index the table: `sum(i in 0..8) {{ sum(j in 0..3) {{ t[i][j] }} }}`";
    /// `t[8]`
    outside(shape: &str) "outside this {shape}";
    /// `a in r` of a number `r`
    fold_over_number() "expected a range or a table, found a number" => "write `0..8`, or the name of a table";
    /// `a in t` of a table of tables of tables
    fold_over_deep() "the rows of this table are tables themselves"
        => "fold over a range and index: `sum(i in 0..8) {{ sum([a, b] in t[i]) {{ … }} }}`";
    /// `a in r` of a row `r`
    fold_over_row() "the row of a fold cannot be folded"
        => "fold over a range and index: `sum(i in 0..8) {{ sum(a in t[i]) {{ … }} }}`";
    /// `[a, b] in t`
    pattern_length(names: &str, row: &str) "{names}, but each row has {row}";
    /// `[a] in t` of a table of numbers
    pattern_of_numbers(names: &str) "{names} in brackets, but each row is one number"
        => "write the name without brackets";
    /// `[a, b] in 0..8`
    pattern_of_range() "a range yields one number at a time" => "write `i in 0..8`";
    /// `x + (y < z)`
    comparison_as_number() "a comparison is not a number" => "write `if y < z {{ 1 }} else {{ 0 }}` for a number";
    /// `x^2 < 1`
    inequality() "a comparison is not a number" => "a surface is an equation: write `=`";
    /// `if x { … }`
    number_as_condition() "expected a comparison after `if`" => "write `x > 0`";
    /// `[1, 2] + x`
    list_as_number() "a list is not a number" => "tables are fields of the struct";
    /// `r^2 - 1`
    constant_formula() "this formula does not depend on `x`, `y` or `z`"
        => "its zero set is everything or nothing";
}
