//! Two scenes with one object each that claim to be the same set, compared ray by ray.

use zeroset::camera::{Ray, Sampling};
use zeroset::glam::{DVec3, dvec3};
use zeroset::interval::Interval;
use zeroset::render::all_roots;
use zeroset::verdict::{Answer, Verdict};
use zeroset::{Camera, Options, Scene, render};

/// Half the width of the cube in which all scenes are.
pub const HALF: f64 = 1.5;
/// The side of the pictures.
pub const SIZE: u32 = 48;

/// What came of a comparison.
#[derive(Debug, Default, PartialEq)]
pub struct Tally {
    /// Rays on which both sides are certain of everything.
    pub certain: u32,
    /// Among them, those with a root.
    pub hit: u32,
    /// Rays on which a side leaves something open.
    pub open: u32,
    /// Rays on which both cannot be right.
    pub refuted: Vec<String>,
}

pub fn camera() -> Camera {
    let from = dvec3(3.1, 2.3, 1.7) * HALF;
    Camera::perspective(from, DVec3::ZERO, DVec3::Z, 40.0).expect("a camera")
}

pub fn pixel_ray(x: u32, y: u32) -> Ray {
    camera().ray(x, y, SIZE, SIZE, Sampling::Centre)
}

impl Tally {
    /// The first verdicts of two pictures.
    pub fn of_pictures(a: &Scene, b: &Scene) -> Tally {
        let mut tally = Tally::default();
        let [a, b] = [a, b].map(|scene| {
            render(scene, &camera(), &Options::new(SIZE, SIZE)).expect("a valid scene")
        });
        for (x, y) in (0..SIZE * SIZE).map(|i| (i % SIZE, i / SIZE)) {
            let [one, other] = [&a, &b].map(|picture| picture.pixel(x, y).answer);
            let place = || format!("({x}, {y})\n  {one:?}\n  {other:?}");
            tally.add(&first(&one), &first(&other), place);
        }
        tally
    }

    /// All events along every third pixel's ray.
    pub fn of_lists(a: &Scene, b: &Scene) -> Tally {
        let mut tally = Tally::default();
        for (x, y) in (0..SIZE * SIZE).step_by(3).map(|i| (i % SIZE, i / SIZE)) {
            let [one, other] = [a, b].map(|scene| {
                let lists = all_roots(scene, &pixel_ray(x, y), &Options::new(1, 1));
                lists.expect("a valid scene").remove(0).1
            });
            let place = || format!("({x}, {y})\n  {one:?}\n  {other:?}");
            tally.add(&one, &other, place);
        }
        tally
    }

    /// Both claim to describe one function along one ray.
    fn add(&mut self, one: &[Verdict], other: &[Verdict], place: impl Fn() -> String) {
        let certain = |list: &[Verdict]| list.iter().all(|v| matches!(v, Verdict::Root { .. }));
        if !certain(one) || !certain(other) {
            self.open += 1;
            if unexplained(one, other) || unexplained(other, one) {
                self.refuted.push(place());
            }
            return;
        }
        self.certain += 1;
        self.hit += u32::from(!one.is_empty());
        let same = one.len() == other.len() && one.iter().zip(other).all(|(a, b)| meet(a, b));
        if !same {
            self.refuted.push(place());
        }
    }
}

/// An answer as a list of which nothing lies behind the first certain root.
fn first(answer: &Answer) -> Vec<Verdict> {
    let mut list = vec![answer.first];
    list.retain(|verdict| *verdict != Verdict::Miss);
    list.extend(answer.behind);
    list
}

fn span(verdict: &Verdict) -> Interval {
    verdict.t().expect("a place")
}

fn meet(a: &Verdict, b: &Verdict) -> bool {
    let (a, b) = (span(a), span(b));
    a.lo <= b.hi && b.lo <= a.hi
}

/// Is the first certain root of one list in no event of the other, though that goes as far?
fn unexplained(list: &[Verdict], other: &[Verdict]) -> bool {
    let Some(root) = list.iter().find(|v| v.is_certain_hit()) else {
        return false;
    };
    let ends = other.iter().find(|v| v.is_certain_hit());
    let reached = ends.is_none_or(|end| span(end).hi >= span(root).lo);
    reached && !other.iter().any(|event| meet(event, root))
}
