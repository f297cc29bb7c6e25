use zeroset::implicit;

implicit! {
    pub struct Torus { pub major: f64, pub minor: f64 = 0.5 }
    (sqrt(x^2 + y^2) - major)^2 + z^2 = minor^2
}

fn main() {
    let torus = Torus { minor: 1.0 };
    let other = Torus::default();
}
