//! Renders the family g = Σ exp(r(x, y, z)), r quadratic with all ten coefficients, and prints what was proved.
//!
//! `cargo run --release --example sum_of_exp_quadrics -- --help`

mod arguments;
mod failure;
mod family;
mod figures;
mod picture;
mod random;
mod report;
#[cfg(test)]
mod tests;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

use arguments::Arguments;
use failure::Failure;

fn main() -> ExitCode {
    match run(std::env::args_os(), &mut std::io::stdout().lock()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            match &failure {
                // Help goes to standard output, and mistakes in colour to standard error: clap knows which is which.
                Failure::Arguments(error) => drop(error.print()),
                other => eprintln!("error: {other}"),
            }
            ExitCode::from(failure.code())
        }
    }
}

/// All of the program, so that tests can call it.
fn run(arguments: impl IntoIterator<Item = OsString>, out: &mut impl Write) -> Result<(), Failure> {
    let arguments = Arguments::try_parse_from(arguments)?;
    report::heading(out, &arguments)?;
    let rendering = picture::take(&arguments)?;
    let paths = picture::write(&rendering, &arguments.out)?;
    report::statistics(out, rendering.statistics())?;
    let mut paths = Vec::from(paths);
    if arguments.figures {
        paths.extend(figures::write(out, &arguments.out)?);
    }
    if let Some(path) = &arguments.certificate {
        picture::certify(&arguments, path)?;
        paths.push(path.clone());
    }
    writeln!(out)?;
    for path in paths {
        writeln!(out, "wrote {}", path.display())?;
    }
    Ok(())
}
