//! Laws of inclusion, by proptest.

use proptest::prelude::*;
use zeroset::interval::Interval;
use zeroset_enclosures::backend::Backend;
use zeroset_enclosures::operation::Operation;

/// Operations whose back-end code is monotone in its operands, so that isotonicity holds to the last bit.
const ISOTONE: [Operation; 12] = [
    Operation::Neg,
    Operation::Abs,
    Operation::Sqr,
    Operation::Sqrt,
    Operation::Add,
    Operation::Sub,
    Operation::Mul,
    Operation::Div,
    Operation::Min,
    Operation::Max,
    Operation::Powi(4),
    Operation::Powi(5),
];

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -10.0..10.0f64,
        2 => prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        1 => (-4i32..5).prop_map(f64::from),
    ]
}

fn interval() -> impl Strategy<Value = Interval> {
    (number(), number()).prop_map(|(x, y)| Interval {
        lo: x.min(y),
        hi: x.max(y),
    })
}

/// An interval and one inside it.
fn nested() -> impl Strategy<Value = (Interval, Interval)> {
    (interval(), number(), number()).prop_map(|(a, x, y)| {
        let (x, y) = (x.clamp(a.lo, a.hi), y.clamp(a.lo, a.hi));
        (
            a,
            Interval {
                lo: x.min(y),
                hi: x.max(y),
            },
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    /// a' ⊆ a and b' ⊆ b ⟹ a' ∘ b' ⊆ a ∘ b.
    #[test]
    fn inclusion_is_isotone((a, inner_a) in nested(), (b, inner_b) in nested()) {
        for backend in Backend::rounded() {
            for operation in ISOTONE {
                let outer = backend.one(operation, a, b);
                let inner = backend.one(operation, inner_a, inner_b);
                prop_assert!(
                    inner.empty || outer.range.encloses(&inner.range),
                    "{} {:?}: {:?} {:?} gives {:?}, of {:?} {:?} {:?}",
                    backend.name(), operation, inner_a, inner_b, inner.range, a, b, outer.range
                );
            }
        }
    }

    /// All back-ends enclose the same set, so their ranges meet and their flags agree.
    #[test]
    fn back_ends_agree(a in interval(), b in interval()) {
        let all = Backend::rounded();
        for operation in ISOTONE.into_iter().chain([Operation::Exp, Operation::Sin, Operation::Ln, Operation::Recip]) {
            let first = all[0].one(operation, a, b);
            for backend in &all[1..] {
                let other = backend.one(operation, a, b);
                prop_assert_eq!((first.empty, first.undefined), (other.empty, other.undefined));
                prop_assert!(
                    first.empty || first.range.intersect(&other.range).is_some(),
                    "{:?} of {:?} {:?}: {} {:?}, {} {:?}",
                    operation, a, b, all[0].name(), first.range, backend.name(), other.range
                );
            }
        }
    }

    /// x ∈ a ⟹ f(x) ∈ f(a), where the enclosure of the point stands for f(x): the two meet.
    #[test]
    fn functions_contain_their_points((a, inner) in nested()) {
        let point = Interval { lo: inner.lo, hi: inner.lo };
        for name in ["exp", "ln", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "cbrt", "asin", "acosh"] {
            let operation = Operation::named(name).unwrap();
            for backend in Backend::rounded() {
                let (whole, at) = (backend.one(operation, a, a), backend.one(operation, point, point));
                prop_assert!(
                    at.undefined || whole.range.intersect(&at.range).is_some(),
                    "{} {}: {:?} at {:?}, {:?} over {:?}", backend.name(), name, at.range, point, whole.range, a
                );
                // A function that is defined on all of a is defined at the point.
                prop_assert!(whole.undefined || !at.undefined);
            }
        }
    }
}
