//! Laws of inclusion, by proptest, for every operation of formulas on every back-end.

use proptest::prelude::*;
use zeroset::interval::Interval;
use zeroset_enclosures::backend::{Backend, Outcome};
use zeroset_enclosures::promise::{operations, slack};

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -10.0..10.0f64,
        2 => -800.0..800.0f64,
        2 => prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        1 => (-4i32..5).prop_map(f64::from),
        1 => prop::sample::select(vec![f64::MAX, f64::MIN, f64::from_bits(1), -0.0, 1.0f64.next_down(), 1.0f64.next_up()]),
    ]
}

/// An interval and one inside it; now and then with an infinite bound.
fn nested() -> impl Strategy<Value = (Interval, Interval)> {
    (prop::array::uniform4(number()), 0..8).prop_map(|(mut x, infinite)| {
        x.sort_by(f64::total_cmp);
        let below = infinite == 0 || infinite == 2;
        let outer = Interval {
            lo: if below { f64::NEG_INFINITY } else { x[0] },
            hi: if infinite == 1 || infinite == 2 {
                f64::INFINITY
            } else {
                x[3]
            },
        };
        (outer, Interval { lo: x[1], hi: x[2] })
    })
}

/// The operand as the operation takes it: what is known to be ≥ 0 has no negative bound.
fn cut(name: &str, a: Interval, first: bool) -> Interval {
    if name == "mul_pos_pos" || (name == "mul_pos" && first) {
        Interval {
            lo: a.lo.max(0.0),
            hi: a.hi.max(0.0),
        }
    } else {
        a
    }
}

/// The doubles `steps` further out.
fn widened(a: Interval, steps: u64) -> Interval {
    let (mut lo, mut hi) = (a.lo, a.hi);
    for _ in 0..steps {
        (lo, hi) = (lo.next_down(), hi.next_up());
    }
    Interval { lo, hi }
}

/// |x| has no derivative at 0: over an interval that ends there it is that of the other points, at 0 alone it is 1.
fn has_no_value(name: &str, a: Interval) -> bool {
    name == "abs_slope" && a == Interval::ZERO
}

/// Does a flag over the part imply the flag over the whole, and is a whole that is nowhere defined so in the part?
fn flags_are_isotone(whole: Outcome, part: Outcome) -> bool {
    (!part.undefined || whole.undefined)
        && (!part.jump || whole.jump)
        && (!part.kink || whole.kink)
        && (!whole.empty || part.empty)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(if cfg!(miri) { 4 } else { 1000 }) })]

    /// a' ⊆ a and b' ⊆ b ⟹ a' ∘ b' ⊆ a ∘ b, to the last bit where the code is monotone.
    #[test]
    fn inclusion_is_isotone((a, inner_a) in nested(), (b, inner_b) in nested()) {
        for backend in Backend::rounded() {
            for (name, operation) in operations() {
                let whole = backend.one(operation, cut(&name, a, true), cut(&name, b, false));
                let part = backend.one(operation, cut(&name, inner_a, true), cut(&name, inner_b, false));
                let holds = widened(whole.range, slack(&name)).encloses(&part.range);
                prop_assert!(
                    part.empty || holds || has_no_value(&name, inner_a),
                    "{} {operation:?}: {inner_a:?} {inner_b:?} gives {:?}, of {a:?} {b:?} {:?}",
                    backend.name(), part.range, whole.range
                );
                prop_assert!(
                    flags_are_isotone(whole, part),
                    "{} {operation:?}: {inner_a:?} {inner_b:?} {part:?}, {a:?} {b:?} {whole:?}",
                    backend.name()
                );
            }
        }
    }

    /// x ∈ a and y ∈ b ⟹ x ∘ y ∈ a ∘ b, where the enclosures of the point by *other* back-ends stand for x ∘ y: they meet.
    #[test]
    fn points_are_contained((a, inner_a) in nested(), (b, inner_b) in nested()) {
        let point = |x| Interval { lo: x, hi: x };
        let all = Backend::rounded();
        for (name, operation) in operations() {
            let (a, b) = (cut(&name, a, true), cut(&name, b, false));
            let (x, y) = (cut(&name, point(inner_a.lo), true), cut(&name, point(inner_b.hi), false));
            let values: Vec<Outcome> = all.iter().map(|backend| backend.one(operation, x, y)).collect();
            for backend in &all {
                let whole = backend.one(operation, a, b);
                for value in values.iter().filter(|value| !value.undefined && !has_no_value(&name, x)) {
                    prop_assert!(
                        !whole.empty && whole.range.intersect(&value.range).is_some(),
                        "{} {operation:?}: {:?} at {x:?} {y:?}, {whole:?} over {a:?} {b:?}",
                        backend.name(), value.range
                    );
                }
            }
        }
    }

    /// All back-ends enclose the same set, so their ranges meet; their flags agree.
    #[test]
    fn back_ends_agree((a, _) in nested(), (b, _) in nested()) {
        let all = Backend::rounded();
        for (name, operation) in operations() {
            let (a, b) = (cut(&name, a, true), cut(&name, b, false));
            let first = all[0].one(operation, a, b);
            for backend in &all[1..] {
                let other = backend.one(operation, a, b);
                let flags = |o: Outcome| (o.empty, o.undefined, o.jump, o.kink);
                prop_assert_eq!(flags(first), flags(other), "{:?} of {:?} {:?}, {}", operation, a, b, backend.name());
                prop_assert!(
                    first.empty || first.range.intersect(&other.range).is_some(),
                    "{operation:?} of {a:?} {b:?}: {} {:?}, {} {:?}",
                    all[0].name(), first.range, backend.name(), other.range
                );
            }
        }
    }
}

/// The operations that the trait declares, from its source: nothing that a formula can use is left out.
#[test]
fn every_operation_of_the_trait_is_under_these_laws() {
    /// Those without a range of their own: constants, flags, choices, which `choices.rs` is about, and two operations at
    /// once, which `functions.rs` shows to be these two.
    const OTHERS: [&str; 14] = [
        "constant",
        "literal",
        "stored",
        "clear",
        "join",
        "join_derivative",
        "undefined_if",
        "less",
        "less_or_equal",
        "both",
        "either",
        "choose",
        "branch",
        "sin_cos",
    ];
    let declared = |source: &'static str, prefix: &'static str| {
        source
            .lines()
            .filter_map(move |line| line.trim().strip_prefix(prefix))
            .filter_map(|rest| rest.split('(').next())
    };
    let names: Vec<String> = operations().into_iter().map(|(name, _)| name).collect();
    let has = |name: &str| OTHERS.contains(&name) || names.iter().any(|n| n == name);
    let arithmetic = include_str!("../../../runtime/src/interval/arithmetic.rs");
    let enclose = include_str!("../../../runtime/src/interval/enclose.rs");
    let all: Vec<&str> = declared(arithmetic, "fn ")
        .chain(declared(enclose, "fn i_"))
        .collect();
    assert!(all.len() > 60, "{all:?}");
    for name in all {
        assert!(has(name), "`{name}` is under no law");
    }
    assert!(!has("no_such_operation"));
}

/// The laws can fail: with rounding off, parts reach beyond the whole, and points are missed.
#[test]
fn negative_control_laws_are_broken_without_rounding() {
    let mut broken = 0;
    let third = Interval {
        lo: 1.0 / 3.0,
        hi: 1.0 / 3.0,
    };
    for backend in Backend::unrounded() {
        for exact in Backend::rounded() {
            for (_, operation) in operations() {
                let (one, other) = (
                    backend.one(operation, third, third),
                    exact.one(operation, third, third),
                );
                broken += usize::from(!one.undefined && !one.range.encloses(&other.range));
            }
        }
    }
    println!("{broken} enclosures of a point do not hold those of back-ends that round");
    assert!(broken > 0);
}
