//! Polynomials of higher degree along a ray: as written, and from their coefficients.

use crate::entry::Entry;
use crate::surfaces::Forms;
use crate::table::{Timed, list, medians};
use crate::width::median;

/// Widths of segments: a ray passes the surface's cube in t ∈ [0, 1].
const WIDTHS: [f64; 4] = [0.5, 0.0625, 1.0 / 256.0, 1.0 / 65536.0];
/// Segments for each.
const SEGMENTS: usize = 400;

/// Prints, for each surface that has some, times of both ways, and how many times wider the enclosures of others are.
pub fn print(surfaces: &[Forms]) {
    println!(
        "Polynomials of degree 3 and more: ns per packet as written and from coefficients, and how many times wider than from\n\
         coefficients f(T) is as written, by Taylor's formula, and f'(T) as written (medians of quotients over {SEGMENTS}\n\
         segments, for T of {WIDTHS:?} of the cube).\n"
    );
    println!(
        "| surface | degree | operations | value, ns | slope, ns | curvature, ns | f as written | f by Taylor | f' as written |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut lost = Vec::new();
    for s in surfaces {
        let [_, _, written, staged] = &s.forms;
        let report = staged.report();
        if report.polynomials == 0 {
            continue;
        }
        let both = [written.as_ref(), staged.as_ref()];
        let along = [Entry::Value, Entry::Slope, Entry::Curvature];
        let timed = |entry| both.map(|form| Timed::new(form, s.half, entry));
        let times = medians(along.into_iter().flat_map(timed).collect());
        let cells: Vec<String> = times
            .chunks(2)
            .map(|t| format!("{:.1} {:.1}", t[0], t[1]))
            .collect();
        if times.chunks(2).any(|t| t[0] < 0.95 * t[1]) {
            lost.push(s.name.to_owned());
        }
        let [mut value, mut taylor, mut slope] = [const { Vec::new() }; 3];
        for width in WIDTHS {
            let [a, b] = both.map(|form| form.widths(s.half, width, SEGMENTS));
            let pairs = || a.iter().zip(&b);
            value.push(median(pairs().map(|(a, b)| a.value / b.value).collect()));
            taylor.push(median(pairs().map(|(a, b)| a.taylor / b.value).collect()));
            slope.push(median(pairs().map(|(a, b)| a.slope / b.slope).collect()));
        }
        let columns = [value, taylor, slope].map(|all| {
            let all: Vec<String> = all.iter().map(|q| format!("{q:.2}")).collect();
            all.join(" ")
        });
        let degree = report.degree.map_or("none".to_owned(), |d| d.to_string());
        println!(
            "| {} | {degree} | {} | {} | {} |",
            s.name,
            written
                .report()
                .segment
                .map(|o| o.staged.to_string())
                .join(" "),
            cells.join(" | "),
            columns.join(" | ")
        );
    }
    println!("\nSlower from coefficients: {}.\n", list(&lost));
}
