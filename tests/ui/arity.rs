use zeroset::implicit;

implicit! {
    pub struct A;
    atan2(y)
}

implicit! {
    pub struct B;
    max(x, y, z)
}

implicit! {
    pub struct C;
    x.sin(y)
}

fn main() {}
