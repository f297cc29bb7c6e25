//! The one table of functions.

/// A function of the language.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Function {
    Sqrt,
    Cbrt,
    Abs,
    Exp,
    Exp2,
    ExpM1,
    Ln,
    Ln1p,
    Log2,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Hypot,
    Recip,
    Min,
    Max,
    Clamp,
}

/// A row of the table.
#[derive(Debug)]
pub struct Entry {
    /// Which function.
    pub function: Function,
    /// Its name, that of std's `f64` method.
    pub name: &'static str,
    /// How many arguments it takes.
    pub arity: usize,
    /// Is it defined for all arguments?
    pub total: bool,
    /// Does it have all derivatives wherever it is defined?
    pub smooth: bool,
}

const fn entry(
    function: Function,
    name: &'static str,
    arity: usize,
    total: bool,
    smooth: bool,
) -> Entry {
    Entry {
        function,
        name,
        arity,
        total,
        smooth,
    }
}

/// All functions, in the order of [`Function`].
pub const TABLE: &[Entry] = &[
    entry(Function::Sqrt, "sqrt", 1, false, false),
    entry(Function::Cbrt, "cbrt", 1, true, false),
    entry(Function::Abs, "abs", 1, true, false),
    entry(Function::Exp, "exp", 1, true, true),
    entry(Function::Exp2, "exp2", 1, true, true),
    entry(Function::ExpM1, "exp_m1", 1, true, true),
    entry(Function::Ln, "ln", 1, false, true),
    entry(Function::Ln1p, "ln_1p", 1, false, true),
    entry(Function::Log2, "log2", 1, false, true),
    entry(Function::Log10, "log10", 1, false, true),
    entry(Function::Sin, "sin", 1, true, true),
    entry(Function::Cos, "cos", 1, true, true),
    entry(Function::Tan, "tan", 1, false, true),
    entry(Function::Asin, "asin", 1, false, false),
    entry(Function::Acos, "acos", 1, false, false),
    entry(Function::Atan, "atan", 1, true, true),
    entry(Function::Atan2, "atan2", 2, false, false),
    entry(Function::Sinh, "sinh", 1, true, true),
    entry(Function::Cosh, "cosh", 1, true, true),
    entry(Function::Tanh, "tanh", 1, true, true),
    entry(Function::Asinh, "asinh", 1, true, true),
    entry(Function::Acosh, "acosh", 1, false, false),
    entry(Function::Atanh, "atanh", 1, false, true),
    entry(Function::Hypot, "hypot", 2, true, false),
    entry(Function::Recip, "recip", 1, false, true),
    entry(Function::Min, "min", 2, true, false),
    entry(Function::Max, "max", 2, true, false),
    entry(Function::Clamp, "clamp", 3, true, false),
];

impl Function {
    /// The function's row.
    pub fn entry(self) -> &'static Entry {
        &TABLE[self as usize]
    }

    /// The function of this name.
    pub fn find(name: &str) -> Option<Function> {
        TABLE.iter().find(|e| e.name == name).map(|e| e.function)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_at_their_own_index() {
        for e in TABLE {
            assert_eq!(e.function.entry().name, e.name);
            assert_eq!(Function::find(e.name), Some(e.function));
        }
    }
}
