//! Plain floating point on packets against the standard library.

use zeroset::interval::{Arithmetic, Isa, Kernel, Nearest, Packet};

/// exp, sin, cos, ln and the square root of eight numbers.
struct Values([f64; 8]);

impl Kernel for &Values {
    type Output = [[f64; 8]; 5];

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [[f64; 8]; 5] {
        let (a, x) = (Nearest(p), p.lanes(self.0));
        [a.exp(x), a.sin(x), a.cos(x), a.ln(x).0, a.sqrt(x).0].map(|y| p.to_array(y))
    }
}

#[test]
fn nearest_is_near_the_library_and_keeps_nan() {
    let inputs = [
        [0.0, 1.0, -1.0, 3.5, 1e6, -700.0, 709.0, 1e-300],
        [
            f64::NAN,
            f64::INFINITY,
            0.5,
            2.0,
            1e300,
            -5e-324,
            5e-324,
            100.0,
        ],
    ];
    for isa in Isa::available() {
        for x in inputs {
            let found = isa.run(&Values(x));
            let functions: [fn(f64) -> f64; 5] = [f64::exp, f64::sin, f64::cos, f64::ln, f64::sqrt];
            for (values, f) in found.iter().zip(functions) {
                for (value, x) in values.iter().zip(x) {
                    // Infinity has no sine; the packet functions give a number there.
                    if x.is_infinite() && f(x).is_nan() {
                        continue;
                    }
                    let near =
                        (value - f(x)).abs() <= 1e-15 * f(x).abs() + 1e-320 || *value == f(x);
                    assert!(
                        near || (value.is_nan() && f(x).is_nan()),
                        "{isa}: {value} for {} at {x}",
                        f(x)
                    );
                }
            }
        }
    }
}
