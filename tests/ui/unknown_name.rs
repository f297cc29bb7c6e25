use zeroset::implicit;

implicit! {
    pub struct Ball { pub radius: f64 }
    x^2 + y^2 + z^2 = radus^2
}

fn main() {}
