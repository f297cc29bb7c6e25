//! A few hundred answers of each sum in a file, for a second opinion by other software.

use std::fmt::Write;

use rayon::prelude::*;
use zeroset::camera::Sampling;
use zeroset::contract::Auto;
use zeroset::interval::Isa;
use zeroset::verdict::Verdict;

use crate::gallery;
use crate::sum::Sum;
use crate::tally::hex;

/// Answers of the sums of these seeds from pictures of size × size pixels, all of them; in the format of `arb.py`.
///
/// # Panics
/// If a picture cannot be rendered.
pub fn sample(seeds: std::ops::RangeInclusive<u64>, size: u32, isa: Isa) -> String {
    let all: Vec<String> = gallery::sums_with_terms::<Auto>(seeds)
        .into_par_iter()
        .map(|(sum, picture)| {
            let mut text = header(&sum);
            let rendering = picture.render(size, isa);
            for (x, y) in (0..size).flat_map(|y| (0..size).map(move |x| (x, y))) {
                let ray = picture.camera.ray(x, y, size, size, Sampling::Centre);
                let answer = rendering.answer(x, y);
                let mut numbers = [ray.origin.to_array(), ray.direction.to_array()].concat();
                let word = match answer.first {
                    Verdict::Miss => "miss",
                    Verdict::Root { t } => {
                        numbers.extend([answer.entry, t.lo, t.hi]);
                        "root"
                    }
                    _ => continue,
                };
                line(&mut text, word, &numbers);
            }
            text
        })
        .collect();
    all.concat()
}

fn header(sum: &Sum) -> String {
    let mut text = format!("sum {} {}\n", hex(sum.level), sum.rows.len());
    for row in &sum.rows {
        line(&mut text, "", row);
    }
    text
}

fn line(text: &mut String, word: &str, numbers: &[f64]) {
    let numbers: Vec<String> = numbers.iter().copied().map(hex).collect();
    let _ = writeln!(text, "{word} {}", numbers.join(" "));
}
