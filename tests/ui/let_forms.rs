use zeroset::implicit;

implicit! {
    pub struct A;
    let mut a = x;
    a
}

implicit! {
    pub struct B;
    let a: f64 = x;
    a
}

implicit! {
    pub struct C;
    let (a, b) = x;
    y
}

fn main() {}
