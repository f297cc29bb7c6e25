//! Run time against error: for each surface of the zoo and each tolerance, this library beside the usual methods.
//!
//! `cargo run --release -p accuracy` writes `benches/accuracy/accuracy.csv`, `docs/accuracy.svg` and `docs/accuracy.md`.
//! `-- only NAME` measures one surface and writes nothing but its table to the screen; `-- page` writes picture and page of
//! the CSV as it is; `-- rays` writes the rays, for `tests/accuracy/truth.py`.

#![forbid(unsafe_code)]

mod chart;
mod csv;
mod measure;
mod page;

use std::error::Error;
use std::path::{Path, PathBuf};

use measure::Row;
use zeroset::interval::Isa;
use zeroset_accuracy::trial::pixels;
use zeroset_accuracy::truth;

/// A file of the repository.
fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        [] => everything(),
        ["rays"] => {
            rays();
            Ok(())
        }
        ["page"] => {
            let text = std::fs::read_to_string(file(CSV))?;
            pictures(&csv::read(&text).ok_or("not a table of this program")?)
        }
        ["only", name] => {
            print!("{}", csv::table(&rows(|one| one == name, |_| Ok(()))?));
            Ok(())
        }
        _ => Err("usage: accuracy, accuracy only NAME, accuracy page, or accuracy rays".into()),
    }
}

/// Measures the chosen surfaces; `keep` sees what there is after each.
fn rows(
    chosen: impl Fn(&str) -> bool,
    keep: impl Fn(&[Row]) -> std::io::Result<()>,
) -> Result<Vec<Row>, Box<dyn Error>> {
    let known = truth::read(&std::fs::read_to_string(file("tests/accuracy/truth.txt"))?);
    for name in ["avx512", "avx2"] {
        if let Err(why) = Isa::named(name) {
            println!("SKIPPED {name}: {why}");
        }
    }
    let mut rows = Vec::new();
    for subject in accuracy::subjects() {
        let name = subject.name();
        if chosen(name) {
            let known = known
                .get(name)
                .ok_or_else(|| format!("no truth for {name}"))?;
            rows.extend(measure::measure(&*subject, known));
            keep(&rows)?;
            eprintln!("{name}");
        }
    }
    if rows.is_empty() {
        return Err("no surface of this name".into());
    }
    Ok(rows)
}

const CSV: &str = "benches/accuracy/accuracy.csv";

fn everything() -> Result<(), Box<dyn Error>> {
    let rows = rows(|_| true, |rows| std::fs::write(file(CSV), csv::table(rows)))?;
    pictures(&rows)
}

fn pictures(rows: &[Row]) -> Result<(), Box<dyn Error>> {
    std::fs::write(file("docs/accuracy.svg"), chart::draw(rows)?)?;
    std::fs::write(file("docs/accuracy.md"), page::write(rows))?;
    println!("docs/accuracy.md");
    Ok(())
}

/// In the zoo's format.
fn rays() {
    for subject in accuracy::subjects() {
        println!("surface {}", subject.name());
        for [x, y] in pixels() {
            let ray = subject.ray(x, y);
            print!("ray");
            for number in ray
                .origin
                .to_array()
                .iter()
                .chain(&ray.direction.to_array())
            {
                print!(" {:016x}", number.to_bits());
            }
            println!();
        }
    }
}
