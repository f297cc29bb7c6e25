//! Where f asks for the sign of a minimum or maximum alone, numbers whose sign is certain may be left out; nowhere else.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used)]

use zeroset_compiler::expand;

const BALL: &str = "let a = (x - 1)^2 + y^2 + z^2 - 1; let b = (x + 1)^2 + y^2 + z^2 - 1; let c = x^2 + y^2 + z^2 - 2;";

/// How many choices between two numbers the code tells by their sign, and how many folds.
fn told(formula: &str) -> [usize; 2] {
    let source = format!("zeroset struct F {{ rows: [[f64; 4]] }} {BALL} {formula}");
    let code = expand(source.parse().unwrap()).to_string();
    assert!(!code.contains("compile_error"), "{formula}: {code}");
    let folds = code.matches("to . candidate").count();
    let by_value = code
        .split("to . candidate")
        .skip(1)
        .filter(|rest| rest.split(';').next().unwrap().contains("false"))
        .count();
    [code.matches("to . by_sign").count(), folds - by_value]
}

#[test]
fn signs_do_where_f_has_no_use_for_values() {
    let ball = "(x - p)^2 + (y - q)^2 + (z - r)^2 - s";
    let fold = |kind: &str| format!("{kind}([p, q, r, s] in rows) {{ {ball} }}");
    let (least, most) = (fold("min"), fold("max"));
    // The formula, choices by sign, folds by sign.
    let cases = [
        ("min(a, b)".to_owned(), 1, 0),
        ("max(min(a, b), -c)".to_owned(), 2, 0),
        ("-2*min(a, max(b, c)/3) = 0".to_owned(), 2, 0),
        (least.clone(), 0, 1),
        (most, 0, 1),
        (format!("max({least}, c)"), 1, 1),
        // An offset, a blend and a product ask for the value.
        ("min(a, b) - 0.1".to_owned(), 0, 0),
        ("min(a, b) = c".to_owned(), 0, 0),
        (format!("{least} = 0.1"), 0, 0),
        (format!("{least} * c"), 0, 0),
        ("sin(min(a, b))".to_owned(), 0, 0),
        // So does another use of the same number, or of the same comparison.
        ("max(min(a, b), c + min(a, b)/9)".to_owned(), 1, 0),
        (
            "max(min(a, b), c) + if a < b { 1 } else { 2 }".to_owned(),
            0,
            0,
        ),
        (
            "min(min(a, b), if a < b { c } else { -c })".to_owned(),
            1,
            0,
        ),
        (format!("max({least}, c - {least}^2)"), 1, 0),
    ];
    for (formula, choices, folds) in cases {
        assert_eq!(told(&formula), [choices, folds], "{formula}");
    }
}
