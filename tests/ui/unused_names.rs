#![deny(warnings)]

use zeroset::implicit;

implicit! {
    struct Unused { radius: f64 = 1, spare: f64 = 2 }
    let used = x + 1;
    let idle = x + 2;
    used^2 + { let inside = y; z^2 } = radius^2 + sum(k in 0..3) { z }
}

fn main() {
    let _ = zeroset::Surface::at(&Unused::default(), [0.0; 3]);
}
