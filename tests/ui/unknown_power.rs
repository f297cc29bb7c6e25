use zeroset::implicit;

implicit! {
    pub struct A;
    x2 + y2 = 1
}

fn main() {}
