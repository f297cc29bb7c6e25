//! Every form of enclosure holds the values of f, also where f is undefined or jumps, and the best is the narrowest.

#![forbid(unsafe_code)]

use glam::DVec3;
use zeroset::camera::Ray;
use zeroset::enclosure::{
    Best, Enclosure, MeanValue, Monotone, Natural, Range, Staged, Taylor, range,
};
use zeroset::implicit;
use zeroset::interval::{Interval, Isa};
use zeroset::surface::Surface;

implicit! { struct Cubic; x^3 - 2*x*y + z^2 - 0.125 }
implicit! { struct Pole; y/x + z }
implicit! { struct Step; if x > 0 { 1 + y } else { -1 + y } }
implicit! { struct Third; 1/(2 + x) }

/// Coordinates are whole 256ths for t a multiple of 1/64, so that these functions are exact in `f64` (or correctly
/// rounded, where they divide).
const RAY: Ray = Ray {
    origin: DVec3::new(-1.0, 0.5, 0.25),
    direction: DVec3::new(1.0, -0.25, 0.5),
};
const STEPS: u32 = 128;

fn at(k: u32) -> f64 {
    f64::from(k) / 64.0
}

fn point(t: f64) -> [f64; 3] {
    (RAY.origin + t * RAY.direction).to_array()
}

fn cubic([x, y, z]: [f64; 3]) -> f64 {
    x * x * x - 2.0 * x * y + z * z - 0.125
}

/// The forms, by name.
fn forms<S: Surface>(surface: &S, t: Interval, isa: Isa) -> [(&'static str, Range); 6] {
    fn one<E: Enclosure, S: Surface>(s: &S, t: Interval, isa: Isa) -> (&'static str, Range) {
        (E::NAME, range::<E, S>(s, &RAY, t, isa))
    }
    [
        one::<Natural, S>(surface, t, isa),
        one::<Staged, S>(surface, t, isa),
        one::<MeanValue, S>(surface, t, isa),
        one::<Monotone, S>(surface, t, isa),
        one::<Taylor, S>(surface, t, isa),
        one::<Best, S>(surface, t, isa),
    ]
}

/// All forms over all segments; f is exact where it is defined.
fn hold<S: Surface>(surface: &S, f: fn([f64; 3]) -> Option<f64>) {
    for isa in Isa::available() {
        for (a, b) in (0..STEPS).flat_map(|a| [1, 3, 16, 61, 128].map(|n| (a, a + n))) {
            let t = Interval {
                lo: at(a),
                hi: at(b.min(STEPS)),
            };
            let ranges = forms(surface, t, isa);
            for (name, range) in ranges {
                for k in a..=b.min(STEPS) {
                    if let Some(value) = f(point(at(k))) {
                        assert!(range.f.contains(value), "{name} on {isa}, {t}: {}", range.f);
                    }
                }
            }
            let [.., best] = ranges.map(|(_, range)| range.f);
            assert!(ranges[1].1.f.encloses(&best), "{isa}, {t}: {best}");
        }
    }
}

#[test]
fn a_polynomial() {
    hold(&Cubic, |p| Some(cubic(p)));
}

/// The quotients are not exact: an enclosure over a segment has room for half a unit in the last place.
#[test]
fn a_pole() {
    hold(&Pole, |[x, y, z]| (x != 0.0).then(|| y / x + z));
}

#[test]
fn a_step() {
    hold(&Step, |[x, y, _]| {
        Some(if x > 0.0 { 1.0 + y } else { y - 1.0 })
    });
}

/// On narrow segments the forms of second order win, by the square of the width.
#[test]
fn centred_forms_converge() {
    let isa = Isa::available()[0];
    let widths = |n: i32| {
        let t = Interval {
            lo: 0.5,
            hi: 0.5 + 2f64.powi(-n),
        };
        let [before, behind] = [t.lo, t.hi].map(|t| cubic(point(t)));
        let true_width = (behind - before).abs();
        forms(&Cubic, t, isa).map(|(_, range)| range.f.width() - true_width)
    };
    let (wide, narrow) = (widths(4), widths(8));
    // f is monotone there: what is above the true width falls by 16² for centred forms, by 16 for the plain one.
    for form in [2, 4] {
        assert!(narrow[form] < wide[form] / 200.0, "{wide:?} {narrow:?}");
    }
    assert!(narrow[0] > wide[0] / 40.0, "{wide:?} {narrow:?}");
}

/// The control: a third is no `f64`, and without rounding its enclosure does not hold it.
#[test]
fn without_rounding_a_value_is_lost() {
    // x = 1 there.
    let t = Interval { lo: 2.0, hi: 2.0 };
    let holds = |isa| {
        forms(&Third, t, isa).map(|(_, range)| {
            range.f.lo.mul_add(3.0, -1.0) <= 0.0 && range.f.hi.mul_add(3.0, -1.0) >= 0.0
        })
    };
    for isa in Isa::available() {
        assert_eq!(holds(isa), [true; 6], "{isa}");
    }
    for isa in Isa::unrounded() {
        assert!(holds(isa).contains(&false), "{isa}");
    }
}
