//! How time grows with pixels, terms and spheres, and shrinks with threads.

use crate::Arguments;
use crate::shapes::{self, Shape};
use crate::timing::{Contender, Spread, digits, interleave, pool, timed};
use crate::view::{Place, View};

/// The side of the pictures in which only the number of terms changes.
const SIZE: u32 = 512;

/// Three tables.
pub fn run(arguments: &Arguments) {
    let runs = arguments.runs;
    pixels(arguments.largest.clamp(256, 4096), runs);
    let most = arguments.terms.clamp(8, 4096);
    let counts: Vec<usize> = (3..=12).map(|k| 1 << k).filter(|n| *n <= most).collect();
    terms("exponentials", &counts, runs, |n| {
        shapes::exponentials(terms_of(n))
    });
    terms("spheres", &counts, runs, |n| shapes::spheres(spheres_of(n)));
    threads(runs);
}

fn chosen() -> Vec<Shape> {
    let mut shapes = shapes::all();
    shapes.retain(|s| {
        ["sphere", "Barth sextic", "8 exponentials", "64 spheres"].contains(&s.name.as_str())
    });
    shapes
}

/// Time per pixel, in fresh memory and in that of the last picture.
fn pixels(largest: u32, runs: usize) {
    let sizes: Vec<u32> = (8..=12).map(|k| 1 << k).filter(|n| *n <= largest).collect();
    println!("\n### Growth: ns per pixel, one thread\n");
    let columns: Vec<String> = sizes.iter().map(|n| format!("{n}²")).collect();
    println!(
        "| shape | {} |\n|---|{}",
        columns.join(" | "),
        "---|".repeat(sizes.len())
    );
    let pool = pool(1);
    for shape in chosen() {
        let (shape, pool) = (&shape, &pool);
        let views = sizes.iter().map(|&size| View {
            size,
            place: Place::Centre,
        });
        let fresh = views.clone().map(|view| -> Contender {
            Box::new(move || timed(1, || pool.install(|| view.render(&shape.scene))))
        });
        let again = views.map(|view| -> Contender {
            let mut last = None;
            Box::new(move || {
                let old = last.take();
                timed(1, || {
                    last = Some(pool.install(|| view.render_over(old, &shape.scene)));
                })
            })
        });
        let mut contenders: Vec<Contender> = fresh.chain(again).collect();
        let times = interleave(runs, &mut contenders);
        let (fresh, again) = times.split_at(sizes.len());
        row(&shape.name, &sizes, fresh);
        row(
            &format!("{}, over the last picture", shape.name),
            &sizes,
            again,
        );
    }
}

/// Nanoseconds per pixel of pictures of these sizes.
fn row(name: &str, sizes: &[u32], times: &[Spread]) {
    let cells = sizes.iter().zip(times).map(|(&n, time)| {
        let scale = 1e9 / (f64::from(n) * f64::from(n));
        let [median, least, most] = [time.median, time.least, time.most].map(|t| digits(scale * t));
        format!("{median} ({least} … {most})")
    });
    println!("| {name} | {} |", cells.collect::<Vec<_>>().join(" | "));
}

/// Milliseconds against the number of terms, beside what a linear law would give from the first on.
fn terms(what: &str, counts: &[usize], runs: usize, make: impl Fn(usize) -> Shape) {
    println!("\n### Growth: {what}, {SIZE}², one thread\n");
    println!(
        "| {what} | ms | time by the first | number by the first | exponent since the row above | hit, % |\n|---|---|---|---|---|---|"
    );
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    let pool = pool(1);
    let shapes: Vec<Shape> = counts.iter().map(|&n| make(n)).collect();
    let mut contenders: Vec<Contender> = shapes
        .iter()
        .map(|shape| -> Contender {
            let pool = &pool;
            Box::new(move || timed(1, || pool.install(|| view.render(&shape.scene))))
        })
        .collect();
    let times = interleave(runs, &mut contenders);
    for (k, (&n, time)) in counts.iter().zip(&times).enumerate() {
        let picture = view.render(&shapes[k].scene);
        let statistics = picture.statistics();
        let exponent = |above: &Spread| digits((time.median / above.median).log2());
        println!(
            "| {n} | {} | {} | {} | {} | {:.0} |",
            time.cell(),
            digits(time.median / times[0].median),
            n / counts[0],
            k.checked_sub(1)
                .map_or("—".to_owned(), |above| exponent(&times[above])),
            100.0 * statistics.root as f64 / statistics.rays as f64
        );
    }
}

/// Two threads beside one, by the clock on the wall.
fn threads(runs: usize) {
    println!("\n### Two threads against one, {SIZE}², ms by the clock on the wall\n");
    println!(
        "| shape | one | two | quotient of the medians | of the least |\n|---|---|---|---|---|"
    );
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    let pools = [pool(1), pool(2)];
    for shape in chosen() {
        let shape = &shape;
        let mut contenders: Vec<Contender> = pools
            .iter()
            .map(|pool| -> Contender {
                // Not 1: that would be processor time.
                Box::new(move || timed(2, || pool.install(|| view.render(&shape.scene))))
            })
            .collect();
        let times = interleave(runs, &mut contenders);
        println!(
            "| {} | {} | {} | {} | {} |",
            shape.name,
            times[0].cell(),
            times[1].cell(),
            digits(times[0].median / times[1].median),
            digits(times[0].least / times[1].least)
        );
    }
}

/// Numbers in [0, 1) from a fixed seed, multiples of 1/4096.
fn random() -> impl FnMut() -> f64 {
    let mut state = 1u64;
    move || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 52) as f64 / 4096.0
    }
}

/// A point of the ball of radius 0.7.
fn centre(random: &mut impl FnMut() -> f64) -> [f64; 3] {
    loop {
        let c: [f64; 3] = std::array::from_fn(|_| 1.4 * random() - 0.7);
        if c.iter().map(|v| v * v).sum::<f64>() < 0.49 {
            return c;
        }
    }
}

/// Balls whose discs have the same area together, whatever their number.
fn spheres_of(n: usize) -> Vec<[f64; 4]> {
    let mut random = random();
    let scale = (1.0 / n as f64).sqrt();
    (0..n)
        .map(|_| {
            let [x, y, z] = centre(&mut random);
            [x, y, z, scale * (0.7 + 0.6 * random())]
        })
        .collect()
}

/// Exponentials that shrink likewise, with axes that are a little askew.
fn terms_of(n: usize) -> Vec<[f64; 9]> {
    let mut random = random();
    let scale = (n as f64).sqrt();
    (0..n)
        .map(|_| {
            let [x, y, z] = centre(&mut random);
            let mut axis = || scale * (0.8 + 0.4 * random());
            let [a, d, f] = [axis(), axis(), axis()];
            let mut askew = || 0.4 * scale * (random() - 0.5);
            [x, y, z, a, askew(), askew(), d, askew(), f]
        })
        .collect()
}
