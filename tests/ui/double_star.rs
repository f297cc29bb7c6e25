use zeroset::implicit;

implicit! {
    pub struct A;
    x**2 + y**2 = 1
}

fn main() {}
