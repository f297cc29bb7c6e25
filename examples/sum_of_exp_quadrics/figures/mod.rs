//! The paper's two figures, over 256 ray functions: how wide enclosures of f(T) are, and how much of T one step of each
//! contractor leaves. Each is written as a table (CSV) and as a drawing (SVG).

mod chart;
mod forms;
mod function;
mod steps;
mod summary;
#[cfg(test)]
mod tests;

use std::io::Write;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::failure::Failure;
use crate::family::Form;
use chart::{Chart, Series};
use forms::Widths;
use function::{COUNT, NARROWEST, RayFunction, SEED, functions};
use steps::Remainder;
use summary::Summary;

/// What was measured on one ray function, by the exponent of the width.
struct Measured {
    form: Form,
    widths: Vec<Widths>,
    steps: Vec<[Remainder; 3]>,
}

/// Measures, writes the four files into `folder`, and prints a few rows.
pub fn write(out: &mut impl Write, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let all: Vec<Measured> = functions().par_iter().map(measure).collect();
    print(out, &all)?;
    let files = [
        ("enclosures.csv", enclosures_table(&all)),
        ("enclosures.svg", enclosures_chart(&all).svg()),
        ("contractions.csv", contractions_table(&all)),
        ("contractions.svg", contractions_chart(&all).svg()),
    ];
    let mut paths = Vec::new();
    for (name, content) in files {
        let path = folder.join(name);
        std::fs::write(&path, content).map_err(Failure::write(&path))?;
        paths.push(path);
    }
    Ok(paths)
}

fn measure(f: &RayFunction) -> Measured {
    Measured {
        form: f.form,
        widths: f.segments.iter().map(|t| forms::widths(f, *t)).collect(),
        steps: f
            .segments
            .iter()
            .map(|t| steps::remainders(f, *t))
            .collect(),
    }
}

/// The functions of one form, or all.
fn of(all: &[Measured], form: Option<Form>) -> impl Iterator<Item = &Measured> {
    all.iter().filter(move |m| form.is_none_or(|f| f == m.form))
}

fn width_summary(all: &[Measured], form: Option<Form>, k: usize, which: usize) -> Summary {
    Summary::of(of(all, form).map(|m| m.widths[k].ratios[which]).collect())
}

fn step_summary(all: &[Measured], form: Option<Form>, k: usize, which: usize) -> Summary {
    Summary::of(of(all, form).map(|m| m.steps[k][which].share).collect())
}

/// How far a width taken for true may be short of it, at worst.
fn doubt(all: &[Measured]) -> f64 {
    let widths = all.iter().flat_map(|m| &m.widths);
    widths.map(|w| w.doubt).fold(0.0, f64::max)
}

/// How many steps end in this many pieces.
fn ending(all: &[Measured], form: Option<Form>, k: usize, which: usize, pieces: usize) -> usize {
    of(all, form)
        .filter(|m| m.steps[k][which].pieces == pieces)
        .count()
}

const GROUPS: [Option<Form>; 3] = [None, Some(Form::NegativeDefinite), Some(Form::Indefinite)];

fn enclosures_table(all: &[Measured]) -> String {
    let mut table = format!(
        "# Width of each enclosure of f(T) over the true width, {COUNT} ray functions, ray seed {SEED}.\n\
         # The width taken for true is that of values of f: the truth is more by {:.1e} of it at most.\n\
         quadratics,width,form,mean,quartile1,median,quartile3\n",
        doubt(all)
    );
    for group in GROUPS {
        for k in 0..=NARROWEST {
            for (which, name) in forms::NAMES.iter().enumerate() {
                let s = width_summary(all, group, k, which);
                let group = group.map_or("all", Form::name);
                table += &format!("{group},2^-{k},{name},{}\n", numbers(&s));
            }
        }
    }
    table
}

fn contractions_table(all: &[Measured]) -> String {
    let mut table = format!(
        "# What one step leaves of T, over its width, {COUNT} ray functions, ray seed {SEED}.\n\
         # Two pieces count with the sum of their widths, an empty end with 0. T always holds a root: none may be empty.\n\
         quadratics,width,step,mean,quartile1,median,quartile3,two pieces,empty\n"
    );
    for group in GROUPS {
        for k in 0..=NARROWEST {
            for (which, name) in steps::NAMES.iter().enumerate() {
                let s = step_summary(all, group, k, which);
                let [empty, two] = [0, 2].map(|n| ending(all, group, k, which, n));
                let group = group.map_or("all", Form::name);
                table += &format!("{group},2^-{k},{name},{},{two},{empty}\n", numbers(&s));
            }
        }
    }
    table
}

fn numbers(s: &Summary) -> String {
    format!(
        "{:.6e},{:.6e},{:.6e},{:.6e}",
        s.mean, s.first, s.median, s.third
    )
}

fn enclosures_chart(all: &[Measured]) -> Chart {
    let series = |(which, name): (usize, &&'static str)| Series {
        name,
        values: (0..=NARROWEST)
            .map(|k| width_summary(all, None, k, which))
            .collect(),
    };
    Chart {
        title: "How wide enclosures of f(T) are",
        note: format!(
            "{COUNT} ray functions, ray seed {SEED}, half negative definite, half indefinite; above 10⁶: see the table"
        ),
        y_label: "width over true width",
        // Far out, plain interval arithmetic on e^(large) has no use for an axis.
        highest: 6,
        series: forms::NAMES.iter().enumerate().map(series).collect(),
    }
}

fn contractions_chart(all: &[Measured]) -> Chart {
    let series = |(which, name): (usize, &&'static str)| Series {
        name,
        values: (0..=NARROWEST)
            .map(|k| step_summary(all, None, k, which))
            .collect(),
    };
    Chart {
        title: "What one step leaves of T",
        note: format!(
            "{COUNT} ray functions, ray seed {SEED}; T holds a root: none ends empty; two pieces: their sum"
        ),
        y_label: "width left over width of T",
        highest: 0,
        series: steps::NAMES.iter().enumerate().map(series).collect(),
    }
}

/// Means at every fifth width.
fn print(out: &mut impl Write, all: &[Measured]) -> std::io::Result<()> {
    let ks = (0..=NARROWEST).step_by(5);
    write!(out, "\n{:<22}", "width of T")?;
    for k in ks.clone() {
        write!(out, "{:>10}", format!("2^-{k}"))?;
    }
    writeln!(out, "   means of {COUNT} ray functions, ray seed {SEED}")?;
    for (which, name) in forms::NAMES.iter().enumerate() {
        write!(out, "{:<22}", format!("width, {name}"))?;
        for k in ks.clone() {
            let mean = width_summary(all, None, k, which).mean;
            if mean < 1e5 {
                write!(out, "{mean:>10.3}")?;
            } else {
                write!(out, "{mean:>10.1e}")?;
            }
        }
        writeln!(out)?;
    }
    writeln!(out, "{:<22}widths are known to {:.1e}", "", doubt(all))?;
    for (which, name) in steps::NAMES.iter().enumerate() {
        write!(out, "{:<22}", format!("left by {name}"))?;
        for k in ks.clone() {
            write!(out, "{:>10.1e}", step_summary(all, None, k, which).mean)?;
        }
        let two: usize = (0..=NARROWEST)
            .map(|k| ending(all, None, k, which, 2))
            .sum();
        let empty: usize = (0..=NARROWEST)
            .map(|k| ending(all, None, k, which, 0))
            .sum();
        let steps = COUNT * (NARROWEST + 1);
        writeln!(out, "   two pieces {two}, empty {empty} of {steps} steps")?;
    }
    Ok(())
}
