//! From the arguments to the two pictures.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use glam::{DVec3, Vec3};
use image::RgbImage;
use indicatif::{ProgressBar, ProgressStyle};
use zeroset::camera::Camera;
use zeroset::certificate;
use zeroset::contract::{Auto, Bisection, Halley, Newton, Tightened};
use zeroset::render::{Options, Progress, Rendering, render};
use zeroset::scene::Scene;
use zeroset::shade::Shading;

use crate::arguments::{Arguments, Solver};
use crate::failure::Failure;
use crate::family::{Form, SumOfExpQuadrics, quadratics};
use crate::random::Random;

const FROM: DVec3 = DVec3::new(2.6, -4.4, 2.5);
const AT: DVec3 = DVec3::new(0.0, 0.0, -0.03);

/// The surface that the arguments describe.
fn surface(arguments: &Arguments) -> SumOfExpQuadrics {
    let mut random = Random::new(arguments.seed);
    let terms = quadratics(&mut random, arguments.terms, Form::NegativeDefinite);
    SumOfExpQuadrics { terms, level: 0.5 }
}

fn camera() -> Result<Camera, Failure> {
    Ok(Camera::perspective(FROM, AT, DVec3::Z, 19.5)?)
}

/// Writes what the picture claims, with the numbers of its formula.
pub fn certify(arguments: &Arguments, path: &Path) -> Result<(), Failure> {
    let surface = surface(arguments);
    let bits = |x: &f64| format!("{:016x}", x.to_bits());
    let mut head = vec![format!("parameter level {}", bits(&surface.level))];
    head.extend(surface.terms.iter().map(|row| {
        let row: Vec<String> = row.iter().map(bits).collect();
        format!("row {}", row.join(" "))
    }));
    let options = Options::new(arguments.size, arguments.size);
    let file = File::create(path).map_err(Failure::write(path))?;
    let mut out = BufWriter::new(file);
    let scene = scene(surface, arguments.solver);
    Ok(certificate::write(
        &scene,
        &camera()?,
        &options,
        &head,
        &mut out,
    )?)
}

/// Renders it.
pub fn take(arguments: &Arguments) -> Result<Rendering, Failure> {
    let scene = scene(surface(arguments), arguments.solver);
    let camera = camera()?;
    let bar = progress_bar();
    let advance = |progress: Progress| {
        bar.set_length(progress.of as u64);
        bar.set_position(progress.done as u64);
    };
    let mut options = Options::new(arguments.size, arguments.size);
    options.progress = Some(&advance);
    let rendering = render(&scene, &camera, &options);
    bar.finish_and_clear();
    Ok(rendering?)
}

fn scene(surface: SumOfExpQuadrics, solver: Solver) -> Scene {
    let scene = Scene::new();
    match solver {
        Solver::Bisection => scene.with_solver::<Bisection, _>(surface),
        Solver::Newton => scene.with_solver::<Newton, _>(surface),
        Solver::Newton2 => scene.with_solver::<Tightened, _>(surface),
        Solver::Halley => scene.with_solver::<Halley, _>(surface),
        Solver::Auto => scene.with_solver::<Auto, _>(surface),
    }
}

/// A bar on standard error; nothing is drawn where that is no terminal.
fn progress_bar() -> ProgressBar {
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("rendering {wide_bar} {percent:>3} %") {
        bar.set_style(style);
    }
    bar
}

/// Writes the shaded picture and that of the verdicts into `folder`; returns their paths.
pub fn write(rendering: &Rendering, folder: &Path) -> Result<[PathBuf; 2], Failure> {
    std::fs::create_dir_all(folder).map_err(Failure::write(folder))?;
    let shaded = folder.join("sum_of_exp_quadrics.png");
    let verdicts = folder.join("verdicts.png");
    save(&rendering.image(&shading()), &shaded)?;
    save(&rendering.verdict_image(), &verdicts)?;
    Ok([shaded, verdicts])
}

fn save(image: &RgbImage, path: &Path) -> Result<(), Failure> {
    image.save(path).map_err(|source| Failure::Picture {
        path: path.to_owned(),
        source,
    })
}

/// A light from above left, as seen by the camera.
fn shading() -> Shading {
    let back = (FROM - AT).normalize();
    let right = DVec3::Z.cross(back).normalize();
    let up = back.cross(right);
    Shading {
        light: (back * 1.5 + up * 1.1 - right * 0.9).as_vec3(),
        ambient: 0.13,
        highlight: 0.4,
        colours: vec![Vec3::new(0.03, 0.34, 0.46)],
        background: Vec3::new(0.94, 0.925, 0.89),
        ..Shading::default()
    }
}
