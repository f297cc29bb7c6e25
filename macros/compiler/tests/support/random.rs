//! Random token streams, and what holds for each of them.

use super::print;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use zeroset_compiler::expand;
use zeroset_compiler::front::Front;

/// Words that random inputs are made of.
const WORDS: &[&str] = &[
    "x",
    "y",
    "z",
    "a",
    "t",
    "r",
    "pi",
    "tau",
    "e",
    "_",
    "sin",
    "max",
    "clamp",
    "sum",
    "min",
    "floor",
    "log",
    "let",
    "let a =",
    "if",
    "else",
    "in",
    "for",
    "mut",
    "struct",
    "pub",
    "struct S;",
    "struct S { r : f64 , t : [f64 ; 8] }",
    "#[domain(x in -1..1, y in -1..1, z in -1..1)]",
    "#[doc = \"text\"]",
    "as",
    "self",
    "match",
    "return",
    "f64",
    "0",
    "1",
    "2.5",
    "1e-3",
    "2x",
    "3f32",
    "0x10",
    "1e999",
    "\"text\"",
    "'c'",
    "+",
    "-",
    "*",
    "/",
    "^",
    "**",
    "%",
    "=",
    "==",
    "!=",
    "<",
    "<=",
    ">",
    ">=",
    "&&",
    "||",
    "|",
    "&",
    "!",
    ".",
    "..",
    "..=",
    "::",
    ":",
    ";",
    ";",
    ",",
    "?",
    "#",
    "$",
    "+=",
    "->",
    "=>",
    "i in 0..8",
    "[a, b] in t",
    "(i in 0..8)",
    "{ x }",
    "if x > 0 { y } else { z }",
    "x^2 + y^2",
    "[0]",
    ".sin()",
    "r#type",
    "α",
    "x·y",
];

/// Marsaglia's xorshift.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most as u64) as usize
    }

    pub fn word(&mut self) -> TokenStream {
        WORDS[self.below(WORDS.len())].parse().unwrap()
    }

    /// A stream of words, with groups in it.
    pub fn soup(&mut self, depth: usize) -> TokenStream {
        let mut stream = TokenStream::new();
        for _ in 0..self.below(12) {
            if depth > 0 && self.below(5) == 0 {
                let inner = self.soup(depth - 1);
                stream.extend([TokenTree::from(Group::new(self.delimiter(), inner))]);
            } else {
                stream.extend(self.word());
            }
        }
        stream
    }

    fn delimiter(&mut self) -> Delimiter {
        [
            Delimiter::Parenthesis,
            Delimiter::Brace,
            Delimiter::Bracket,
            Delimiter::None,
        ][self.below(4)]
    }

    /// The same tokens with a mistake in them, here or inside a group.
    pub fn mutated(&mut self, stream: TokenStream) -> TokenStream {
        let mut trees: Vec<TokenTree> = stream.into_iter().collect();
        if trees.is_empty() {
            return self.word();
        }
        let at = self.below(trees.len());
        if let TokenTree::Group(group) = &trees[at]
            && self.below(4) > 0
        {
            let mut inner = Group::new(group.delimiter(), self.mutated(group.stream()));
            inner.set_span(group.span());
            trees[at] = inner.into();
            return trees.into_iter().collect();
        }
        match self.below(5) {
            0 => {
                trees.remove(at);
            }
            1 => trees.insert(at, trees[at].clone()),
            2 => {
                let other = self.below(trees.len());
                trees.swap(at, other);
            }
            3 => {
                let word = self.word();
                trees.splice(at..=at, word);
            }
            _ => {
                let wrapped = trees.drain(at..).collect();
                trees.push(Group::new(self.delimiter(), wrapped).into());
            }
        }
        trees.into_iter().collect()
    }
}

/// What holds for every input.
pub fn lawful(front: &Front, input: &str) {
    let found = front.diagnostics.in_order();
    assert_eq!(front.formula.is_some(), found.is_empty(), "{input}");
    let mut last = 0;
    for diagnostic in &found {
        assert!(!diagnostic.message.is_empty(), "{input}");
        assert!(diagnostic.place.order >= last, "{input}");
        last = diagnostic.place.order;
    }
    let tokens = front.diagnostics.to_tokens().to_string();
    assert_eq!(
        tokens.matches("compile_error").count(),
        found.len(),
        "{input}"
    );
    if let Some(formula) = &front.formula {
        print::formula(formula);
        assert_eq!(formula.name.is_some(), front.head.is_some(), "{input}");
    }
}

/// The rest of the compiler takes what the front end lets through, and says nothing more about what it does not.
pub fn compiled(input: TokenStream, sound: bool) {
    let text = input.to_string();
    let root = "zeroset".parse::<TokenStream>().unwrap();
    let code = expand(root.into_iter().chain(input).collect()).to_string();
    assert_eq!(code.contains("compile_error"), !sound, "{text}");
    assert!(!code.is_empty(), "{text}");
}
