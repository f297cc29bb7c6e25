use zeroset::implicit;

implicit! {
    pub struct A { pub r: f64 = x }
    x = r
}

implicit! {
    pub struct B { pub r: f64 = 2*s, pub s: f64 = 1 }
    x = r*s
}

implicit! {
    pub struct C { pub t: [f64; 3] = [1, 2] }
    x = t[0]
}

fn main() {}
