//! Comparisons and choices: what is certain is true, and what is chosen is enclosed.

use proptest::prelude::*;
use zeroset::interval::{Flags, Interval, Isa, Kernel, Packet, Undecided};
use zeroset_enclosures::backend::load;

/// Certainly true and certainly false.
type Answer = (bool, bool);

/// a < b, c ≤ d, both, either; the choice between c and d by a < b, and its flags, c being undefined.
struct Choices([Interval; 4]);

struct Found {
    answers: [Answer; 4],
    choice: Interval,
    undefined: bool,
    jump: bool,
}

impl Kernel for &Choices {
    type Output = Found;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Found {
        let [a, b, c, d] = self.0.map(|x| load(p, [x; 8]));
        let (less, at_most) = (p.less(a, b), p.less_or_equal(c, d));
        let answers = [
            less,
            at_most,
            p.both(less, at_most),
            p.either(less, at_most),
        ]
        .map(|t| (p.any(t.yes), p.any(t.no)));
        let choice = p.choose(less, c, d);
        let partial = Flags {
            undefined: p.all(),
            ..p.clear()
        };
        let flags = p.branch(less, partial, p.clear(), Undecided::Jump);
        Found {
            answers,
            choice: Interval {
                lo: p.to_array(choice.lo)[0],
                hi: p.to_array(choice.hi)[0],
            },
            undefined: p.any(flags.undefined),
            jump: p.any(flags.jump),
        }
    }
}

/// An interval of small whole numbers, so that bounds are often equal, and a member.
fn operand() -> impl Strategy<Value = (Interval, f64)> {
    (-3i32..4, 0i32..4, 0i32..4).prop_map(|(lo, width, place)| {
        let x = lo + place.min(width);
        let (lo, hi) = (f64::from(lo), f64::from(lo + width));
        (Interval { lo, hi }, f64::from(x))
    })
}

/// What is certain must be so.
fn agrees(answer: Answer, truth: bool) -> bool {
    match answer {
        (true, true) => false,
        (yes, no) => yes && truth || no && !truth || !yes && !no,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(if cfg!(miri) { 8 } else { 2000 }) })]

    #[test]
    fn certain_answers_are_true_and_choices_enclose(operands in prop::array::uniform4(operand())) {
        let [a, b, c, d] = operands.map(|o| o.0);
        let [w, x, y, z] = operands.map(|o| o.1);
        for isa in Isa::available() {
            let found = isa.run(&Choices([a, b, c, d]));
            let truths = [w < x, y <= z, w < x && y <= z, w < x || y <= z];
            for (answer, truth) in found.answers.into_iter().zip(truths) {
                prop_assert!(agrees(answer, truth), "{isa}: {a:?} {b:?} {c:?} {d:?}: {answer:?} {truth}");
            }
            let value = if w < x { y } else { z };
            prop_assert!(found.choice.contains(value), "{isa}: {a:?} {b:?} {c:?} {d:?}: {:?}", found.choice);
            // The branch with a hole counts unless the other one is certain.
            let (yes, no) = found.answers[0];
            prop_assert_eq!(found.undefined, !no);
            prop_assert_eq!(found.jump, !yes && !no);
        }
    }

    /// Intervals that do not overlap are decided.
    #[test]
    fn what_can_be_decided_is(a in -9i32..10, b in -9i32..10) {
        let point = |x: i32| Interval { lo: f64::from(x), hi: f64::from(x) };
        for isa in Isa::available() {
            let answers = isa.run(&Choices([point(a), point(b), point(a), point(b)])).answers;
            prop_assert_eq!(answers[0], (a < b, a >= b));
            prop_assert_eq!(answers[1], (a <= b, a > b));
        }
    }
}

#[test]
fn negative_control_a_wrong_answer_is_noticed() {
    assert!(!agrees((true, false), false) && !agrees((false, true), true));
    assert!(!agrees((true, true), true) && agrees((false, false), true));
}
