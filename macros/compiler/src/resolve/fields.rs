//! Fields with their defaults, and the domain.

use super::table::{describe, rows};
use super::{Resolver, Setting};
use crate::ast::{self, Expr, ExprKind};
use crate::catalogue::head;
use crate::tree::{Default, Field, Shape, Term};

/// The most entries that defaults spell out in all.
const MOST_ENTRIES: usize = 1 << 16;

impl Resolver<'_> {
    /// Declares the fields of the struct.
    pub(super) fn declare_fields(&mut self, fields: Vec<ast::Field>) {
        let mut defaults = Vec::new();
        for field in fields {
            defaults.push(field.default);
            if !field.ty.sound {
                self.flawed_fields.insert(self.fields.len());
            }
            self.fields.push(Field {
                attributes: field.attributes,
                visibility: field.visibility,
                name: field.name.ident,
                shape: field.ty.shape,
                ty: field.ty.tokens,
                default: None,
            });
        }
        // All fields are declared by now, so that a default that names one is told so.
        self.setting = Setting::Default;
        for (index, default) in defaults.iter().enumerate() {
            let (Some(default), Some(shape)) =
                (default, self.fields.get(index).map(|f| f.shape.clone()))
            else {
                continue;
            };
            if self.flawed_fields.contains(&index) {
                self.names_in_entries(default);
                continue;
            }
            let default = self.default(default, &shape);
            if let Some(field) = self.fields.get_mut(index) {
                field.default = default;
            }
        }
        self.setting = Setting::Formula;
    }

    /// Checks the names in a default of unknown shape.
    fn names_in_entries(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::List(entries) => entries
                .iter()
                .for_each(|entry| self.names_in_entries(entry)),
            ExprKind::Repeat(parts) => parts.iter().for_each(|part| self.names_in_entries(part)),
            _ => self.names_in(expr),
        }
    }

    /// A default of this shape.
    fn default(&mut self, expr: &Expr, shape: &Shape) -> Option<Default> {
        match (&expr.kind, rows(shape)) {
            (ExprKind::Error(_), _) => {
                self.names_in(expr);
                None
            }
            (ExprKind::List(_) | ExprKind::Repeat(_), None) => {
                self.diagnostics
                    .push(head::default_list(expr.place, "a number"));
                None
            }
            (ExprKind::List(entries), Some((row, length))) => {
                self.fits(expr, entries.len(), length)?;
                let entries: Vec<Option<Default>> = entries
                    .iter()
                    .map(|entry| self.default(entry, row))
                    .collect();
                entries
                    .into_iter()
                    .collect::<Option<_>>()
                    .map(Default::Table)
            }
            (ExprKind::Repeat(parts), Some((row, length))) => {
                self.repeated(expr, parts, row, length)
            }
            (_, Some(_)) => {
                let found = format!("a {}", describe(shape));
                self.diagnostics
                    .push(head::default_not_list(expr.place, &found));
                None
            }
            (_, None) => self.value(expr).map(|value| Default::Number(value.term)),
        }
    }

    /// `[entry; count]`
    fn repeated(
        &mut self,
        expr: &Expr,
        parts: &[Expr; 2],
        row: &Shape,
        length: Option<usize>,
    ) -> Option<Default> {
        let [entry, count] = parts;
        let count_value = self.value(count)?.constant.filter(|c| c.is_integer());
        let Some(repeats) = count_value.and_then(|c| usize::try_from(c.to_i64()?).ok()) else {
            self.diagnostics.push(head::table_length(count.place));
            return None;
        };
        self.fits(expr, repeats, length)?;
        let before = self.entries;
        let entry = self.default(entry, row)?;
        // An entry that is a table itself counts as often as it is repeated.
        let size = (self.entries - before).max(1);
        self.entries = self
            .entries
            .saturating_add(size.saturating_mul(repeats.saturating_sub(1)));
        if self.entries > MOST_ENTRIES {
            self.diagnostics
                .push(head::table_too_long(expr.place, MOST_ENTRIES));
            return None;
        }
        Some(Default::Table(vec![entry; repeats]))
    }

    /// Does a list of so many entries fit the table?
    fn fits(&mut self, expr: &Expr, found: usize, length: Option<usize>) -> Option<()> {
        self.entries = self.entries.saturating_add(found.min(MOST_ENTRIES));
        match length {
            Some(wanted) if wanted != found => {
                self.diagnostics
                    .push(head::default_length(expr.place, &entries(found), wanted));
                None
            }
            _ if found > MOST_ENTRIES => {
                self.diagnostics
                    .push(head::table_too_long(expr.place, MOST_ENTRIES));
                None
            }
            _ => Some(()),
        }
    }

    /// The bounds of the domain.
    pub(super) fn domain(&mut self, domain: &[[Expr; 2]; 3]) -> Option<[[Term; 2]; 3]> {
        self.setting = Setting::Domain;
        let [x, y, z] = [0, 1, 2].map(|axis| self.axis(domain.get(axis)?));
        self.setting = Setting::Formula;
        Some([x?, y?, z?])
    }

    fn axis(&mut self, [lower, upper]: &[Expr; 2]) -> Option<[Term; 2]> {
        let first = self.value(lower);
        let last = self.value(upper);
        let (first, last) = (first?, last?);
        if let (Some(a), Some(b)) = (&first.constant, &last.constant)
            && a >= b
        {
            self.diagnostics
                .push(head::domain_empty(lower.place.to(upper.place)));
            return None;
        }
        Some([first.term, last.term])
    }
}

fn entries(count: usize) -> String {
    match count {
        1 => "1 entry".to_owned(),
        n => format!("{n} entries"),
    }
}
