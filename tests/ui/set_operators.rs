use zeroset::implicit;

implicit! {
    pub struct A;
    x | y
}

implicit! {
    pub struct B;
    x & y
}

implicit! {
    pub struct C;
    !x
}

fn main() {}
