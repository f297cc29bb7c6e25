//! Gradients and Hessians of the graph, evaluated in plain `f64`, against differences of the formula.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::HashMap;

use zeroset_compiler::front::front;
use zeroset_compiler::graph::{Graph, Id, Op, Over};
use zeroset_compiler::lower::Lowering;
use zeroset_compiler::tree::FoldKind;

const FORMULAS: [&str; 8] = [
    "exp(x*y) + x*y*z^2 - (x - z)^3*(y + 1)^2",
    "sin(x^2 + y*z)*cos(z) + sqrt(x^2 + y^2 + 2)/(z^2 + 1)",
    "max(x*y, z) + min(x + 2*y, max(z^2, x - 1))*y",
    "if x*y < z { x^2*y } else { if z < 1 { y*sin(x) } else { z^3 } }",
    "sum(i in 1..4) { exp(-i*((x - i)^2 + y^2*z)) } * x",
    "prod(i in 1..4) { x + i*y*z } + min(i in 0..3) { (x - i)^2 + y*z }",
    "sum(i in 0..3) { max(x - i, y*z) * exp(x*y) }",
    "let q = x*y + z; exp(q) + sin(q)*q^2 + abs(q - 3)",
];

fn value(graph: &Graph, id: Id, at: &[f64; 3], rows: &HashMap<usize, i64>) -> f64 {
    let of = |id: &Id| value(graph, *id, at, rows);
    match graph.op(id) {
        Op::Literal(r) => zeroset_compiler::rational::nearest(r),
        Op::Coordinate(k) => at[*k],
        Op::Counter(fold) => rows[fold] as f64,
        Op::Negate(a) => -of(a),
        Op::Add(a, b) => of(a) + of(b),
        Op::Subtract(a, b) => of(a) - of(b),
        Op::Multiply(a, b) => of(a) * of(b),
        Op::Divide(a, b) => of(a) / of(b),
        Op::Power(a, n) => of(a).powi(*n as i32),
        Op::Unary(f, a) => match f.entry().name {
            "exp" => of(a).exp(),
            "sin" => of(a).sin(),
            "cos" => of(a).cos(),
            "sqrt" => of(a).sqrt(),
            "abs" => of(a).abs(),
            name => panic!("{name}"),
        },
        Op::Binary(f, a, b) => match f.entry().name {
            "min" => of(a).min(of(b)),
            "max" => of(a).max(of(b)),
            name => panic!("{name}"),
        },
        Op::AbsSlope(a) => of(a).signum(),
        Op::Less(a, b) => f64::from(u8::from(of(a) < of(b))),
        Op::Choose(c, a, b, _) => of(if of(c) != 0.0 { a } else { b }),
        Op::Fold(kind, fold, args) => folded(graph, *kind, *fold, args, at, rows),
        op => panic!("{op:?}"),
    }
}

fn folded(
    graph: &Graph,
    kind: FoldKind,
    fold: usize,
    args: &[Id],
    at: &[f64; 3],
    rows: &HashMap<usize, i64>,
) -> f64 {
    let Over::Range(start, end) = graph.folds[fold].over else {
        panic!("a table");
    };
    // Each row's arguments.
    let all: Vec<Vec<f64>> = (start..end)
        .map(|row| {
            let mut rows = rows.clone();
            rows.insert(fold, row);
            args.iter().map(|a| value(graph, *a, at, &rows)).collect()
        })
        .collect();
    let product = |without: &[usize]| -> f64 {
        let left = all.iter().enumerate().filter(|(k, _)| !without.contains(k));
        left.map(|(_, row)| row[0]).product()
    };
    let n = all.len();
    match (kind, args.len()) {
        (FoldKind::Sum, _) => all.iter().map(|row| row[0]).sum(),
        (FoldKind::Product, 1) => product(&[]),
        (FoldKind::Product, 2) => (0..n).map(|k| all[k][1] * product(&[k])).sum(),
        // b, b_u, b_v, b_uv
        (FoldKind::Product, _) => {
            let own: f64 = (0..n).map(|k| all[k][3] * product(&[k])).sum();
            let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
            let mixed = pairs.filter(|(i, j)| i != j);
            own + mixed
                .map(|(i, j)| all[i][1] * all[j][2] * product(&[i, j]))
                .sum::<f64>()
        }
        (FoldKind::Minimum | FoldKind::Maximum, _) => {
            let sign = if kind == FoldKind::Minimum { 1.0 } else { -1.0 };
            let best = all
                .iter()
                .min_by(|a, b| (sign * a[0]).total_cmp(&(sign * b[0])));
            *best.unwrap().last().unwrap()
        }
    }
}

/// Derivatives that differ from differences of what they are derivatives of, `spoil` added to each; and how many there are.
fn disagreements(spoil: f64) -> [usize; 2] {
    let mut counts = [0; 2];
    for source in FORMULAS {
        let formula = front(format!("struct S; {source}").parse().unwrap())
            .formula
            .unwrap();
        let mut lowering = Lowering::new(&formula);
        let root = lowering.root().unwrap();
        let mut graph = lowering.graph;
        let gradient = graph.gradient(root);
        let hessian = gradient.map(|row| graph.gradient(row));
        for p in [
            [0.3, -0.7, 1.1],
            [1.3, 0.4, 0.2],
            [-0.6, 0.9, -1.2],
            [2.2, 1.7, 0.8],
        ] {
            let none = HashMap::new();
            let h = 1.0 / 4096.0;
            for (k, first) in gradient.iter().enumerate() {
                let pairs = std::iter::once((root, *first));
                for (of, derivative) in
                    pairs.chain(gradient.into_iter().zip(hessian.map(|row| row[k])))
                {
                    let moved = |step: f64| {
                        let mut q = p;
                        q[k] += step;
                        value(&graph, of, &q, &none)
                    };
                    let d = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
                    let expected = (4.0 * d(h / 2.0) - d(h)) / 3.0;
                    let found = value(&graph, derivative, &p, &none) + spoil;
                    counts[0] +=
                        usize::from((found - expected).abs() > 1e-5 * (1.0 + expected.abs()));
                    counts[1] += 1;
                }
            }
        }
    }
    counts
}

#[test]
fn derivatives_agree_with_differences() {
    let [wrong, all] = disagreements(0.0);
    assert!(wrong == 0 && all > 300, "{wrong} of {all}");
}

#[test]
fn wrong_derivatives_would_be_noticed() {
    let [wrong, all] = disagreements(0.1);
    assert!(2 * wrong > all, "{wrong} of {all}");
}
