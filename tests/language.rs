//! What formulas are worth: the rules of the language, each by the value of a formula at a point.

use zeroset::implicit;
use zeroset::surface::Surface;

/// The value of an expression form at (3, −2, 0.5). In braces, which rustfmt leaves alone: to it `^` is exclusive or.
macro_rules! value {
    ($($formula:tt)*) => { implicit!($($formula)*).at([3.0, -2.0, 0.5]) };
}

#[test]
fn precedence() {
    assert_eq!(value! { -x^2 }, -9.0);
    assert_eq!(value! { x*0 + 2^3^2 }, 512.0);
    assert_eq!(value! { x - y - z }, 4.5);
    assert_eq!(value! { x/y*z }, -0.75);
    assert_eq!(value! { -x*-y }, -6.0);
    assert_eq!(value! { 2*x^2 + y }, 16.0);
    assert_eq!(value! { (x + y)^2*z }, 0.5);
    assert_eq!(value! { z^-2 }, 4.0);
    assert_eq!(value! { 2^-x }, 0.125);
    assert_eq!(value! { 2^-z^2*x }, 3.0 * 2.0_f64.powf(-0.25));
}

#[test]
fn an_equation_may_begin_with_a_fold() {
    implicit! { struct Nearest { rows: [[f64; 2]] } min([c, r] in rows) { (x - c)^2 - r } = 1 }
    let nearest = Nearest {
        rows: vec![[0.0, 1.0], [3.0, 2.0]],
    };
    assert_eq!(nearest.at([2.0, 0.0, 0.0]), -2.0);
}

#[test]
fn equations_are_differences() {
    assert_eq!(value! { x^2 = y }, 11.0);
    assert_eq!(value! { max({ x = y }, z) }, 5.0);
}

#[test]
fn numbers() {
    assert_eq!(value! { x*0 + 1_000.5e-1 }, 100.05);
    assert_eq!(value! { x*.5 }, 1.5);
    assert_eq!(value! { x*pi }, 3.0 * std::f64::consts::PI);
    assert_eq!(value! { x*tau }, 3.0 * std::f64::consts::TAU);
}

#[test]
fn lets_and_blocks() {
    assert_eq!(
        value! { let a = x + y; let b = a*z; let a = a + b; a*b },
        0.75
    );
    assert_eq!(value! { { let a = x; a^2 } + { let a = y; a^3 } }, 1.0);
    assert_eq!(value! { let max = x; max(max, y) }, 3.0);
}

#[test]
fn functions_and_methods() {
    assert_eq!(value! { hypot(x, y*2) - x.hypot(4) }, 0.0);
    assert_eq!(value! { (x + y).max(z).abs() }, 1.0);
    assert_eq!(
        value! { clamp(x, -1, 1) + clamp(y, -1, 1) + clamp(z, -1, 1) },
        0.5
    );
    assert_eq!(value! { -y.abs() }, -2.0);
    assert_eq!(value! { atan2(y, x) }, (-2.0_f64).atan2(3.0));
}

#[test]
fn branches() {
    assert_eq!(value! { if x > 0 { x } else { y } }, 3.0);
    assert_eq!(
        value! { if x < 0 || y < 0 && z >= 1 { x } else { y } },
        -2.0
    );
    assert_eq!(
        value! { if (x < 0 || y < 0) && z <= 1 { x } else { y } },
        3.0
    );
    assert_eq!(
        value! { if x < 0 { 1 } else if y < 0 { 2 } else { 3 } + x },
        5.0
    );
}

#[test]
fn folds() {
    assert_eq!(value! { sum(i in 0..4) { i*x } }, 18.0);
    assert_eq!(value! { prod(j in -2..0 + 1) { x - j } }, 60.0);
    assert_eq!(value! { min(i in 0..4) { (x - i)^2 } }, 0.0);
    assert_eq!(value! { max(i in 1..4) { i*y } }, -2.0);
    assert_eq!(
        value! { sum(i in 0..2) { i*sum(i in 5..7) { i*x } + i } },
        34.0
    );
    assert_eq!(value! { let n = 2; sum(_ in 0..2*n) { x } }, 12.0);
}

implicit! {
    struct Tables {
        t: [f64; 3] = [1, 2.5, -1/2],
        u: [[f64; 2]] = [[1, 2], [3, 4], [5; 2]],
        v: [[[f64; 2]; 2]; 3] = [[[1; 2]; 2]; 3],
    }
    x*sum(a in t) { a }
        + sum([a, b] in u) { a*b }
        + sum(r in u) { r[0] - r[1] }
        + sum(i in 0..2) { t[i + 1]*u[i][1] + sum([a, _] in v[i]) { a } }
}

#[test]
fn tables() {
    let sound = Tables::default();
    assert_eq!(
        sound.at([3.0, -2.0, 0.5]),
        9.0 + 39.0 - 2.0 + (5.0 - 2.0) + 4.0
    );
    let other = sound.with_t([0.0; 3]).with_u(vec![[2.0, 3.0]; 2]);
    assert_eq!(other.at([3.0, -2.0, 0.5]), 12.0 - 2.0 + 4.0);
}

implicit! {
    #[domain(z in -2*pi..2*pi, x in -1..1, y in -1.5..1)]
    struct Boxed { k: f64 = 2*sqrt(4) }
    x*k
}

#[test]
fn defaults_and_domain() {
    assert_eq!(Boxed::default().k, 4.0);
    let [lower, upper] = Boxed::default().domain().unwrap();
    assert_eq!(
        (lower[0], lower[1], upper[0], upper[1]),
        (-1.0, -1.5, 1.0, 1.0)
    );
    // π is not an f64: the box is rounded outward, by no more than two neighbours.
    let end = 2.0 * std::f64::consts::PI;
    assert!(
        (end..=end.next_up().next_up()).contains(&upper[2]),
        "{}",
        upper[2]
    );
    assert_eq!(lower[2], -upper[2]);
}

#[test]
fn captured_locals_stand_for_themselves() {
    let (radius, e) = (2.0, 0.25);
    let ball = implicit!(x ^ 2 + y ^ 2 + z ^ 2 = radius ^ 2 + e);
    assert_eq!(ball.at([2.0, 0.0, 0.0]), -0.25);
}
