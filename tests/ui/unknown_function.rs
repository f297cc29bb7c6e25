use zeroset::implicit;

implicit! {
    pub struct A;
    sine(x)
}

implicit! {
    pub struct B;
    pow(x, 2) + y
}

implicit! {
    pub struct C;
    floor(x)
}

implicit! {
    pub struct D;
    log(x)
}

fn main() {}
