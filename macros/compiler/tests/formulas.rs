//! What formulas mean: every example of the language, and every rule of its grammar, as a resolved tree.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::panic)]

mod support;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use support::{Case, print};
use zeroset_compiler::front::front;

/// The resolved tree of a case, or the mistakes that should not be there.
fn tree(case: &Case) -> String {
    let input = case
        .source
        .lines()
        .fold(String::new(), |text, line| text + "    " + line + "\n");
    let input: String = input
        .lines()
        .map(|line| format!("{}\n", line.trim_end()))
        .collect();
    format!(
        "{input}\n```text\n{}```\n",
        resolved(case.source.parse().unwrap())
    )
}

fn resolved(stream: TokenStream) -> String {
    let front = front(stream);
    match front.formula {
        Some(formula) => print::formula(&formula),
        None => front
            .diagnostics
            .in_order()
            .iter()
            .map(|d| format!("error: {}\n", d.message))
            .collect(),
    }
}

#[test]
fn examples_of_the_language() {
    support::check("formulas/examples.md", tree);
}

#[test]
fn grammar() {
    support::check("formulas/grammar.md", tree);
}

#[test]
fn fixtures_hold_no_mistakes() {
    for file in ["formulas/examples.md", "formulas/grammar.md"] {
        for case in support::cases(file) {
            let text = resolved(case.source.parse().unwrap());
            assert!(!text.contains("error:"), "{}: {text}", case.name);
        }
    }
}

/// A group without brackets, as rustc makes for `$e:expr`.
fn invisible(source: &str) -> TokenTree {
    Group::new(Delimiter::None, source.parse().unwrap()).into()
}

fn with(source: &str, variable: &TokenTree) -> String {
    let replace = |tree: TokenTree| match tree {
        TokenTree::Ident(name) if name == "HOLE" => variable.clone(),
        other => other,
    };
    let stream: TokenStream = source.parse().unwrap();
    resolved(stream.into_iter().map(replace).collect())
}

#[test]
fn macro_variables_are_values_of_their_own() {
    let direct = resolved("struct S; 2*(x + y)^2".parse().unwrap());
    assert_eq!(with("struct S; 2*HOLE^2", &invisible("x + y")), direct);
}

#[test]
fn macro_variables_vanish_around_a_single_token() {
    let direct = resolved("pub struct S { r: f64 } x - r".parse().unwrap());
    assert_eq!(
        with("HOLE struct S { r: f64 } x - r", &invisible("pub")),
        direct
    );
    let nested: TokenTree = Group::new(Delimiter::None, invisible("x").into()).into();
    assert_eq!(with("pub struct S { r: f64 } HOLE - r", &nested), direct);
    let private = resolved("struct S; x".parse().unwrap());
    assert_eq!(with("HOLE struct S; x", &invisible("")), private);
}

#[test]
fn a_macro_variable_may_be_the_whole_input() {
    let direct = resolved("struct S; x = 1".parse().unwrap());
    assert_eq!(with("HOLE", &invisible("struct S; x = 1")), direct);
    assert_eq!(
        with("HOLE", &invisible("x = 1")),
        resolved("x = 1".parse().unwrap())
    );
}

#[test]
fn long_sums_keep_their_value_and_stay_low() {
    let signs = ["+", "-", "-", "+", "-"];
    let mut source = "struct S; x".to_owned();
    let mut expected = 0i64;
    for (i, sign) in (1..5000i64).zip(signs.iter().cycle()) {
        source += &format!(" {sign} {i}");
        expected += if *sign == "+" { i } else { -i };
    }
    let text = resolved(source.parse().unwrap());
    let body = text.lines().last().unwrap().to_owned();
    let depth = |text: &str| {
        let steps = text
            .chars()
            .map(|c| i32::from(c == '(') - i32::from(c == ')'));
        steps
            .scan(0, |depth, step| {
                *depth += step;
                Some(*depth)
            })
            .max()
            .unwrap()
    };
    assert!(depth(&body) < 64, "{}", depth(&body));
    assert_eq!(evaluate(&body.replace('x', "0")), expected);
}

#[test]
fn long_products_do_not_move_divisions() {
    let source = format!("struct S; x{}", "*2*3/y*5".repeat(40));
    let text = resolved(source.parse().unwrap());
    assert_eq!(text.matches("/ y)").count(), 40);
    assert_eq!(text.matches("/ (").count(), 0);
}

/// The value of a printed sum: whole numbers, `+`, `-` and brackets.
fn evaluate(text: &str) -> i64 {
    fn value(words: &mut std::iter::Peekable<std::vec::IntoIter<String>>) -> i64 {
        let word = words.next().unwrap();
        if word != "(" {
            return word.parse().unwrap();
        }
        let left = value(words);
        let operator = words.next().unwrap();
        let right = value(words);
        assert_eq!(words.next().unwrap(), ")");
        if operator == "+" {
            left + right
        } else {
            left - right
        }
    }
    let spaced = text.replace('(', "( ").replace(')', " )");
    let words: Vec<String> = spaced.split_whitespace().map(str::to_owned).collect();
    value(&mut words.into_iter().peekable())
}

/// The control: a fixture with another tree is told apart from the answer.
#[test]
fn wrong_trees_are_refused() {
    let right = support::text("formulas/grammar.md");
    assert_eq!(support::answered(&right, tree), right);
    for (old, new) in [
        ("(-(x ^ 2))", "((-x) ^ 2)"),
        ("a#2", "a#0"),
        ("@1.0", "@0.0"),
        ("1/1000", "1/100"),
    ] {
        let wrong = right.replacen(old, new, 1);
        assert_ne!(wrong, right, "{old:?}");
        assert_ne!(support::answered(&wrong, tree), wrong, "{old:?}");
    }
}
