use zeroset::implicit;

implicit! {
    pub struct A;
    f64::sin(x)
}

implicit! {
    pub struct B;
    2*std::f64::consts::PI*x
}

implicit! {
    pub struct C { pub r: f64 }
    x = self.r
}

fn main() {}
