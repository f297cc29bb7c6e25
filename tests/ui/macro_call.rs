use zeroset::implicit;

implicit! {
    pub struct A;
    vec![x]
}

fn main() {}
