//! All rows, for other programs.

use std::fmt::Write as _;

use crate::measure::{Found, Row, Tuning};

pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "surface,method,tuning,setting,isa,tolerance,ns_per_ray,evaluations_per_ray,largest_error,median_error,rays,right,missed,invented,wrong_sheet,open\n",
    );
    for row in rows {
        let tuning = match row.tuning {
            Tuning::None => "certified",
            Tuning::Careful => "careful",
            Tuning::Careless => "careless",
        };
        let setting = row.setting.map(|n| n.to_string()).unwrap_or_default();
        let tolerance = row.tolerance.map(|t| format!("{t:e}")).unwrap_or_default();
        let s = &row.found;
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{},{},{tuning},{setting},{},{tolerance},{:.1},{:.2},{:.1e},{:.1e},{},{},{},{},{},{}",
            row.surface,
            row.method,
            row.isa,
            row.nanoseconds,
            row.evaluations,
            s.largest,
            s.median,
            s.rays,
            s.right,
            s.missed,
            s.invented,
            s.wrong_sheet,
            s.open
        );
    }
    text
}

/// The rows of such a table.
pub fn read(text: &str) -> Option<Vec<Row>> {
    text.lines().skip(1).map(row).collect()
}

fn row(line: &str) -> Option<Row> {
    let fields: Vec<&str> = line.split(',').collect();
    let [
        surface,
        method,
        tuning,
        setting,
        isa,
        tolerance,
        ns,
        evaluations,
        largest,
        median,
        counts @ ..,
    ] = &fields[..]
    else {
        return None;
    };
    let counts: Vec<u32> = counts
        .iter()
        .map(|n| n.parse().ok())
        .collect::<Option<_>>()?;
    let [rays, right, missed, invented, wrong_sheet, open] = counts[..] else {
        return None;
    };
    Some(Row {
        surface: (*surface).to_owned(),
        method: (*method).to_owned(),
        setting: setting.parse().ok(),
        tuning: match *tuning {
            "certified" => Tuning::None,
            "careful" => Tuning::Careful,
            "careless" => Tuning::Careless,
            _ => return None,
        },
        isa: (*isa).to_owned(),
        tolerance: tolerance.parse().ok(),
        nanoseconds: ns.parse().ok()?,
        evaluations: evaluations.parse().ok()?,
        found: Found {
            largest: largest.parse().ok()?,
            median: median.parse().ok()?,
            rays,
            right,
            missed,
            invented,
            wrong_sheet,
            open,
        },
    })
}
