//! Beams through solids: they change no verdict, and what they claim of areas holds. No ray through a cell that is hit
//! passes, and none through a cell that is missed meets a root, as the same solid in one formula tells ray by ray.

use crate::compare::HALF;
use crate::pairs::pairs;
use crate::random::Random;
use zeroset::camera::Sampling;
use zeroset::glam::DVec3;
use zeroset::interval::Isa;
use zeroset::render::{Area, all_roots};
use zeroset::verdict::Verdict;
use zeroset::{Camera, Options, Scene, render};

/// A picture of one cell is 8×8 pixels; so many rays in a row are sampled in it, from edge to edge.
const FINE: u32 = 24;
const CELLS: usize = 60;

/// A narrow view of some place from some side: what is a cell in a picture of some size.
fn cell(random: &mut Random) -> Camera {
    let from = 5.0 * HALF * (DVec3::from(random.point(1.0)) + 1e-3).normalize();
    let at = 0.8 * HALF * DVec3::from(random.point(1.0));
    let size = (2.0 * random.next() - 3.5).exp2();
    let view = if random.next() < 0.0 {
        Camera::orthographic(from, at, DVec3::Z, size)
    } else {
        Camera::perspective(from, at, DVec3::Z, (size / (5.0 * HALF)).to_degrees())
    };
    view.expect("a camera")
}

fn area(scene: &Scene, camera: &Camera) -> Area {
    let picture = render(scene, camera, &Options::new(8, 8)).expect("a valid scene");
    picture.statistics().area
}

/// Does a ray of the cell refute what is claimed of it?
fn refuted(area: &Area, camera: &Camera, formula: &Scene) -> bool {
    let places = (0..=FINE).flat_map(|x| (0..=FINE).map(move |y| (x, y)));
    places.into_iter().any(|(x, y)| {
        let ray = camera.ray(x, y, FINE, FINE, Sampling::Corner);
        let lists = all_roots(formula, &ray, &Options::new(1, 1)).expect("a valid scene");
        let events = &lists[0].1;
        area.hit > 0 && events.is_empty()
            || area.miss > 0 && events.iter().any(|event| event.is_certain_hit())
    })
}

/// Every solid in many cells. Then the control: the same operands, put together in another way, must be found out.
#[test]
fn no_ray_refutes_what_is_claimed_of_an_area() {
    let (mut hit, mut miss, mut controls) = (0, 0, 0);
    for pair in pairs() {
        let mut random = Random(7);
        let (mut own, mut wrong) = ([0; 3], 0);
        for _ in 0..CELLS {
            let camera = cell(&mut random);
            let claimed = area(&pair.solid, &camera);
            assert_eq!(claimed.hit + claimed.miss + claimed.undecided, 64);
            assert!(
                !refuted(&claimed, &camera, &pair.formula),
                "{}: {claimed:?}, {camera:?}",
                pair.name
            );
            own[usize::from(claimed.miss > 0) + 2 * usize::from(claimed.undecided > 0)] += 1;
            let other = area(&pair.wrong, &camera);
            wrong += u32::from(refuted(&other, &camera, &pair.formula));
        }
        println!(
            "{:28} hit, miss, undecided {own:2?}; control: {wrong} refuted",
            pair.name
        );
        (hit, miss) = (hit + own[0], miss + own[1]);
        controls += u32::from(wrong > 0);
    }
    assert!(hit > 100 && miss > 200, "{hit} cells hit, {miss} missed");
    assert!(controls >= 13, "{controls} controls");
}

/// Without beams nothing is claimed.
#[test]
fn areas_take_beams() {
    let mut options = Options::new(64, 64);
    for beams in [true, false] {
        options.settings.beams = beams;
        let scene = crate::pairs::apart();
        let picture = render(&scene, &crate::compare::camera(), &options).expect("a valid scene");
        let area = picture.statistics().area;
        assert_eq!(area.miss > 2000, beams, "{area:?}");
        assert_eq!(area.undecided == 64 * 64, !beams, "{area:?}");
    }
}

/// Beams may decide what rays leave open, and nothing else differs.
#[test]
fn beams_change_no_verdict_of_solids() {
    let (mut hits, mut spared) = (0, 0);
    for (isa, pair) in Isa::available()
        .into_iter()
        .flat_map(|isa| pairs().into_iter().map(move |p| (isa, p)))
    {
        // Where cells are small, operands are left out that a beam is inside of. (Known: with an undefined operand, a
        // ray of such a picture stays open that is certain without beams; its pieces are cut in other places.)
        let (width, height) = if isa == Isa::available()[0] && pair.open == 0 {
            (331, 251)
        } else {
            (83, 71)
        };
        let mut options = Options::new(width, height);
        options.isa = Some(isa);
        let [with, without] = [true, false].map(|beams| {
            options.settings.beams = beams;
            render(&pair.solid, &crate::compare::camera(), &options).expect("a valid scene")
        });
        for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
            let (p, q) = (with.pixel(x, y), without.pixel(x, y));
            let same = match (p.answer.first, q.answer.first) {
                (Verdict::Root { t: s }, Verdict::Root { t }) => {
                    hits += 1;
                    (s.lo <= t.hi && t.lo <= s.hi) && (p.surface == q.surface || p.tied || q.tied)
                }
                (Verdict::Miss, Verdict::Miss) => true,
                (_, old) => !matches!(old, Verdict::Root { .. } | Verdict::Miss),
            };
            assert!(same, "{}, {isa}, ({x}, {y}): {p:?}, {q:?}", pair.name);
        }
        let statistics = with.statistics();
        spared += statistics.rays - statistics.made;
    }
    println!("{hits} hits, {spared} rays spared");
    assert!(hits > 10_000 && spared > 10_000);
}
