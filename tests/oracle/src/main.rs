//! All pictures on all processor paths against the oracle, 512² pixels each; a picture may be chosen by a part of its
//! name: `cargo run --release -p zeroset-oracle -- [size] [part of a name]`.

#![forbid(unsafe_code)]

use std::process::ExitCode;
use zeroset::interval::Isa;
use zeroset_oracle::gallery;
use zeroset_oracle::picture::{Outcome, Picture, paths};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let size = arguments.next().map_or(Ok(512), |s| s.parse());
    let Ok(size) = size else {
        eprintln!("usage: zeroset-oracle [size] [part of a name]");
        return ExitCode::FAILURE;
    };
    let part = arguments.next().unwrap_or_default();
    let chosen = |pictures: Vec<Picture>| {
        let fits = |p: &Picture| p.name.contains(&part);
        pictures.into_iter().filter(fits).collect::<Vec<_>>()
    };
    let paths = paths();
    let mut all = chosen(gallery::polynomial_pictures());
    all.extend(chosen(gallery::sums(1..=8)));
    let wrong: u64 = all.iter().map(|p| print(&p.check(size, &paths))).sum();
    println!("wrong in all: {wrong}");
    println!("\nthe negative control, rounding switched off:");
    let control = chosen(gallery::controls());
    let caught: u64 = control
        .iter()
        .map(|p| summary(&p.check(size, &Isa::unrounded())))
        .sum();
    println!("caught in all: {caught}");
    if wrong == 0 && (caught > 0 || control.is_empty()) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// One line for each path, and the answers worth a look; returns how many are wrong.
fn print(outcome: &Outcome) -> u64 {
    let wrong = summary(outcome);
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
    wrong
}

/// One line for each path; returns how many answers are wrong.
fn summary(outcome: &Outcome) -> u64 {
    for (path, tally) in &outcome.paths {
        println!("{}; {path}: {tally}", outcome.name);
    }
    outcome.wrong()
}
