//! The same render on every back-end of this processor, and by the same algorithms with one lane in place of eight.

use crate::Arguments;
use crate::shapes::Shape;
use crate::timing::{Contender, Spread, digits, interleave, pool, timed};
use crate::view::{Place, View};
use std::mem::discriminant;
use zeroset::interval::{Isa, IsaError};
use zeroset::render::{Rendering, render};

const SIZE: u32 = 512;
const NAMES: [&str; 4] = ["avx512", "avx512-one", "avx2", "portable"];

/// The back-ends of these names, as far as they are there and compiled.
pub fn back_ends<const N: usize>(names: [&str; N]) -> [Result<Isa, IsaError>; N] {
    names.map(Isa::named)
}

/// Says of each that is missing why it is.
pub fn say_skipped<const N: usize>(
    section: &str,
    names: [&str; N],
    back_ends: &[Result<Isa, IsaError>; N],
) {
    println!();
    for (name, back_end) in names.iter().zip(back_ends) {
        match back_end {
            Ok(_) => {}
            Err(IsaError::Unknown { .. }) => println!(
                "SKIPPED {section}, {name}: not compiled; build with --features one-lane,unrounded"
            ),
            Err(error) => println!("SKIPPED {section}, {name}: {error}"),
        }
    }
}

/// A picture on one back-end.
pub fn picture(shape: &Shape, view: &View, isa: Isa) -> Rendering {
    let mut options = view.options();
    options.isa = Some(isa);
    #[cfg(feature = "unrounded")]
    if Isa::unrounded().contains(&isa) {
        return render(&shape.unrounded, &view.camera(), &options).expect("a valid scene");
    }
    render(&shape.scene, &view.camera(), &options).expect("a valid scene")
}

/// Times of a picture on each back-end, interleaved, on one thread.
pub fn times<const N: usize>(
    shape: &Shape,
    view: &View,
    back_ends: &[Result<Isa, IsaError>; N],
    runs: usize,
) -> [Option<Spread>; N] {
    let pool = &pool(1);
    let mut contenders: Vec<Contender> = Vec::new();
    for &isa in back_ends.iter().flatten() {
        contenders.push(Box::new(move || {
            timed(1, || pool.install(|| picture(shape, view, isa)))
        }));
    }
    let mut times = interleave(runs, &mut contenders).into_iter();
    back_ends
        .each_ref()
        .map(|b| b.is_ok().then(|| times.next()).flatten())
}

/// The quotient of two medians, for a cell of a table.
pub fn quotient(above: Option<Spread>, below: Option<Spread>) -> String {
    match (above, below) {
        (Some(a), Some(b)) => digits(a.median / b.median),
        _ => "—".to_owned(),
    }
}

/// Milliseconds of processor time on each.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    println!("\n### Packets, {SIZE}², one thread, ms\n");
    println!(
        "`avx512-one` takes a packet's rays and a group's beams one by one, by the same code, with scalar instructions of AVX-512, which round as the vectors do. *Busy* is how many evaluations it makes for one of eight lanes: no more than so many lanes have work. *Decided* is how many choices between sides an evaluation decides, of eight lanes and of one: eight must agree. *Others* counts pixels with another verdict than on eight lanes, and those with another interval: eight lanes use a polynomial's hull only where it tells for all of them.\n"
    );
    println!(
        "| shape | {} | one lane by eight | busy | decided | avx2 by avx512 | portable by avx512 | others |\n|{}",
        NAMES.join(" | "),
        "---|".repeat(11)
    );
    let back_ends = back_ends(NAMES);
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    for shape in shapes {
        let mut compared = ["—", "—", "—"].map(str::to_owned);
        if let [Ok(eight), Ok(one), ..] = &back_ends {
            compared = compare(&picture(shape, &view, *eight), &picture(shape, &view, *one));
        }
        let times = times(shape, &view, &back_ends, arguments.runs);
        println!(
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            shape.name,
            times
                .map(|t| t.map_or("—".to_owned(), |t| t.cell()))
                .join(" | "),
            quotient(times[1], times[0]),
            compared[0],
            compared[1],
            quotient(times[2], times[0]),
            quotient(times[3], times[0]),
            compared[2],
        );
    }
    say_skipped("packets", NAMES, &back_ends);
}

/// How many evaluations of one lane stand for one of eight, what each decides, and how many pixels differ.
fn compare(eight: &Rendering, one: &Rendering) -> [String; 3] {
    let counts = [eight, one].map(|picture| {
        let evaluations = picture.statistics().evaluations;
        let all = (evaluations.packets + evaluations.beams) as f64;
        (all, evaluations.decided as f64 / all)
    });
    let [(all, together), (parts, alone)] = counts;
    let decided = if together == 0.0 {
        "—".to_owned()
    } else {
        format!("{} and {}", digits(together), digits(alone))
    };
    let [verdicts, intervals] = others(eight, one);
    [
        digits(parts / all),
        decided,
        format!("{verdicts} and {intervals}"),
    ]
}

/// How many pixels have another verdict, and how many another interval.
pub fn others(first: &Rendering, second: &Rendering) -> [usize; 2] {
    let pixels = (0..first.height()).flat_map(|j| (0..first.width()).map(move |i| (i, j)));
    let mut others = [0; 2];
    for (i, j) in pixels {
        let (a, b) = (first.answer(i, j), second.answer(i, j));
        if discriminant(&a.first) != discriminant(&b.first) {
            others[0] += 1;
        } else if a != b {
            others[1] += 1;
        }
    }
    others
}
