use zeroset::implicit;

implicit! {
    pub struct A;
    sin + x
}

implicit! {
    pub struct B;
    sum + x
}

fn main() {}
