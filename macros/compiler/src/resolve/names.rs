//! Names in the place of values.

use super::scope::Found;
use super::{Resolver, nearest};
use crate::ast::Name;
use crate::catalogue::names;
use crate::diagnostic::Diagnostic;
use crate::functions::Function;
use crate::tree;
use proc_macro2::{Ident, TokenStream};

impl Resolver<'_> {
    /// What an unknown name is: a captured local, or a mistake.
    pub(super) fn unknown(&mut self, name: &Name) -> Option<usize> {
        let mistake = match self.not_a_value(name) {
            Some(mistake) => mistake,
            None if self.expression_form => return Some(self.capture(name)),
            None => self.suggestion(name),
        };
        self.diagnostics.push(mistake);
        None
    }

    /// A local becomes a field, in the order of first appearance.
    fn capture(&mut self, name: &Name) -> usize {
        let ident = name.ident.clone();
        let span = ident.span();
        self.fields.push(tree::Field {
            attributes: TokenStream::new(),
            visibility: TokenStream::new(),
            name: ident,
            shape: tree::Shape::Number,
            ty: crate::parse::primitive(Ident::new("f64", span)),
            default: None,
        });
        self.fields.len() - 1
    }

    /// Names that cannot be values, whoever declares them.
    fn not_a_value(&self, name: &Name) -> Option<Diagnostic> {
        let (place, text) = (name.place, name.text.as_str());
        if text.contains('·') {
            return Some(names::middle_dot(place, text, &text.replace('·', "*")));
        }
        if matches!(text, "sum" | "prod") {
            return Some(names::fold_as_value(place, text));
        }
        Function::find(text).map(|_| names::function_as_value(place, text))
    }

    /// The best help for a name that nobody declared.
    fn suggestion(&self, name: &Name) -> Diagnostic {
        let (place, text) = (name.place, name.text.as_str());
        if self.declared.contains(text) {
            return names::out_of_scope(place, text);
        }
        if let Some(constant) = nearest::constant(text) {
            return names::unknown_constant(place, text, constant);
        }
        match text {
            "e" | "E" => return names::unknown_e(place, text),
            "f" => return names::named_formula(place, text),
            _ => {}
        }
        if nearest::not_finite(text) {
            return names::not_finite(place, text);
        }
        let visible = self.visible();
        if let Some(product) = nearest::product(text, &visible) {
            return names::unknown_product(place, text, &product);
        }
        if let Some(power) = nearest::power(text, &visible) {
            return names::unknown_power(place, text, &power);
        }
        match nearest::nearest(text, visible.iter().map(String::as_str)) {
            Some(similar) => names::unknown_similar(place, text, similar),
            None => names::unknown(place, text),
        }
    }

    /// Is this the name of a table or of a row?
    pub(super) fn names_a_table(&self, name: &str) -> bool {
        match self.find(name) {
            Some(Found::Field(field)) => self
                .fields
                .get(field)
                .is_some_and(|f| f.shape != tree::Shape::Number),
            Some(Found::Declared(super::scope::Meaning::Row { shape, .. })) => {
                shape != tree::Shape::Number
            }
            _ => false,
        }
    }
}
