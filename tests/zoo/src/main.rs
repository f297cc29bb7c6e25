//! Traces the rays of standard input; see the library's documentation for the format.

#![forbid(unsafe_code)]

use std::io::{BufRead, Write, stdin, stdout};
use std::process::ExitCode;

use std::f64::consts::TAU;

use zeroset::camera::Ray;
use zeroset_zoo::surfaces as s;
use zeroset_zoo::text::{self, Answered};
use zeroset_zoo::trace;

macro_rules! zoo {
    ($($name:literal in $half:tt: $surface:expr;)*) => {
        /// The names of the surfaces.
        const NAMES: &[&str] = &[$($name),*];

        /// Traces rays through the surface of this name.
        fn trace_named(name: &str, rays: &[Ray]) -> Result<Vec<Answered>, String> {
            match name {
                $($name => trace($surface, $half, rays),)*
                _ => Err(format!("no surface is called {name}; there are {}", NAMES.join(", "))),
            }
        }
    };
}

zoo! {
    "sphere" in 1.0: s::Sphere;
    "ellipsoid" in 1.5: s::Ellipsoid;
    "cylinder" in 1.0: s::Cylinder;
    "cone" in 1.0: s::Cone;
    "hyperboloid" in 1.5: s::Hyperboloid;
    "torus" in 0.9: s::Torus;
    "torus_root" in 0.9: s::TorusRoot;
    "cayley" in 1.5: s::Cayley;
    "clebsch" in 3.0: s::Clebsch;
    "kummer" in 2.5: s::Kummer::default();
    "tangle" in 3.2: s::Tangle;
    "mitchell" in 2.1: s::Mitchell;
    "steiner" in 0.6: s::Steiner;
    "klein" in 4.2: s::Klein;
    "heart" in 1.5: s::Heart;
    "teardrop" in 1.2: s::Teardrop;
    "barth_sextic" in 2.0: s::BarthSextic::default();
    "barth_decic" in 2.2: s::BarthDecic::default();
    "chmutov_6" in 1.35: s::Chmutov6;
    "chmutov_8" in 1.5: s::Chmutov8;
    "bretzel" in 2.4: s::Bretzel;
    "decocube" in 1.3: s::Decocube;
    "icosahedral" in 4.77: s::Icosahedral::default();
    "superquadric" in 1.3: s::Superquadric;
    "gyroid" in TAU: s::Gyroid;
    "schwarz_p" in TAU: s::SchwarzP;
    "schwarz_d" in TAU: s::SchwarzD;
    "blobby" in 2.5: s::Blobby;
    "scherk" in 10.0: s::Scherk;
    "exponentials" in 1.0: s::Exponentials { blobs: s::BLOBS };
    "zitrus" in 1.2: s::Zitrus;
    "ding_dong" in 1.5: s::DingDong;
    "calypso" in 1.5: s::Calypso;
    "whitney" in 1.5: s::Whitney;
    "himmel" in 1.5: s::Himmel;
    "limao" in 1.5: s::Limao;
    "doubled_sphere" in 1.0: s::DoubledSphere;
    "isolated_point" in 1.0: s::IsolatedPoint;
    "thin_shell" in 1.0: s::ThinShell::default();
}

fn main() -> ExitCode {
    let result = match std::env::args().nth(1).as_deref() {
        None => run(),
        Some("names") => {
            println!("{}", NAMES.join("\n"));
            Ok(())
        }
        Some(_) => Err("usage: zeroset-zoo < RAYS > ANSWERS, or zeroset-zoo names".to_owned()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let mut name = String::new();
    let mut rays: Vec<Ray> = Vec::new();
    for (number, line) in (1..).zip(stdin().lock().lines()) {
        let line = line.map_err(|e| e.to_string())?;
        let at = |error: String| format!("line {number}: {error}");
        let mut words = line.split_whitespace();
        match words.next() {
            Some("surface") => {
                answer(&name, &rays)?;
                rays.clear();
                name = words.next().unwrap_or_default().to_owned();
            }
            Some("ray") => rays.push(text::ray(words).map_err(at)?),
            other => {
                return Err(at(format!(
                    "`{}` is no kind of line",
                    other.unwrap_or_default()
                )));
            }
        }
    }
    answer(&name, &rays)
}

/// Writes the answers for one surface.
fn answer(name: &str, rays: &[Ray]) -> Result<(), String> {
    if rays.is_empty() {
        return Ok(());
    }
    let answers = trace_named(name, rays)?;
    let mut out = stdout().lock();
    let mut write = || {
        writeln!(out, "surface {name}")?;
        answers.iter().try_for_each(|a| writeln!(out, "{a}"))
    };
    write().map_err(|e: std::io::Error| e.to_string())
}
