//! The struct.

use crate::diagnostic::{Diagnostic, Place};

messages! {
    /// `pub enum S`
    not_a_struct() "expected `struct`";
    /// `S { r: f64 }`
    struct_missing(name: &str) "expected `struct` before `{name}`";
    /// `struct S { x^2 = 1 }`
    formula_as_field() "expected a field, found a formula" => "the formula stands behind the braces";
    /// `struct S { r: f64 }; x`
    semicolon() "no `;` stands between the fields and the formula" => "remove the `;`";
    /// `struct ;`
    struct_name() "expected the surface's name after `struct`";
    /// `struct S<T>`
    generics() "a surface has no type parameters" => "numbers are `f64`";
    /// `struct S(f64);`
    tuple_struct() "fields of a surface need names" => "write `{{ r: f64 }}`";
    /// `struct S x`
    struct_end() "expected `;` or fields in braces after this";
    /// `#![allow(…)]`
    inner_attribute() "inner attributes are not possible here" => "write `#[…]`";
    /// `struct S { 2: f64 }`
    field_name(found: &str) "expected the name of a field, found `{found}`";
    /// `z: f64`
    field_hides_coordinate(name: &str) "field `{name}` hides the coordinate `{name}`" => "choose another name";
    /// `pi: f64`
    field_hides_constant(name: &str) "field `{name}` hides the constant `{name}`" => "choose another name";
    /// `r` twice
    field_twice(name: &str, first: &str) "field `{name}` is declared twice" => "first declared {first}";
    /// `r = 1`
    field_without_type(name: &str) "field `{name}` has no type" => "write `{name}: f64`";
    /// `r: f32`
    field_type() "the numbers of a field must be `f64`" => "enclosures are computed in `f64`";
    /// `r: Vec<f64>`
    field_vec() "this type is not a number or a table"
        => "a number is `f64`, a table `[f64; 8]`, or `[f64]` if its length is open";
    /// `t: [[f64]; 3]`
    ragged() "only the outermost length of a table may be left open" => "write the length: `[f64; n]`";
    /// `t: [f64; N]`
    table_length() "the length of a table must be a whole number";
    /// `t: f64[8]`, `t: [f64, 8]`
    table_form(length: &str) "a table and its length are joined by `;`" => "write `[…; {length}]`";
    /// `t: [f64; 0]`
    table_empty() "this table is empty";
    /// `t: [f64; 1000000000000]`
    table_too_long(most: usize) "this table has more than {most} rows";
    /// `a: f64 b: f64`
    field_end(found: &str) "expected `,` after this field, found `{found}`";
    /// `r: f64 = x`
    default_point() "a default cannot depend on the point";
    /// `r: f64 = s`
    default_field(name: &str) "a default cannot depend on the field `{name}`";
    /// `r: f64 = if … { … } else { … }`
    default_kind() "a default is made of numbers, constants and functions only";
    /// `r: f64 = [1, 2]`
    default_list(shape: &str) "expected {shape}, found a list";
    /// `t: [f64; 2] = 1`
    default_not_list(shape: &str) "expected {shape}, found a number" => "a table is written as a list: `[1, 2, 3]`";
    /// `t: [f64; 2] = [1, 2, 3]`
    default_length(found: &str, wanted: usize) "this list has {found}, but the table has {wanted}";
    /// `#[domain(x in -1..1)]`
    domain_axes() "a domain needs all three axes" => "`#[domain(x in -1..1, y in -1..1, z in -1..1)]`";
    /// `#[domain(x in 1, …)]`
    domain_interval() "expected an interval" => "write `-1..1`";
    /// `#[domain(x in -1..=1, …)]`
    domain_closed() "an interval is written with two dots" => "write `..`: both ends belong to the domain";
    /// `#[domain]` twice
    domain_twice() "the domain is given twice";
    /// `struct S { #[domain(…)] r: f64 }`
    domain_of_field() "the domain belongs to the struct" => "write it before `struct`";
    /// `#[domain(x in 1..-1, …)]`
    domain_empty() "this interval is empty" => "the lower bound stands first: `-1..1`";
    /// `#[domain(x in k..1, …)]`
    domain_bound() "a bound of the domain is made of numbers, constants and functions only";
}
