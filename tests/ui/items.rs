//! Items inside a formula.

zeroset::implicit! {
    struct Items;
    use std::f64::consts::PI;
    const A: f64 = 2;
    let f(t) = t^2;
    fn g(t: f64) -> f64 { t*t }
    A*f(x) + g(y)
}

zeroset::implicit! {
    pub struct First; x^2 + y^2 = 1
    pub struct Second { pub r: f64 } x^2 + z^2 = r
}

fn main() {
    let _ = (Items, First);
}
