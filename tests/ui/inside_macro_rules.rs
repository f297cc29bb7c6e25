use zeroset::implicit;

macro_rules! ball {
    ($name:ident, $radius:expr, $unknown:ident) => {
        implicit! { pub struct $name; x^2 + y^2 + z^2 = $radius^2 + $unknown }
    };
}

ball!(Sound, 1 + 2, pi);
ball!(Unsound, 1 + 2, radus);

fn main() {}
