//! The struct itself: fields, `Default`, setters, `check` and `domain`.

use super::block::block;
use super::enclosure::{Enclosure, Stage};
use super::layout::Layout;
use super::scalar;
use crate::form::Form;
use crate::front::{Head, HeadField};
use crate::graph::{Graph, Id, Scope};
use crate::lower::{Lowering, TooLarge};
use crate::stage::Staged;
use crate::tree::{Default, Field, Formula, Shape, Term};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use std::collections::HashMap;

/// The definition of the struct, with its name.
pub fn definition(
    attributes: &TokenStream,
    visibility: &TokenStream,
    name: &Ident,
    fields: &[FieldHead],
) -> TokenStream {
    if fields.is_empty() {
        return quote_spanned!(name.span()=> #attributes #visibility struct #name;);
    }
    let fields = fields.iter().map(|f| {
        let (attributes, visibility, name, ty) = (&f.attributes, &f.visibility, &f.name, &f.ty);
        quote!(#attributes #visibility #name: #ty)
    });
    // The item's own tokens stand where the user named it: rustc reports nothing in code that it takes for a macro's.
    quote_spanned!(name.span()=> #attributes #visibility struct #name { #(#fields),* })
}

/// What the struct needs of a field.
pub struct FieldHead {
    /// Attributes that pass through.
    pub attributes: TokenStream,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Its name.
    pub name: Ident,
    /// Its type as it stands in the struct.
    pub ty: TokenStream,
}

impl From<&Field> for FieldHead {
    fn from(f: &Field) -> Self {
        FieldHead {
            attributes: f.attributes.clone(),
            visibility: f.visibility.clone(),
            name: f.name.clone(),
            ty: f.ty.clone(),
        }
    }
}

impl From<&HeadField> for FieldHead {
    fn from(f: &HeadField) -> Self {
        FieldHead {
            attributes: f.attributes.clone(),
            visibility: f.visibility.clone(),
            name: f.name.clone(),
            ty: f.ty.clone(),
        }
    }
}

/// `Default` of a formula with mistakes, where the right one would have it.
pub fn placeholder_default(head: &Head) -> TokenStream {
    let derived = head.attributes.to_string().contains("Default");
    if derived || head.fields.iter().any(|f| !f.has_default) {
        return TokenStream::new();
    }
    let name = &head.name;
    quote! {
        impl __zeroset::Default for #name {
            fn default() -> Self {
                loop {}
            }
        }
    }
}

/// `&`, `|`, `-` and `!` make solids. Coherence allows no implementation for all surfaces, so each has its own; inlined,
/// they cost nothing where they are not used.
pub fn operators(name: &Ident) -> TokenStream {
    let binary = [
        ("BitAnd", "bitand", "and"),
        ("BitOr", "bitor", "or"),
        ("Sub", "sub", "without"),
    ];
    let binary = binary.map(|(operator, method, function)| {
        let [operator, method, function] =
            [operator, method, function].map(|n| format_ident!("{n}"));
        quote! {
            impl<R: __zeroset::Operand> __zeroset::#operator<R> for #name {
                type Output = __zeroset::Solid;
                #[inline]
                fn #method(self, other: R) -> __zeroset::Solid {
                    __zeroset::Solid::#function(self, other)
                }
            }
        }
    });
    quote! {
        #(#binary)*
        impl __zeroset::Not for #name {
            type Output = __zeroset::Solid;
            #[inline]
            fn not(self) -> __zeroset::Solid {
                __zeroset::Solid::complement(self)
            }
        }
    }
}

/// `with_…` for each field.
pub fn setters(name: &Ident, fields: &[FieldHead]) -> TokenStream {
    if fields.is_empty() {
        return TokenStream::new();
    }
    let methods = fields.iter().map(|f| {
        let (visibility, field, ty) = (&f.visibility, &f.name, &f.ty);
        let method = format_ident!("with_{}", plain_name(field), span = field.span());
        let doc = format!("The same surface with another `{}`.", plain_name(field));
        quote! {
            #[doc = #doc]
            #[must_use]
            #[allow(dead_code, clippy::needless_update, clippy::missing_const_for_fn)]
            #visibility fn #method(self, #field: #ty) -> Self {
                // No assignment: rustc would take it for a use of the field.
                Self { #field, ..self }
            }
        }
    });
    quote!(impl #name { #(#methods)* })
}

fn plain_name(name: &Ident) -> String {
    let text = name.to_string();
    text.strip_prefix("r#").map(str::to_owned).unwrap_or(text)
}

/// `Default`, where every field has a default and the user does not derive it.
pub fn default(formula: &Formula, name: &Ident) -> TokenStream {
    let derived = formula.attributes.to_string().contains("Default");
    if derived || formula.fields.iter().any(|f| f.default.is_none()) {
        return TokenStream::new();
    }
    let values = formula.fields.iter().filter_map(|f| {
        let (field, value) = (
            &f.name,
            default_value(formula, f.default.as_ref()?, &f.shape),
        );
        Some(quote!(#field: #value))
    });
    quote! {
        impl __zeroset::Default for #name {
            fn default() -> Self {
                Self { #(#values),* }
            }
        }
    }
}

fn default_value(formula: &Formula, default: &Default, shape: &Shape) -> TokenStream {
    match (default, shape) {
        (Default::Number(term), _) => scalar::constant(formula, term),
        (Default::Table(rows), Shape::Vec(inner)) => {
            let rows = rows.iter().map(|r| default_value(formula, r, inner));
            quote!(__zeroset::vec![#(#rows),*])
        }
        (Default::Table(rows), Shape::Array(inner, _)) => {
            let rows = rows.iter().map(|r| default_value(formula, r, inner));
            quote!([#(#rows),*])
        }
        // The front end refused it.
        (Default::Table(_), Shape::Number) => quote!(0.0),
    }
}

/// `check`: finite fields, and enough rows in tables of run-time length.
pub fn check(graph: &Graph, root: Id, surface: &str, fields: &[Field]) -> TokenStream {
    // Fields that the formula does not use are not read, so that rustc can report them.
    let used = fields
        .iter()
        .enumerate()
        .filter(|(k, _)| super::rows::uses(graph, root, *k));
    let tests = used.map(|(k, f)| {
        let (name, text) = (&f.name, plain_name(&f.name));
        let finite = finite(quote!(self.#name), &f.shape, surface, &text);
        let needed = super::rows::needed(graph, root, k);
        let rows = enough_rows(quote!(self.#name), &f.shape, &needed, surface, &text);
        quote!(#finite #rows)
    });
    quote! {
        fn check(&self) -> __zeroset::Result<(), __zeroset::ParameterError> {
            #(#tests)*
            __zeroset::Ok(())
        }
    }
}

/// Tests the length of each dimension that is a `Vec` against what the formula's indices need.
fn enough_rows(
    place: TokenStream,
    shape: &Shape,
    needed: &[usize],
    surface: &str,
    field: &str,
) -> TokenStream {
    let (Some((first, rest)), Shape::Array(inner, _) | Shape::Vec(inner)) =
        (needed.split_first(), shape)
    else {
        return TokenStream::new();
    };
    let below = enough_rows(quote!((*row)), inner, rest, surface, field);
    let below = if below.is_empty() {
        below
    } else {
        quote!(for row in #place.iter() { #below })
    };
    if *first == 0 || matches!(shape, Shape::Array(..)) {
        return below;
    }
    let first = Literal::usize_unsuffixed(*first);
    quote!(__zeroset::enough_rows(#surface, #field, #place.len(), #first)?; #below)
}

fn finite(place: TokenStream, shape: &Shape, surface: &str, field: &str) -> TokenStream {
    match shape {
        Shape::Number => quote!(__zeroset::finite(#surface, #field, #place)?;),
        Shape::Array(inner, _) | Shape::Vec(inner) => {
            let body = finite(quote!((*row)), inner, surface, field);
            quote!(for row in #place.iter() { #body })
        }
    }
}

/// `domain`: the box, rounded outward.
pub fn domain(formula: &Formula) -> Result<TokenStream, TooLarge> {
    let body = match &formula.domain {
        None => quote!(__zeroset::Option::None),
        Some(axes) => {
            let mut low = Vec::new();
            let mut high = Vec::new();
            for [from, to] in axes {
                low.push(bound(formula, from, &quote!(lo))?);
                high.push(bound(formula, to, &quote!(hi))?);
            }
            quote!(__zeroset::Option::Some([[#(#low),*], [#(#high),*]]))
        }
    };
    Ok(quote! {
        fn domain(&self) -> __zeroset::Option<[[__zeroset::primitive::f64; 3]; 2]> {
            #body
        }
    })
}

fn bound(formula: &Formula, term: &Term, side: &TokenStream) -> Result<TokenStream, TooLarge> {
    let mut lowering = Lowering::new(formula);
    let id: Id = lowering.term(term)?;
    let graph = &lowering.graph;
    let layout = Layout::new(graph, Form::Staged, &Staged::default(), &[]);
    let mut target = Enclosure {
        graph,
        layout: &layout,
        stage: Stage::Surface,
        fields: &[],
        flat: false,
    };
    let mut body = TokenStream::new();
    let value = block(
        graph,
        &mut target,
        Scope::default(),
        &[id],
        &mut HashMap::new(),
        &mut body,
    );
    let name = value.iter().map(|v| &v.name);
    // `let a` and the body that names it must have one hygiene: only the braces carry the bound's span.
    let code = quote!(let a = __zeroset::scalar(); #body #(#name)*.#side);
    Ok(quote_spanned!(term.source.start=> { #code }))
}
