//! Folds as other languages write them.

zeroset::implicit! {
    struct Headers { t: [[f64; 2]; 8] }
    sum(i = 0..8) { i*x }
        + sum(i, 0, 8) { i*y }
        + sum(i = 0, 8, i*z)
        + sum(a, b in t) { a*x + b }
        + sum((a, b) in t) { a*x + b }
        + sum i in 0..8 { i*x }
        + sum(i in 0..8, i*y)
        + sum(i in 0..t.len()) { t[i][0] }
}

fn main() {}
