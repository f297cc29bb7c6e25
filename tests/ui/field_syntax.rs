use zeroset::implicit;

implicit! {
    pub struct A { pub a: f64 pub b: f64 }
    x = a + b
}

implicit! {
    pub struct B { pub 2: f64 }
    x
}

implicit! {
    pub struct C { pub t: [f64; 0] }
    x
}

fn main() {}
