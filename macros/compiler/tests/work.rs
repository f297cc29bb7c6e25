//! What evaluations cost: of either side of a choice, and of rows.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used)]

use zeroset_compiler::expand;

/// The numbers in the constant `WORK`, in their order.
fn work(formula: &str) -> Vec<u32> {
    let source = format!("zeroset struct F {{ rows: [[f64; 4]] }} {formula}");
    let code = expand(source.parse().unwrap()).to_string();
    let constant = code.split("__zeroset :: Work {").nth(1).unwrap();
    let constant = constant.split('}').next().unwrap().replace("u32", " ");
    let words = constant.split(|c: char| !c.is_ascii_digit());
    words.filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn sides_cost_what_is_computed_for_them_only() {
    let waves = "sin(9*x)*cos(9*y) + sin(9*y)*cos(9*z) + sin(9*z)*cos(9*x)";
    let [whole, first, second] = work(&format!("max({waves}, x^2 + y^2 + z^2 - 1)"))[..] else {
        panic!("a choice")
    };
    // The ball decides where the waves are less.
    assert!(
        whole < 4 && first > 240 && 8 * second < first,
        "{whole} {first} {second}"
    );
}

#[test]
fn what_both_sides_need_is_of_neither() {
    let numbers = work("let q = exp(x*y*z); max(q*x, q*y) = 1");
    let [whole, first, second] = numbers[..] else {
        panic!("a choice")
    };
    assert!(whole > 40 && first < 40 && second < 40, "{numbers:?}");
}

#[test]
fn rows_cost_what_stands_in_their_loop() {
    let numbers =
        work("sum([a, b, c, d] in rows) { exp(-a*(x - b)^2 - (y - c)^2 - (z - d)^2) } = sqrt(x)");
    let [whole, row] = numbers[..] else {
        panic!("a list of rows")
    };
    assert!(row > 40 && whole < 20, "{numbers:?}");
}
