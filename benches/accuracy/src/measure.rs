//! Times, errors and counts of all methods on one surface.

use std::hint::black_box;

use cpu_time::ProcessTime;
use zeroset::interval::Isa;
use zeroset_accuracy::judge::Score;
use zeroset_accuracy::methods::Method;
use zeroset_accuracy::ours::{Solver, picture};
use zeroset_accuracy::subject::{Eight, Subject};
use zeroset_accuracy::trial::Trial;
use zeroset_accuracy::truth::Known;

/// Timed runs of each method.
pub const RUNS: usize = 5;
/// Columns and rows of the picture that this library is timed on: beams serve many rays.
pub const TIMED: u32 = 512;
/// Others than this library are timed on every so many packets of eight rays.
const SHARE: usize = 5;
/// What a tuning may get wrong, as a share of the rays that are judged.
pub const CARELESS: f64 = 0.01;

/// How a setting was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tuning {
    /// This library has none.
    None,
    /// The fewest wrong rays, and among these the fewest evaluations.
    Careful,
    /// The fewest evaluations with at most [`CARELESS`] of the rays wrong.
    Careless,
}

/// One method at one tolerance.
#[derive(Clone, Debug)]
pub struct Row {
    pub surface: String,
    pub method: String,
    /// Steps, or a degree.
    pub setting: Option<u32>,
    pub tuning: Tuning,
    pub isa: String,
    pub tolerance: Option<f64>,
    /// Processor time per ray; the median.
    pub nanoseconds: f64,
    pub evaluations: f64,
    pub found: Found,
}

/// What a row keeps of a score.
#[derive(Clone, Copy, Debug, Default)]
pub struct Found {
    pub largest: f64,
    pub median: f64,
    /// Rays that were judged, and how many of them …
    pub rays: u32,
    /// … have the right root, …
    pub right: u32,
    /// … are wrong in one of three ways, …
    pub missed: u32,
    pub invented: u32,
    pub wrong_sheet: u32,
    /// … or open.
    pub open: u32,
}

impl Found {
    fn of(score: &Score) -> Self {
        Found {
            largest: score.largest(),
            median: score.median(),
            rays: score.rays,
            right: score.errors.len() as u32,
            missed: score.missed,
            invented: score.invented,
            wrong_sheet: score.wrong_sheet,
            open: score.open,
        }
    }

    /// Wrong answers of all kinds.
    pub fn wrong(&self) -> u32 {
        self.missed + self.invented + self.wrong_sheet
    }
}

impl Row {
    pub fn is_ours(&self) -> bool {
        self.tuning == Tuning::None
    }
}

/// From 1e-2 down to 1e-15.
pub fn tolerances() -> impl Iterator<Item = f64> {
    (2..=15).map(|digits| 10f64.powi(-digits))
}

enum Work {
    Ours(Solver, Isa),
    Theirs(Method, f64),
}

pub fn measure(subject: &dyn Subject, known: &[Known]) -> Vec<Row> {
    let trial = Trial::new(subject, known);
    let best = Isa::available()[0];
    let mut works = Vec::new();
    let mut rows = Vec::new();
    for isa in Isa::available() {
        for &solver in subject.solvers() {
            let (score, evaluations) = trial.ours(solver, isa);
            works.push(Work::Ours(solver, isa));
            rows.push(Row {
                surface: subject.name().to_owned(),
                method: solver.name().to_owned(),
                setting: None,
                tuning: Tuning::None,
                isa: isa.name().to_owned(),
                tolerance: None,
                nanoseconds: 0.0,
                evaluations,
                found: Found::of(&score),
            });
        }
    }
    for settings in Method::ladder(subject.degree()) {
        for tolerance in tolerances() {
            for (tuning, method, score, evaluations) in tuned(&trial, &settings, tolerance, best) {
                works.push(Work::Theirs(method, tolerance));
                rows.push(Row {
                    surface: subject.name().to_owned(),
                    method: method.name().to_owned(),
                    setting: Some(method.setting()),
                    tuning,
                    isa: best.name().to_owned(),
                    tolerance: Some(tolerance),
                    nanoseconds: 0.0,
                    evaluations,
                    found: Found::of(&score),
                });
            }
        }
    }
    let times = timed(subject, &works, best);
    for (row, time) in rows.iter_mut().zip(times) {
        row.nanoseconds = time;
    }
    rows
}

/// The best settings of a method by both tunings.
fn tuned(
    trial: &Trial,
    settings: &[Method],
    tolerance: f64,
    isa: Isa,
) -> Vec<(Tuning, Method, Score, f64)> {
    let mut tried: Vec<(Method, Score, f64)> = Vec::new();
    let (mut least, mut stalled) = (u32::MAX, 0);
    for &method in settings {
        let (score, evaluations) = trial.theirs(method, tolerance, isa);
        let wrong = score.wrong();
        tried.push((method, score, evaluations));
        stalled = if wrong < least { 0 } else { stalled + 1 };
        least = least.min(wrong);
        // Larger settings take longer, and are not expected to be better.
        if wrong == 0 || stalled == 3 {
            break;
        }
    }
    let few = |score: &Score| f64::from(score.wrong()) <= CARELESS * f64::from(score.rays);
    let careful = tried.iter().min_by(|a, b| {
        (a.1.wrong(), a.2)
            .partial_cmp(&(b.1.wrong(), b.2))
            .expect("numbers")
    });
    let careless = tried
        .iter()
        .filter(|(_, score, _)| few(score))
        .min_by(|a, b| a.2.total_cmp(&b.2))
        .filter(|one| careful.is_none_or(|other| one.0 != other.0));
    let both = [(Tuning::Careful, careful), (Tuning::Careless, careless)];
    both.into_iter()
        .filter_map(|(tuning, found)| found.map(|(m, s, e)| (tuning, *m, s.clone(), *e)))
        .collect()
}

/// All of them in turn, several times; the median of each.
fn timed(subject: &dyn Subject, works: &[Work], best: Isa) -> Vec<f64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("one thread");
    let solvers = subject.solvers().iter();
    let scenes: Vec<_> = solvers.map(|&s| (s, subject.scene(s))).collect();
    let camera = subject.camera();
    // Evenly over the picture.
    let packets: Vec<Eight> = subject.packets().into_iter().step_by(SHARE).collect();
    let mut times = vec![Vec::with_capacity(RUNS); works.len()];
    for _ in 0..RUNS {
        for (work, times) in works.iter().zip(&mut times) {
            let start = ProcessTime::now();
            let rays = match *work {
                Work::Ours(solver, isa) => {
                    let scene = scenes.iter().find(|(s, _)| *s == solver);
                    let (_, scene) = scene.expect("a scene for each solver");
                    black_box(pool.install(|| picture(scene, &camera, isa, TIMED)));
                    f64::from(TIMED * TIMED)
                }
                Work::Theirs(method, tolerance) => {
                    black_box(subject.trace(best, &packets, method, tolerance));
                    8.0 * packets.len() as f64
                }
            };
            times.push(start.elapsed().as_nanos() as f64 / rays);
        }
    }
    times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[RUNS / 2]
        })
        .collect()
}
