//! `cargo run --release -p zeroset-stress` prints the table of the docs: each case with the verdict that it must get, the
//! evaluations that it took, and whether it got it, on the best processor path or the one that is named.

#![forbid(unsafe_code)]

use std::process::ExitCode;

use zeroset::interval::Isa;
use zeroset_stress::cases::cases;

fn main() -> ExitCode {
    let isa = match std::env::args().nth(1) {
        Some(name) => Isa::named(&name),
        None => Isa::detect(),
    };
    let isa = match isa {
        Ok(isa) => isa,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    };
    println!("| case | f | verdict | evaluations |\n|---|---|---|---|");
    let mut wrong = 0;
    for case in cases() {
        let trail = case.run(isa);
        let expected: Vec<String> = case.expected.iter().map(ToString::to_string).collect();
        let verdict = if expected.is_empty() {
            "Miss".to_owned()
        } else {
            expected.join(", ")
        };
        let formula = case.formula.replace('|', "\\|");
        println!(
            "| {} | `{formula}` | {verdict} | {} |",
            case.what,
            trail.evaluations.total()
        );
        if let Some(complaint) = case.complaint(&trail) {
            eprintln!("wrong, {}: {complaint}", case.what);
            wrong += 1;
        }
    }
    if wrong == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
