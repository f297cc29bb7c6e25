//! Whatever is thrown at it, the front end returns: a formula or mistakes, never a panic, never a hang.
//!
//! Two kinds of input: tokens of the language in random order, and formulas of the fixtures with tokens removed,
//! doubled, swapped and replaced. The sequence is seeded, so that a failure can be repeated.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::panic)]

mod support;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use zeroset_compiler::expand;
use zeroset_compiler::front::{Front, front};

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
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most as u64) as usize
    }

    fn word(&mut self) -> TokenStream {
        WORDS[self.below(WORDS.len())].parse().unwrap()
    }

    /// A stream of words, with groups in it.
    fn soup(&mut self, depth: usize) -> TokenStream {
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
    fn mutated(&mut self, stream: TokenStream) -> TokenStream {
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
fn lawful(front: &Front, input: &str) {
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
        support::print::formula(formula);
        assert_eq!(formula.name.is_some(), front.head.is_some(), "{input}");
    }
}

/// The rest of the compiler takes what the front end lets through, and says nothing more about what it does not.
fn compiled(input: TokenStream, sound: bool) {
    let text = input.to_string();
    let root = "zeroset".parse::<TokenStream>().unwrap();
    let code = expand(root.into_iter().chain(input).collect()).to_string();
    assert_eq!(code.contains("compile_error"), !sound, "{text}");
    assert!(!code.is_empty(), "{text}");
}

/// The control: a formula beside a mistake breaks the laws.
#[test]
#[should_panic(expected = "broken")]
fn lawlessness_is_noticed() {
    let mut broken = front("struct S; x +".parse().unwrap());
    broken.formula = front("struct S; x".parse().unwrap()).formula;
    lawful(&broken, "broken");
}

#[test]
fn random_tokens() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let mut sound = 0;
    for _ in 0..20_000 {
        let input = random.soup(3);
        let text = input.to_string();
        let front = front(input);
        lawful(&front, &text);
        sound += usize::from(front.formula.is_some());
    }
    // The soup must hold a formula now and then, or it tests nothing but the first mistake.
    assert!(sound > 20, "{sound}");
}

#[test]
fn mutated_formulas() {
    on_rustc_stack(mutate);
}

fn mutate() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut sound, mut total) = (0, 0);
    for file in [
        "formulas/examples.md",
        "formulas/grammar.md",
        "errors/syntax.md",
        "errors/shapes.md",
    ] {
        for case in support::cases(file) {
            // The cases of too many brackets are slow to copy and say nothing new.
            if case.source.len() > 1000 {
                continue;
            }
            for _ in 0..60 {
                let mut input: TokenStream = case.source.parse().unwrap();
                for _ in 0..=random.below(3) {
                    input = random.mutated(input);
                }
                let text = input.to_string();
                let front = front(input.clone());
                lawful(&front, &text);
                sound += usize::from(front.formula.is_some());
                total += 1;
                if total % 4 == 0 {
                    compiled(input, front.formula.is_some());
                }
            }
        }
    }
    assert!(
        sound > total / 100 && sound < total / 2,
        "{sound} of {total}"
    );
}

/// Runs a test with the stack that rustc gives to macros: 8 MB. An unoptimised build needs half of it.
fn on_rustc_stack(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(8 << 20).spawn(test);
    thread.unwrap().join().unwrap();
}

#[test]
fn depth_is_bounded_for_every_way_to_nest() {
    on_rustc_stack(nest_everything);
}

fn nest_everything() {
    let deep = |open: &str, close: &str| {
        format!(
            "struct S {{ t: [f64; 2] }} {}x{}",
            open.repeat(3000),
            close.repeat(3000)
        )
    };
    for (open, close) in [
        ("(", ")"),
        ("{", "}"),
        ("[", "]"),
        ("-", ""),
        ("!", ""),
        ("|", ""),
        ("2^", ""),
        ("sin(", ")"),
        ("1 + (", ")"),
        ("x < ", ""),
        ("x = ", ""),
        ("x && ", ""),
        ("x - ", ""),
        ("x / ", ""),
        ("x ", ""),
        ("x % ", ""),
        ("", ".abs()"),
        ("", "[0]"),
        ("sum(i in 0..2) {", "}"),
        ("if x > 0 { 1 } else ", ""),
        ("if ", ""),
        ("let a = ", ""),
        ("let a = {", ";}"),
        ("x ? ", ""),
        ("t[", "]"),
        ("a::", ""),
        ("* ", ""),
        ("for i in ", ""),
        ("f64 as ", ""),
        ("", " as f64"),
        ("", "^2"),
        ("", " = y"),
        ("a += ", ""),
        ("sum(", " in t) {}"),
    ] {
        let source = deep(open, close);
        let Ok(stream) = source.parse::<TokenStream>() else {
            continue;
        };
        let front = front(stream);
        lawful(&front, open);
    }
    let mut group = TokenTree::from(Group::new(Delimiter::None, "x + y".parse().unwrap()));
    for _ in 0..3000 {
        group = Group::new(Delimiter::None, group.into()).into();
    }
    lawful(&front(group.into()), "invisible groups");
}

#[test]
fn types_may_be_nested_too() {
    on_rustc_stack(nest_types);
}

fn nest_types() {
    let source = format!(
        "struct S {{ t: {}f64{} }} x",
        "[".repeat(3000),
        "; 2]".repeat(3000)
    );
    lawful(&front(source.parse().unwrap()), "types");
    let source = format!(
        "struct S {{ r: f64 = {}1{} }} x",
        "[".repeat(3000),
        "]".repeat(3000)
    );
    lawful(&front(source.parse().unwrap()), "defaults");
}

#[test]
fn huge_numbers_cost_nothing() {
    for source in [
        "x + 9^9^9^9",
        "x + 2^1000000",
        "x + (1e300)^1e6",
        "x + 1e-300^400*3^9999/7^9999",
        "x + 1^1e9",
    ] {
        let source = format!("struct S; {source}");
        lawful(&front(source.parse().unwrap()), &source);
    }
    let squares = "let a = 3; ".to_owned() + &"let a = a*a; ".repeat(200);
    lawful(
        &front(format!("struct S; {squares} x + a").parse().unwrap()),
        "squares",
    );
}

#[test]
fn long_formulas_compile() {
    on_rustc_stack(|| {
        let powers: String = (1..400).map(|i| format!(" + {i}*x^{i}")).collect();
        for source in [
            format!("struct S; y{powers}"),
            format!("struct S; let a = x; {} a", "let a = a*a + y; ".repeat(300)),
            format!("struct S; let a = x; {} a", "let a = a + y; ".repeat(1000)),
            format!("struct S; {}x{}", "sin(".repeat(250), ")".repeat(250)),
            format!(
                "struct S; let a = x; {} a",
                format!("let a = {}a{};", "sin(".repeat(200), ")".repeat(200)).repeat(10)
            ),
            format!("struct S; {}x{}", "(1 + ".repeat(120), ")^2".repeat(120)),
            format!("struct S; {} {{ x }}", "if x > 0 { y } else ".repeat(80)),
        ] {
            compiled(source.parse().unwrap(), true);
        }
    });
}
