use zeroset::implicit;

implicit! {
    pub struct A;
    let x = y;
    z
}

implicit! {
    pub struct B { pub z: f64 }
    x + y
}

implicit! {
    pub struct C { pub r: f64 }
    let r = x;
    r
}

fn main() {}
