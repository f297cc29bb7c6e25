//! The front end: from tokens to a formula without open questions, or to everything that is wrong with it.

use crate::diagnostic::Diagnostics;
use crate::parse::parse;
use crate::resolve::resolve;
use crate::tree::Formula;
use proc_macro2::{Ident, TokenStream};

/// What became of an input.
#[derive(Debug)]
pub struct Front {
    /// The struct, so far as it could be read; `None` in the expression form, or if not even its name is there. With it
    /// the type can be emitted beside the messages, so that its uses elsewhere are not reported as well.
    pub head: Option<Head>,
    /// Is the input the expression form? Then the messages stand where a value is expected.
    pub expression_form: bool,
    /// The formula, if there are no mistakes.
    pub formula: Option<Formula>,
    /// The mistakes.
    pub diagnostics: Diagnostics,
}

/// The outside of a surface.
#[derive(Debug)]
pub struct Head {
    /// Attributes that pass through.
    pub attributes: TokenStream,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Its name.
    pub name: Ident,
    /// Its fields, each name once.
    pub fields: Vec<HeadField>,
}

/// The outside of a field.
#[derive(Debug)]
pub struct HeadField {
    /// Attributes that pass through.
    pub attributes: TokenStream,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Its name.
    pub name: Ident,
    /// Its type in the struct.
    pub ty: TokenStream,
    /// Was a default given, right or wrong?
    pub has_default: bool,
}

/// Reads an input: the tokens inside `implicit! { … }`, without the path that the wrapper puts in front.
pub fn front(input: TokenStream) -> Front {
    let mut diagnostics = Diagnostics::default();
    let input = parse(input, &mut diagnostics);
    let head = input.head.as_ref().and_then(outside);
    let expression_form = input.expression_form;
    let formula = resolve(input, &mut diagnostics);
    Front {
        head,
        expression_form,
        formula: diagnostics.is_empty().then_some(formula),
        diagnostics,
    }
}

/// The outside of the struct.
fn outside(head: &crate::ast::Head) -> Option<Head> {
    let field = |field: &crate::ast::Field| HeadField {
        attributes: field.attributes.clone(),
        visibility: field.visibility.clone(),
        name: field.name.ident.clone(),
        ty: field.ty.tokens.clone(),
        has_default: field.default.is_some(),
    };
    Some(Head {
        attributes: head.attributes.clone(),
        visibility: head.visibility.clone(),
        name: head.name.clone()?,
        fields: head.fields.iter().map(field).collect(),
    })
}
