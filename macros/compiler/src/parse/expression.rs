//! Operators and their precedence.
//!
//! Loosest first: `||`, `&&`, comparisons, `+ -`, `* /`, unary `-`, `^`. So `-x^2` is `-(x^2)`, and `^` joins from the
//! right: `2^3^2` is `2^9`. Operators of Rust that the language lacks have a precedence too, so that one of them in
//! the middle of a formula is one mistake.

use super::chain::Join;
use super::cursor::Cursor;
use super::token::TokenKind;
use super::{Parser, error};
use crate::ast::{Comparison, Expr, ExprKind, Logic};
use crate::catalogue::{names, syntax, tokens};
use crate::diagnostic::Place;
use crate::tree::Operator;
use proc_macro2::Delimiter;

const OR: u8 = 1;
const AND: u8 = 2;
const COMPARE: u8 = 3;
const SUM: u8 = 4;
const PRODUCT: u8 = 5;
const UNARY: u8 = 6;

/// What comes next after an operand.
enum Next {
    /// An operator.
    Operator(Join),
    /// A second operand without an operator.
    Operand,
}

impl Parser<'_> {
    /// Parses an expression.
    pub(super) fn expression(&mut self, cursor: &mut Cursor) -> Expr {
        let place = cursor.place();
        self.deeper(cursor, |parser, cursor| parser.operators(cursor, OR))
            .unwrap_or_else(|| {
                cursor.take();
                error(place, Vec::new())
            })
    }

    /// Parses operands joined by operators that bind at least as tightly as `least`.
    fn operators(&mut self, cursor: &mut Cursor, least: u8) -> Expr {
        let mut first = self.unary(cursor);
        let mut rest: Vec<(Join, Expr)> = Vec::new();
        let mut level = UNARY;
        while let Some((found, next)) = self.next(cursor) {
            if found < least {
                break;
            }
            // `if (x > 0) y`: the block lacks its braces.
            let last = rest.last().map_or(&first, |(_, last)| last);
            if matches!(next, Next::Operand) && cursor.condition && compares(last) {
                break;
            }
            // A looser operator: what was collected so far is its left operand.
            if found != level {
                first = self.chain(first, std::mem::take(&mut rest));
                level = found;
            }
            let mut join = match next {
                Next::Operator(join) => join,
                Next::Operand => Join::Mistake,
            };
            if found == COMPARE && !rest.is_empty() && !matches!(join, Join::Mistake) {
                self.report(syntax::chained(cursor.place()));
                join = Join::Mistake;
            }
            if let Next::Operator(_) = next {
                self.foreign(cursor);
                cursor.take();
                rest.push((join, self.operators(cursor, found + 1)));
            } else {
                let operand = self.second_operand(cursor);
                rest.push((join, operand));
            }
        }
        self.chain(first, rest)
    }

    /// An operand that lacks its operator.
    fn second_operand(&mut self, cursor: &mut Cursor) -> Expr {
        if !cursor.at_word("if") {
            let operand = self.unary(cursor);
            self.report(syntax::juxtaposed(operand.place));
            return operand;
        }
        // `a if c else b`
        self.report(syntax::value_before_if(cursor.place()));
        cursor.take();
        let condition = self.expression(cursor);
        let mut parts = vec![condition];
        if cursor.group(0, Delimiter::Brace).is_some() {
            parts.push(self.expression(cursor));
        }
        if cursor.eat_word("else").is_some() && !cursor.at_end() {
            parts.push(self.expression(cursor));
        }
        error(cursor.last(), parts)
    }

    /// The operator ahead, or the operand that lacks one, with its precedence.
    fn next(&self, cursor: &Cursor) -> Option<(u8, Next)> {
        let operator = |level, join| Some((level, Next::Operator(join)));
        let arithmetic = |level, join| operator(level, Join::Arithmetic(join));
        let compare = |join| operator(COMPARE, Join::Compare(join));
        match cursor.operator(0) {
            "||" if cursor.bars == 0 => operator(OR, Join::Logic(Logic::Or)),
            "|" if cursor.bars > 0 => None,
            "|" | "&" => operator(OR, Join::Mistake),
            "&&" => operator(AND, Join::Logic(Logic::And)),
            "<" => compare(Comparison::Less),
            "<=" => compare(Comparison::LessOrEqual),
            ">" => compare(Comparison::Greater),
            ">=" => compare(Comparison::GreaterOrEqual),
            "==" | "!=" => operator(COMPARE, Join::Mistake),
            "+" => arithmetic(SUM, Operator::Add),
            "-" => arithmetic(SUM, Operator::Subtract),
            "*" => arithmetic(PRODUCT, Operator::Multiply),
            "/" => arithmetic(PRODUCT, Operator::Divide),
            "%" | "<<" | ">>" => operator(PRODUCT, Join::Mistake),
            "" if cursor.at_word("or") => operator(OR, Join::Mistake),
            "" if cursor.at_word("and") => operator(AND, Join::Mistake),
            "" if foreign_word(cursor) => operator(PRODUCT, Join::Mistake),
            "" if self.operand_ahead(cursor) => Some((PRODUCT, Next::Operand)),
            _ => None,
        }
    }

    /// Does a second operand follow the first? A brace opens the block of an `if` or a fold, and in a `let` it may be
    /// the `;` that is missing rather than an operator.
    pub(super) fn operand_ahead(&self, cursor: &Cursor) -> bool {
        if cursor.unended {
            return false;
        }
        match cursor.peek(0) {
            // `name:` begins the next field.
            Some(TokenKind::Word(_)) if cursor.operator(1) == ":" => false,
            Some(TokenKind::Word(word)) => !matches!(
                word.to_string().as_str(),
                "in" | "else" | "let" | "for" | "as" | "pub" | "struct" | "then" | "and" | "or"
            ),
            Some(TokenKind::Literal(_)) => true,
            Some(TokenKind::Group(group)) => group.delimiter() != Delimiter::Brace,
            _ => false,
        }
    }

    /// Reports the operator ahead if the language lacks it.
    fn foreign(&mut self, cursor: &Cursor) {
        let place = cursor.place();
        match cursor.operator(0) {
            operator @ ("|" | "&") => self.report(tokens::bit_operator(place, operator)),
            operator @ ("<<" | ">>") => self.report(tokens::shift(place, operator)),
            "%" => self.report(tokens::remainder(place)),
            operator @ ("==" | "!=") if cursor.condition => {
                self.report(tokens::equality_test(place, operator))
            }
            operator @ ("==" | "!=") => self.report(tokens::double_equals(place, operator)),
            _ if foreign_word(cursor) => self.report(match cursor.at_word("mod") {
                true => names::jumps(place, "mod"),
                false => tokens::bit_operator(place, "xor"),
            }),
            _ if !cursor.condition && cursor.at_word("and") => {
                self.report(tokens::bit_operator(place, "and"));
            }
            _ if !cursor.condition && cursor.at_word("or") => {
                self.report(tokens::bit_operator(place, "or"));
            }
            _ if cursor.at_word("and") => self.report(tokens::word_operator(place, "and", "&&")),
            _ if cursor.at_word("or") => self.report(tokens::word_operator(place, "or", "||")),
            _ => {}
        }
    }

    /// `-a`, or a power.
    fn unary(&mut self, cursor: &mut Cursor) -> Expr {
        let Some(minus) = cursor.eat("-") else {
            return self.power(cursor);
        };
        let operand = self.deeper(cursor, Self::unary);
        self.negated(minus, operand)
    }

    fn negated(&mut self, minus: Place, operand: Option<Expr>) -> Expr {
        match operand {
            Some(operand) => {
                let place = minus.to(operand.place);
                self.expr(ExprKind::Negate(Box::new(operand)), place)
            }
            None => error(minus, Vec::new()),
        }
    }

    /// `a^b`; the exponent may have a sign and powers of its own.
    pub(super) fn power(&mut self, cursor: &mut Cursor) -> Expr {
        let base = self.postfix(cursor);
        match cursor.operator(0) {
            "**" => self.report(tokens::double_star(cursor.place())),
            "^" => {}
            _ => return base,
        }
        let caret = cursor.place();
        cursor.take();
        let exponent = self
            .deeper(cursor, Self::unary)
            .unwrap_or_else(|| error(caret, Vec::new()));
        let place = base.place.to(exponent.place);
        let kind = ExprKind::Binary(Operator::Power, Box::new(base), Box::new(exponent));
        self.expr(kind, place)
    }
}

/// Words that are operators in other languages.
fn foreign_word(cursor: &Cursor) -> bool {
    (cursor.at_word("mod") || cursor.at_word("xor")) && cursor.token(1).is_some()
}

/// Is this a comparison?
fn compares(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Compare(..) | ExprKind::Logic(..))
}
