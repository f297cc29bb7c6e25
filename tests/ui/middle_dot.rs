use zeroset::implicit;

implicit! {
    pub struct A;
    x·y
}

fn main() {}
