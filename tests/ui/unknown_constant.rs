use zeroset::implicit;

implicit! {
    pub struct A;
    sin(PI*x)
}

implicit! {
    pub struct B;
    e^x = y
}

fn main() {}
