use zeroset::implicit;

implicit! {
    pub struct Many { pub radius: f64, pub t: [f64; 3] }
    let a = 2x;
    let b = sine(y) % 2;
    a*b + t[3] + radus = PI**2
}

fn main() {}
