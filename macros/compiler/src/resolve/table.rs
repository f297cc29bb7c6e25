//! Tables, their elements and the names of numbers.

use super::expression::term;
use super::scope::{Found, Meaning};
use super::{Resolver, Setting, Value};
use crate::ast::{Expr, ExprKind, Name};
use crate::catalogue::{head, shapes};
use crate::exact::Rational;
use crate::tree::{Index, Operator, Over, Shape, TermKind};
use proc_macro2::Ident;

/// A number, or a table that may still be indexed.
pub(super) enum Element {
    Number(Value),
    Table(Table),
}

/// A table: a field, a part of one, or the row of a fold.
pub(super) struct Table {
    pub(super) base: Base,
    pub(super) shape: Shape,
}

/// Where a table comes from.
pub(super) enum Base {
    Field {
        field: usize,
        name: Ident,
        indices: Vec<Index>,
    },
    Row {
        fold: usize,
        name: Ident,
    },
}

/// A table in words.
pub(super) fn describe(shape: &Shape) -> String {
    match shape {
        Shape::Array(_, length) => format!("table of {length}"),
        Shape::Vec(_) => "table".to_owned(),
        Shape::Number => "number".to_owned(),
    }
}

/// The rows of a table.
pub(super) fn rows(shape: &Shape) -> Option<(&Shape, Option<usize>)> {
    match shape {
        Shape::Array(row, length) => Some((row, Some(*length))),
        Shape::Vec(row) => Some((row, None)),
        Shape::Number => None,
    }
}

impl Resolver<'_> {
    /// A name, or a name with indexes.
    pub(super) fn element(&mut self, expr: &Expr) -> Option<Element> {
        match &expr.kind {
            ExprKind::Name(name) => self.named(expr, name),
            ExprKind::Index(base, index) => {
                let element = match &base.kind {
                    ExprKind::Name(_) | ExprKind::Index(..) => self.element(base),
                    _ => self.value(base).map(Element::Number),
                };
                match element {
                    Some(Element::Table(table)) => self.indexed(expr, table, index),
                    Some(Element::Number(_)) => {
                        self.diagnostics.push(shapes::number_indexed(base.place));
                        None
                    }
                    None => None,
                }
            }
            _ => self.value(expr).map(Element::Number),
        }
    }

    fn named(&mut self, expr: &Expr, name: &Name) -> Option<Element> {
        let found = self.find(&name.text);
        if self.setting != Setting::Formula && !matches!(found, Some(Found::Pi | Found::Tau)) {
            self.not_constant(name, found.as_ref());
            return None;
        }
        let ident = name.ident.clone();
        let mut moves = false;
        let mut constant = None;
        let kind = match found {
            Some(Found::Coordinate(axis)) => {
                moves = true;
                TermKind::Coordinate(axis, ident)
            }
            Some(Found::Pi) => TermKind::Pi(ident),
            Some(Found::Tau) => TermKind::Tau(ident),
            Some(Found::Field(field)) if self.flawed_fields.contains(&field) => return None,
            Some(Found::Field(field)) => return self.field(expr, field, ident),
            Some(Found::Declared(Meaning::Let(index))) => {
                let fact = self.facts.get(index)?;
                self.deepest = self.deepest.max(fact.depth);
                moves = fact.moves;
                constant = fact.constant.clone();
                TermKind::Let(index, ident)
            }
            Some(Found::Declared(Meaning::Counter(fold))) => TermKind::Counter(fold, ident),
            Some(Found::Declared(Meaning::Row {
                fold,
                column,
                shape: Shape::Number,
            })) => TermKind::Row {
                fold,
                column,
                name: ident,
            },
            Some(Found::Declared(Meaning::Row { fold, shape, .. })) => {
                return Some(Element::Table(Table {
                    base: Base::Row { fold, name: ident },
                    shape,
                }));
            }
            Some(Found::Declared(Meaning::Mistake)) => return None,
            None => {
                let field = self.unknown(name)?;
                return self.field(expr, field, ident);
            }
        };
        Some(Element::Number(Value {
            term: term(expr.place, kind),
            constant,
            moves,
        }))
    }

    fn field(&self, expr: &Expr, field: usize, name: Ident) -> Option<Element> {
        let shape = self.fields.get(field)?.shape.clone();
        let base = Base::Field {
            field,
            name,
            indices: Vec::new(),
        };
        Some(self.finished(expr, Table { base, shape }))
    }

    /// A table whose last index was given is a number.
    fn finished(&self, expr: &Expr, table: Table) -> Element {
        match table {
            Table {
                base:
                    Base::Field {
                        field,
                        name,
                        indices,
                    },
                shape: Shape::Number,
            } => {
                let kind = TermKind::Field {
                    field,
                    name,
                    indices,
                };
                Element::Number(Value {
                    term: term(expr.place, kind),
                    constant: None,
                    moves: false,
                })
            }
            table => Element::Table(table),
        }
    }

    /// `table[index]`
    fn indexed(&mut self, expr: &Expr, table: Table, index: &Expr) -> Option<Element> {
        let (row, length) = rows(&table.shape)?;
        let row = row.clone();
        let found = self.index(index, &table.shape, length)?;
        match (table.base, found) {
            (
                Base::Field {
                    field,
                    name,
                    mut indices,
                },
                found,
            ) => {
                indices.push(found);
                let base = Base::Field {
                    field,
                    name,
                    indices,
                };
                Some(self.finished(expr, Table { base, shape: row }))
            }
            (Base::Row { fold, name }, Index::Constant(column)) => {
                let kind = TermKind::Row {
                    fold,
                    column: Some(column),
                    name,
                };
                Some(Element::Number(Value {
                    term: term(expr.place, kind),
                    constant: None,
                    moves: false,
                }))
            }
            (Base::Row { .. }, Index::Counter(..)) => {
                self.diagnostics.push(shapes::row_index(index.place));
                None
            }
        }
    }

    /// An index, checked against the length where that is known.
    fn index(&mut self, expr: &Expr, shape: &Shape, length: Option<usize>) -> Option<Index> {
        let (counter, offset) = self.affine(expr)?;
        let offset = match offset.is_integer().then(|| offset.to_i64()) {
            Some(Some(offset)) if offset.unsigned_abs() < 1 << 40 => offset,
            Some(_) => {
                self.diagnostics
                    .push(shapes::outside(expr.place, &describe(shape)));
                return None;
            }
            None => {
                self.diagnostics.push(shapes::index(expr.place));
                return None;
            }
        };
        let (first, last) = match counter.and_then(|fold| self.folds.get(fold)) {
            Some(fold) => match fold.over {
                Over::Range(start, end) => (start + offset, end - 1 + offset),
                Over::Table { .. } => return None,
            },
            None => (offset, offset),
        };
        let length = length
            .and_then(|length| i64::try_from(length).ok())
            .unwrap_or(i64::MAX);
        if first < 0 || last >= length {
            self.diagnostics
                .push(shapes::outside(expr.place, &describe(shape)));
            return None;
        }
        Some(match counter {
            Some(fold) => Index::Counter(fold, offset),
            None => Index::Constant(usize::try_from(offset).ok()?),
        })
    }

    /// A constant, or the counter of a fold plus a constant.
    fn affine(&mut self, expr: &Expr) -> Option<(Option<usize>, Rational)> {
        match &expr.kind {
            ExprKind::Name(name) => {
                if let Some(Found::Declared(Meaning::Counter(fold))) = self.find(&name.text) {
                    return Some((Some(fold), Rational::from(0)));
                }
            }
            ExprKind::Binary(operator @ (Operator::Add | Operator::Subtract), a, b) => {
                let left = self.affine(a);
                let right = self.affine(b);
                let ((left, a_offset), (right, b_offset)) = (left?, right?);
                let counter = match (left, right) {
                    (counter, None) => counter,
                    (None, counter) if *operator == Operator::Add => counter,
                    _ => {
                        self.diagnostics.push(shapes::index(expr.place));
                        return None;
                    }
                };
                let offset = match operator {
                    Operator::Add => &a_offset + &b_offset,
                    _ => &a_offset - &b_offset,
                };
                return Some((counter, offset));
            }
            _ => {}
        }
        match self.value(expr)?.constant {
            Some(constant) => Some((None, constant)),
            None => {
                self.diagnostics.push(shapes::index(expr.place));
                None
            }
        }
    }

    /// A name where only constants may stand.
    fn not_constant(&mut self, name: &Name, found: Option<&Found>) {
        let (place, text) = (name.place, name.text.as_str());
        let mistake = match (self.setting, found) {
            (_, None) => {
                self.unknown(name);
                return;
            }
            (Setting::Domain, _) => head::domain_bound(place),
            (_, Some(Found::Coordinate(_))) => head::default_point(place),
            _ => head::default_field(place, text),
        };
        self.diagnostics.push(mistake);
    }
}
