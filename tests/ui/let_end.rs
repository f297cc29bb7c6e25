use zeroset::implicit;

implicit! {
    pub struct A;
    let a = x^2
    a - y
}

fn main() {}
