use zeroset::implicit;

implicit! {
    pub struct A;
    x/(2 - 2)
}

implicit! {
    pub struct B;
    x + sqrt(-2)
}

implicit! {
    pub struct C;
    x + (-8)^(1/3)
}

implicit! {
    pub struct D;
    x + ln(0)
}

fn main() {}
