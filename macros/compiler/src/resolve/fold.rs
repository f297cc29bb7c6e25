//! Folds over ranges and tables.

use super::expression::term;
use super::scope::Meaning;
use super::table::{Base, Element, rows};
use super::{Resolver, Value};
use crate::ast::{self, Expr, Pattern};
use crate::catalogue::{constants, names, shapes};
use crate::diagnostic::Place;
use crate::tree::{Fold, Over, Shape, TermKind};

/// The most folds of a formula: sets of them are the bits of one word in the graph.
pub const MOST_FOLDS: usize = 64;

/// Bounds of ranges lie within ± this.
const MOST_BOUND: i64 = 1 << 31;

impl Resolver<'_> {
    /// A fold.
    pub(super) fn fold(&mut self, place: Place, fold: &ast::Fold) -> Option<Value> {
        let over = match &fold.over {
            ast::Over::Range(start, end) => self.range(start, end),
            ast::Over::Table(table) => self.table(table),
        };
        let outer = self.scope.mark();
        let meanings = match &over {
            Some((_, row)) if fold.pattern.sound => self.meanings(&fold.pattern, row.as_ref()),
            _ => None,
        };
        self.declare_pattern(&fold.pattern, meanings.as_deref());
        let index = self.folds.len();
        let sound = over.is_some() && meanings.is_some();
        if index == MOST_FOLDS {
            self.diagnostics
                .push(constants::too_many_folds(place, MOST_FOLDS));
        }
        if let Some((over, _)) = over {
            self.folds.push(Fold {
                names: fold
                    .pattern
                    .names
                    .iter()
                    .map(|name| name.ident.clone())
                    .collect(),
                list: fold.pattern.list,
                over,
            });
        }
        let body = self.body(&fold.body);
        self.scope.leave(outer);
        let (body, kind) = (body?, fold.kind?);
        if !sound {
            return None;
        }
        Some(Value {
            term: term(place, TermKind::Fold(kind, index, Box::new(body.term))),
            constant: None,
            moves: body.moves,
        })
    }

    /// `start..end`
    fn range(&mut self, start: &Expr, end: &Expr) -> Option<(Over, Option<Shape>)> {
        let first = self.bound(start);
        let last = self.bound(end);
        let (first, last) = (first?, last?);
        if first >= last {
            self.diagnostics
                .push(constants::range_empty(start.place.to(end.place)));
            return None;
        }
        Some((Over::Range(first, last), None))
    }

    fn bound(&mut self, expr: &Expr) -> Option<i64> {
        let constant = self.value(expr)?.constant.filter(|c| c.is_integer());
        let Some(constant) = constant else {
            self.diagnostics.push(constants::fold_bounds(expr.place));
            return None;
        };
        let bound = constant
            .to_i64()
            .filter(|b| b.unsigned_abs() <= MOST_BOUND.unsigned_abs());
        if bound.is_none() {
            self.diagnostics
                .push(constants::range_too_long(expr.place, MOST_BOUND));
        }
        bound
    }

    /// A table to run over, and the shape of its rows.
    fn table(&mut self, expr: &Expr) -> Option<(Over, Option<Shape>)> {
        let table = match self.element(expr)? {
            Element::Table(table) => table,
            Element::Number(_) => {
                self.diagnostics.push(shapes::fold_over_number(expr.place));
                return None;
            }
        };
        let row = rows(&table.shape)?.0.clone();
        let deep = rows(&row).is_some_and(|(inner, _)| *inner != Shape::Number);
        match table.base {
            Base::Field {
                field,
                name,
                indices,
            } if !deep => Some((
                Over::Table {
                    field,
                    name,
                    indices,
                },
                Some(row),
            )),
            Base::Field { .. } => {
                self.diagnostics.push(shapes::fold_over_deep(expr.place));
                None
            }
            Base::Row { .. } => {
                self.diagnostics.push(shapes::fold_over_row(expr.place));
                None
            }
        }
    }

    /// What the names of a pattern stand for, given the shape of a row (`None`: the counter of a range).
    fn meanings(&mut self, pattern: &Pattern, row: Option<&Shape>) -> Option<Vec<Meaning>> {
        let fold = self.folds.len();
        let count = pattern.names.len();
        let mistake = match (row, pattern.list) {
            (None, false) => return Some(vec![Meaning::Counter(fold)]),
            (None, true) => shapes::pattern_of_range(pattern.place),
            (Some(shape), false) => {
                return Some(vec![Meaning::Row {
                    fold,
                    column: None,
                    shape: shape.clone(),
                }]);
            }
            (Some(Shape::Array(_, length)), true) if *length == count => {
                let column = |column| Meaning::Row {
                    fold,
                    column: Some(column),
                    shape: Shape::Number,
                };
                return Some((0..count).map(column).collect());
            }
            (Some(Shape::Array(_, length)), true) => shapes::pattern_length(
                pattern.place,
                &plural(count, "name"),
                &plural(*length, "number"),
            ),
            (Some(_), true) => shapes::pattern_of_numbers(pattern.place, &plural(count, "name")),
        };
        self.diagnostics.push(mistake);
        None
    }

    /// Declares the names of a pattern. After a mistake nothing is said about them.
    fn declare_pattern(&mut self, pattern: &Pattern, meanings: Option<&[Meaning]>) {
        for (i, name) in pattern.names.iter().enumerate() {
            if name.text == "_" {
                continue;
            }
            if pattern
                .names
                .iter()
                .take(i)
                .any(|earlier| earlier.text == name.text)
            {
                self.diagnostics
                    .push(names::pattern_twice(name.place, &name.text));
                continue;
            }
            if self.may_declare(name) {
                let meaning = meanings.and_then(|m| m.get(i)).cloned();
                self.scope
                    .declare(&name.text, meaning.unwrap_or(Meaning::Mistake));
            }
        }
    }
}

/// `1 name`, `2 names`
fn plural(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        n => format!("{n} {what}s"),
    }
}
