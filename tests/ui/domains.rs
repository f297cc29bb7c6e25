use zeroset::implicit;

implicit! {
    #[domain(x in -1..1)]
    pub struct A;
    x
}

implicit! {
    #[domain(x in 1..-1, y in -1..1, z in -1..1)]
    pub struct B;
    x
}

fn main() {}
