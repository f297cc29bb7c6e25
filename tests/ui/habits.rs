//! Notations of mathematics and of other languages.

zeroset::implicit! { struct Powers; sin^2(x) + cos^2(y) }
zeroset::implicit! { struct Bare; sqrt x + y }
zeroset::implicit! { struct Named; f(x, y, z) = x^2 + y^2 + z^2 - 1 }
zeroset::implicit! { struct Quoted; "x^2 + y^2 + z^2 - 1" }
zeroset::implicit! { struct Point; p.x^2 + p.y^2 + p.z^2 - 1 }
zeroset::implicit! { struct Words; if x > 0 and not y > 0 { x } elif x < 0 or z > 0 { y } else { z } }
zeroset::implicit! { struct Then; if x > 0 then { x } else { z } }

fn main() {}
