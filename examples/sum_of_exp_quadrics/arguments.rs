//! The command line.

use std::path::PathBuf;

use clap::{Parser, ValueEnum, builder::RangedU64ValueParser};

/// Renders a surface of the family Σ exp(r(x, y, z)) = level, every pixel with a proved verdict.
#[derive(Clone, Debug, Parser)]
#[command(name = "sum_of_exp_quadrics", version)]
pub struct Arguments {
    /// How many exponentials the sum has, 1 to 4096
    #[arg(long, value_name = "N", default_value_t = 8, allow_negative_numbers = true, value_parser = RangedU64ValueParser::<usize>::new().range(1..=4096))]
    pub terms: usize,

    /// Width and height of the picture in pixels, 1 to 4096
    #[arg(long, value_name = "PIXELS", default_value_t = 512, allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub size: u32,

    /// Which surface: any number gives another one
    #[arg(long, default_value_t = 4, allow_negative_numbers = true)]
    pub seed: u64,

    /// What the search for roots uses
    #[arg(long, value_enum, default_value_t = Solver::Auto)]
    pub solver: Solver,

    /// Where the pictures go; made if it does not exist
    #[arg(long, value_name = "DIR", default_value = "target/pictures")]
    pub out: PathBuf,

    /// Also write the figures on enclosures and contractors, as SVG and CSV
    #[arg(long)]
    pub figures: bool,

    /// Also write what each ray's verdict claims, for scripts/check-certificate
    #[arg(long, value_name = "FILE")]
    pub certificate: Option<PathBuf>,
}

/// A contractor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Solver {
    /// Ranges of f alone: finds sign changes, proves no uniqueness
    Bisection,
    /// Interval Newton
    Newton,
    /// Interval Newton, the derivative tightened by the second derivative
    Newton2,
    /// Interval Halley
    Halley,
    /// Steps from the front of the segment, derivatives only where f cannot decide
    Auto,
}

impl std::fmt::Display for Solver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let value = self.to_possible_value();
        f.write_str(value.as_ref().map_or("", |v| v.get_name()))
    }
}
