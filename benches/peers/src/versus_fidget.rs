//! Beside fidget: from the constructed shape to finished depth and normals.
//!
//! fidget's `Shape` holds the formula as a tape for its virtual machine, made beforehand; tapes for the machine at hand,
//! those of tiles among them, are compiled while it renders. Of its evaluators the one counts that is faster.

use crate::Arguments;
use crate::judge::Sampled;
use crate::shapes::Shape;
use crate::timing::{Contender, digits, interleave, pool, timed};
use crate::view::{Place, Shown, View};
use fidget::eval::MathFunction;
use fidget::jit::JitFunction;
use fidget::raster::voxel::{EvalConfig, Image, RenderConfig, render};
use fidget::render::{CancelToken, RenderHints, ThreadPool};
use fidget::shape::ShapeVars;
use fidget::vm::VmFunction;

/// fidget's picture of a shape with the default tile sizes.
pub fn picture<F: MathFunction + RenderHints>(
    shape: &fidget::shape::Shape<F>,
    size: u32,
    threads: Option<&ThreadPool>,
) -> Image {
    let vars = ShapeVars::new();
    let config = EvalConfig {
        tile_sizes: None,
        threads,
        cancel: CancelToken::new(),
    };
    let bound = shape.bind(&vars).expect("no variables");
    render(bound, &RenderConfig::from_size(size.into()), &config).expect("it is not cancelled")
}

/// What it shows: the middle of the voxel edge on which f changes its sign.
pub fn shown(picture: &Image, i: u32, j: u32) -> Shown {
    let half = 0.5 * picture.width() as f64;
    match picture[(j as usize, i as usize)].depth {
        0 => Shown::Miss,
        depth => Shown::At((f64::from(depth) - 0.5 - half) / half),
    }
}

/// All shapes, sizes and numbers of threads.
pub fn run(shapes: &[Shape], arguments: &Arguments) {
    for &size in &arguments.size {
        println!("\n### Beside fidget, {size}²\n");
        println!(
            "| shape | threads | fidget, ms | evaluator | zeroset, ms | ratio |\n|---|---|---|---|---|---|"
        );
        let mut ratios = vec![Vec::new(); arguments.threads.len()];
        for shape in shapes {
            for (&threads, ratios) in arguments.threads.iter().zip(&mut ratios) {
                ratios.push(measure(shape, size, threads, arguments.runs));
            }
        }
        for (threads, ratios) in arguments.threads.iter().zip(&ratios) {
            let mean = ratios.iter().map(|r: &f64| r.ln()).sum::<f64>() / ratios.len() as f64;
            println!(
                "| **geometric mean** | {threads} | | | | **{}** |",
                digits(mean.exp())
            );
        }
        println!(
            "\nWrong pixels and errors of depth (median / largest), against a march in plain f64 by hand:\n"
        );
        println!(
            "| shape | rays | that hit | fidget wrong | fidget error | zeroset wrong | open | zeroset error | certified width, whole picture |"
        );
        println!("|---|---|---|---|---|---|---|---|---|");
        for shape in shapes {
            compare(shape, size, arguments.rays);
        }
    }
}

/// One row of times; the ratio.
fn measure(shape: &Shape, size: u32, threads: usize, runs: usize) -> f64 {
    let jit = fidget::shape::Shape::<JitFunction>::from(shape.tree.clone());
    let vm = fidget::shape::Shape::<VmFunction>::from(shape.tree.clone());
    let theirs = (threads > 1).then(|| ThreadPool::Custom(pool(threads)));
    let ours = pool(threads);
    let view = View {
        size,
        place: Place::Corner,
    };
    let by_jit = || timed(threads, || picture(&jit, size, theirs.as_ref()));
    let by_vm = || timed(threads, || picture(&vm, size, theirs.as_ref()));
    // An evaluator that is far behind need not run on.
    let (once_jit, once_vm) = (by_jit(), by_vm());
    let mut names = vec!["", "JIT", "interpreter"];
    let mut contenders: Vec<Contender> = vec![
        Box::new(|| timed(threads, || ours.install(|| view.render(&shape.scene)))),
        Box::new(by_jit),
        Box::new(by_vm),
    ];
    if once_jit > once_vm * 2 {
        names.remove(1);
        drop(contenders.remove(1));
    } else if once_vm > once_jit * 2 {
        names.truncate(2);
        contenders.truncate(2);
    }
    let times = interleave(runs, &mut contenders);
    let zeroset = times[0];
    let (name, fidget) = names[1..]
        .iter()
        .zip(&times[1..])
        .min_by(|a, b| a.1.median.total_cmp(&b.1.median))
        .expect("an evaluator");
    let ratio = fidget.median / zeroset.median;
    println!(
        "| {} | {threads} | {} | {name} | {} | {} |",
        shape.name,
        fidget.cell(),
        zeroset.cell(),
        digits(ratio)
    );
    ratio
}

/// One row of errors.
fn compare(shape: &Shape, size: u32, rays: u32) {
    let view = View {
        size,
        place: Place::Corner,
    };
    let ours = view.render(&shape.scene);
    let jit = fidget::shape::Shape::<JitFunction>::from(shape.tree.clone());
    let theirs = picture(&jit, size, Some(&ThreadPool::Global));
    let mut sampled = Sampled::new(shape, view, rays);
    sampled.look_again(|i, j| View::shown(&ours, i, j));
    let zeroset = sampled.judge(|i, j| View::shown(&ours, i, j));
    let fidget = sampled.judge(|i, j| shown(&theirs, i, j));
    let widest = (0..size)
        .flat_map(|j| (0..size).map(move |i| (i, j)))
        .filter_map(|(i, j)| match ours.answer(i, j).first {
            zeroset::verdict::Verdict::Root { t } => Some(t.hi - t.lo),
            _ => None,
        })
        .fold(0.0, f64::max);
    let statistics = ours.statistics();
    let hits = sampled.rays.iter().filter(|r| r.1.is_some()).count();
    println!(
        "| {} | {} | {hits} | {} | {} | {} | {} of {} | {} | {} |",
        shape.name,
        zeroset.rays,
        fidget.wrong_cell(),
        fidget.error_cell(),
        zeroset.wrong_cell(),
        statistics.rays - statistics.root - statistics.miss,
        statistics.rays,
        zeroset.error_cell(),
        digits(widest),
    );
    if zeroset.wrong() > 0 {
        println!(
            "\nzeroset is wrong, first of all at {:?} of {}\n",
            zeroset.examples, shape.name
        );
    }
}
