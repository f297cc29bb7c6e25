use zeroset::implicit;

implicit! {
    pub struct A;
    /// a distance
    let a = x;
    a
}

implicit! {
    pub struct B { #[domain(x in 0..1, y in 0..1, z in 0..1)] pub r: f64 }
    x = r
}

fn main() {}
