use zeroset::implicit;

implicit! {
    pub struct A;
    x(y + 1)
}

fn main() {}
