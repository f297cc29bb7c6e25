use zeroset::{implicit, surface::Surface};

fn main() {
    let radius = 0.8;
    let ball = implicit!(x^2 + y^2 + z^2 = 2radius + sine(x));
    println!("{}", ball.at([0.0, 0.0, 0.0]));
    let empty = implicit!();
    println!("{}", empty.at([0.0, 0.0, 0.0]));
}
