use zeroset::implicit;

implicit! {
    pub struct A;
}

implicit! {
    pub struct B { pub r: f64 }
}

fn main() {}
