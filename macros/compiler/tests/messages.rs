//! Every message has a fixture: what is underlined, what is said, what is advised.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::panic)]

mod support;

use proc_macro2::{LineColumn, TokenStream};
use std::collections::BTreeSet;
use std::fmt::Write;
use support::Case;
use zeroset_compiler::catalogue;
use zeroset_compiler::diagnostic::Diagnostic;
use zeroset_compiler::front::front;

const FILES: &[&str] = &[
    "errors/constants.md",
    "errors/head.md",
    "errors/names.md",
    "errors/shapes.md",
    "errors/syntax.md",
    "errors/tokens.md",
];

/// The input with its messages.
fn annotate(case: &Case) -> String {
    let stream: TokenStream = case.source.parse().unwrap();
    let front = front(stream);
    let found = front.diagnostics.in_order();
    let mut text = String::new();
    // An empty input has no line to underline.
    let lines: Vec<&str> = if case.source.is_empty() {
        vec![""]
    } else {
        case.source.lines().collect()
    };
    for (index, line) in lines.iter().enumerate() {
        writeln!(text, "{}", format!("    {line}").trim_end()).unwrap();
        for diagnostic in &found {
            let (start, end) = ends(diagnostic);
            if (start.line..=end.line).contains(&(index + 1)) {
                let from = if start.line == index + 1 {
                    start.column
                } else {
                    0
                };
                let to = if end.line == index + 1 {
                    end.column
                } else {
                    line.chars().count()
                };
                writeln!(
                    text,
                    "    {}{}",
                    " ".repeat(from),
                    "~".repeat(to.saturating_sub(from).max(1))
                )
                .unwrap();
            }
            if end.line == index + 1 {
                writeln!(text, "error: {}", diagnostic.message).unwrap();
                if let Some(help) = &diagnostic.help {
                    writeln!(text, "help: {help}").unwrap();
                }
            }
        }
    }
    assert_eq!(front.formula.is_none(), !found.is_empty());
    text
}

fn ends(diagnostic: &Diagnostic) -> (LineColumn, LineColumn) {
    (diagnostic.place.start.start(), diagnostic.place.end.end())
}

#[test]
fn every_message_stands_where_its_fixture_says() {
    for file in FILES {
        support::check(file, annotate);
        for case in support::cases(file) {
            let front = front(case.source.parse().unwrap());
            let codes: Vec<&str> = front
                .diagnostics
                .in_order()
                .iter()
                .map(|d| d.code)
                .collect();
            // `code: remark` is a second case of the same message.
            let code = case.name.split(':').next().unwrap_or_default();
            assert!(
                codes.contains(&code),
                "{file}: {} gives {codes:?}",
                case.name
            );
        }
    }
}

#[test]
fn every_message_has_a_fixture() {
    let mut covered = BTreeSet::new();
    for file in FILES {
        for case in support::cases(file) {
            covered.insert(case.name.split(':').next().unwrap_or_default().to_owned());
        }
    }
    let all: BTreeSet<String> = catalogue::messages()
        .into_iter()
        .map(str::to_owned)
        .collect();
    assert_eq!(covered, all);
    assert_eq!(
        all.len(),
        catalogue::messages().len(),
        "two messages have one name"
    );
}

#[test]
fn messages_keep_the_house_style() {
    for file in FILES {
        for case in support::cases(file) {
            for diagnostic in front(case.source.parse().unwrap()).diagnostics.in_order() {
                let first = diagnostic.message.chars().next().unwrap();
                assert!(!first.is_uppercase(), "{}", diagnostic.message);
                assert!(
                    !diagnostic.message.ends_with(['.', '?', '!']),
                    "{}",
                    diagnostic.message
                );
                assert_ne!(diagnostic.help.as_deref(), Some(""));
            }
        }
    }
}

/// The control: a fixture with a wrong underline, message or help is told apart from the answer.
#[test]
fn wrong_fixtures_are_refused() {
    let right = support::text("errors/names.md");
    assert_eq!(support::answered(&right, annotate), right);
    for (old, new) in [
        ("~~~~~\n", "~~~~\n"),
        ("    ~~~", "     ~~"),
        ("cannot find `radus`", "cannot find `radius`"),
        ("help: the constant is `pi`\n", ""),
    ] {
        let wrong = right.replacen(old, new, 1);
        assert_ne!(wrong, right, "{old:?}");
        assert_ne!(support::answered(&wrong, annotate), wrong, "{old:?}");
    }
}
