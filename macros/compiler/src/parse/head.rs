//! The struct of the struct form.

use super::attributes::visibility;
use super::cursor::Cursor;
use super::token::Token;
use super::{Parser, keyword, name};
use crate::ast::{Field, Head, Type};
use crate::catalogue::head;
use crate::diagnostic::{Place, line};
use crate::tree::Shape;
use proc_macro2::{Delimiter, Ident};

impl Parser<'_> {
    /// The struct, if the input begins with one.
    pub(super) fn head(&mut self, cursor: &mut Cursor) -> Option<Head> {
        let attributes = self.attributes(cursor);
        let visibility = visibility(cursor);
        let mut item = cursor.word(0).map_or(String::new(), Ident::to_string);
        let nameless = !keyword(&item) && (fields_follow(cursor) || surface_ahead(cursor, &item));
        if nameless {
            self.report(head::struct_missing(cursor.place(), &item));
            item = "struct".to_owned();
        } else if item != "struct" {
            // `pub x^2` lacks the whole head; `pub enum S` is a head with a wrong word.
            let wrong = matches!(
                item.as_str(),
                "enum" | "union" | "fn" | "trait" | "type" | "mod" | "const" | "static"
            ) && cursor.word(1).is_some();
            if !wrong && !attributes.any && visibility.is_empty() {
                return None;
            }
            self.report(head::not_a_struct(cursor.place()));
            if !wrong {
                return None;
            }
        }
        if !nameless {
            cursor.take();
        }
        cursor.open();
        let name = self.struct_name(cursor);
        let fields = if item == "struct" {
            self.generics(cursor);
            self.struct_fields(cursor)
        } else {
            skip_item(cursor);
            None
        };
        Some(Head {
            attributes: attributes.tokens,
            visibility,
            name,
            readable: fields.is_some(),
            fields: fields.unwrap_or_default(),
            domain: attributes.domain,
        })
    }

    fn struct_name(&mut self, cursor: &mut Cursor) -> Option<Ident> {
        let word = cursor
            .word(0)
            .filter(|word| !keyword(&word.to_string()))
            .cloned();
        match word {
            Some(_) => {
                cursor.take();
            }
            None => self.report(head::struct_name(cursor.last())),
        }
        word
    }

    fn generics(&mut self, cursor: &mut Cursor) {
        let place = cursor.place();
        if cursor.operator(0) == "<" {
            self.report(head::generics(place));
            while !cursor.at_end()
                && cursor.operator(0) != ";"
                && cursor.group(0, Delimiter::Brace).is_none()
            {
                cursor.take();
            }
        }
    }

    /// `;` or fields; `None` if there may be others than those that could be read.
    fn struct_fields(&mut self, cursor: &mut Cursor) -> Option<Vec<Field>> {
        cursor.open();
        if cursor.eat(";").is_some() {
            return Some(Vec::new());
        }
        if let Some(group) = cursor.group(0, Delimiter::Brace).cloned() {
            cursor.take();
            let mut inner = cursor.inside(&group);
            let fields = self.fields(&mut inner);
            if !inner.at_end() {
                // The formula stands between the braces: it is read from there.
                cursor.prepend(inner);
            }
            if cursor.operator(0) == ";" {
                self.report(head::semicolon(cursor.place()));
                cursor.take();
            }
            return fields;
        }
        if cursor.group(0, Delimiter::Parenthesis).is_some() {
            self.report(head::tuple_struct(cursor.place()));
            cursor.take();
            cursor.eat(";");
            return None;
        }
        self.report(head::struct_end(cursor.last()));
        if matches!(cursor.operator(0), ":" | "=" | "=>" | "->") {
            cursor.take();
        }
        None
    }

    fn fields(&mut self, cursor: &mut Cursor) -> Option<Vec<Field>> {
        let mut fields: Vec<Field> = Vec::new();
        let mut readable = true;
        while !cursor.at_end() {
            if formula_ahead(cursor) {
                self.report(head::formula_as_field(cursor.place()));
                return None;
            }
            let Some(field) = self.field(cursor) else {
                readable = false;
                cursor.skip_to(&[","]);
                cursor.eat(",");
                continue;
            };
            match fields.iter().find(|f| f.name.text == field.name.text) {
                Some(first) => {
                    let first = match line(first.name.place.start) {
                        Some(line) => format!("on line {line}"),
                        None => "above".to_owned(),
                    };
                    self.report(head::field_twice(
                        field.name.place,
                        &field.name.text,
                        &first,
                    ));
                }
                None => fields.push(field),
            }
        }
        readable.then_some(fields)
    }

    /// One field with the `,` after it.
    fn field(&mut self, cursor: &mut Cursor) -> Option<Field> {
        let attributes = self.attributes(cursor);
        if let Some(place) = attributes.domain_seen {
            self.report(head::domain_of_field(place));
        }
        let visibility = visibility(cursor);
        cursor.open();
        let place = cursor.place();
        let word = cursor
            .word(0)
            .filter(|word| !keyword(&word.to_string()))
            .cloned();
        let Some(word) = word else {
            let found = cursor.token(0).map_or("}".to_owned(), Token::text);
            self.report(head::field_name(place, &found));
            return None;
        };
        cursor.take();
        let name = name(word, place);
        self.field_hides(&name.text, place);
        let ty = if cursor.eat(":").is_some() {
            self.ty(cursor)
        } else {
            self.report(head::field_without_type(place, &name.text));
            Type {
                shape: Shape::Number,
                sound: false,
                tokens: quote::quote_spanned!(place.start=> f64),
            }
        };
        let default = cursor.eat("=").map(|_| self.expression(cursor));
        self.field_end(cursor);
        Some(Field {
            attributes: attributes.tokens,
            visibility,
            name,
            ty,
            default,
        })
    }

    /// The `,` after a field. Where it is missing, the next field may follow at once.
    fn field_end(&mut self, cursor: &mut Cursor) {
        if cursor.eat(",").is_some() {
            return;
        }
        let Some(text) = cursor.token(0).map(Token::text) else {
            return;
        };
        self.report(head::field_end(cursor.place(), &text));
        if cursor.eat(";").is_some() {
            return;
        }
        let field = cursor.operator(1) == ":" || cursor.at_word("pub") || cursor.operator(0) == "#";
        if !field {
            cursor.skip_to(&[","]);
            cursor.eat(",");
        }
    }

    fn field_hides(&mut self, name: &str, place: Place) {
        match name {
            "x" | "y" | "z" => self.report(head::field_hides_coordinate(place, name)),
            "pi" | "tau" => self.report(head::field_hides_constant(place, name)),
            _ => {}
        }
    }
}

/// Skips the rest of an item that is not a struct.
fn skip_item(cursor: &mut Cursor) {
    while !cursor.at_end() {
        let end = cursor.operator(0) == ";" || cursor.group(0, Delimiter::Brace).is_some();
        cursor.take();
        if end {
            break;
        }
    }
}

/// `S; x^2 = 1`: a name like a type's, and a formula behind its `;`.
fn surface_ahead(cursor: &Cursor, name: &str) -> bool {
    name.starts_with(|c: char| c.is_uppercase())
        && cursor.operator(1) == ";"
        && cursor.token(2).is_some()
}

/// Does `Name { field: …` stand here?
fn fields_follow(cursor: &Cursor) -> bool {
    let Some(group) = cursor.group(1, Delimiter::Brace) else {
        return false;
    };
    let inner = cursor.inside(group);
    cursor.word(0).is_some() && (inner.operator(1) == ":" || inner.at_word("pub"))
}

/// Does a formula stand where a field should be? It begins with a coordinate, and a field with a name and a colon.
fn formula_ahead(cursor: &Cursor) -> bool {
    let coordinate = ["x", "y", "z"].iter().any(|axis| cursor.at_word(axis));
    coordinate && !matches!(cursor.operator(1), ":" | "=" | ",")
}
