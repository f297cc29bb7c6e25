use zeroset::implicit;

implicit! {
    pub struct A { pub r = 1 }
    x = r
}

implicit! {
    pub struct B { pub r: f32 }
    x = r
}

implicit! {
    pub struct C { pub t: Vec<f64> }
    x = t[0]
}

implicit! {
    pub struct D { pub t: [[f64]; 3] }
    x
}

fn main() {}
