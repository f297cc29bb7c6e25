use zeroset::{implicit, surface::Surface};

implicit! {
    #[derive(Clone, Debug)]
    pub struct Ball { pub radius: f64 = 1, pub centre: [f64; 3] = [0, 0, 0] }
    x^2 + y^2 + z^2 = radus^2
}

fn main() {
    let ball = Ball::default().with_radius(2.0);
    let value: f64 = ball.at([ball.radius, ball.centre[0], 0.0]);
    println!("{value} {ball:?}");
}
