use zeroset::implicit;

implicit! {
    pub struct A;
    x^2 == y
}

implicit! {
    pub struct B;
    x^2 + y^2 < 1
}

implicit! {
    pub struct C;
    if x == 0 { y } else { z }
}

fn main() {}
