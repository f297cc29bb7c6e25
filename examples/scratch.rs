//! Scratch.
#![deny(warnings)]
#![warn(unused)]
use zeroset::{Surface, implicit};
implicit! { struct Unused { radius: f64 = 1, spare: f64 = 2 }
    let a = x + 1;
    let b = x + 2;
    let c = { let d = y; let e = y^2; e };
    b^2 + c = radius^2 + sum([p, q] in 0..3) { p } }
implicit! { struct Fine { radius: f64 = 1/3, t: [[f64; 2]; 2] = [[1, 2], [3, -4]] }
    let s = x; let s = s + y;
    (if s > 0 && y < 2 { s } else { -s }).max(z.sin())^2 + sum([_, q] in t) { q } + sum(i in 0..2) { t[i][0]*i } = radius^(1/2) }
fn main() {
    println!("{} {}", Unused::default().at([1., 2., 3.]), Fine::default().at([1.,2.,3.]));
}
