use zeroset::implicit;

implicit! {
    pub struct A<T> { pub r: f64 }
    x = r
}

implicit! {
    pub struct B(f64);
    x
}

implicit! {
    pub struct C x^2 = 1
}

fn main() {}
