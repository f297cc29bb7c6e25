use zeroset::implicit;

implicit! {
    pub struct A { pub t: [f64; 8] }
    t*x
}

implicit! {
    pub struct B { pub t: [f64; 8] }
    t[8]*x
}

implicit! {
    pub struct C { pub t: [f64; 8] }
    sum(i in 0..8) { t[i + 1]*x }
}

implicit! {
    pub struct D;
    x[0]
}

fn main() {}
