use zeroset::implicit;

implicit! {
    pub struct A { pub n: f64 }
    sum(i in 0..n) { i*x }
}

implicit! {
    pub struct B;
    sum(i in 4..4) { i*x }
}

implicit! {
    pub struct C;
    sum(i in 0..=7) { i*x }
}

fn main() {}
