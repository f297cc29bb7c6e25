//! Whatever is thrown at it, the front end returns: a formula or mistakes, never a panic, never a hang.
//!
//! Two kinds of input: tokens of the language in random order, and formulas of the fixtures with tokens removed,
//! doubled, swapped and replaced. The sequence is seeded, so that a failure can be repeated. `scripts/soup` tries a
//! million of each.

// Tests may stop at a failure; the compiler may not.
#![allow(clippy::unwrap_used, clippy::panic)]

mod support;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use support::random::{Random, compiled, lawful};
use zeroset_compiler::front::front;

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
    soups(20_000, 0x2545_f491_4f6c_dd1d);
}

/// Random tokens; now and then they are a formula.
fn soups(count: usize, seed: u64) {
    let mut random = Random(seed);
    let mut sound = 0;
    for _ in 0..count {
        let input = random.soup(3);
        let text = input.to_string();
        let front = front(input);
        lawful(&front, &text);
        sound += usize::from(front.formula.is_some());
    }
    // The soup must hold a formula now and then, or it tests nothing but the first mistake.
    assert!(sound > count / 1000, "{sound} of {count}");
    println!("{count} random inputs, {sound} of them formulas");
}

#[test]
fn mutated_formulas() {
    on_rustc_stack(|| mutants(60, 0x9e37_79b9_7f4a_7c15));
}

/// Mutants of the formulas of the fixtures. One in four goes through the whole compiler.
fn mutants(each: usize, seed: u64) {
    let mut random = Random(seed);
    let (mut sound, mut total) = (0, 0);
    for case in originals() {
        for _ in 0..each {
            let mut input: TokenStream = case.parse().unwrap();
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
    assert!(
        sound > total / 100 && sound < total / 2,
        "{sound} of {total}"
    );
    println!("{total} mutated inputs, {sound} of them formulas");
}

/// The sources of the fixtures. Those with too many brackets are slow to copy and say nothing new.
fn originals() -> Vec<String> {
    let files = [
        "formulas/examples.md",
        "formulas/grammar.md",
        "errors/syntax.md",
        "errors/shapes.md",
        "errors/tokens.md",
        "errors/head.md",
    ];
    let cases = files.into_iter().flat_map(support::cases);
    let sources = cases.map(|case| case.source);
    sources.filter(|source| source.len() <= 1000).collect()
}

/// A million of each kind. The seed is the day's, and printed.
#[test]
#[ignore = "minutes: scripts/soup runs it, optimised"]
fn a_million_token_streams() {
    let seed = match std::env::var("ZEROSET_SEED") {
        Ok(seed) => seed.parse().expect("ZEROSET_SEED is a whole number"),
        Err(_) => std::time::SystemTime::now()
            .duration_since(std::time::UNIX_EPOCH)
            .map_or(1, |now| now.as_secs() / 86_400),
    };
    println!("ZEROSET_SEED={seed}");
    // A xorshift needs bits to begin with.
    let start = (seed + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    soups(1_000_000, start);
    on_rustc_stack(move || mutants(1_000_000usize.div_ceil(originals().len()), start));
}

/// Runs a test with the stack that rustc gives to macros: 8 MB. An unoptimised build needs half of it.
fn on_rustc_stack(test: impl FnOnce() + Send + 'static) {
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
