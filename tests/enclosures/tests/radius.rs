//! Radii: upper bounds of a·b + c, and never subnormal where a factor is 0, which would be slow on many processors.

use zeroset::interval::{Isa, Kernel, Packet};
use zeroset_enclosures::exact::Exact;

/// Factors and terms, edges among them.
const NUMBERS: [f64; 11] = [
    0.0,
    5e-324,
    1e-310,
    2.2250738585072014e-308,
    1e-300,
    1e-160,
    0.1,
    1.0,
    1.0 + f64::EPSILON,
    3.3,
    1e150,
];

/// The bound for the same three numbers in all lanes.
struct Radius([f64; 3]);

impl Kernel for &Radius {
    type Output = f64;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> f64 {
        let [a, b, c] = self.0.map(|x| p.splat(x));
        p.to_array(p.radius(a, b, c))[0]
    }
}

/// For how many triples is the bound too low?
fn violations(isa: Isa) -> usize {
    let mut count = 0;
    for a in NUMBERS {
        for b in NUMBERS {
            for c in NUMBERS {
                let exact = Exact::from(a).mul(&Exact::from(b)).add(&Exact::from(c));
                let bound = isa.run(&Radius([a, b, c]));
                count += usize::from(!exact.is_in(f64::NEG_INFINITY, bound));
            }
        }
    }
    count
}

#[test]
fn radii_are_upper_bounds() {
    for isa in Isa::available() {
        assert_eq!(violations(isa), 0, "{isa}");
    }
    // The control.
    for isa in Isa::unrounded() {
        assert!(violations(isa) > 50, "{isa}: {}", violations(isa));
    }
}

#[test]
fn a_factor_of_zero_gives_no_subnormal() {
    for isa in Isa::available() {
        for b in [0.0, 1.0, f64::MAX, f64::INFINITY] {
            let bound = isa.run(&Radius([0.0, b, 0.0]));
            assert!(!bound.is_subnormal() && bound < 1e-270, "{isa}: {bound:e}");
        }
    }
}
