//! zeroset beside its peers, in one process and one run: times, and what is wrong in each picture.
//!
//! `cd benches/peers && cargo run --release -- --help`
//!
//! Tables are printed as Markdown. Contenders take turns; the first round warms up and is not counted. A cell is a median
//! with the least and the most behind it. Times on one thread are processor time, which other work on the machine
//! disturbs least; times on more threads are those of the clock on the wall.

#![forbid(unsafe_code)]

mod ablation;
mod animation;
// The default example's surface.
#[path = "../../../examples/sum_of_exp_quadrics/family.rs"]
#[allow(dead_code)]
mod family;
mod growth;
mod judge;
#[cfg(feature = "limit")]
mod limit;
// A script writes the formulas.
#[allow(clippy::let_and_return)]
mod models;
mod packets;
mod picture;
#[path = "../../../examples/sum_of_exp_quadrics/random.rs"]
mod random;
mod rigour;
mod shapes;
mod space;
mod timing;
mod truth;
mod versus_fidget;
mod versus_povray;
mod view;

use clap::{Parser, ValueEnum};

/// zeroset beside fidget and POV-Ray; growth with pixels and terms; packets; the price of rigour; what no render can avoid; what each skip saves.
#[derive(Parser)]
struct Arguments {
    /// What to measure; all of it if not given. May be repeated.
    #[arg(long, value_enum)]
    section: Vec<Section>,
    /// Only shapes whose names hold this.
    #[arg(long, default_value = "")]
    shape: String,
    /// Sides of the pictures beside fidget, in pixels: powers of two.
    #[arg(long, value_delimiter = ',', default_value = "512")]
    size: Vec<u32>,
    /// Numbers of threads beside fidget.
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<usize>,
    /// Counted rounds.
    #[arg(long, default_value_t = 5)]
    runs: usize,
    /// Rays of each picture, about, that are compared with the truth.
    #[arg(long, default_value_t = 10_000)]
    rays: u32,
    /// The side of the largest picture of the growth table, up to 4096.
    #[arg(long, default_value_t = 1024)]
    largest: u32,
    /// The largest number of terms and spheres of the growth table, up to 4096.
    #[arg(long, default_value_t = 512)]
    terms: usize,
    /// Writes a picture of the thin shell by fidget and by zeroset, side by side, and measures nothing.
    #[arg(long, value_name = "FILE")]
    picture: Option<std::path::PathBuf>,
    /// How often an octree halves each box.
    #[arg(long, default_value_t = 5)]
    depth: u32,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Section {
    Fidget,
    Povray,
    Growth,
    Packets,
    Rigour,
    Limit,
    Ablation,
    Space,
    Animation,
}

fn main() {
    let arguments = Arguments::parse();
    if let Some(bad) = arguments
        .size
        .iter()
        .find(|n| !n.is_power_of_two() || **n < 8)
    {
        eprintln!(
            "a picture of {bad} pixels: give a power of two from 8, so that both peers see the same rays"
        );
        std::process::exit(2);
    }
    if let Some(path) = &arguments.picture {
        if let Err(error) = picture::write(path) {
            eprintln!("{}: {error}", path.display());
            std::process::exit(1);
        }
        return;
    }
    let wanted = |s| arguments.section.is_empty() || arguments.section.contains(&s);
    let mut shapes = shapes::all();
    shapes.retain(|s| s.name.contains(&arguments.shape));
    if shapes.is_empty() {
        eprintln!(
            "no shape's name holds `{}`: leave --shape out to see all",
            arguments.shape
        );
        std::process::exit(2);
    }
    println!(
        "processor: {}; zeroset runs on `{}`; {} counted rounds, interleaved",
        timing::processor(),
        zeroset::interval::Isa::available()[0].name(),
        arguments.runs
    );
    if wanted(Section::Fidget) {
        versus_fidget::run(&shapes, &arguments);
    }
    if wanted(Section::Povray) {
        versus_povray::run(&shapes, &arguments);
    }
    if wanted(Section::Growth) {
        growth::run(&arguments);
    }
    if wanted(Section::Packets) {
        packets::run(&shapes, &arguments);
    }
    if wanted(Section::Rigour) {
        rigour::run(&shapes, &arguments);
    }
    if wanted(Section::Limit) {
        #[cfg(feature = "limit")]
        limit::run(&shapes, &arguments);
        #[cfg(not(feature = "limit"))]
        println!("\nSKIPPED beside the limit: not compiled; build with --features limit");
    }
    if wanted(Section::Ablation) {
        ablation::run(&shapes, &arguments);
    }
    if wanted(Section::Space) {
        space::run(&mut shapes, &arguments);
    }
    if wanted(Section::Animation) {
        animation::run(&arguments);
    }
}

#[cfg(test)]
mod tests;
