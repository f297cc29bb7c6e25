use zeroset::implicit;

implicit! {
    pub struct A;
    x % 2
}

fn main() {}
