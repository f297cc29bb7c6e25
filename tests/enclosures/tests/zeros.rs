//! What is exactly 0 stays so: no bound of it becomes a subnormal number, which takes many processors a hundred cycles
//! for each operation. What merely rounds to 0 does not stay there.

use zeroset::interval::{Interval, Isa, Kernel, Packet};
use zeroset_enclosures::backend::Backend;
use zeroset_enclosures::operation::Operation;

const ZERO: Interval = Interval { lo: 0.0, hi: 0.0 };

fn operation(name: &str) -> Operation {
    Operation::named(name).expect("an operation of this name")
}

#[test]
fn a_factor_of_zero_gives_zero() {
    let others = [
        (1.0, 1.0),
        (0.1, 3.3),
        (5e-324, 1e300),
        (1.0, f64::INFINITY),
    ];
    for backend in Backend::rounded() {
        for (lo, hi) in others {
            let other = Interval { lo, hi };
            for name in ["mul", "mul_pos", "mul_pos_pos", "div"] {
                let range = backend.one(operation(name), ZERO, other).range;
                assert_eq!(range, ZERO, "{} {name} {other:?}", backend.name());
            }
            let range = backend.one(operation("mul"), other, ZERO).range;
            assert_eq!(range, ZERO, "{} {other:?}", backend.name());
        }
        for name in ["add", "sub", "sqr", "sqrt", "powi_2", "powi_3"] {
            let range = backend.one(operation(name), ZERO, ZERO).range;
            assert_eq!(range, ZERO, "{} {name}", backend.name());
        }
    }
}

/// Both bounds of a·b + c, twice: as tight as they can be, and as leaves need them.
struct ProductAndSum([f64; 3]);

impl Kernel for &ProductAndSum {
    type Output = [f64; 4];

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [f64; 4] {
        let [a, b, c] = self.0.map(|x| p.splat(x));
        let bounds = [
            p.fma_rd(a, b, c),
            p.fma_ru(a, b, c),
            p.mul_add_rd(a, b, c),
            p.mul_add_ru(a, b, c),
        ];
        bounds.map(|bound| p.to_array(bound)[0])
    }
}

#[test]
fn a_coefficient_of_zero_gives_zero() {
    for isa in Isa::available() {
        for [a, b] in [[0.0, 0.3], [0.3, 0.0], [0.0, 0.0], [-0.0, 1e300]] {
            let bounds = isa.run(&ProductAndSum([a, b, 0.0]));
            assert_eq!(bounds, [0.0; 4], "{isa}: {a:e}·{b:e}");
        }
    }
}

/// The control: products of numbers that are not 0 round to it, and both bounds must not be 0.
#[test]
fn what_rounds_to_zero_is_not_zero() {
    let tiny = Interval {
        lo: -1e-200,
        hi: 1e-200,
    };
    for backend in Backend::rounded() {
        let range = backend.one(operation("mul"), tiny, tiny).range;
        assert!(range.lo < 0.0 && range.hi > 0.0, "{}", backend.name());
    }
    for isa in Isa::available() {
        let [tight_lo, tight_hi, lo, hi] = isa.run(&ProductAndSum([1e-200, -1e-200, 0.0]));
        assert!(tight_lo < 0.0 && lo < 0.0, "{isa}");
        assert!(tight_hi >= 0.0 && hi >= 0.0, "{isa}");
    }
}
