//! Notations of mathematics and of other languages that begin with the name of a function or of a fold.

use super::cursor::Cursor;
use super::fold::kind;
use super::token::TokenKind;
use super::{Parser, error, keyword, name};
use crate::ast::{Expr, ExprKind, Fold, Name, Over, Pattern};
use crate::catalogue::{names, syntax, tokens};
use crate::diagnostic::Place;
use crate::functions::Function;
use proc_macro2::{Delimiter, Group};

impl Parser<'_> {
    /// What the name begins, if that is a mistake of these kinds. The name is taken.
    pub(super) fn habit(&mut self, cursor: &mut Cursor, name: &Name) -> Option<Expr> {
        if kind(&name.text).is_some()
            && let Some(fold) = self.other_fold(cursor, name)
        {
            return Some(fold);
        }
        let operand = !matches!(cursor.peek(0), Some(TokenKind::Group(_)));
        let operand = operand && self.operand_ahead(cursor);
        if name.text == "not" && operand {
            self.report(match cursor.condition {
                true => tokens::word_not(name.place),
                false => tokens::not(name.place, "not"),
            });
        } else if Function::find(&name.text).is_none() {
            return None;
        } else if let Some(power) = power_of_function(cursor) {
            let caret = cursor.place();
            cursor.take();
            cursor.take();
            let place = caret.to(cursor.last());
            self.report(syntax::power_of_function(place, &name.text, &power));
        } else if operand || braced(cursor) {
            // `sqrt x`, `sqrt{x}`
            self.report(names::function_as_value(name.place, &name.text));
        } else {
            return None;
        }
        let operand = self.deeper(cursor, Self::power);
        let place = name.place.to(cursor.last());
        Some(error(place, operand.into_iter().collect()))
    }

    /// A fold that is written in another way.
    fn other_fold(&mut self, cursor: &mut Cursor, folder: &Name) -> Option<Expr> {
        if cursor.word(0).is_some() && cursor.word(1).is_some_and(|word| word == "in") {
            return Some(self.fold_without_brackets(cursor, folder));
        }
        let group = cursor.group(0, Delimiter::Parenthesis).cloned()?;
        let inner = cursor.inside(&group);
        let block = cursor.group(1, Delimiter::Brace).is_some() && !cursor.condition;
        let counts = inner.word(0).is_some() && inner.operator(1) == "=";
        if Self::fold_ahead(&inner) || !(block || counts) {
            return None;
        }
        cursor.take();
        let pattern = self.other_header(inner, folder);
        let place = folder.place.to(cursor.last());
        if cursor.group(0, Delimiter::Brace).is_none() {
            return Some(error(place, Vec::new()));
        }
        let fold = Fold {
            kind: None,
            pattern,
            over: Over::Table(error(place, Vec::new())),
            body: self.block(cursor),
        };
        Some(self.expr(ExprKind::Fold(Box::new(fold)), place))
    }

    /// `sum i in 0..8 { … }`
    fn fold_without_brackets(&mut self, cursor: &mut Cursor, folder: &Name) -> Expr {
        self.report(syntax::fold_brackets(folder.place, &folder.text));
        let pattern = self.pattern(cursor);
        cursor.take();
        let over = self.over(cursor);
        let body = self.block(cursor);
        let fold = Fold {
            kind: kind(&folder.text),
            pattern,
            over,
            body,
        };
        let place = folder.place.to(cursor.last());
        self.expr(ExprKind::Fold(Box::new(fold)), place)
    }

    /// `a, b in t`, `i = 0..8`, `i, 0, 8`: the names in it are known in the body.
    fn other_header(&mut self, mut inner: Cursor, folder: &Name) -> Pattern {
        let start = inner.place();
        let mut names = Vec::new();
        let mut table = None;
        while let Some((token, place)) = inner.take() {
            match token {
                TokenKind::Word(word) if word == "in" => {
                    table = inner.word(0).map(ToString::to_string);
                    break;
                }
                TokenKind::Operator("=") => break,
                TokenKind::Word(word) => names.extend(variable(word, place)),
                TokenKind::Group(group) => names.extend(variables(&inner, &group)),
                _ => {}
            }
        }
        inner.skip_to(&[]);
        if table.is_none() {
            names.truncate(1);
        }
        let listed: Vec<&str> = names.iter().map(|name| name.text.as_str()).collect();
        let listed = match (listed.as_slice(), &table) {
            ([], _) => "i in 0..8".to_owned(),
            ([one], None) => format!("{one} in 0..8"),
            ([one], Some(table)) => format!("{one} in {table}"),
            (several, table) => {
                let table = table.as_deref().unwrap_or("t");
                format!("[{}] in {table}", several.join(", "))
            }
        };
        let place = start.to(inner.last());
        let instead = format!("{}({listed}) {{ … }}", folder.text);
        self.report(syntax::fold_header(place, &instead));
        Pattern {
            names,
            list: false,
            sound: false,
            place,
        }
    }
}

/// `{x}` in `sqrt{x}`. (In a condition a brace opens the block.)
fn braced(cursor: &Cursor) -> bool {
    !cursor.condition && cursor.group(0, Delimiter::Brace).is_some()
}

/// `^2` in `sin^2(x)`.
fn power_of_function(cursor: &Cursor) -> Option<String> {
    let power = cursor.token(1)?;
    let whole = matches!(power.kind, TokenKind::Literal(_));
    let called = cursor.group(2, Delimiter::Parenthesis).is_some();
    (cursor.operator(0) == "^" && whole && called).then(|| power.text())
}

fn variable(word: proc_macro2::Ident, place: Place) -> Option<Name> {
    (!keyword(&word.to_string())).then(|| name(word, place))
}

/// The names in a group.
pub(super) fn variables(outer: &Cursor, group: &Group) -> Vec<Name> {
    let mut inner = outer.inside(group);
    let mut names = Vec::new();
    while let Some((token, place)) = inner.take() {
        if let TokenKind::Word(word) = token {
            names.extend(variable(word, place));
        }
    }
    names
}
