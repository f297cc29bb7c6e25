//! A formula as it was written: shapes and places, no meaning yet.

use crate::diagnostic::Place;
use crate::exact::Rational;
use crate::tree::{FoldKind, Operator};
use proc_macro2::{Ident, TokenStream};

/// A whole input.
#[derive(Debug)]
pub struct Input {
    /// The struct, or `None` in the expression form and where it cannot be read.
    pub head: Option<Head>,
    /// Does the input begin without any trace of a struct?
    pub expression_form: bool,
    /// The formula.
    pub body: Body,
}

/// The struct of the struct form.
#[derive(Debug)]
pub struct Head {
    /// Attributes that pass through.
    pub attributes: TokenStream,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Its name; `None` after a mistake.
    pub name: Option<Ident>,
    /// Its fields.
    pub fields: Vec<Field>,
    /// Could all fields be read? If not, unknown names may be fields.
    pub readable: bool,
    /// `#[domain]`: three axes of two bounds.
    pub domain: Option<[[Expr; 2]; 3]>,
}

/// A field as it was written.
#[derive(Debug)]
pub struct Field {
    /// Attributes that pass through.
    pub attributes: TokenStream,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Its name.
    pub name: Name,
    /// Its type; a number after a mistake.
    pub ty: Type,
    /// Its default.
    pub default: Option<Expr>,
}

/// The type of a field.
#[derive(Debug)]
pub struct Type {
    /// What it holds.
    pub shape: crate::tree::Shape,
    /// Is the shape what was written? After a mistake nothing is said about uses of the field.
    pub sound: bool,
    /// As it stands in the struct.
    pub tokens: TokenStream,
}

/// A name with its place.
#[derive(Clone, Debug)]
pub struct Name {
    /// The user's token.
    pub ident: Ident,
    /// Its text.
    pub text: String,
    /// Where it stands.
    pub place: Place,
}

/// `let`s, then an expression or an equation.
#[derive(Debug)]
pub struct Body {
    /// The bindings, and the values that were discarded by mistake.
    pub lets: Vec<Let>,
    /// The left side of the equation, or the expression.
    pub left: Expr,
    /// The right side of the equation.
    pub right: Option<Expr>,
}

/// A `let`.
#[derive(Debug)]
pub struct Let {
    /// `None` after a mistake.
    pub name: Option<Name>,
    /// Its value.
    pub value: Expr,
    /// Is it the user's own, or stands it for `a = …;`, which was reported?
    pub written: bool,
}

/// An expression.
#[derive(Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands, with its brackets.
    pub place: Place,
    /// Height of the tree, bounded so that later passes may recurse.
    pub height: u16,
}

impl Expr {
    /// Was it reported as a mistake?
    pub fn is_error(&self) -> bool {
        matches!(self.kind, ExprKind::Error(_))
    }
}

/// The kinds of expressions.
#[derive(Debug)]
pub enum ExprKind {
    /// An exact literal.
    Number(Rational),
    /// A name.
    Name(Name),
    /// A call as a function or as a method; the receiver is the first argument.
    Call(Name, Vec<Expr>),
    /// `a[b]`
    Index(Box<Expr>, Box<Expr>),
    /// `-a`
    Negate(Box<Expr>),
    /// `a + b` and so on.
    Binary(Operator, Box<Expr>, Box<Expr>),
    /// `a < b` and so on.
    Compare(Comparison, Box<Expr>, Box<Expr>),
    /// `a && b`, `a || b`
    Logic(Logic, Box<Expr>, Box<Expr>),
    /// `sum(i in 0..8) { … }`
    Fold(Box<Fold>),
    /// `if a < b { … } else { … }`; both blocks are there, the second may be another `if`.
    If(Box<[Expr; 3]>),
    /// `{ … }`
    Block(Box<Body>),
    /// `[a, b]`
    List(Vec<Expr>),
    /// `[a; n]`
    Repeat(Box<[Expr; 2]>),
    /// A mistake that was reported. The names inside are still checked.
    Error(Vec<Expr>),
}

/// Comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Comparison {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

/// Joins of comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Logic {
    And,
    Or,
}

/// A fold.
#[derive(Debug)]
pub struct Fold {
    /// How it combines; `None` after a mistake.
    pub kind: Option<FoldKind>,
    /// Its variables.
    pub pattern: Pattern,
    /// What it runs over.
    pub over: Over,
    /// Its body.
    pub body: Body,
}

/// The variables of a fold.
#[derive(Debug)]
pub struct Pattern {
    /// The names; `_` is one of them.
    pub names: Vec<Name>,
    /// Is it a list in brackets?
    pub list: bool,
    /// Are all of them names?
    pub sound: bool,
    /// From the first to the last name.
    pub place: Place,
}

/// What a fold runs over.
#[derive(Debug)]
pub enum Over {
    /// `start..end`, half open.
    Range(Expr, Expr),
    /// A table.
    Table(Expr),
}
