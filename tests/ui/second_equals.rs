use zeroset::implicit;

implicit! {
    pub struct A;
    x = y = z
}

fn main() {}
