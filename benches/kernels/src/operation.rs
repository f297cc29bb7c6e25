//! The operations that are timed: one loop each, so that no choice is made inside.

use std::hint::black_box;

use zeroset::interval::{Interval, Packet, Parameter, Quadratic};

use crate::data::{Row, load};

/// Declares the operations and their loops, with names for the token and the three operands.
macro_rules! operations {
    ($p:ident $a:ident $b:ident $c:ident; $($variant:ident $name:literal $body:expr;)*) => {
        /// A timed operation.
        #[allow(missing_docs)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

        /// The operation on each packet of operands, `count` times over.
        #[inline(always)]
        pub fn for_each<P: Packet>(p: P, operation: Operation, count: u32, rows: &mut [Row]) {
            match operation {
                $(Operation::$variant => for _ in 0..count {
                    for row in black_box(&mut *rows) {
                        #[allow(unused_variables)]
                        let ($p, $a, $b, $c) =
                            (p, load(p, &row.a), load(p, &row.b), load(p, &row.c));
                        let y: Interval<P::F> = $body;
                        row.out = [p.to_array(y.lo), p.to_array(y.hi)];
                    }
                })*
            }
        }
    };
}

operations! {
    p a b c;
    Copy "copy" b;
    Add "add" p.add(a, b);
    Sub "sub" p.sub(a, b);
    Mul "mul" p.mul(a, b);
    MulPos "mul_pos" p.mul_pos(c, b);
    MulPosPos "mul_pos_pos" p.mul_pos_pos(c, c);
    Sqr "sqr" p.sqr(b);
    Powi6 "powi6" p.powi(b, 6);
    Div "div" p.div(a, b).0;
    Recip "recip" p.recip(b).0;
    Sqrt "sqrt" p.sqrt(c).0;
    Hypot "hypot" p.hypot(a, b);
    QuadraticLeaf "quadratic" {
        let low = p.splat(-8.0);
        let leaf = Quadratic { c0: b, c1: c, c2: b, low, high: p.splat(8.0), vertex: c };
        c.quadratic(p, &leaf)
    };
    Exp "exp" p.exp(b);
    Exp2 "exp2" p.exp2(b);
    ExpM1 "exp_m1" p.exp_m1(b);
    Ln "ln" p.ln(c).0;
    Ln1p "ln_1p" p.ln_1p(c).0;
    Log2 "log2" p.log2(c).0;
    Log10 "log10" p.log10(c).0;
    Sin "sin" p.sin(b);
    Cos "cos" p.cos(b);
    Tan "tan" p.tan(c).0;
    Asin "asin" p.asin(c).0;
    Acos "acos" p.acos(c).0;
    Atan "atan" p.atan(b);
    Atan2 "atan2" p.atan2(a, b).0;
    Sinh "sinh" p.sinh(b);
    Cosh "cosh" p.cosh(b);
    Tanh "tanh" p.tanh(b);
    Asinh "asinh" p.asinh(b);
    Acosh "acosh" p.acosh(p.recip(c).0).0;
    Atanh "atanh" p.atanh(c).0;
    Cbrt "cbrt" p.cbrt(b);
    Pow "pow" p.pow(c, b).0;
}
