//! Which names are visible, and what they stand for.

use super::Resolver;
use crate::ast::{Body, Expr, ExprKind, Name, Over};
use crate::catalogue::names;
use crate::tree::Shape;

/// What a declared name stands for.
#[derive(Clone, Debug)]
pub(super) enum Meaning {
    /// A `let`, by its index.
    Let(usize),
    /// The counter of a fold over a range.
    Counter(usize),
    /// The row of a fold over a table, or one of its numbers.
    Row {
        /// Index of the fold.
        fold: usize,
        /// Which number of the row.
        column: Option<usize>,
        /// What it holds.
        shape: Shape,
    },
    /// A name whose declaration has a mistake: nothing more is said about it.
    Mistake,
}

/// What a name means.
pub(super) enum Found {
    Coordinate(usize),
    Pi,
    Tau,
    Declared(Meaning),
    Field(usize),
}

/// The `let`s and loop variables in scope, the innermost last.
#[derive(Default)]
pub(super) struct Scope {
    names: Vec<(String, Meaning)>,
}

impl Scope {
    /// Adds a name, which hides an older one.
    pub(super) fn declare(&mut self, name: &str, meaning: Meaning) {
        self.names.push((name.to_owned(), meaning));
    }

    /// The present depth, for [`Scope::leave`].
    pub(super) fn mark(&self) -> usize {
        self.names.len()
    }

    /// Forgets what was declared since the mark.
    pub(super) fn leave(&mut self, mark: usize) {
        self.names.truncate(mark);
    }
}

impl Resolver<'_> {
    /// What this name means here.
    pub(super) fn find(&self, name: &str) -> Option<Found> {
        match name {
            "x" => return Some(Found::Coordinate(0)),
            "y" => return Some(Found::Coordinate(1)),
            "z" => return Some(Found::Coordinate(2)),
            "pi" => return Some(Found::Pi),
            "tau" => return Some(Found::Tau),
            _ => {}
        }
        if let Some((_, meaning)) = self.scope.names.iter().rev().find(|(n, _)| n == name) {
            return Some(Found::Declared(meaning.clone()));
        }
        let field = self.fields.iter().position(|field| field.name == name)?;
        Some(Found::Field(field))
    }

    /// Every name that can be used here, for suggestions.
    pub(super) fn visible(&self) -> Vec<String> {
        let declared = self.scope.names.iter().map(|(name, _)| name.clone());
        let fields = self.fields.iter().map(|field| field.name.to_string());
        let fixed = ["x", "y", "z", "pi", "tau"].map(str::to_owned);
        declared.chain(fields).chain(fixed).collect()
    }

    /// May a `let` or a loop variable have this name? Only other `let`s and loop variables may be hidden.
    pub(super) fn may_declare(&mut self, name: &Name) -> bool {
        let (place, text) = (name.place, name.text.as_str());
        let mistake = match text {
            "x" | "y" | "z" => names::hides_coordinate(place, text),
            "pi" | "tau" => names::hides_constant(place, text),
            _ if !self.expression_form && self.fields.iter().any(|f| f.name == text) => {
                names::hides_field(place, text)
            }
            _ => return true,
        };
        self.diagnostics.push(mistake);
        false
    }

    /// Notes every name that is declared in a body, however deep.
    pub(super) fn declare_all(&mut self, body: &Body) {
        for binding in &body.lets {
            self.declared
                .extend(binding.name.iter().map(|n| n.text.clone()));
            self.declare_inside(&binding.value);
        }
        self.declare_inside(&body.left);
        if let Some(right) = &body.right {
            self.declare_inside(right);
        }
    }

    fn declare_inside(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Name(_) => {}
            ExprKind::Call(_, parts) | ExprKind::List(parts) | ExprKind::Error(parts) => {
                parts.iter().for_each(|part| self.declare_inside(part));
            }
            ExprKind::If(parts) => parts.iter().for_each(|part| self.declare_inside(part)),
            ExprKind::Repeat(parts) => parts.iter().for_each(|part| self.declare_inside(part)),
            ExprKind::Negate(a) => self.declare_inside(a),
            ExprKind::Index(a, b)
            | ExprKind::Binary(_, a, b)
            | ExprKind::Compare(_, a, b)
            | ExprKind::Logic(_, a, b) => {
                self.declare_inside(a);
                self.declare_inside(b);
            }
            ExprKind::Block(body) => self.declare_all(body),
            ExprKind::Fold(fold) => {
                let names = fold.pattern.names.iter().map(|n| n.text.clone());
                self.declared.extend(names);
                if let Over::Range(a, b) = &fold.over {
                    self.declare_inside(a);
                    self.declare_inside(b);
                }
                self.declare_all(&fold.body);
            }
        }
    }
}
