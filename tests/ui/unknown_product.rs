use zeroset::implicit;

implicit! {
    pub struct A;
    xy = 1
}

implicit! {
    pub struct B { pub k: f64 }
    sin(kx) + cos(ky)
}

fn main() {}
