use zeroset::implicit;

implicit! {
    pub struct A;
    x^2 +
}

implicit! {
    pub struct B;
    * x
}

implicit! {
    pub struct C;
    let a = ;
    x
}

implicit! {
    pub struct D;
    max(x,, y)
}

fn main() {}
