use zeroset::implicit;

implicit! {
    pub struct A { pub t: [[f64; 3]; 8] }
    sum([a, b] in t) { a*x + b }
}

implicit! {
    pub struct B { pub t: [f64; 3] }
    sum([a] in t) { a*x }
}

implicit! {
    pub struct C { pub t: [[f64; 2]; 8] }
    sum([a, a] in t) { a*x }
}

fn main() {}
