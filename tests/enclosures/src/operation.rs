//! Operations by name.

use zeroset::interval::{Flags, Interval, Packet};

/// Declares the enumeration, the names and the dispatch in one place.
macro_rules! operations {
    (
        total { $($total:ident = $t:ident;)* }
        partial { $($partial:ident = $p:ident;)* }
        binary { $($binary:ident = $b:ident;)* }
        partial_binary { $($partial_binary:ident = $pb:ident;)* }
    ) => {
        /// An operation of one or two intervals.
        #[allow(missing_docs)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Operation {
            $($total,)* $($partial,)* $($binary,)* $($partial_binary,)*
            /// A whole power.
            Powi(u32),
            /// A whole power that may be negative, as the compiler writes it.
            Pown(i32),
            /// The hull of two intervals.
            Hull,
            /// What two intervals have in common; empty where that is nothing.
            Intersect,
        }

        impl Operation {
            /// The operation of this name, that of the method; `powi_3` is the third power, `powi_-3` its reciprocal.
            pub fn named(name: &str) -> Option<Operation> {
                if let Some(n) = name.strip_prefix("powi_") {
                    let n: i32 = n.parse().ok()?;
                    return Some(u32::try_from(n).map_or(Operation::Pown(n), Operation::Powi));
                }
                Self::ALL.iter().find(|entry| entry.0 == name).map(|entry| entry.1)
            }

            /// All that take one or two intervals and have a method of [`Arithmetic`](zeroset::interval::Arithmetic).
            pub const ALL: &[(&str, Operation)] = &[
                $((stringify!($t), Operation::$total),)*
                $((stringify!($p), Operation::$partial),)*
                $((stringify!($b), Operation::$binary),)*
                $((stringify!($pb), Operation::$partial_binary),)*
            ];
        }

        /// The operation on packets, with its flags.
        #[inline(always)]
        pub fn apply<P: Packet>(
            p: P,
            operation: Operation,
            a: Interval<P::F>,
            b: Interval<P::F>,
        ) -> (Interval<P::F>, Flags<P>) {
            match operation {
                $(Operation::$total => (p.$t(a), p.clear()),)*
                $(Operation::$partial => p.$p(a),)*
                $(Operation::$binary => (p.$b(a, b), p.clear()),)*
                $(Operation::$partial_binary => p.$pb(a, b),)*
                Operation::Powi(n) => (p.powi(a, n), p.clear()),
                Operation::Pown(n) => {
                    let power = p.powi(a, n.unsigned_abs());
                    if n < 0 {
                        // The power is 0 just where a is, unless it underflows.
                        let (range, _) = p.recip(power);
                        (range, p.recip(a).1)
                    } else {
                        (power, p.clear())
                    }
                }
                Operation::Hull => (p.hull(a, b), p.clear()),
                Operation::Intersect => {
                    let (range, empty) = p.intersect(a, b);
                    (range, Flags { empty, ..p.clear() })
                }
            }
        }
    };
}

operations! {
    total {
        Neg = neg; Nonneg = nonneg; Sqr = sqr; Abs = abs; Cbrt = cbrt; Exp = exp; Exp2 = exp2; ExpM1 = exp_m1; Sin = sin; Cos = cos;
        Atan = atan; Sinh = sinh; Cosh = cosh; Tanh = tanh; Asinh = asinh;
    }
    partial {
        Recip = recip; Sqrt = sqrt; Ln = ln; Ln1p = ln_1p; Log2 = log2; Log10 = log10; Tan = tan; Asin = asin;
        Acos = acos; Acosh = acosh; Atanh = atanh; AbsSlope = abs_slope;
    }
    binary {
        Add = add; Sub = sub; Mul = mul; MulPos = mul_pos; MulPosPos = mul_pos_pos; Min = min; Max = max; Hypot = hypot;
    }
    partial_binary {
        Div = div; Pow = pow; Atan2 = atan2;
    }
}
