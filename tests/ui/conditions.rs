use zeroset::implicit;

implicit! {
    pub struct A;
    if x { y } else { z }
}

implicit! {
    pub struct B;
    if 0 < x < 1 { y } else { z }
}

implicit! {
    pub struct C;
    x + (y < z)
}

implicit! {
    pub struct D;
    x > 0 ? y : z
}

fn main() {}
