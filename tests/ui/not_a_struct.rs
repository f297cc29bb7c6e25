use zeroset::implicit;

implicit! {
    pub enum A { B }
    x
}

implicit! {
    pub x^2 = 1
}

fn main() {}
