//! From tokens to [`crate::ast`]: precedence climbing that never stops at a mistake.
//!
//! A mistake becomes an [`ExprKind::Error`] that keeps the expressions around it, so that their names are checked too.
//! The parser picks up again at `;`, `,` and the ends of groups.

mod attributes;
mod body;
mod branch;
mod call;
mod chain;
mod cursor;
mod expression;
mod fold;
mod habits;
mod head;
mod items;
mod mistakes;
mod number;
mod primary;
mod token;
mod types;

use crate::ast::{Body, Expr, ExprKind, Input, Name};
use crate::catalogue::syntax;
use crate::diagnostic::{Diagnostic, Diagnostics, Place};
use cursor::Cursor;
use proc_macro2::{Ident, TokenStream};
pub use types::primitive;

/// The deepest nesting of brackets and operators. Later passes recurse over the tree.
pub const MOST_LEVELS: u16 = 256;

/// Parses a whole input.
pub fn parse(input: TokenStream, diagnostics: &mut Diagnostics) -> Input {
    let mut parser = Parser {
        diagnostics,
        depth: 0,
        too_deep: false,
        reported_at: None,
    };
    let mut cursor = Cursor::new(input);
    parser.imports(&mut cursor);
    let head = parser.head(&mut cursor);
    let expression_form = head.is_none() && parser.diagnostics.is_empty();
    let mut body = parser.body(&mut cursor);
    if parser.too_deep {
        // Nothing can be said about a formula that was read in part only.
        body = Body {
            lets: Vec::new(),
            left: error(body.left.place, Vec::new()),
            right: None,
        };
    }
    Input {
        head,
        expression_form,
        body,
    }
}

/// The state of the parser besides its position.
struct Parser<'a> {
    diagnostics: &'a mut Diagnostics,
    /// How deep the parser has recursed.
    depth: u16,
    /// Was the depth reported? Once is enough.
    too_deep: bool,
    /// Rank of the token at which the last mistake stands.
    reported_at: Option<u32>,
}

impl Parser<'_> {
    /// Reports a mistake. What follows at the same token is its echo.
    fn report(&mut self, diagnostic: Diagnostic) {
        if !self.too_deep && self.reported_at != Some(diagnostic.place.order) {
            self.reported_at = Some(diagnostic.place.order);
            self.diagnostics.push(diagnostic);
        }
    }

    /// Says nothing more about the token at this place.
    fn echo(&mut self, place: Place) {
        self.reported_at = Some(place.order);
    }

    /// Runs `parse` one level deeper, or reports that there are too many levels.
    fn deeper<T>(
        &mut self,
        cursor: &mut Cursor,
        parse: impl FnOnce(&mut Self, &mut Cursor) -> T,
    ) -> Option<T> {
        if self.depth >= MOST_LEVELS {
            self.report_depth(cursor.place());
            return None;
        }
        self.depth += 1;
        let result = parse(self, cursor);
        self.depth -= 1;
        Some(result)
    }

    /// Reports the depth, once per formula.
    fn report_depth(&mut self, place: Place) {
        if !self.too_deep {
            self.report(syntax::too_deep(place, MOST_LEVELS));
            self.too_deep = true;
        }
    }

    /// An expression. Its height is that of its highest part plus one.
    fn expr(&mut self, kind: ExprKind, place: Place) -> Expr {
        let height = 1 + tallest(&kind);
        if height > MOST_LEVELS {
            self.report_depth(place);
            return error(place, Vec::new());
        }
        Expr {
            kind,
            place,
            height,
        }
    }
}

/// The greatest height among the parts of an expression.
fn tallest(kind: &ExprKind) -> u16 {
    let body = |body: &Body| {
        let values = body.lets.iter().map(|l| l.value.height);
        let right = body.right.as_ref().map_or(0, |r| r.height);
        values.chain([body.left.height, right]).max().unwrap_or(0)
    };
    match kind {
        ExprKind::Number(_) | ExprKind::Name(_) => 0,
        ExprKind::Call(_, parts) | ExprKind::List(parts) | ExprKind::Error(parts) => {
            parts.iter().map(|p| p.height).max().unwrap_or(0)
        }
        ExprKind::Negate(a) => a.height,
        ExprKind::Index(a, b)
        | ExprKind::Binary(_, a, b)
        | ExprKind::Compare(_, a, b)
        | ExprKind::Logic(_, a, b) => a.height.max(b.height),
        ExprKind::Fold(fold) => match &fold.over {
            crate::ast::Over::Range(a, b) => body(&fold.body).max(a.height).max(b.height),
            crate::ast::Over::Table(a) => body(&fold.body).max(a.height),
        },
        ExprKind::If(parts) => parts.iter().map(|p| p.height).max().unwrap_or(0),
        ExprKind::Block(inner) => body(inner),
        ExprKind::Repeat(parts) => parts[0].height.max(parts[1].height),
    }
}

/// A mistake that was reported. Deep parts are left out rather than reported twice.
fn error(place: Place, mut parts: Vec<Expr>) -> Expr {
    parts.retain(|p| p.height < MOST_LEVELS);
    let height = 1 + parts.iter().map(|p| p.height).max().unwrap_or(0);
    Expr {
        kind: ExprKind::Error(parts),
        place,
        height,
    }
}

/// A name with its place.
fn name(ident: Ident, place: Place) -> Name {
    Name {
        text: ident.to_string(),
        ident,
        place,
    }
}

/// Rust's keywords, which cannot be names. (`self`, `if` and the loops have messages of their own.)
fn keyword(word: &str) -> bool {
    matches!(
        word,
        "_" | "abstract"
            | "as"
            | "async"
            | "await"
            | "become"
            | "box"
            | "break"
            | "const"
            | "continue"
            | "crate"
            | "do"
            | "dyn"
            | "else"
            | "enum"
            | "extern"
            | "false"
            | "final"
            | "fn"
            | "for"
            | "gen"
            | "if"
            | "impl"
            | "in"
            | "let"
            | "loop"
            | "macro"
            | "match"
            | "mod"
            | "move"
            | "mut"
            | "override"
            | "priv"
            | "pub"
            | "ref"
            | "return"
            | "self"
            | "Self"
            | "static"
            | "struct"
            | "super"
            | "trait"
            | "true"
            | "try"
            | "type"
            | "typeof"
            | "unsafe"
            | "unsized"
            | "use"
            | "virtual"
            | "where"
            | "while"
            | "yield"
    )
}
