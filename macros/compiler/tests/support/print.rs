//! A formula as text: fields, `let`s, folds and the two sides, every operation in brackets, every name resolved.
//!
//! `a#0` is the `let` number 0, `i@1` the counter and `w@1.0` a column of fold number 1.

use std::fmt::Write;
use zeroset_compiler::tree::{
    Condition, Default, Fold, FoldKind, Formula, Index, Operator, Over, Term, TermKind,
};

/// The whole formula.
pub fn formula(formula: &Formula) -> String {
    let mut text = match &formula.name {
        Some(name) => {
            format!("{} struct {name}", formula.visibility)
                .trim()
                .to_owned()
                + "\n"
        }
        None => "anonymous\n".to_owned(),
    };
    if !formula.attributes.is_empty() {
        writeln!(text, "attributes {}", formula.attributes).unwrap();
    }
    for (axis, bounds) in ["x", "y", "z"].iter().zip(formula.domain.iter().flatten()) {
        writeln!(
            text,
            "domain {axis} in {}..{}",
            term(&bounds[0]),
            term(&bounds[1])
        )
        .unwrap();
    }
    for field in &formula.fields {
        let visibility = match field.visibility.to_string() {
            none if none.is_empty() => none,
            some => some + " ",
        };
        let ty = field.ty.to_string().replace(":: core :: primitive :: ", "");
        write!(text, "field {visibility}{}: {ty}", field.name).unwrap();
        if let Some(value) = &field.default {
            write!(text, " = {}", default(value)).unwrap();
        }
        if !field.attributes.is_empty() {
            write!(text, " with {}", field.attributes).unwrap();
        }
        writeln!(text, "   [{:?}]", field.shape).unwrap();
    }
    for (i, fold) in formula.folds.iter().enumerate() {
        writeln!(text, "fold @{i}: {}", head(fold)).unwrap();
    }
    for (i, binding) in formula.lets.iter().enumerate() {
        writeln!(text, "let {}#{i} = {}", binding.name, term(&binding.value)).unwrap();
    }
    write!(text, "{}", term(&formula.left)).unwrap();
    if let Some(right) = &formula.right {
        write!(text, " = {}", term(right)).unwrap();
    }
    text + "\n"
}

fn default(value: &Default) -> String {
    match value {
        Default::Number(value) => term(value),
        Default::Table(rows) => format!(
            "[{}]",
            rows.iter().map(default).collect::<Vec<_>>().join(", ")
        ),
    }
}

fn head(fold: &Fold) -> String {
    let names: Vec<String> = fold.names.iter().map(ToString::to_string).collect();
    let names = names.join(", ");
    let names = if fold.list {
        format!("[{names}]")
    } else {
        names
    };
    match &fold.over {
        Over::Range(start, end) => format!("{names} in {start}..{end}"),
        Over::Table {
            field,
            name,
            indices,
        } => format!("{names} in {name}({field}){}", path(indices)),
    }
}

fn path(indices: &[Index]) -> String {
    let one = |index: &Index| match index {
        Index::Constant(value) => format!("[{value}]"),
        Index::Counter(fold, 0) => format!("[@{fold}]"),
        Index::Counter(fold, offset) => format!("[@{fold} {offset:+}]"),
    };
    indices.iter().map(one).collect()
}

/// One expression.
fn term(t: &Term) -> String {
    match &t.kind {
        TermKind::Number(value) => value.to_string(),
        TermKind::Pi(name) | TermKind::Tau(name) => name.to_string(),
        TermKind::Coordinate(axis, name) => {
            assert_eq!(["x", "y", "z"][*axis], name.to_string());
            name.to_string()
        }
        TermKind::Field {
            field,
            name,
            indices,
        } => format!("{name}({field}){}", path(indices)),
        TermKind::Let(index, name) => format!("{name}#{index}"),
        TermKind::Row {
            fold,
            column: Some(column),
            name,
        } => format!("{name}@{fold}.{column}"),
        TermKind::Row {
            fold,
            column: None,
            name,
        } => format!("{name}@{fold}"),
        TermKind::Counter(fold, name) => format!("{name}@{fold}"),
        TermKind::Negate(a) => format!("(-{})", term(a)),
        TermKind::Binary(operator, a, b) => {
            format!("({} {} {})", term(a), sign(*operator), term(b))
        }
        TermKind::Call(function, name, arguments) => {
            assert_eq!(function.entry().name, name.to_string());
            format!(
                "{name}({})",
                arguments.iter().map(term).collect::<Vec<_>>().join(", ")
            )
        }
        TermKind::Fold(kind, fold, body) => format!("{}@{fold}({})", fold_name(*kind), term(body)),
        TermKind::Block(_, value) => term(value),
        TermKind::If(c, a, b) => {
            format!("if {} {{{}}} else {{{}}}", condition(c), term(a), term(b))
        }
    }
}

fn sign(operator: Operator) -> &'static str {
    match operator {
        Operator::Add => "+",
        Operator::Subtract => "-",
        Operator::Multiply => "*",
        Operator::Divide => "/",
        Operator::Power => "^",
    }
}

fn fold_name(kind: FoldKind) -> &'static str {
    match kind {
        FoldKind::Sum => "sum",
        FoldKind::Product => "prod",
        FoldKind::Minimum => "min",
        FoldKind::Maximum => "max",
    }
}

fn condition(c: &Condition) -> String {
    match c {
        Condition::Less(a, b) => format!("({} < {})", term(a), term(b)),
        Condition::LessOrEqual(a, b) => format!("({} <= {})", term(a), term(b)),
        Condition::Both(a, b) => format!("({} && {})", condition(a), condition(b)),
        Condition::Either(a, b) => format!("({} || {})", condition(a), condition(b)),
    }
}
