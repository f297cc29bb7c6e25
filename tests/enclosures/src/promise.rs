//! How wide enclosures of points may be.

use zeroset::interval::UNPROVED;

use crate::operation::Operation;

/// Operations whose code is monotone in the operands' bounds down to the last bit. For the others a computed bound of
/// f(x) may be beyond that of f(y) although f(x) < f(y), as long as both are bounds.
pub const MONOTONE: &[&str] = &[
    "neg",
    "nonneg",
    "sqr",
    "abs",
    "recip",
    "sqrt",
    "abs_slope",
    "add",
    "sub",
    "mul",
    "mul_pos",
    "mul_pos_pos",
    "min",
    "max",
    "hypot",
    "div",
    "powi",
];

/// The greatest width of the enclosure of a point, in doubles, where the value is a normal number: what the head of the
/// function's file derives.
pub fn width(name: &str, backend: &str) -> u64 {
    // One step outward, two without fused operations.
    let optimal = matches!(backend, "avx512" | "scalar");
    let fused = backend != "portable";
    if let Some(n) = name.strip_prefix("powi_") {
        return power_width(n.parse().unwrap_or_default(), optimal);
    }
    match name {
        // Neighbouring doubles; a unit more on each side where they are widened, and for tiny factors in `Scalar`.
        "add" | "sub" | "sqrt" if optimal => 1,
        "sqr" | "recip" | "mul" | "div" if backend == "avx512" => 1,
        "add" | "sub" | "sqrt" | "sqr" | "recip" | "mul" | "div" => 2,
        "exp" | "atan" | "asin" | "acos" | "cbrt" => 2,
        "ln" | "sin" | "cos" if fused => 2,
        "ln" | "sin" | "cos" => 4,
        "ln_1p" | "asinh" | "acosh" | "atanh" => 2,
        "tan" | "exp_m1" | "sinh" | "tanh" => 4,
        "pow" if fused => 4,
        "pow" => 6,
        // Where the quotient is tiny.
        "atan2" => 6,
        "exp2" => 4,
        "log2" | "log10" if optimal => 6,
        "log2" | "log10" if fused => 7,
        "log2" | "log10" => 11,
        "cosh" if optimal => 3,
        "cosh" => 5,
        "hypot" if optimal => 4,
        "hypot" => 10,
        _ => 12,
    }
}

/// For xⁿ in units u of the value, of which 1 to 2 are a unit in the last place. Each of the n − 1 roundings (a square
/// doubles those of its root) takes 2u from either bound where instructions round; else they take u from both alike and the
/// step at the end takes n from either. A reciprocal rounds once more, and is widened.
fn power_width(n: i32, optimal: bool) -> u64 {
    let roundings = u64::from(n.unsigned_abs()) - 1;
    let reciprocal = u64::from(n < 0);
    if optimal {
        4 * (roundings + reciprocal)
    } else {
        2 * (roundings + 1) + 4 * reciprocal + 2
    }
}

/// By how many doubles the bounds over an interval may fall short of those over a part of it.
pub fn slack(name: &str) -> u64 {
    if name == "mul_pos" || name == "mul_pos_pos" {
        // 0·∞ is 0, where 0·x may be widened to the smallest subnormal.
        1
    } else if name == "hypot" {
        // One number alone steps outward where a square's rest underflows, and not where the square is 0.
        1
    } else if MONOTONE.contains(&name) {
        0
    } else {
        width(name, "portable")
    }
}

/// All operations by name, with some whole powers.
pub fn operations() -> Vec<(String, Operation)> {
    let mut all: Vec<(String, Operation)> = Operation::ALL
        .iter()
        .map(|&(name, operation)| (name.to_owned(), operation))
        .collect();
    for n in [0, 1, 3, 4, 5, 7, 12] {
        all.push(("powi".to_owned(), Operation::Powi(n)));
    }
    for n in [-1, -2, -3] {
        all.push(("powi".to_owned(), Operation::Pown(n)));
    }
    all
}

/// Has the enclosure of this function a proof?
pub fn is_proved(name: &str) -> bool {
    !UNPROVED.contains(&name)
}
