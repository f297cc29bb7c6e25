//! From [`crate::ast`] to [`crate::tree`]: what each name means, and whether every part has the shape it needs.

mod call;
mod condition;
mod constant;
mod expression;
mod fields;
pub(crate) mod fold;
mod names;
mod nearest;
mod scope;
mod table;

use crate::ast::{Body, Expr, Input, Name};
use crate::catalogue::{shapes, syntax};
use crate::diagnostic::Diagnostics;
use crate::exact::Rational;
use crate::tree::{self, Formula, Term, TermKind};
use proc_macro2::TokenStream;
use scope::Scope;
use std::collections::HashSet;

/// Resolves a whole input. With mistakes in it the result is of no use.
pub fn resolve(input: Input, diagnostics: &mut Diagnostics) -> Formula {
    let mut resolver = Resolver {
        diagnostics,
        // Where the struct cannot be read, an unknown name may be a field.
        expression_form: !input.head.as_ref().is_some_and(|head| head.readable),
        setting: Setting::Formula,
        fields: Vec::new(),
        flawed_fields: HashSet::new(),
        lets: Vec::new(),
        facts: Vec::new(),
        folds: Vec::new(),
        scope: Scope::default(),
        declared: HashSet::new(),
        deepest: 0,
        entries: 0,
    };
    let mut formula = Formula {
        attributes: TokenStream::new(),
        visibility: TokenStream::new(),
        name: None,
        fields: Vec::new(),
        domain: None,
        lets: Vec::new(),
        body: Vec::new(),
        folds: Vec::new(),
        left: nothing(&input.body.left),
        right: None,
    };
    if let Some(head) = input.head {
        resolver.declare_fields(head.fields);
        formula.domain = head.domain.and_then(|domain| resolver.domain(&domain));
        formula.attributes = head.attributes;
        formula.visibility = head.visibility;
        formula.name = head.name;
    }
    if let Some((body, left, right)) = resolver.formula(&input.body) {
        formula.body = body;
        formula.left = left;
        formula.right = right;
    }
    formula.fields = resolver.fields;
    formula.lets = resolver.lets;
    formula.folds = resolver.folds;
    formula
}

/// Stands for a formula that has mistakes.
fn nothing(at: &Expr) -> Term {
    Term {
        kind: TermKind::Number(Rational::from(0)),
        source: at.place.source(),
    }
}

/// Where an expression stands, and so what it may be made of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Setting {
    /// The formula: everything.
    Formula,
    /// The default of a field: constants.
    Default,
    /// A bound of the domain: constants.
    Domain,
}

/// A resolved number.
struct Value {
    term: Term,
    /// Its value, where that is a rational number that the compiler knows.
    constant: Option<Rational>,
    /// Does it depend on the point?
    moves: bool,
}

impl Value {
    /// The value of a block that begins with these `let`s.
    fn after(mut self, lets: Vec<usize>) -> Value {
        if !lets.is_empty() {
            self.term = Term {
                source: self.term.source,
                kind: TermKind::Block(lets, Box::new(self.term)),
            };
        }
        self
    }
}

/// What is known of a `let`.
struct Fact {
    constant: Option<Rational>,
    moves: bool,
    /// Height of its tree with every `let` written out.
    depth: u32,
}

/// The greatest height of a formula with every `let` written out. Later passes recurse over it.
const MOST_DEPTH: u32 = 2048;

/// The state of the resolution. Every method that returns `None` has reported why.
struct Resolver<'a> {
    diagnostics: &'a mut Diagnostics,
    /// In the expression form unknown names are captured locals.
    expression_form: bool,
    setting: Setting,
    fields: Vec<tree::Field>,
    /// Fields whose type has a mistake.
    flawed_fields: HashSet<usize>,
    lets: Vec<tree::Let>,
    /// One fact per `let`.
    facts: Vec<Fact>,
    folds: Vec<tree::Fold>,
    scope: Scope,
    /// Every name that is declared anywhere in the formula.
    declared: HashSet<String>,
    /// The greatest depth among the `let`s that the present expression uses.
    deepest: u32,
    /// Entries of default lists so far.
    entries: usize,
}

impl Resolver<'_> {
    /// The whole formula: its outermost `let`s and its two sides.
    fn formula(&mut self, body: &Body) -> Option<(Vec<usize>, Term, Option<Term>)> {
        self.declare_all(body);
        let lets = self.bindings(body);
        if body.right.is_none() && self.inequality(&body.left) {
            return None;
        }
        let left = self.value(&body.left);
        let right = body.right.as_ref().map(|right| self.value(right));
        let (left, right) = match right {
            Some(right) => (left?, Some(right?)),
            None => (left?, None),
        };
        let moves = left.moves || right.as_ref().is_some_and(|r| r.moves);
        // After another mistake the coordinate may be just what is missing.
        if !moves && self.diagnostics.is_empty() {
            let last = body.right.as_ref().map_or(body.left.place, |r| r.place);
            self.diagnostics
                .push(shapes::constant_formula(body.left.place.to(last)));
        }
        Some((lets, left.term, right.map(|r| r.term)))
    }

    /// The value of a block. An equation means the difference of its sides.
    fn body(&mut self, body: &Body) -> Option<Value> {
        let outer = self.scope.mark();
        let lets = self.bindings(body);
        let left = self.value(&body.left);
        let value = match &body.right {
            None => left,
            Some(right) => {
                let right_value = self.value(right);
                let place = body.left.place.to(right.place);
                left.zip(right_value)
                    .map(|(left, right)| self.difference(place, left, right))
            }
        };
        self.scope.leave(outer);
        value.map(|value| value.after(lets))
    }

    /// The `let`s of a body, which stay in scope.
    fn bindings(&mut self, body: &Body) -> Vec<usize> {
        let mut lets = Vec::new();
        for binding in &body.lets {
            let outer = std::mem::take(&mut self.deepest);
            let value = self.value(&binding.value);
            let depth = self.depth(&binding.value);
            self.deepest = outer;
            let Some(name) = &binding.name else { continue };
            if !binding.written {
                // It was told that it lacks its `let`.
                if self.find(&name.text).is_none() {
                    self.scope.declare(&name.text, scope::Meaning::Mistake);
                }
                continue;
            }
            if !self.may_declare(name) {
                continue;
            }
            match value {
                Some(value) => {
                    lets.push(self.lets.len());
                    self.bind(name, value, depth);
                }
                None => self.scope.declare(&name.text, scope::Meaning::Mistake),
            }
        }
        lets
    }

    /// The depth of an expression that was resolved just now.
    fn depth(&mut self, expr: &Expr) -> u32 {
        let depth = self.deepest.saturating_add(u32::from(expr.height));
        if depth <= MOST_DEPTH {
            return depth;
        }
        self.diagnostics
            .push(syntax::lets_too_deep(expr.place, MOST_DEPTH));
        0
    }

    fn bind(&mut self, name: &Name, value: Value, depth: u32) {
        self.scope
            .declare(&name.text, scope::Meaning::Let(self.lets.len()));
        let known = value.constant.is_some();
        self.facts.push(Fact {
            constant: value.constant,
            moves: value.moves,
            depth,
        });
        self.lets.push(tree::Let {
            known,
            name: name.ident.clone(),
            value: value.term,
        });
    }
}
