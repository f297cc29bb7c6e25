//! The graph of unlike formulas, before and after: as written, and what is left for each stage.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::panic)]

mod support;

use support::Case;
use zeroset_compiler::front::front;
use zeroset_compiler::graph::{Graph, Id};
use zeroset_compiler::lower::Lowering;
use zeroset_compiler::stage::Staged;
use zeroset_compiler::tree::Formula;

/// A formula's graph and its root.
fn lowered(formula: &Formula, graph: Graph) -> (Graph, Id) {
    let mut lowering = Lowering::into_graph(formula, graph);
    let root = lowering.root().unwrap();
    (lowering.graph, root)
}

fn formula(source: &str) -> Formula {
    front(source.parse().unwrap()).formula.unwrap()
}

/// How many operations, inputs left out.
fn operations(graph: &Graph, roots: &[Id]) -> usize {
    let ids = graph.reachable(roots, |_| false);
    let works = |id: &&Id| !zeroset_compiler::graph::operands(graph.op(**id)).is_empty();
    ids.iter().filter(works).count()
}

fn describe(case: &Case) -> String {
    let formula = formula(&case.source);
    let (plain, written) = lowered(&formula, Graph::as_written());
    let (mut graph, root) = lowered(&formula, Graph::default());
    let gradient = graph.gradient(root);
    let space = [
        ("f", root),
        ("df/dx", gradient[0]),
        ("df/dy", gradient[1]),
        ("df/dz", gradient[2]),
    ];
    let text_of_space = graph.text(&space);
    let staged = Staged::new(&mut graph, root);
    let leaves: Vec<(String, Id)> = staged
        .leaves
        .iter()
        .enumerate()
        .map(|(k, leaf)| {
            let kind = if leaf.quadratic {
                "quadratic"
            } else {
                "linear"
            };
            (format!("leaf {k}, {kind}"), leaf.node)
        })
        .collect();
    let leaves: Vec<(&str, Id)> = leaves
        .iter()
        .map(|(label, id)| (label.as_str(), *id))
        .collect();
    let labelled = |ids: [Id; 3]| -> Vec<(&str, Id)> {
        ["value", "slope", "curvature"]
            .into_iter()
            .zip(ids)
            .collect()
    };
    let jet = labelled(staged.jet.map(Option::unwrap));
    let polynomials: Vec<(String, Id)> = staged
        .polynomials
        .iter()
        .enumerate()
        .map(|(k, (id, degree))| (format!("polynomial {k} of degree {degree}"), *id))
        .collect();
    let count = |roots: &[(&str, Id)]| {
        let ids: Vec<Id> = roots.iter().map(|r| r.1).collect();
        operations(&graph, &ids)
    };
    let source = case
        .source
        .lines()
        .fold(String::new(), |text, line| text + "    " + line + "\n");
    format!(
        "{source}\nAs written; operations: {}\n\n```text\n{}```\n\nf and its gradient; operations: {}\n\n```text\n{}```\n\n\
         Leaves of the ray stage; operations: {}\n\n```text\n{}```\n\nThe segment stage; operations: {}\n\n```text\n{}```\n",
        operations(&plain, &[written]),
        plain.text(&[("f", written)]),
        count(&space),
        text_of_space,
        count(&leaves),
        graph.text(&leaves),
        count(&jet),
        graph.text(&jet),
    ) + &match staged.over {
        None => String::new(),
        Some(over) => {
            let over = labelled(over);
            let nodes = polynomials
                .iter()
                .map(|(label, id)| format!("{label}: n{}\n", id.0));
            format!(
                "\nThe same over segments, from coefficients; operations: {}\n\n```text\n{}{}```\n",
                count(&over),
                nodes.collect::<String>(),
                graph.text(&over),
            )
        }
    }
}

#[test]
fn before_and_after() {
    support::check("graphs.md", describe);
}

/// What the page on differentiation shows is what is made of the small formula.
#[test]
fn the_page_shows_what_is_made() {
    let page = include_str!("../../../docs/how-differentiation-works.md");
    let fixture = include_str!("fixtures/graphs.md");
    let small = fixture.split("\n## ").nth(1).unwrap();
    assert!(small.starts_with("a_small_one"));
    let shown: Vec<&str> = page.split("```text\n").skip(1).collect();
    assert_eq!(shown.len(), 3);
    for block in shown {
        let block = block.split("```").next().unwrap();
        assert!(small.contains(block), "not in the fixture:\n{block}");
    }
}

/// What leaves a formula has is found in two rounds, and the first one's leaves must leave nothing behind: this maximum was
/// decided by the range of another leaf of the same number.
#[test]
fn a_leaf_is_not_another_round_s() {
    let formula =
        formula("struct S; max(0.5 - exp(-4*(x^2 + y^2 + z^2)), 0.09 - (x^2 + y^2 + z^2))");
    let (mut graph, root) = lowered(&formula, Graph::default());
    let staged = Staged::new(&mut graph, root);
    let value = graph.text(&[("f", staged.jet[0].unwrap())]);
    assert!(value.contains("max") && value.contains("exp"), "{value}");
}

/// Derivatives need a cosine of what f needs a sine of. A sine alone stays one, and so do those of different nodes.
#[test]
fn a_sine_and_the_cosine_of_the_same_node_are_one_operation() {
    let code = |formula: &str| {
        let source = format!("zeroset struct F; {formula}");
        zeroset_compiler::expand(source.parse().unwrap()).to_string()
    };
    let count = |code: &str, call: &str| code.matches(call).count();
    let both = code("sin(x)*cos(y) + sin(y)*cos(x)");
    assert!(count(&both, "a . sin_cos (") > 0, "{both}");
    assert_eq!(count(&both, "a . sin ("), 0, "{both}");
    let apart = code("sin(x) + cos(2*x) + z^3");
    let value = apart.split("fn value").nth(1).unwrap();
    let value = value.split("fn ").next().unwrap();
    assert_eq!(count(value, "a . sin_cos ("), 0, "{value}");
    assert_eq!(count(value, "a . sin ("), 1, "{value}");
}
