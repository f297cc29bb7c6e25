//! Pictures: a scene, a camera and the oracle that knows the answers; and what comes of them on every path.

use std::io::Write;
use std::sync::Once;

use rayon::prelude::*;
use zeroset::camera::{Camera, Ray, Sampling};
use zeroset::interval::Isa;
use zeroset::render::{Options, Rendering, all_roots, first_roots, render};
use zeroset::scene::Scene;
use zeroset::solve::Settings;
use zeroset::verdict::{Answer, Verdict};

use crate::judge::Oracle;
use crate::segment::Corners;
use crate::tally::{Tally, describe, kind};

/// A scene with one surface, seen by a camera, and the oracle for it.
pub struct Picture {
    /// What it shows.
    pub name: String,
    /// One surface without a domain of its own.
    pub scene: Scene,
    /// The scene's box.
    pub corners: Corners,
    /// Where from.
    pub camera: Camera,
    /// How to search.
    pub settings: Settings,
    /// The truth.
    pub oracle: Box<dyn Oracle + Send>,
}

/// What came of a picture, or of a list of rays.
#[derive(Clone, Default)]
pub struct Outcome {
    /// The picture's name.
    pub name: String,
    /// For each path: its name, and its counts.
    pub paths: Vec<(&'static str, Tally)>,
    /// Rays on which the paths' verdicts are not of one kind.
    pub differences: Vec<String>,
    /// Of these, the rays that are a miss on one path and a root on another.
    pub contradictions: u64,
    /// Lists of all roots that the oracle refutes.
    pub wrong_lists: Vec<String>,
}

/// The processor paths of this machine; says once which ones they are, and which are missing.
pub fn paths() -> Vec<Isa> {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for name in ["avx512", "avx2", "portable"] {
            match Isa::named(name) {
                Ok(_) => say(&format!("path {name}: runs")),
                Err(error) => say(&format!("SKIPPED path {name}: {error}")),
            }
        }
    });
    Isa::available()
}

/// Prints a line that is seen even when a test passes: the test harness keeps back what `println!` prints.
pub fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

impl Picture {
    /// Renders it on each of `paths`, size × size pixels, and has every answer judged.
    ///
    /// # Panics
    /// If it cannot be rendered.
    pub fn check(&self, size: u32, paths: &[Isa]) -> Outcome {
        let renderings: Vec<Rendering> = paths.iter().map(|&isa| self.render(size, isa)).collect();
        let row = |y| {
            let mut row = Outcome::new(&self.name, paths);
            for x in 0..size {
                let ray = self.camera.ray(x, y, size, size, Sampling::Centre);
                let answers: Vec<Answer> = renderings.iter().map(|r| r.answer(x, y)).collect();
                row.add(self, &ray, &answers);
            }
            row
        };
        let none = || Outcome::new(&self.name, paths);
        (0..size)
            .into_par_iter()
            .map(row)
            .reduce(none, Outcome::join)
    }

    /// Has the answers to single rays judged: all roots, and the first root by them.
    ///
    /// # Panics
    /// If a ray is refused.
    pub fn check_rays(&self, rays: &[Ray], paths: &[Isa]) -> Outcome {
        let one = |ray: &Ray| {
            let mut outcome = Outcome::new(&self.name, paths);
            let mut answers = Vec::new();
            for &isa in paths {
                let lists = all_roots(&self.scene, ray, &self.options(1, isa));
                let (entry, events) = &lists.expect("a valid ray")[0];
                let answer = Answer::from_events(*entry, events);
                let judged = self.oracle.judge_all(ray, &self.corners, *entry, events);
                if let Err(why) = judged {
                    let text = describe(ray, &answer);
                    let list = format!("{}: {why}: {text} of {events:?}", isa.name());
                    outcome.wrong_lists.push(list);
                }
                answers.push(answer);
            }
            outcome.add(self, ray, &answers);
            outcome
        };
        let none = || Outcome::new(&self.name, paths);
        rays.par_iter().map(one).reduce(none, Outcome::join)
    }

    /// The answer to a single ray.
    ///
    /// # Panics
    /// If the ray is refused.
    pub fn first_root(&self, ray: &Ray, isa: Isa) -> Answer {
        let answers = first_roots(&self.scene, ray, &self.options(1, isa));
        answers.expect("a valid ray")[0]
    }

    /// Renders it on one path, size × size pixels.
    ///
    /// # Panics
    /// If it cannot be rendered.
    pub fn render(&self, size: u32, isa: Isa) -> Rendering {
        render(&self.scene, &self.camera, &self.options(size, isa)).expect("a valid scene")
    }

    fn options(&self, size: u32, isa: Isa) -> Options<'static> {
        let mut options = Options::new(size, size);
        options.isa = Some(isa);
        options.settings = self.settings;
        options.normals = false;
        options
    }
}

impl Outcome {
    fn new(name: &str, paths: &[Isa]) -> Self {
        let tallies = paths.iter().map(|isa| (isa.name(), Tally::default()));
        Outcome {
            name: name.into(),
            paths: tallies.collect(),
            ..Outcome::default()
        }
    }

    /// Counts the paths' answers about one ray.
    fn add(&mut self, picture: &Picture, ray: &Ray, answers: &[Answer]) {
        let findings = picture.oracle.judge(ray, &picture.corners, answers);
        for (((_, tally), answer), finding) in self.paths.iter_mut().zip(answers).zip(&findings) {
            tally.add(ray, answer, finding);
        }
        let first = answers.first().map(|a| kind(&a.first));
        if answers.iter().any(|a| Some(kind(&a.first)) != first) {
            let all: Vec<String> = answers.iter().map(|a| describe(ray, a)).collect();
            self.differences.push(all.join("; "));
            let miss = answers.iter().any(|a| a.first == Verdict::Miss);
            let hit = answers.iter().any(|a| a.first.is_certain_hit());
            self.contradictions += u64::from(miss && hit);
        }
    }

    /// Both together.
    fn join(mut self, other: Outcome) -> Self {
        for ((_, mine), (_, its)) in self.paths.iter_mut().zip(other.paths) {
            *mine = std::mem::take(mine).join(its);
        }
        self.differences.extend(other.differences);
        self.contradictions += other.contradictions;
        self.wrong_lists.extend(other.wrong_lists);
        self
    }

    /// Answers that the oracle refutes, on all paths.
    pub fn wrong(&self) -> u64 {
        let tallies = self.paths.iter().map(|(_, tally)| tally.wrong);
        tallies.sum::<u64>() + self.wrong_lists.len() as u64
    }
}
