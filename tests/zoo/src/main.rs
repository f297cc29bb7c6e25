//! Traces the rays of standard input; see the library's documentation for the format.

#![forbid(unsafe_code)]

use std::f64::consts::TAU;
use std::io::{BufRead, Write, stdin, stdout};
use std::process::ExitCode;

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

zeroset_zoo::each_surface!(zoo(s));

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
