//! All rows, for other programs.

use std::fmt::Write as _;

use crate::measure::{Row, Tuning};

pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "surface,method,tuning,setting,isa,tolerance,ns_per_ray,evaluations_per_ray,largest_error,median_error,rays,missed,invented,wrong_sheet,open\n",
    );
    for row in rows {
        let tuning = match row.tuning {
            Tuning::None => "certified",
            Tuning::Careful => "careful",
            Tuning::Careless => "careless",
        };
        let setting = row.setting.map(|n| n.to_string()).unwrap_or_default();
        let tolerance = row.tolerance.map(|t| format!("{t:e}")).unwrap_or_default();
        let s = &row.score;
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{},{},{tuning},{setting},{},{tolerance},{:.1},{:.2},{:.1e},{:.1e},{},{},{},{},{}",
            row.surface,
            row.method,
            row.isa,
            row.nanoseconds,
            row.evaluations,
            s.largest(),
            s.median(),
            s.rays,
            s.missed,
            s.invented,
            s.wrong_sheet,
            s.open
        );
    }
    text
}
