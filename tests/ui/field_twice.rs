use zeroset::implicit;

implicit! {
    pub struct A {
        pub r: f64,
        pub s: f64,
        pub r: f64,
    }
    x = r*s
}

fn main() {}
