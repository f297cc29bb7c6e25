//! A casting: a body that is cut open, hollowed and drilled. Faces of the cut are red, those of the bores blue. The
//! report tells how much of its box is certainly empty.
//!
//! `cargo run --release --example solid` writes `solid.png`; a name and a size may follow.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use zeroset::glam::{DAffine3, DVec3, Vec3, dvec3};
use zeroset::{Camera, Operand, Options, Scene, Shading, Solid, implicit, render};

implicit! { struct Ball { radius: f64 = 1 } x^2 + y^2 + z^2 = radius^2 }

// Rounded, and flat on all six sides.
implicit! { struct Block { half: f64 = 0.82 } (x/half)^8 + (y/half)^8 + (z/half)^8 = 1 }

implicit! { struct Bore { radius: f64 = 0.3 } x^2 + y^2 = radius^2 }

// The points below z = 0.
implicit! { struct Below; z = 0 }

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "solid.png".to_owned());
    let size = arguments.next().map_or(Ok(800), |size| size.parse())?;

    let (casting, domain) = (casting(), [[-1.0; 3], [1.0; 3]]);
    let volume = casting.volume(domain, 7)?;
    println!("{}", casting.operands().collect::<Vec<_>>().join(", "));

    let scene = Scene::new().with(casting).within(domain[0], domain[1]);
    let camera = Camera::perspective(dvec3(2.9, 2.0, 2.2), DVec3::ZERO, DVec3::Z, 36.0)?;
    let picture = render(&scene, &camera, &Options::new(size, size))?;
    picture.image(&Shading::default()).save(&name)?;
    println!("{}", picture.statistics());

    let whole = (volume.inside.lo + volume.outside.lo + volume.undecided.lo) / 100.0;
    println!(
        "of the box, {:.2} % are certainly solid and {:.2} % certainly empty; {:.2} % hold the boundary",
        volume.inside.lo / whole,
        volume.outside.lo / whole,
        volume.undecided.hi / whole
    );
    println!("{name}");
    Ok(())
}

/// Colours are linear. What was given one keeps it.
fn casting() -> Solid {
    let (grey, blue, red) = (
        Vec3::new(0.62, 0.60, 0.55),
        Vec3::new(0.05, 0.20, 0.50),
        Vec3::new(0.65, 0.07, 0.04),
    );
    let body = (Block::default() & Ball { radius: 1.08 }).coloured(grey);
    let hollow = Ball { radius: 0.62 }.coloured(Vec3::new(0.75, 0.5, 0.12));
    // Upright, and lying along x and along y.
    let along_x = DAffine3::from_rotation_y(FRAC_PI_2);
    let along_y = DAffine3::from_rotation_x(FRAC_PI_2);
    let bores = Bore::default()
        | Bore { radius: 0.22 }.placed(along_x)
        | Bore { radius: 0.22 }.placed(along_y);
    // An eighth of space, away from the origin.
    let corner = !Below & !Below.placed(along_x) & !Below.placed(along_y.inverse());
    let corner = corner.placed(DAffine3::from_translation(dvec3(0.05, 0.05, 0.05)));
    body - hollow - bores.coloured(blue) - corner.coloured(red)
}
