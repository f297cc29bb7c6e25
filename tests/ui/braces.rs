//! The formula between the braces of the fields, and other ways to write the head.

zeroset::implicit! { struct Inside { r: f64, x^2 + y^2 + z^2 = r^2 } }
zeroset::implicit! { struct Alone { x^2 + y^2 + z^2 = 1 } }
zeroset::implicit! { pub Nameless { r: f64 } x^2 + y^2 = r }
zeroset::implicit! { struct Closed { r: f64 }; x^2 + y^2 = r }
zeroset::implicit! { struct Semicolons { r: f64 = 1; s: f64 = 2 } x*r + s }
zeroset::implicit! { struct Tables { t: [f64, 8], u: f64[3] } x + t[0] + u[0] }
zeroset::implicit! { #[domain(x in -1..=1, y in -1..1, z in -1..1)] struct Ends; x }

fn main() {
    let _ = (Alone, Closed { r: 1.0 });
}
