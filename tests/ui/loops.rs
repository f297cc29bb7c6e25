use zeroset::implicit;

implicit! {
    pub struct A;
    for i in 0..8 { x }
}

implicit! {
    pub struct B;
    while x > 0 { x }
}

fn main() {}
