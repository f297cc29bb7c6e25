//! Items where a formula should be: functions, constants, imports, a second surface.

use super::cursor::Cursor;
use super::habits::variables;
use super::{Parser, error, keyword, name};
use crate::ast::{Let, Name};
use crate::catalogue::syntax;
use proc_macro2::{Delimiter, Group, Ident};

impl Parser<'_> {
    /// An item, as the `let` that it should be.
    pub(super) fn item(&mut self, cursor: &mut Cursor) -> Option<Let> {
        let word = cursor.word(0)?.to_string();
        cursor.word(1)?;
        match word.as_str() {
            "const" | "static" => Some(self.constant_item(cursor, &word)),
            "var" | "val" | "auto" | "double" | "float" | "def" | "Let" | "LET" | "local"
            | "real" | "number" | "f64" | "set"
                if cursor.operator(2) == "=" =>
            {
                Some(self.constant_item(cursor, &word))
            }
            "fn" => Some(self.function_item(cursor)),
            "use" => {
                self.report(syntax::import_inside(cursor.place()));
                cursor.skip_to(&[";"]);
                cursor.eat(";");
                Some(self.nothing(cursor, None))
            }
            _ => None,
        }
    }

    /// `use …;` before the struct.
    pub(super) fn imports(&mut self, cursor: &mut Cursor) {
        while cursor.at_word("use") && cursor.word(1).is_some() {
            self.item(cursor);
        }
    }

    /// `const A = 2;`, which is read as a `let`.
    fn constant_item(&mut self, cursor: &mut Cursor, word: &str) -> Let {
        let place = cursor.place();
        cursor.take();
        let name = self.item_name(cursor);
        let text = name.as_ref().map_or("a", |name| name.text.as_str());
        self.report(syntax::not_let(place, word, text));
        cursor.skip_to(&["=", ";"]);
        if cursor.eat("=").is_none() {
            cursor.eat(";");
            return self.nothing(cursor, name);
        }
        let value = self.expression(cursor);
        self.leftover(cursor, &[";"]);
        cursor.eat(";");
        Let {
            name,
            value,
            written: true,
        }
    }

    /// `fn f(t: f64) -> f64 { … }`
    fn function_item(&mut self, cursor: &mut Cursor) -> Let {
        self.report(syntax::function_inside(cursor.place()));
        cursor.take();
        let name = self.item_name(cursor);
        while !cursor.at_end() && cursor.operator(0) != ";" {
            let block = cursor.group(0, Delimiter::Brace).is_some();
            cursor.take();
            if block {
                break;
            }
        }
        cursor.eat(";");
        self.nothing(cursor, name)
    }

    /// `let f(t) = …;`. The name is taken.
    pub(super) fn let_function(&mut self, cursor: &mut Cursor, name: &Option<Name>) -> Option<Let> {
        let name = name.clone()?;
        cursor.group(0, Delimiter::Parenthesis)?;
        self.report(syntax::function_inside(name.place.to(cursor.place())));
        cursor.skip_to(&[";"]);
        cursor.eat(";");
        Some(self.nothing(cursor, Some(name)))
    }

    /// `let [a, b] = t;`: the names are known in what follows, and nothing is said about their values.
    pub(super) fn let_pattern(&mut self, cursor: &mut Cursor, group: &Group) -> Vec<Let> {
        cursor.take();
        let names = variables(cursor, group);
        let place = cursor.place();
        cursor.skip_to(&["=", ";"]);
        let table = cursor
            .word(1)
            .filter(|word| *word != "x" && *word != "y" && *word != "z");
        let lets = names.iter().take(2).enumerate();
        let lets = lets.map(|(k, name)| match table {
            Some(table) => format!("let {} = {table}[{k}];", name.text),
            None => format!("let {} = …;", name.text),
        });
        let example = lets.collect::<Vec<_>>().join(" ");
        self.report(syntax::let_pattern(place, &example));
        cursor.skip_to(&[";"]);
        cursor.eat(";");
        let all = names
            .into_iter()
            .map(|name| self.nothing(cursor, Some(name)));
        all.collect()
    }

    /// `let f = |t| t^2;`: the `=` is taken.
    pub(super) fn closure(&mut self, cursor: &mut Cursor, name: &Option<Name>) -> Option<Let> {
        let parameter = cursor.word(1).is_some() && matches!(cursor.operator(2), "|" | "," | ":");
        // `|a| - 1` is an absolute value: behind the second bar of a closure stands a value.
        let called = parameter && cursor.operator(0) == "|" && cursor.operator(3).is_empty();
        if !called || cursor.token(3).is_none() {
            return None;
        }
        let start = cursor.place();
        cursor.take();
        cursor.skip_to(&["|", ";"]);
        cursor.eat("|");
        self.report(syntax::closure(start.to(cursor.last())));
        cursor.skip_to(&[";"]);
        cursor.eat(";");
        Some(self.nothing(cursor, name.clone()))
    }

    /// Another `struct` in the same macro call. Nothing is said about what follows.
    pub(super) fn second_surface(&mut self, cursor: &mut Cursor) -> bool {
        let ahead = |n| cursor.word(n).map_or(String::new(), Ident::to_string);
        let found = ahead(0) == "struct" || (ahead(0) == "pub" && ahead(1) == "struct");
        if found {
            self.report(syntax::second_surface(cursor.place()));
            cursor.skip_to(&[]);
        }
        found
    }

    fn item_name(&mut self, cursor: &mut Cursor) -> Option<Name> {
        let place = cursor.place();
        let word = cursor.word(0).filter(|word| !keyword(&word.to_string()));
        let found = word.cloned().map(|word| name(word, place));
        if found.is_some() {
            cursor.take();
        }
        found
    }

    /// A `let` of whose value nothing is said.
    fn nothing(&self, cursor: &Cursor, name: Option<Name>) -> Let {
        Let {
            name,
            value: error(cursor.last(), Vec::new()),
            written: true,
        }
    }
}
