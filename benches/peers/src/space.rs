//! The two ways to skip many rays at once: space in boxes, which serves any number of pictures, and beams, which serve one.

use crate::Arguments;
use crate::shapes::Shape;
use crate::timing::{Contender, Spread, digits, interleave, pool, timed};
use crate::view::{Place, View};
use zeroset::Scene;
use zeroset::render::{Options, Rendering, render};
use zeroset::space::Subdivision;

const SIZE: u32 = 512;

/// A name, and whether space and beams are used.
const WAYS: [(&str, bool, bool); 4] = [
    ("none", false, false),
    ("octree", true, false),
    ("beams", false, true),
    ("both", true, true),
];

/// Times and counters, per ray of the picture; the octree's own cost on the row of its name.
pub fn run(shapes: &mut [Shape], arguments: &Arguments) {
    let depth = arguments.depth;
    println!(
        "\n### Space in boxes and beams, {SIZE}², one thread; depth {depth}; counts per ray of the picture\n"
    );
    println!(
        "| shape | | ms | by none | rays made | beams | ray evaluations | passed by | shortened | boxes to build, ms | boxes left | evaluations of eight boxes | root / miss / other |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|"
    );
    let pool = pool(1);
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    for shape in shapes {
        let how = Subdivision {
            depth,
            ..Subdivision::default()
        };
        let builds = Spread::of(
            (0..arguments.runs.max(1))
                .map(|_| {
                    let scene = std::mem::take(&mut shape.scene);
                    let mut divided = Scene::new();
                    let time = timed(1, || {
                        divided = pool.install(|| scene.subdivided(&how).expect("a valid scene"));
                    });
                    shape.scene = divided;
                    time.as_secs_f64()
                })
                .collect(),
        );
        let scene = &shape.scene;
        let picture = |space, beams| picture(scene, &view, space, beams);
        let pool = &pool;
        let mut contenders: Vec<Contender> = WAYS
            .iter()
            .map(|&(_, space, beams)| -> Contender {
                Box::new(move || timed(1, || pool.install(|| picture(space, beams))))
            })
            .collect();
        let times = interleave(arguments.runs, &mut contenders);
        for (&(name, space, beams), time) in WAYS.iter().zip(&times) {
            let built = match (name, scene.octree()) {
                ("octree", Some(octree)) => {
                    let census = octree.census();
                    format!(
                        "{} | {} | {}",
                        builds.cell(),
                        census.open,
                        census.evaluations
                    )
                }
                _ => "| |".to_owned(),
            };
            println!(
                "| {} | {name} | {} | {} | {} | {built} | {} |",
                shape.name,
                time.cell(),
                digits(time.median / times[0].median),
                counts(&picture(space, beams)),
                verdicts(&picture(space, beams)),
            );
        }
    }
}

fn picture(scene: &Scene, view: &View, space: bool, beams: bool) -> Rendering {
    let mut options: Options = view.options();
    options.settings.space = space;
    options.settings.beams = beams;
    render(scene, &view.camera(), &options).expect("a valid scene")
}

fn counts(picture: &Rendering) -> String {
    let s = picture.statistics();
    let e = &s.evaluations;
    [s.made, e.beams, e.total(), e.apart, e.trimmed]
        .map(|n| digits(n as f64 / s.rays as f64))
        .join(" | ")
}

fn verdicts(picture: &Rendering) -> String {
    let s = picture.statistics();
    format!("{} / {} / {}", s.root, s.miss, s.rays - s.root - s.miss)
}
