//! All pictures on all processor paths against the oracle, 512² pixels each; a picture may be chosen by a part of its
//! name: `cargo run --release -p zeroset-oracle -- [size] [part of a name]`.
//!
//! `sample FILE` writes 400 answers of each sum instead, for a second opinion by `arb.py`.

#![forbid(unsafe_code)]

use std::process::ExitCode;
use zeroset::interval::Isa;
use zeroset_oracle::claims::broken;
use zeroset_oracle::gallery;
use zeroset_oracle::picture::{Outcome, Picture, paths};
use zeroset_oracle::sample::sample;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (size, part) = match arguments[..] {
        ["sample", file] => return write_sample(file),
        [] => ("512", ""),
        [size] => (size, ""),
        [size, part] => (size, part),
        _ => ("", ""),
    };
    match size.parse() {
        Ok(size) => check(size, part),
        Err(_) => {
            eprintln!(
                "usage: zeroset-oracle [size] [part of a name], or zeroset-oracle sample FILE"
            );
            ExitCode::FAILURE
        }
    }
}

fn write_sample(file: &str) -> ExitCode {
    let isa = Isa::available()[0];
    match std::fs::write(file, sample(1..=8, 20, isa)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{file} cannot be written: {error}");
            ExitCode::FAILURE
        }
    }
}

fn check(size: u32, part: &str) -> ExitCode {
    let chosen = |pictures: Vec<Picture>| {
        let fits = |p: &Picture| p.name.contains(part);
        pictures.into_iter().filter(fits).collect::<Vec<_>>()
    };
    let paths = paths();
    let mut all = chosen(gallery::polynomial_pictures());
    all.extend(chosen(gallery::sums(1..=8)));
    let broken: Vec<String> = all
        .iter()
        .flat_map(|p| {
            let outcome = p.check(size, &paths);
            print(&outcome);
            broken(&outcome)
        })
        .collect();
    println!("\nclaims that are broken: {}", broken.len());
    for claim in &broken {
        println!("    {claim}");
    }
    println!("\nthe negative control, rounding switched off:");
    let control = chosen(gallery::controls());
    let mut caught = 0;
    for picture in &control {
        let outcome = picture.check(size, &Isa::unrounded());
        summary(&outcome);
        caught += outcome.wrong();
    }
    println!("answers refuted: {caught}");
    if broken.is_empty() && (caught > 0 || control.is_empty()) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// One line for each path, the answers worth a look, and the rays on which the paths differ.
fn print(outcome: &Outcome) {
    summary(outcome);
    for (path, tally) in &outcome.paths {
        for example in &tally.examples {
            println!("    {path}: {example}");
        }
    }
    println!(
        "{}; rays on which the paths differ: {}, a miss on one and a root on another: {}",
        outcome.name,
        outcome.differences.len(),
        outcome.contradictions
    );
    for difference in &outcome.differences {
        println!("    {difference}");
    }
}

/// One line for each path.
fn summary(outcome: &Outcome) {
    for (path, tally) in &outcome.paths {
        println!("{}; {path}: {tally}", outcome.name);
    }
}
