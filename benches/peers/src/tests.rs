//! A few pixels of everything: counts and errors, never times.

use crate::judge::Sampled;
use crate::shapes;
use crate::truth;
use crate::versus_fidget;
use crate::view::{Place, Shown, View};
use fidget::jit::JitFunction;
use fidget::shape::Shape;
use fidget::vm::VmFunction;

const SIZE: u32 = 64;

#[test]
fn zeroset_shows_the_truth() {
    for place in [Place::Corner, Place::Centre] {
        let view = View { size: SIZE, place };
        for shape in shapes::all() {
            let picture = view.render(&shape.scene);
            let mut sampled = Sampled::new(&shape, view, 400);
            sampled.look_again(|i, j| View::shown(&picture, i, j));
            let judged = sampled.judge(|i, j| View::shown(&picture, i, j));
            assert_eq!(judged.wrong(), 0, "{}: {judged:?}", shape.name);
            assert!(judged.errors.len() > 40, "{}: few rays hit", shape.name);
            let largest = judged.errors[judged.errors.len() - 1];
            assert!(largest < 1e-9, "{}: an error of {largest}", shape.name);
        }
    }
}

#[test]
fn fidget_is_right_within_a_voxel_where_the_shape_is_thick() {
    let view = View {
        size: SIZE,
        place: Place::Corner,
    };
    for shape in shapes::all() {
        let jit =
            versus_fidget::picture(&Shape::<JitFunction>::from(shape.tree.clone()), SIZE, None);
        let vm = versus_fidget::picture(&Shape::<VmFunction>::from(shape.tree.clone()), SIZE, None);
        let sampled = Sampled::new(&shape, view, 400);
        for picture in [jit, vm] {
            let judged = sampled.judge(|i, j| versus_fidget::shown(&picture, i, j));
            let voxel = 2.0 / f64::from(SIZE);
            if let Some(&median) = judged.errors.get(judged.errors.len() / 2) {
                assert!(median < 0.51 * voxel, "{}: median {median}", shape.name);
            }
            // What is lost by a shell far thinner than a voxel is what the judge is there to see.
            let lost = judged.lost as f64 / judged.rays as f64;
            assert_eq!(
                lost > 0.1,
                shape.name.starts_with("shell"),
                "{}: {judged:?}",
                shape.name
            );
        }
    }
}

#[test]
fn a_wrong_picture_is_found_wrong() {
    let shapes = shapes::all();
    let view = View {
        size: SIZE,
        place: Place::Corner,
    };
    let sampled = Sampled::new(&shapes[0], view, 400);
    let hits = sampled.rays.iter().filter(|r| r.1.is_some()).count();
    let blank = sampled.judge(|_, _| Shown::Miss);
    assert_eq!((blank.lost, blank.wrong()), (hits, hits));
    let wall = sampled.judge(|_, _| Shown::At(0.0));
    assert_eq!(wall.invented, sampled.rays.len() - hits);
    assert!(wall.sheet > hits / 2);
    assert_eq!(sampled.judge(|_, _| Shown::Open).open, sampled.rays.len());
}

#[test]
fn the_truth_finds_what_lies_between_its_steps() {
    let thin = 1e-5;
    let shell = |[x, y, z]: [f64; 3]| {
        let r = x * x + y * y + z * z;
        (r - 0.64).max((0.8 - thin) * (0.8 - thin) - r)
    };
    let z = truth::first(&shell, [0.1, 0.2], truth::STEPS).expect("a hit");
    assert!((z - (0.64f64 - 0.05).sqrt()).abs() < 1e-14);
    assert_eq!(truth::first(&shell, [0.6, 0.6], truth::STEPS), None);
}

/// One lane answers as eight do, to the last bit where no polynomial is in play.
#[cfg(feature = "one-lane")]
#[test]
fn one_lane_answers_as_eight_do() {
    use crate::packets::{others, picture};
    use zeroset::interval::Isa;

    let (Ok(eight), Ok(one)) = (Isa::named("avx512"), Isa::named("avx512-one")) else {
        return;
    };
    let view = View {
        size: SIZE,
        place: Place::Centre,
    };
    for shape in shapes::all() {
        let [eight, one] = [eight, one].map(|isa| picture(&shape, &view, isa));
        let [verdicts, intervals] = others(&eight, &one);
        assert_eq!(verdicts, 0, "{}", shape.name);
        let polynomial = ["torus, quartic", "Barth sextic"].contains(&&*shape.name);
        assert!(intervals == 0 || polynomial, "{}: {intervals}", shape.name);
        // It did go ray by ray.
        let evaluations = [eight, one].map(|p| p.statistics().evaluations.packets);
        assert!(
            evaluations[1] > 3 * evaluations[0],
            "{}: {evaluations:?}",
            shape.name
        );
    }
}
