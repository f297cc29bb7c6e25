//! A formula with all its names resolved: what `resolve` makes and `lower` takes.

use crate::exact::Rational;
use crate::functions::Function;
use proc_macro2::{Ident, Span, TokenStream};

/// A whole `implicit!` call that is free of errors.
#[derive(Debug)]
pub struct Formula {
    /// Attributes that pass through to the struct (doc comments, derives; not `#[domain]`).
    pub attributes: TokenStream,
    /// The struct's visibility; empty in the expression form.
    pub visibility: TokenStream,
    /// The struct's name; `None` in the expression form, whose fields are the captured locals.
    pub name: Option<Ident>,
    /// The fields in their order.
    pub fields: Vec<Field>,
    /// `#[domain]`: for each axis the lower and the upper bound. Terms without coordinates, locals or folds.
    pub domain: Option<[[Term; 2]; 3]>,
    /// Every `let`, also those in blocks and bodies of folds, in source order.
    pub lets: Vec<Let>,
    /// The outermost of them; the others stand in a [`TermKind::Block`].
    pub body: Vec<usize>,
    /// Every fold.
    pub folds: Vec<Fold>,
    /// Left side of the equation.
    pub left: Term,
    /// Right side, if it is an equation.
    pub right: Option<Term>,
}

impl Formula {
    /// `struct name; x`: what stands in for a formula with mistakes.
    pub fn coordinate(name: Ident) -> Formula {
        let source = Source {
            start: name.span(),
            end: name.span(),
        };
        let x = Ident::new("x", name.span());
        Formula {
            attributes: TokenStream::new(),
            visibility: TokenStream::new(),
            name: Some(name),
            fields: Vec::new(),
            domain: None,
            lets: Vec::new(),
            body: Vec::new(),
            folds: Vec::new(),
            left: Term {
                kind: TermKind::Coordinate(0, x),
                source,
            },
            right: None,
        }
    }
}

/// A field of the struct.
#[derive(Debug)]
pub struct Field {
    /// Attributes that pass through.
    pub attributes: TokenStream,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Its name.
    pub name: Ident,
    /// Number or table.
    pub shape: Shape,
    /// The type as it stands in the struct: `f64`, `[[f64; 7]; 8]` or `Vec<[f64; 7]>`.
    pub ty: TokenStream,
    /// Its default, without coordinates, other fields or locals; for a number field only. (A table's default is
    /// `TableDefault`.)
    pub default: Option<Default>,
}

/// The default of a field.
#[derive(Clone, Debug)]
pub enum Default {
    /// Of a number.
    Number(Term),
    /// Of a table: nested lists.
    Table(Vec<Default>),
}

/// What a field holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// An `f64`.
    Number,
    /// `[shape; n]`.
    Array(Box<Shape>, usize),
    /// `[shape]`, a `Vec`.
    Vec(Box<Shape>),
}

/// A `let`.
#[derive(Debug)]
pub struct Let {
    /// The name as declared.
    pub name: Ident,
    /// Its value.
    pub value: Term,
    /// Does the compiler know its number? It may then be used where only the compiler sees it: in bounds and indices.
    pub known: bool,
}

/// What a fold runs over.
#[derive(Debug)]
pub struct Fold {
    /// The loop variables as declared, for the scalar evaluator.
    pub names: Vec<Ident>,
    /// Do the names stand in brackets, one per number of a row?
    pub list: bool,
    /// The range or the table.
    pub over: Over,
}

/// The iterations of a fold.
#[derive(Debug)]
pub enum Over {
    /// `start..end`, not empty.
    Range(i64, i64),
    /// The rows of a table: a field, or an element of a field that is itself a table.
    Table {
        /// Index into [`Formula::fields`].
        field: usize,
        /// The field as written.
        name: Ident,
        /// Indices that select a sub-table; empty for the field itself.
        indices: Vec<Index>,
    },
}

/// An index of a table.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Index {
    /// A whole number, checked against the length where that is known.
    Constant(usize),
    /// The variable of an enclosing fold over a range (index into [`Formula::folds`]), plus a constant.
    Counter(usize, i64),
}

/// First and last token of a piece of source.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Span of the first token.
    pub start: Span,
    /// Span of the last token.
    pub end: Span,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Term {
    /// What it is.
    pub kind: TermKind,
    /// Where it stands.
    pub source: Source,
}

/// The kinds of expressions. Identifiers are the user's own tokens.
#[derive(Clone, Debug)]
pub enum TermKind {
    /// An exact literal, with the digits as written.
    Number(Rational),
    /// π.
    Pi(Ident),
    /// 2π.
    Tau(Ident),
    /// x, y, z are 0, 1, 2.
    Coordinate(usize, Ident),
    /// A number field, or an element of a table.
    Field {
        /// Index into [`Formula::fields`].
        field: usize,
        /// The field as written.
        name: Ident,
        /// Indices, as many as the table has dimensions.
        indices: Vec<Index>,
    },
    /// A `let`, by its index in [`Formula::lets`].
    Let(usize, Ident),
    /// A loop variable of a fold over a table: the row's column, `None` if rows are numbers.
    Row {
        /// Index into [`Formula::folds`].
        fold: usize,
        /// Column of the row.
        column: Option<usize>,
        /// The name as written.
        name: Ident,
    },
    /// The loop variable of a fold over a range.
    Counter(usize, Ident),
    /// −a
    Negate(Box<Term>),
    /// a ∘ b
    Binary(Operator, Box<Term>, Box<Term>),
    /// A call, as a function or as a method.
    Call(Function, Ident, Vec<Term>),
    /// A fold over [`Formula::folds`].
    Fold(FoldKind, usize, Box<Term>),
    /// `{ let …; value }`: indices into [`Formula::lets`], and the value.
    Block(Vec<usize>, Box<Term>),
    /// `if`.
    If(Box<Condition>, Box<Term>, Box<Term>),
}

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// How a fold combines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum FoldKind {
    Sum,
    Product,
    Minimum,
    Maximum,
}

/// The condition of an `if`.
#[derive(Clone, Debug)]
pub enum Condition {
    /// a < b (`a > b` is `b < a`).
    Less(Term, Term),
    /// a ≤ b.
    LessOrEqual(Term, Term),
    /// Both.
    Both(Box<Condition>, Box<Condition>),
    /// Either.
    Either(Box<Condition>, Box<Condition>),
}
