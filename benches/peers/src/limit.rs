//! Beside the limit: what proves a picture whose roots are known beforehand, by the render's own kernels.

use crate::Arguments;
use crate::shapes::{CUBE, Shape};
use crate::timing::{Contender, Spread, digits, interleave, pool, timed};
use crate::view::{Place, View};
use zeroset::Surface;
use zeroset::limit::{Counts, Limit, Part};
use zeroset::render::Rendering;

const SIZE: u32 = 512;
const PARTS: [Part; 6] = [
    Part::Beams,
    Part::Rays,
    Part::Ways,
    Part::Ends,
    Part::Gradients,
    Part::Passing,
];

/// A limit without its surface's type.
pub trait Limited {
    fn counts(&self) -> Counts;
    fn replay(&self, upto: Part) -> u64;
}

impl<S: Surface> Limited for Limit<S> {
    fn counts(&self) -> Counts {
        Limit::counts(self)
    }
    fn replay(&self, upto: Part) -> u64 {
        Limit::replay(self, upto)
    }
}

/// From a view and the picture to a limit, if there is one.
pub type Maker = Box<dyn Fn(&View, &Rendering) -> Option<Box<dyn Limited>> + Sync>;

/// For this surface.
pub fn maker<S: Surface + 'static>(surface: S) -> Maker {
    Box::new(move |view, picture| {
        let limit = Limit::new(&surface, CUBE, view.camera(), view.options(), picture)?;
        Some(Box::new(limit))
    })
}

/// Nanoseconds of processor time per ray.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    println!("\n### Beside the limit, {SIZE}², one thread, ns per ray of the picture\n");
    println!(
        "The limit knows all roots and evaluates only what proves them: f over each group of eight beams that the render looks at, once, which also ends empty tiles; for packets that show something, rays and their leaves; f over the fewest pieces that cover their ways from where beams end to the roots; f at both ends of each root's interval and its slope around it; and the gradient. *Passing* is what the rays that miss would need in the same way, as far as no beam excludes them: it is not in the limit.\n"
    );
    println!(
        "| shape | render | limit | ratio | beams | rays | ways | ends | gradient | passing | ratio with it | groups of beams | packets | pieces by packet | rays by packet |\n|{}",
        "---|".repeat(15)
    );
    for shape in shapes {
        row(shape, arguments.runs);
    }
}

fn row(shape: &Shape, runs: usize) {
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    let Some(limit) = (shape.limit)(&view, &view.render(&shape.scene)) else {
        println!("| {} | no beams, or no vectors |", shape.name);
        return;
    };
    let failed = limit.replay(Part::Passing);
    assert_eq!(failed, 0, "{}: what proved the picture fails", shape.name);
    let pool = &pool(1);
    let mut contenders: Vec<Contender> = vec![Box::new(|| {
        timed(1, || pool.install(|| view.render(&shape.scene)))
    })];
    for part in PARTS {
        let limit = &limit;
        contenders.push(Box::new(move || timed(1, || limit.replay(part))));
    }
    let times = interleave(runs, &mut contenders);
    let rays = f64::from(SIZE * SIZE);
    let ns = |t: f64| digits(1e9 * t / rays);
    let spread = |t: &Spread| format!("{} ({} … {})", ns(t.median), ns(t.least), ns(t.most));
    let parts: Vec<String> = (1..=PARTS.len())
        .map(|k| {
            let before = if k == 1 { 0.0 } else { times[k - 1].median };
            ns((times[k].median - before).max(0.0))
        })
        .collect();
    let counts = limit.counts();
    println!(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
        shape.name,
        spread(&times[0]),
        spread(&times[5]),
        digits(times[0].median / times[5].median),
        parts.join(" | "),
        digits(times[0].median / times[6].median),
        counts.groups,
        counts.packets,
        digits(counts.pieces as f64 / counts.packets as f64),
        digits(counts.hits as f64 / counts.packets as f64),
    );
    if counts.left > 0 {
        println!(
            "\n{}: the limit leaves out {} rays\n",
            shape.name, counts.left
        );
    }
}
