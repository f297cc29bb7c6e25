use zeroset::implicit;

implicit! {
    pub struct A { pub r: f64 }
    r^2 - 1
}

fn main() {}
