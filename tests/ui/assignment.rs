use zeroset::implicit;

implicit! {
    pub struct A { pub a: f64 }
    a += y
}

fn main() {}
