use zeroset::implicit;

implicit! {
    pub struct A;
    if x > 0 { y }
}

fn main() {}
