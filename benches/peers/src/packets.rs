//! The same render on every back-end of this processor. All of them have eight lanes.

use crate::Arguments;
use crate::shapes::Shape;
use crate::timing::{Contender, digits, interleave, pool, timed};
use crate::view::{Place, View};
use zeroset::interval::Isa;
use zeroset::render::render;

const SIZE: u32 = 512;
const NAMES: [&str; 3] = ["avx512", "avx2", "portable"];

/// Milliseconds of processor time on each.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    println!("\n### Packets, {SIZE}², one thread, ms\n");
    println!(
        "| shape | {} | portable by avx2 | portable by avx512 |\n|---|---|---|---|---|---|",
        NAMES.join(" | ")
    );
    let back_ends = NAMES.map(|name| Isa::named(name).map_err(|e| e.to_string()));
    let pool = pool(1);
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    for shape in shapes {
        let mut contenders: Vec<Contender> = Vec::new();
        for &isa in back_ends.iter().flatten() {
            let mut options = view.options();
            options.isa = Some(isa);
            let (camera, pool) = (view.camera(), &pool);
            contenders.push(Box::new(move || {
                let work = || render(&shape.scene, &camera, &options).expect("a valid scene");
                timed(1, || pool.install(work))
            }));
        }
        let mut times = interleave(arguments.runs, &mut contenders).into_iter();
        let times = back_ends
            .each_ref()
            .map(|b| b.is_ok().then(|| times.next()).flatten());
        let ratio = |of: usize| match (times[of], times[2]) {
            (Some(a), Some(b)) => digits(b.median / a.median),
            _ => "—".to_owned(),
        };
        let cells = times.map(|t| t.map_or("—".to_owned(), |t| t.cell()));
        println!(
            "| {} | {} | {} | {} |",
            shape.name,
            cells.join(" | "),
            ratio(1),
            ratio(0)
        );
    }
    println!();
    for (name, error) in NAMES.iter().zip(&back_ends) {
        if let Err(error) = error {
            println!("SKIPPED packets, {name}: {error}");
        }
    }
    println!("SKIPPED packets, one lane: the library has no back-end of one lane");
}
