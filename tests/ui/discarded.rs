use zeroset::implicit;

implicit! {
    pub struct A;
    x + y;
}

implicit! {
    pub struct B;
    a = x + y;
    a^2
}

fn main() {}
