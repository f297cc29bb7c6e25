use zeroset::implicit;

mod surfaces {
    zeroset::implicit! {
        pub struct Ball { radius: f64 = 1 }
        x^2 + y^2 + z^2 = radius^2
    }
}

implicit! { struct Plane; z }

fn main() {
    let _ = Plane;
    let _ = surfaces::Ball { radius: 2.0 };
}
