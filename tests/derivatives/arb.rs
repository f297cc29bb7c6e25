//! Enclosures of all derivatives against arb, where it is installed.

use zeroset::interval::Interval;

use crate::Random;
use crate::python::agrees;
use crate::surfaces::{Sample, each};

/// How enclosures are written: as they are, or for the control.
type Spoil = fn(Interval) -> Interval;

/// A line of the script's input.
fn line(name: &str, kind: &str, places: &[f64], enclosures: &[Interval], spoil: Spoil) -> String {
    let ends = enclosures
        .iter()
        .map(|a| spoil(*a))
        .flat_map(|a| [a.lo, a.hi]);
    let words: Vec<String> = places
        .iter()
        .copied()
        .chain(ends)
        .map(|x| format!("{:016x}", x.to_bits()))
        .collect();
    format!("{name} {kind} {}\n", words.join(" "))
}

/// Second derivatives that are no claim hold everything.
fn claimed<const N: usize>(
    mut all: [Interval; N],
    first_orders: usize,
    smooth: bool,
) -> [Interval; N] {
    if !smooth {
        all[first_orders..].fill(Interval::ENTIRE);
    }
    all
}

/// Points and boxes, and points and segments of rays, of one surface.
fn lines(name: &str, surface: &dyn Sample, spoil: Spoil) -> String {
    let mut random = Random(17);
    let mut text = String::new();
    for k in 0..40 {
        let r = [0.0, 0.3 * random.next().abs()][k % 2];
        let p = random.point(1.5);
        let b = p.map(|x| Interval {
            lo: x - r,
            hi: x + r,
        });
        let (all, smooth) = surface.space(b);
        let sides: Vec<f64> = b.iter().flat_map(|side| [side.lo, side.hi]).collect();
        text += &line(name, "space", &sides, &claimed(all, 4, smooth), spoil);

        let (o, d) = (random.point(1.0), random.point(1.0));
        let start = 0.5 + 0.5 * random.next();
        let t = Interval {
            lo: start,
            hi: start + r,
        };
        let along = surface.along(o, d, t);
        // The shorter entry points say the same, or more.
        let [_, by_slope] = along.slope;
        let by_curvature = claimed(along.curvature, 2, along.smooth);
        let places = [&o[..], &d, &[t.lo, t.hi]].concat();
        text += &line(name, "ray", &places, &by_curvature, spoil);
        let shorter = [along.value, by_slope, by_curvature[2]];
        text += &line(name, "ray", &places, &shorter, spoil);
    }
    text
}

fn all(spoil: Spoil) -> String {
    let mut text = String::new();
    each(|name, surface| text += &lines(name, surface, spoil));
    text
}

fn script() -> &'static str {
    concat!(env!("CARGO_MANIFEST_DIR"), "/tests/derivatives/arb.py")
}

#[test]
fn arb_agrees() {
    let Some((fine, said)) = agrees("derivatives against arb", script(), &all(|a| a)) else {
        return;
    };
    println!("{said}");
    assert!(fine, "{said}");
    // The control: each enclosure one ulp and its own width too high.
    let lie: Spoil = |a| Interval {
        lo: a.hi.next_up(),
        hi: (a.hi + (a.hi - a.lo)).next_up().next_up(),
    };
    let (fine, said) =
        agrees("derivatives against arb", script(), &all(lie)).expect("it ran before");
    let total = said.lines().last().unwrap_or_default();
    println!("control: {total}");
    let counts: Vec<u32> = total.split(' ').filter_map(|w| w.parse().ok()).collect();
    // Enclosures that hold everything stay right.
    assert!(
        !fine && matches!(counts[..], [right, wrong, _] if wrong > 10 * right),
        "{said}"
    );
}
