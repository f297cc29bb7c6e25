use zeroset::implicit;

implicit! {
    pub struct A;
    2x + y
}

implicit! {
    pub struct B;
    x y
}

implicit! {
    pub struct C;
    2(x + y)
}

implicit! {
    pub struct D;
    (x + 1)(y + 1)
}

fn main() {}
