//! The macro stands where items, statements and expressions stand.

#![forbid(unsafe_code)]
#![deny(warnings)]

use zeroset::implicit;
use zeroset::surface::Surface;

implicit! { pub struct Sphere; x^2 + y^2 + z^2 = 1 }

mod inner {
    zeroset::implicit! {
        /// A ring around the z axis.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Torus { pub major: f64 = 2, pub minor: f64 = 0.5 }
        let ring = sqrt(x^2 + y^2) - major;
        ring^2 + z^2 = minor^2
    }
}

macro_rules! ball {
    ($vis:vis $name:ident, $radius:expr) => {
        implicit! { $vis struct $name; x^2 + y^2 + z^2 = 2*$radius }
    };
}

ball!(pub(crate) Ball, 1 + 2);

fn main() {
    implicit! { struct Plane { height: f64 } z - height }
    let radius = 2.0;
    let captured = implicit!(x^2 + y^2 + z^2 = radius^2);
    assert_eq!(Sphere.at([2.0, 0.0, 0.0]), 3.0);
    assert_eq!(inner::Torus::default().at([2.0, 0.0, 0.0]), -0.25);
    assert_eq!(inner::Torus::default().with_minor(1.0).at([2.0, 0.0, 0.0]), -1.0);
    assert_eq!(Plane { height: 1.0 }.at([0.0, 0.0, 3.0]), 2.0);
    assert_eq!(captured.at([0.0, 0.0, 3.0]), 5.0);
    assert_eq!(Ball.at([0.0, 0.0, 0.0]), -6.0);
}
