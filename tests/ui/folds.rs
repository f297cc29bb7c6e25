use zeroset::implicit;

implicit! {
    pub struct A;
    mean(i in 0..8) { i*x }
}

implicit! {
    pub struct B;
    sum(i in 0..8, j in 0..8) { i*j*x }
}

implicit! {
    pub struct C;
    sum(i in 0..8) i*x
}

implicit! {
    pub struct D;
    sum(i in 0..8) { i*x } + i
}

fn main() {}
