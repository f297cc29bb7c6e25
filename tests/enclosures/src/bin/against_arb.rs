//! Every function on every back-end against arb, at random points and at edges.
//!
//! `cargo run --release -p zeroset-enclosures --bin against_arb -- [--pairs N] [--seed S] [function …]`
//!
//! The exact values come from `fixtures/generate.py` (python-flint), 100,000 per function unless told otherwise. Prints,
//! per function and back-end: violations; the median and the largest number of doubles by which the enclosure of a point
//! reaches beyond the two doubles around the value; its width at points; and violations over segments between points.
//! The exit status is 1 if there is any violation. Without python-flint a skip is printed.

use std::io::{BufRead, BufReader};
use std::process::{Command, ExitCode, Stdio};

use zeroset_enclosures::backend::Backend;
use zeroset_enclosures::fixture::{Bracket, parse};
use zeroset_enclosures::operation::Operation;
use zeroset_enclosures::promise::is_proved;
use zeroset_enclosures::survey::{median, survey};

/// The exit status of the generator without python-flint.
const NO_FLINT: i32 = 3;

struct Arguments {
    pairs: usize,
    seed: String,
    names: Vec<String>,
}

fn arguments() -> Result<Arguments, String> {
    let mut out = Arguments {
        pairs: 100_000,
        seed: "1".to_owned(),
        names: Vec::new(),
    };
    let mut rest = std::env::args().skip(1);
    while let Some(argument) = rest.next() {
        let mut value = || rest.next().ok_or(format!("{argument} needs a value"));
        match argument.as_str() {
            "--pairs" => {
                let text = value()?;
                out.pairs = text.parse().map_err(|e| format!("--pairs {text}: {e}"))?;
            }
            "--seed" => out.seed = value()?,
            name if Operation::named(name).is_some() => out.names.push(argument),
            _ => return Err(format!("{argument} is no function")),
        }
    }
    Ok(out)
}

fn generator(arguments: &[&str]) -> Command {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/generate.py");
    let mut command = Command::new("python3");
    command.arg(script).args(arguments).stdout(Stdio::piped());
    command
}

/// The names of all functions; None without python-flint.
fn names() -> Result<Option<Vec<String>>, String> {
    let done = match generator(&["--list"]).output() {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        other => other.map_err(|error| format!("python3: {error}"))?,
    };
    if done.status.code() == Some(NO_FLINT) {
        return Ok(None);
    }
    let text = String::from_utf8_lossy(&done.stdout).into_owned();
    if !done.status.success() {
        return Err(format!("generate.py failed: {}", done.status));
    }
    Ok(Some(text.split_whitespace().map(str::to_owned).collect()))
}

/// Brackets of a function, in order of their arguments.
fn sample(name: &str, pairs: usize, seed: &str) -> Result<Vec<Bracket>, String> {
    let mut child = generator(&["--stream", name, &pairs.to_string(), seed])
        .spawn()
        .map_err(|error| format!("python3: {error}"))?;
    let output = child.stdout.take().ok_or("no output")?;
    let mut brackets = Vec::with_capacity(pairs);
    for line in BufReader::new(output).lines() {
        let line = line.map_err(|error| error.to_string())?;
        brackets.push(parse(&line).ok_or_else(|| format!("{name}: `{line}`"))?);
    }
    let status = child.wait().map_err(|error| error.to_string())?;
    if !status.success() || brackets.len() != pairs {
        return Err(format!("{name}: {} pairs, {status}", brackets.len()));
    }
    brackets.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]));
    Ok(brackets)
}

/// A number of doubles, unless it is too large to say anything.
fn short(steps: u64) -> String {
    if steps < 1 << 20 {
        steps.to_string()
    } else {
        "far".to_owned()
    }
}

/// One line per back-end; how many violations.
fn report(name: &str, operation: Operation, brackets: &[Bracket], unary: bool) -> usize {
    let mut violations = 0;
    for backend in Backend::rounded() {
        let found = survey(backend, operation, brackets, unary);
        let wrong = found.misses.len() + found.segment_misses.len();
        println!(
            "{:<9}{:<9}{:>8}{:>7}{:>9}{:>7}{:>7}{:>7}{:>8}{:>10}{:>7}  {}",
            name,
            backend.name(),
            found.pairs,
            found.misses.len(),
            short(median(&found.excess)),
            short(found.excess.last().copied().unwrap_or_default()),
            short(median(&found.width)),
            short(found.width.last().copied().unwrap_or_default()),
            found.tails,
            found.segments,
            found.segment_misses.len(),
            if is_proved(name) { "" } else { "not proved" },
        );
        for miss in found.misses.iter().chain(&found.segment_misses).take(5) {
            println!("  {miss}");
        }
        violations += wrong;
    }
    violations
}

fn run() -> Result<bool, String> {
    let arguments = arguments()?;
    let Some(all) = names()? else {
        println!("SKIPPED against_arb: python-flint is not installed (pip install python-flint)");
        return Ok(true);
    };
    println!(
        "{:<9}{:<9}{:>8}{:>7}{:>16}{:>14}{:>8}{:>17}",
        "", "", "", "", "excess in ulp", "width in ulp", "", "segments"
    );
    println!(
        "{:<9}{:<9}{:>8}{:>7}{:>9}{:>7}{:>7}{:>7}{:>8}{:>10}{:>7}",
        "function",
        "back-end",
        "pairs",
        "wrong",
        "median",
        "most",
        "median",
        "most",
        "tails",
        "",
        "wrong"
    );
    let mut violations = 0;
    for name in all {
        if !arguments.names.is_empty() && !arguments.names.contains(&name) {
            continue;
        }
        let operation = Operation::named(&name).ok_or(format!("{name} is no operation"))?;
        let brackets = sample(&name, arguments.pairs, &arguments.seed)?;
        let unary = brackets.iter().all(|b| b.unary);
        violations += report(&name, operation, &brackets, unary);
    }
    println!("{violations} violations");
    Ok(violations == 0)
}

fn main() -> ExitCode {
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
