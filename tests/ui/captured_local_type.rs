use zeroset::{implicit, surface::Surface};

fn main() {
    let radius: f32 = 0.8;
    let ball = implicit!(x^2 + y^2 + z^2 = radius^2);
    println!("{}", ball.at([0.0, 0.0, 0.0]));
}
