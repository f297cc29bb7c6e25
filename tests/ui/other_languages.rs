//! What people bring along from other languages.

mod a {
    zeroset::implicit! { struct S; x^2 + y^2 = 1,5 }
}

mod b {
    zeroset::implicit! { struct S { c: [f64; 2] } let [a, b] = c; (x - a)^2 + (y - b)^2 = 1 }
}

mod c {
    zeroset::implicit! { struct S; y if x > 0 else z }
}

mod d {
    zeroset::implicit! { struct S; let f = |t| t^2; f(x) + f(y) = 1 }
}

mod e {
    zeroset::implicit! { struct S; return x^2 + y^2 = 1 }
}

mod f {
    zeroset::implicit! { Sphere; x^2 + y^2 + z^2 = 1 }
}

mod g {
    zeroset::implicit! { struct Sphere { r: f64 } x^2 + y^2 + z^2 = Sphere.r^2 }
}

mod h {
    zeroset::implicit! { struct S; sqrt{x} + (y mod 2) + (not z) }
}

fn main() {}
