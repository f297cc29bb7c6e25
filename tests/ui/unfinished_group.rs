use zeroset::implicit;

implicit! {
    pub struct A;
    sin(x +) + max(, y) + (z = 1)
}

fn main() {}
