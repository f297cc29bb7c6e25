//! Fixture files: Markdown with one section per case.
//!
//! ```text
//! ## unknown_similar
//!
//!     struct S { radius: f64 }
//!     x^2 + y^2 = radus^2
//!                 ~~~~~
//! error: cannot find `radus` in this formula
//! help: a name that looks like it is in scope: `radius`
//! ```
//!
//! The indented lines are the input, less the lines of tildes. Everything else in a section is what the compiler says
//! about it. `ZEROSET_BLESS=1 cargo test -p zeroset-compiler` writes the files anew, to be read in the diff.

// Each test file uses its own part of this.
#![allow(dead_code)]

pub mod print;
pub mod random;

use std::path::PathBuf;

/// One section of a fixture file.
pub struct Case {
    /// The heading.
    pub name: String,
    /// The input.
    pub source: String,
}

fn path(file: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/fixtures")
        .join(file)
}

/// The cases of a file.
pub fn cases(file: &str) -> Vec<Case> {
    split(&text(file)).1
}

/// The text of a file.
pub fn text(file: &str) -> String {
    std::fs::read_to_string(path(file)).unwrap()
}

/// Runs every case of a file through `answer`, which returns a section's text below its heading.
pub fn check(file: &str, answer: impl Fn(&Case) -> String) {
    let old = text(file);
    let new = answered(&old, answer);
    if std::env::var_os("ZEROSET_BLESS").is_some() {
        std::fs::write(path(file), &new).unwrap();
    } else if new != old {
        panic!("{file}: {}", first_difference(&old, &new));
    }
}

/// A fixture file with the answers that its cases get now.
pub fn answered(text: &str, answer: impl Fn(&Case) -> String) -> String {
    let (mut fresh, cases) = split(text);
    for case in &cases {
        fresh.push_str(&format!("## {}\n\n{}\n", case.name, answer(case)));
    }
    format!("{}\n", fresh.trim_end())
}

/// The text before the first section, and the sections.
fn split(text: &str) -> (String, Vec<Case>) {
    let mut intro = String::new();
    let mut cases: Vec<Case> = Vec::new();
    let mut fenced = false;
    for line in text.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        }
        if fenced {
            continue;
        }
        if let Some(name) = line.strip_prefix("## ") {
            let (name, source) = (name.to_owned(), String::new());
            cases.push(Case { name, source });
        } else if let Some(case) = cases.last_mut() {
            match line.strip_prefix("    ") {
                Some(code) if !marks(code) => case.source.push_str(&format!("{code}\n")),
                _ => {}
            }
        } else {
            intro.push_str(&format!("{line}\n"));
        }
    }
    (intro, cases)
}

/// Is this a line of tildes?
fn marks(line: &str) -> bool {
    !line.trim().is_empty() && line.trim().chars().all(|c| c == '~')
}

fn first_difference(old: &str, new: &str) -> String {
    let (mut olds, mut news) = (old.lines(), new.lines());
    let mut section = "";
    for number in 1.. {
        match (olds.next(), news.next()) {
            (Some(a), Some(b)) if a == b => {
                if a.starts_with("## ") {
                    section = a;
                }
            }
            (None, None) => break,
            (a, b) => {
                let show = |line: Option<&str>| line.unwrap_or("(the end)").to_owned();
                return format!(
                    "{section}, line {number}\nexpected: {}\nfound:    {}",
                    show(a),
                    show(b)
                );
            }
        }
    }
    "no difference".to_owned()
}
