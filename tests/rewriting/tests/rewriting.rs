//! The optimised graph against the graph as written.

#[path = "../../support/python.rs"]
mod python;

use std::collections::BTreeMap;

use num_rational::BigRational;
use zeroset::interval::Interval;
use zeroset_compiler::graph::{Graph, Op};
use zeroset_compiler::simplify::RULES;
use zeroset_rewriting::enclose::{Wrong, enclose};
use zeroset_rewriting::formula::{FUNCTIONS, Random};
use zeroset_rewriting::truth::{exact, value};
use zeroset_rewriting::{lowered, random_pair};

/// No wrong rewrite.
const RIGHT: Wrong = |_| None;

/// A box: dyadic numbers, often points or narrow, sometimes with 0 at an end.
fn random_box(random: &mut Random) -> [Interval; 3] {
    let range = [1, 2, 4][random.below(3)];
    let width = [0.0, 1.0 / 1024.0, 1.0 / 16.0, 1.0][random.below(4)];
    std::array::from_fn(|_| {
        let lo = random.dyadic(range);
        Interval {
            lo,
            hi: lo + width * (1 + random.below(3)) as f64,
        }
    })
}

/// Points of a box: corners, and a grid of sixteenths.
fn point(random: &mut Random, over: &[Interval; 3]) -> [BigRational; 3] {
    over.each_ref().map(|side| {
        let step = exact((random.below(17) as f64) / 16.0);
        exact(side.lo) + (exact(side.hi) - exact(side.lo)) * step
    })
}

fn holds(range: &Interval, truth: &BigRational) -> bool {
    (range.lo == f64::NEG_INFINITY || exact(range.lo) <= *truth)
        && (range.hi == f64::INFINITY || *truth <= exact(range.hi))
}

/// Truths outside of the enclosure by the graph as written, and outside of that by the rewritten one.
fn refuted(formulas: usize, wrong: Wrong) -> [usize; 2] {
    let mut random = Random(0x5eed);
    let mut counts = [0; 2];
    let mut decided = 0;
    for _ in 0..formulas {
        let (formula, graphs) = random_pair(&mut random, 5, true);
        for _ in 0..3 {
            let over = random_box(&mut random);
            let wrongs: [Wrong; 2] = [RIGHT, wrong];
            let ranges: [(Interval, bool); 2] =
                std::array::from_fn(|k| enclose(&graphs[k].0, graphs[k].1, &over, wrongs[k]));
            for _ in 0..8 {
                let Some(truth) = value(&formula, &point(&mut random, &over)) else {
                    continue;
                };
                decided += 1;
                for (k, (range, empty)) in ranges.iter().enumerate() {
                    counts[k] += usize::from(*empty || !holds(range, &truth));
                }
            }
        }
    }
    assert!(
        decided > 10 * formulas,
        "{decided} points of {formulas} formulas are defined"
    );
    counts
}

#[test]
fn both_graphs_hold_exact_values() {
    assert_eq!(refuted(4000, RIGHT), [0, 0]);
}

/// The control: |a| → a is a wrong rewrite.
#[test]
fn a_wrong_rewrite_is_caught() {
    let wrong: Wrong = |op| match op {
        Op::Unary(f, a) if f.entry().name == "abs" => Some(*a),
        _ => None,
    };
    let [written, rewritten] = refuted(1000, wrong);
    assert_eq!(written, 0);
    assert!(rewritten > 50, "{rewritten}");
}

/// What was compared.
#[derive(Default)]
struct Compared {
    boxes: usize,
    narrower: usize,
    wider: usize,
    /// The functions of formulas whose enclosure became wider, and an example.
    classes: BTreeMap<String, (usize, String)>,
    used: BTreeMap<&'static str, usize>,
    /// Operations of the graphs as written and rewritten.
    operations: [usize; 2],
    /// How often each rule was applied, in formulas and their gradients.
    applied: BTreeMap<&'static str, usize>,
}

impl Compared {
    fn formula(&mut self, random: &mut Random) {
        let (formula, graphs) = random_pair(random, 4, false);
        let mut functions = Vec::new();
        formula.functions(&mut functions);
        for f in &functions {
            *self.used.entry(f).or_default() += 1;
        }
        let source = formula.source();
        let (mut graph, root) = graphs[1].clone();
        graph.gradient(root);
        for (rule, count) in &graph.applied {
            *self.applied.entry(rule).or_default() += count;
        }
        for (k, (graph, root)) in graphs.iter().enumerate() {
            self.operations[k] += graph.reachable(&[*root], |_| false).len();
        }
        for _ in 0..2 {
            let over = random_box(random);
            let [(a, nowhere), (b, neither)] = graphs
                .each_ref()
                .map(|(graph, root)| enclose(graph, *root, &over, RIGHT));
            self.boxes += 1;
            // Where f is certainly defined nowhere, any range will do.
            if nowhere || neither {
                continue;
            }
            // Beyond rounding: a few operations' worth of it, on the scale of the numbers that occur.
            let scale = a.lo.abs().max(a.hi.abs()).max(64.0);
            let rounding = 1e-9 * (a.hi - a.lo) + 1e-12 * scale;
            self.narrower += usize::from(b.hi - b.lo < a.hi - a.lo - rounding);
            if b.lo < a.lo - rounding || b.hi > a.hi + rounding {
                self.wider += 1;
                functions.sort_unstable();
                functions.dedup();
                let example = format!("{source} over {over:?}: {a:?} became {b:?}");
                let class = self.classes.entry(functions.join(" "));
                class.or_insert((0, example)).0 += 1;
            }
        }
    }
}

#[test]
fn rewriting_does_not_widen() {
    let mut random = Random(0xb0c5);
    let mut compared = Compared::default();
    for _ in 0..20_000 {
        compared.formula(&mut random);
    }
    let Compared {
        boxes,
        narrower,
        wider,
        operations: [before, after],
        ..
    } = compared;
    println!("{boxes} boxes: {narrower} narrower, {wider} wider; {before} nodes became {after}");
    println!("functions: {:?}", compared.used);
    println!("rules: {:?}", compared.applied);
    for (class, (count, example)) in &compared.classes {
        println!("wider, {count} with [{class}]: {example}");
    }
    for (name, _) in FUNCTIONS {
        assert!(
            compared.used.get(name).is_some_and(|n| *n > 100),
            "{name} is not covered"
        );
    }
    // Sums over rows are in no random formula.
    for rule in RULES.iter().filter(|rule| **rule != "sum of 0 = 0") {
        let count = compared.applied.get(rule).copied().unwrap_or(0);
        assert!(count > 10, "the rule {rule} is not covered: {count}");
    }
    assert!(after < before);
    assert!(wider * 100 <= boxes, "{wider} of {boxes} are wider");
}

/// The rule that no random formula meets: the derivative of a sum whose rows do not depend on a coordinate.
#[test]
fn sums_of_zeros_vanish() {
    let (mut graph, root) =
        lowered("sum(i in 1..4) { sin(i*x) }", Graph::default()).expect("a formula");
    let zero = graph.integer(0);
    assert_eq!(graph.gradient(root)[1], zero);
    let none = graph.fold(zeroset_compiler::tree::FoldKind::Sum, 0, vec![zero]);
    assert_eq!((none, graph.applied.get("sum of 0 = 0")), (zero, Some(&1)));
}

/// Both graphs against arb, all functions: a script judges, if it can run.
#[test]
fn both_graphs_hold_what_arb_says() {
    let mut random = Random(0xa2b);
    let mut lines = String::new();
    for _ in 0..2500 {
        let (formula, graphs) = random_pair(&mut random, 4, false);
        let over = random_box(&mut random);
        let ranges = graphs
            .each_ref()
            .map(|(g, root)| enclose(g, *root, &over, RIGHT));
        let mut numbers: Vec<f64> = over.iter().flat_map(|side| [side.lo, side.hi]).collect();
        for (range, empty) in ranges {
            // Nowhere defined: no number is inside.
            let [lo, hi] = if empty {
                [f64::INFINITY, f64::NEG_INFINITY]
            } else {
                [range.lo, range.hi]
            };
            numbers.extend([lo, hi]);
        }
        let words: Vec<String> = numbers
            .iter()
            .map(|x| format!("{:016x}", x.to_bits()))
            .collect();
        lines += &format!("{} |{}\n", words.join(" "), formula.prefix());
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/arb.py");
    let Some((fine, said)) = python::agrees("rewriting against arb", script, &lines) else {
        return;
    };
    println!("{said}");
    assert!(fine, "{said}");
}
