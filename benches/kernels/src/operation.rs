//! The operations that are timed: one loop each, so that no choice is made inside.

use zeroset::interval::{Interval, Packet, Parameter, Quadratic};

use crate::{Data, load};

/// Declares the operations and their loops.
macro_rules! operations {
    ($($variant:ident $name:literal |$p:ident, $a:ident, $b:ident| $body:expr;)*) => {
        /// A timed operation.
        #[derive(Clone, Copy)]
        pub enum Operation {
            $($variant,)*
        }

        /// All of them.
        pub const ALL: [Operation; [$($name),*].len()] = [$(Operation::$variant),*];

        impl Operation {
            /// Its name on the command line.
            pub fn name(self) -> &'static str {
                match self {
                    $(Operation::$variant => $name,)*
                }
            }
        }

        /// The operation on each packet of operands.
        #[inline(always)]
        pub fn for_each<P: Packet>(p: P, operation: Operation, packets: usize, data: &mut Data) {
            match operation {
                $(Operation::$variant => {
                    for i in 0..packets {
                        let ($p, $a, $b) = (p, load(p, &data.a, 8 * i), load(p, &data.b, 8 * i));
                        let y: Interval<P::F> = $body;
                        data.out[0][8 * i..8 * i + 8].copy_from_slice(&p.to_array(y.lo));
                        data.out[1][8 * i..8 * i + 8].copy_from_slice(&p.to_array(y.hi));
                    }
                })*
            }
        }
    };
}

operations! {
    Copy "copy" |_p, _a, b| b;
    Add "add" |p, a, b| p.add(a, b);
    Mul "mul" |p, a, b| p.mul(a, b);
    MulPos "mul_pos" |p, a, b| p.mul_pos(a, b);
    MulPosPos "mul_pos_pos" |p, a, _b| p.mul_pos_pos(a, a);
    Sqr "sqr" |p, _a, b| p.sqr(b);
    Powi6 "powi6" |p, _a, b| p.powi(b, 6);
    Div "div" |p, a, b| p.div(b, a).0;
    Recip "recip" |p, a, _b| p.recip(a).0;
    Sqrt "sqrt" |p, a, _b| p.sqrt(a).0;
    QuadraticLeaf "quadratic" |p, a, b| {
        let low = p.splat(-8.0);
        let leaf = Quadratic { c0: b, c1: a, c2: b, low, high: p.splat(8.0), bottom: a, top: b };
        a.quadratic(p, &leaf)
    };
    Exp "exp" |p, _a, b| p.exp(b);
    Ln "ln" |p, a, _b| p.ln(a).0;
    Sin "sin" |p, _a, b| p.sin(b);
    Cos "cos" |p, _a, b| p.cos(b);
    Tan "tan" |p, a, _b| p.tan(a).0;
    Asin "asin" |p, a, _b| p.asin(a).0;
    Acos "acos" |p, a, _b| p.acos(a).0;
    Atan "atan" |p, _a, b| p.atan(b);
    Atan2 "atan2" |p, a, b| p.atan2(a, b).0;
    Cbrt "cbrt" |p, _a, b| p.cbrt(b);
    Hypot "hypot" |p, a, b| p.hypot(a, b);
    Pow "pow" |p, a, b| p.pow(a, b).0;
    Tanh "tanh" |p, _a, b| p.tanh(b);
}
