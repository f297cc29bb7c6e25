//! Calls of functions.

use super::expression::term;
use super::scope::{Found, Meaning};
use super::{Resolver, Value, constant, nearest};
use crate::ast::{Expr, ExprKind, Name};
use crate::catalogue::{constants, names, shapes};
use crate::diagnostic::{Diagnostic, Place};
use crate::exact::Rational;
use crate::functions::{Function, TABLE};
use crate::tree::TermKind;

impl Resolver<'_> {
    /// A call, as a function or as a method.
    pub(super) fn call(&mut self, place: Place, name: &Name, arguments: &[Expr]) -> Option<Value> {
        let Some(function) = Function::find(&name.text) else {
            // A `let` with a mistake may have meant to be a function.
            if !matches!(
                self.find(&name.text),
                Some(Found::Declared(Meaning::Mistake))
            ) {
                let mistake = self.unknown_function(name);
                self.diagnostics.push(mistake);
            }
            // `sum(i^2, i, 0, 8)`: the fold would have known its variable.
            if !matches!(name.text.as_str(), "sum" | "prod") {
                arguments
                    .iter()
                    .for_each(|argument| self.names_in(argument));
            }
            return None;
        };
        let wrong = arguments.len() != function.entry().arity;
        let list = |a: &Expr| matches!(a.kind, ExprKind::List(_) | ExprKind::Repeat(_));
        let values: Vec<Option<Value>> = arguments
            .iter()
            // `min([x, y, z])` is one mistake.
            .filter(|argument| !(wrong && list(argument)))
            .map(|argument| self.value(argument))
            .collect();
        let sound = arguments.iter().all(|argument| !argument.is_error());
        if wrong && sound {
            self.diagnostics
                .push(arity(place, &name.text, function, arguments.len()));
            return None;
        }
        let values: Vec<Value> = values.into_iter().collect::<Option<_>>()?;
        let known: Vec<Option<Rational>> = values.iter().map(|v| v.constant.clone()).collect();
        self.defined(place, name, function, arguments, &known)?;
        let moves = values.iter().any(|v| v.moves);
        let terms = values.into_iter().map(|v| v.term).collect();
        Some(Value {
            term: term(place, TermKind::Call(function, name.ident.clone(), terms)),
            constant: constant::call(function, &known),
            moves,
        })
    }

    /// Is the function defined for those arguments that are constants?
    fn defined(
        &mut self,
        place: Place,
        name: &Name,
        function: Function,
        arguments: &[Expr],
        known: &[Option<Rational>],
    ) -> Option<()> {
        let first = arguments.first().map_or(place, |a| a.place);
        let mistake = match (function, known) {
            (Function::Sqrt, [Some(a)]) if a.is_negative() => constants::root_of_negative(first),
            (Function::Recip, [Some(a)]) if !a.is_negative() && !a.is_positive() => {
                constants::division_by_zero(first)
            }
            (Function::Clamp, [_, Some(lower), Some(upper)]) if lower > upper => {
                constants::clamp_bounds(place)
            }
            (_, [Some(a)]) => match constant::outside(function, a) {
                Some(domain) => constants::undefined(first, &name.text, domain),
                None => return Some(()),
            },
            _ => return Some(()),
        };
        self.diagnostics.push(mistake);
        None
    }

    /// What is wrong with a call of something that is not a function.
    fn unknown_function(&self, name: &Name) -> Diagnostic {
        let (place, text) = (name.place, name.text.as_str());
        match self.find(text) {
            Some(Found::Field(_)) | Some(Found::Declared(_)) if self.names_a_table(text) => {
                return shapes::table_called(place, text);
            }
            Some(_) => return names::call_of_number(place, text),
            None => {}
        }
        match text {
            "log" => return names::ambiguous_log(place),
            "len" => return names::length_of_table(place),
            "f" => return names::named_formula(place, text),
            _ => {}
        }
        if nearest::jumps(text) {
            return names::jumps(place, text);
        }
        if let Some(instead) = nearest::instead_of_function(text) {
            return names::unknown_function_instead(place, text, instead);
        }
        match nearest::nearest(text, TABLE.iter().map(|entry| entry.name)) {
            Some(similar) => names::unknown_function_similar(place, text, similar),
            None => names::unknown_function(place, text),
        }
    }
}

/// The wrong number of arguments.
fn arity(place: Place, name: &str, function: Function, given: usize) -> Diagnostic {
    let takes = match function.entry().arity {
        1 => "1 argument".to_owned(),
        n => format!("{n} arguments"),
    };
    let are = match given {
        1 => "1 is".to_owned(),
        n => format!("{n} are"),
    };
    if matches!(function, Function::Min | Function::Max) && given != 2 {
        names::arity_fold(place, name, &takes, &are)
    } else if function == Function::Hypot && given == 3 {
        names::arity_hypot(place, name, &takes, &are)
    } else {
        names::arity(place, name, &takes, &are)
    }
}
