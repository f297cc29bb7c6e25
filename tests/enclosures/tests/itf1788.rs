//! The vectors of ITF1788: every range holds the tightest one, and is little wider.
//!
//! All `.itl` files of the folder that `ITF1788_DIR` names are run on every back-end. What is printed goes straight to
//! the error stream, for the harness hides what passing tests print.

use std::io::Write;
use std::path::{Path, PathBuf};

use zeroset_enclosures::backend::Backend;
use zeroset_enclosures::itf::tally::{table, tally};
use zeroset_enclosures::itf::{Case, parse};

/// How many statements files of these names have.
const TOTALS: [(&str, usize); 2] = [
    ("libieeep1788_elem.itl", 3818),
    ("libieeep1788_mul_rev.itl", 347),
];

fn say(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

/// The `.itl` files of the folder, or a skip that is seen.
fn files(test: &str) -> Option<Vec<PathBuf>> {
    let Some(folder) = std::env::var_os("ITF1788_DIR") else {
        say(&format!("SKIPPED {test}: ITF1788_DIR is not set"));
        return None;
    };
    // Tests run in the folder of their package; a relative path is meant from the repository's.
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let folder = Path::new(root).join(folder);
    let entries = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("ITF1788_DIR, {}: {error}", folder.display()));
    let mut files: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == "itl"));
    files.sort();
    assert!(!files.is_empty(), "no .itl file in {}", folder.display());
    Some(files)
}

/// The cases of all files.
fn cases(test: &str) -> Option<Vec<Case>> {
    let mut all = Vec::new();
    for path in files(test)? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let text = std::fs::read_to_string(&path)
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let cases = parse(&name, &text).unwrap_or_else(|error| panic!("{error}"));
        for (known, total) in TOTALS {
            assert!(
                known != name || cases.len() == total,
                "{name}: {} statements, not {total}",
                cases.len()
            );
        }
        all.extend(cases);
    }
    Some(all)
}

#[test]
fn ranges_hold_the_tightest_ones_and_are_little_wider() {
    let Some(cases) = cases("ranges_hold_the_tightest_ones_and_are_little_wider") else {
        return;
    };
    let columns: Vec<_> = Backend::rounded()
        .into_iter()
        .map(|b| (b, tally(b, &cases)))
        .collect();
    say(&table(&cases, &columns));
    let mut failures = String::new();
    for (backend, tallies) in &columns {
        for (name, tally) in tallies {
            for (list, what) in [(&tally.wrong, "wrong"), (&tally.too_wide, "too wide")] {
                if !list.is_empty() {
                    let (count, all) = (list.len(), list.join("\n"));
                    let of = tally.run;
                    failures +=
                        &format!("\n{} {name}: {count} of {of} {what}\n{all}", backend.name());
                }
            }
        }
    }
    assert!(failures.is_empty(), "{failures}");
}

#[test]
fn negative_control_vectors_catch_rounding_to_nearest() {
    const ROUND: [&str; 9] = [
        "add",
        "sub",
        "mul",
        "div",
        "sqrt",
        "exp",
        "log",
        "sin",
        "mulRevToPair",
    ];
    let test = "negative_control_vectors_catch_rounding_to_nearest";
    let Some(cases) = cases(test) else {
        return;
    };
    for backend in Backend::unrounded() {
        let all = tally(backend, &cases);
        for name in ROUND {
            let Some(tally) = all.get(name) else {
                say(&format!("SKIPPED {test}: no case of {name}"));
                continue;
            };
            let (wrong, run) = (tally.wrong.len(), tally.run);
            println!("{} {name}: {wrong} of {run} wrong", backend.name());
            // Vectors of one's own may have a few cases only, without a rounding.
            assert!(wrong > 0 || run < 10, "{} {name}", backend.name());
        }
    }
}
