use zeroset::implicit;

implicit! {
    pub struct A;
    x^1e9
}

implicit! {
    pub struct B;
    x + 1e400
}

implicit! {
    pub struct C;
    x + 1e-400
}

fn main() {}
