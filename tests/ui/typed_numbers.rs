use zeroset::implicit;

implicit! {
    pub struct A;
    2f32*x
}

implicit! {
    pub struct B;
    x as f64 + y
}

implicit! {
    pub struct C;
    0xff*x
}

fn main() {}
