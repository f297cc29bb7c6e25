//! What rounding costs in whole pictures: each back-end beside the same code with rounding switched off.

use crate::Arguments;
use crate::packets::{back_ends, picture, quotient, say_skipped, times};
use crate::shapes::Shape;
use crate::timing::digits;
use crate::view::{Place, View};

const SIZE: u32 = 512;
const NAMES: [&str; 6] = [
    "avx512",
    "avx512-unrounded",
    "avx2",
    "avx2-unrounded",
    "portable",
    "portable-unrounded",
];

/// Milliseconds of processor time with and without rounding.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    println!("\n### Rigour, {SIZE}², one thread, ms\n");
    println!(
        "*Work* is the number of packets that were evaluated, by what it is without rounding: bounds that are not rounded decide a little more.\n"
    );
    let heads =
        ["avx512", "avx2", "portable"].map(|name| format!("{name} | unrounded | tax | work"));
    println!("| shape | {} |\n|{}", heads.join(" | "), "---|".repeat(13));
    let back_ends = back_ends(NAMES);
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    for shape in shapes {
        let times = times(shape, &view, &back_ends, arguments.runs);
        let work = back_ends.each_ref().map(|isa| {
            let isa = isa.as_ref().ok()?;
            let evaluations = picture(shape, &view, *isa).statistics().evaluations;
            Some((evaluations.packets + evaluations.beams) as f64)
        });
        let cells = [0, 2, 4].map(|k| {
            let [with, without] =
                [k, k + 1].map(|k| times[k].map_or("—".to_owned(), |t| t.cell()));
            let work = match (work[k], work[k + 1]) {
                (Some(with), Some(without)) => digits(with / without),
                _ => "—".to_owned(),
            };
            format!(
                "{with} | {without} | {} | {work}",
                quotient(times[k], times[k + 1])
            )
        });
        println!("| {} | {} |", shape.name, cells.join(" | "));
    }
    say_skipped("rigour", NAMES, &back_ends);
}
