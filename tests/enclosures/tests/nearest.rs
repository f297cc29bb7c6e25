//! Plain floating point on packets against the standard library.

use zeroset::interval::{Arithmetic, Isa, Kernel, Nearest, Packet};

/// The functions by name, of eight numbers.
struct Values([f64; 8]);

/// Declares the functions: those of [`Nearest`], and the library's of the same name.
macro_rules! functions {
    (total: $($total:ident)*; partial: $($partial:ident)*) => {
        impl Kernel for &Values {
            type Output = Vec<[f64; 8]>;

            #[inline(always)]
            fn run<P: Packet>(self, p: P) -> Vec<[f64; 8]> {
                let (a, x) = (Nearest(p), p.lanes(self.0));
                let [sin, cos] = a.sin_cos(x).map(|x| p.to_array(x));
                vec![$(p.to_array(a.$total(x)),)* $(p.to_array(a.$partial(x).0),)* sin, cos]
            }
        }

        const LIBRARY: &[(&str, fn(f64) -> f64)] = &[
            $((stringify!($total), f64::$total),)* $((stringify!($partial), f64::$partial),)*
            ("sin_cos().0", f64::sin), ("sin_cos().1", f64::cos),
        ];
    };
}

functions! {
    total: exp exp2 exp_m1 sin cos atan cbrt sinh cosh tanh asinh;
    partial: sqrt ln ln_1p log2 log10 asin acos acosh atanh
}

/// Does it differ by a few units in the last place at most, or is it both times no number?
fn agrees(value: f64, expected: f64) -> bool {
    // A subnormal power may be 0.
    let near = (value - expected).abs() <= 1.5e-15 * expected.abs() + 4e-308;
    (near && expected.is_finite()) || value == expected || (value.is_nan() && expected.is_nan())
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
        [
            -0.3,
            0.99,
            1.01,
            -0.75,
            1e-9,
            -1e-20,
            700.0,
            f64::NEG_INFINITY,
        ],
    ];
    for isa in Isa::available() {
        for x in inputs {
            let found = isa.run(&Values(x));
            for (values, (name, f)) in found.iter().zip(LIBRARY) {
                for (value, x) in values.iter().zip(x) {
                    // Infinity has no sine; the packet functions give a number there. The library's arsinh overflows.
                    if x.is_infinite() && f(x).is_nan() || *name == "asinh" && x > 1e150 {
                        continue;
                    }
                    assert!(
                        agrees(*value, f(x)),
                        "{isa}: {value:e} for {name}({x:e}) = {:e}",
                        f(x)
                    );
                }
            }
        }
    }
}

/// xʸ for eight x and one y.
struct Powers([f64; 8], f64);

impl Kernel for &Powers {
    type Output = [f64; 8];

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> [f64; 8] {
        p.to_array(Nearest(p).pow(p.lanes(self.0), p.splat(self.1)).0)
    }
}

#[test]
fn powers_are_near_those_of_the_library() {
    let x = [0.0, 1.0, -1.0, 3.5, f64::INFINITY, f64::NAN, 0.9999, 1e-310];
    for isa in Isa::available() {
        for y in [
            0.5,
            -0.5,
            3.0,
            -1.5,
            700.0,
            -1e300,
            0.0,
            f64::INFINITY,
            f64::NAN,
        ] {
            for (value, x) in isa.run(&Powers(x, y)).iter().zip(x) {
                // A negative base has no real power here, and no number none at all.
                let expected = if x < 0.0 || x.is_nan() || y.is_nan() {
                    f64::NAN
                } else {
                    x.powf(y)
                };
                assert!(
                    agrees(*value, expected),
                    "{isa}: {value:e} for {x:e}^{y:e} = {expected:e}"
                );
            }
        }
    }
}

#[test]
fn negative_control_what_differs_does_not_agree() {
    assert!(!agrees(1.0, 1.0 + 1e-14));
    assert!(!agrees(f64::NAN, 1.0) && !agrees(1.0, f64::NAN));
    assert!(!agrees(f64::MAX, f64::INFINITY) && !agrees(0.0, 1e-300));
}
