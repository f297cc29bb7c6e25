//! One surface with its rays and their truth.

use zeroset::interval::Isa;

use crate::judge::{Claim, Claimed, Score};
use crate::methods::Method;
use crate::ours::{Solver, claim, picture};
use crate::subject::{Eight, Subject};
use crate::truth::Known;
use crate::{SIZE, STRIDE};

/// What methods are judged on.
pub struct Trial<'a> {
    subject: &'a dyn Subject,
    known: &'a [Known],
    /// All rays of a picture.
    pub packets: Vec<Eight>,
    /// The packets that hold a ray of known truth, and where in them.
    judged: Vec<(Eight, usize)>,
}

/// The pixels of known truth, row after row.
pub fn pixels() -> impl Iterator<Item = [u32; 2]> {
    let places = || (STRIDE / 2..SIZE).step_by(STRIDE as usize);
    places().flat_map(move |y| places().map(move |x| [x, y]))
}

impl<'a> Trial<'a> {
    /// # Panics
    /// If the truth is of another number of rays.
    pub fn new(subject: &'a dyn Subject, known: &'a [Known]) -> Self {
        assert_eq!(known.len(), pixels().count(), "{}", subject.name());
        let packets = subject.packets();
        let mut sample = subject.packets();
        let mut judged = Vec::new();
        for [x, y] in pixels() {
            let corner = [x / 4 * 4, y / 2 * 2];
            let place = sample.iter().position(|eight| eight.corner == corner);
            let eight = sample.swap_remove(place.expect("a packet for each pixel"));
            judged.push((eight, ((y % 2) * 4 + x % 4) as usize));
        }
        Trial {
            subject,
            known,
            packets,
            judged,
        }
    }

    /// The score of this library, and evaluations per ray of the picture.
    pub fn ours(&self, solver: Solver, isa: Isa) -> (Score, f64) {
        let scene = self.subject.scene(solver);
        let picture = picture(&scene, &self.subject.camera(), isa, SIZE);
        let mut score = Score::default();
        for (([x, y], known), (eight, lane)) in pixels().zip(self.known).zip(&self.judged) {
            score.add(known, &claim(&picture, x, y), eight.unit[*lane], 0.0);
        }
        let rays = f64::from(SIZE * SIZE);
        let evaluations = picture.statistics().evaluations.total() as f64 / rays;
        (score.finished(), evaluations)
    }

    /// The score of another method, and evaluations per ray.
    pub fn theirs(&self, method: Method, tolerance: f64, isa: Isa) -> (Score, f64) {
        let mut score = Score::default();
        let mut evaluations = 0;
        for (known, (eight, lane)) in self.known.iter().zip(&self.judged) {
            let alone = std::slice::from_ref(eight);
            let traced = self.subject.trace(isa, alone, method, tolerance);
            evaluations += traced.evaluations;
            let t = traced.t[0][*lane];
            let claimed = Claimed {
                entry: eight.entry[*lane],
                claim: if t.is_nan() {
                    Claim::Nothing
                } else {
                    Claim::Root(t)
                },
            };
            score.add(known, &claimed, eight.unit[*lane], tolerance);
        }
        let rays = 8.0 * self.judged.len() as f64;
        (score.finished(), evaluations as f64 / rays)
    }
}
