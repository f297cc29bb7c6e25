//! What each skip saves: the options of a render switched off in turn.

use crate::Arguments;
use crate::shapes::Shape;
use crate::timing::{Contender, digits, interleave, pool, timed};
use crate::view::{Place, View};
use zeroset::render::{Options, Statistics, render};

const SIZE: u32 = 512;

/// A name, and what it changes.
type Change = (&'static str, fn(&mut Options));

const CHANGES: [Change; 7] = [
    ("all on", |_| ()),
    ("no beams", |o| o.settings.beams = false),
    ("all rows and sides", |o| o.settings.thin = false),
    ("no closed forms", |o| o.settings.closed_forms = false),
    ("no plain convergence", |o| {
        o.settings.plain_convergence = false
    }),
    ("no normals", |o| o.normals = false),
    ("none of the three", |o| {
        o.settings.beams = false;
        o.settings.closed_forms = false;
        o.settings.plain_convergence = false;
    }),
];

/// Times and counters, per ray of the picture.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    println!("\n### What each skip saves, {SIZE}², one thread; counts per ray of the picture\n");
    println!(
        "| shape | | ms | by all on | rays made | rows bound | choices decided | empty pieces | beams | value | slope | curvature | point | float | fine | gradient | closed | single | root / miss / other |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    let pool = pool(1);
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    for shape in shapes {
        let picture = |change: fn(&mut Options)| {
            let mut options = view.options();
            change(&mut options);
            render(&shape.scene, &view.camera(), &options).expect("a valid scene")
        };
        let pool = &pool;
        let mut contenders: Vec<Contender> = CHANGES
            .iter()
            .map(|&(_, change)| -> Contender {
                Box::new(move || timed(1, || pool.install(|| picture(change))))
            })
            .collect();
        let times = interleave(arguments.runs, &mut contenders);
        for ((name, change), time) in CHANGES.iter().zip(&times) {
            println!(
                "| {} | {name} | {} | {} | {} |",
                shape.name,
                time.cell(),
                digits(time.median / times[0].median),
                counts(picture(*change).statistics())
            );
        }
    }
}

fn counts(s: &Statistics) -> String {
    let e = &s.evaluations;
    let kinds = [
        s.made,
        e.rows,
        e.decided,
        e.empty,
        e.beams,
        e.value,
        e.slope,
        e.curvature,
        e.point,
        e.float,
        e.fine,
        e.gradient,
        e.closed,
        e.single,
    ];
    let kinds = kinds.map(|n| digits(n as f64 / s.rays as f64)).join(" | ");
    format!(
        "{kinds} | {} / {} / {}",
        s.root,
        s.miss,
        s.rays - s.root - s.miss
    )
}
