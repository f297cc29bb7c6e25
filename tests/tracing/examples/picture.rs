//! Renders the hand-written surfaces: `picture <folder> [size] [threads] [scene] [repeats]` writes PNG files and prints statistics.

use std::path::PathBuf;

use glam::DVec3;
use zeroset::camera::Camera;
use zeroset::render::{Options, render};
use zeroset::scene::Scene;
use zeroset::shade::Shading;
use zeroset_tracing_tests::dual::Hand;
use zeroset_tracing_tests::formulas::{Sphere, Torus};
use zeroset_tracing_tests::staged::{Ball, Blobs};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(
        arguments
            .next()
            .ok_or("usage: picture <folder> [size] [threads] [scene] [repeats]")?,
    );
    let size = arguments.next().map_or(Ok(512), |s| s.parse())?;
    let threads = arguments.next().map_or(Ok(1), |s| s.parse())?;
    let only = arguments.next();
    let repeats = arguments.next().map_or(Ok(5), |s| s.parse())?;
    let camera = Camera::perspective(DVec3::new(2.5, 1.8, 4.0), DVec3::ZERO, DVec3::Y, 40.0)?;
    let torus = || {
        Hand::new(
            Torus {
                major: 1.0,
                minor: 0.4,
            },
            2.0,
        )
    };
    let scenes = [
        (
            "ball",
            Scene::new().with(Ball {
                radius: 1.0,
                half: 2.0,
            }),
        ),
        ("sphere", Scene::new().with(Hand::new(Sphere(1.0), 2.0))),
        ("torus", Scene::new().with(torus())),
        ("blobs8", Scene::new().with(Blobs::some(8))),
        ("blobs64", Scene::new().with(Blobs::some(64))),
        (
            "two",
            Scene::new().with(torus()).with(Ball {
                radius: 0.8,
                half: 2.0,
            }),
        ),
    ];
    for (name, scene) in scenes {
        if only.as_deref().is_some_and(|o| o != name) {
            continue;
        }
        let mut options = Options::new(size, size);
        options.threads = Some(threads);
        let mut best = render(&scene, &camera, &options)?;
        for _ in 1..repeats {
            let again = render(&scene, &camera, &options)?;
            if again.statistics().phases.roots < best.statistics().phases.roots {
                best = again;
            }
        }
        println!("{name}: {}\n", best.statistics());
        best.image(&Shading::default())
            .save(folder.join(format!("{name}.png")))?;
        best.verdict_image()
            .save(folder.join(format!("{name}-verdicts.png")))?;
    }
    Ok(())
}
