//! Random formulas, as trees that print in two languages.

use std::fmt::Write;

/// Marsaglia's xorshift.
pub struct Random(pub u64);

impl Random {
    /// A whole number below `most`.
    pub fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most as u64) as usize
    }

    /// A multiple of 1/64 in [−range, range].
    pub fn dyadic(&mut self, range: i32) -> f64 {
        let steps = (128 * range + 1) as usize;
        (self.below(steps) as f64 - f64::from(64 * range)) / 64.0
    }
}

/// A formula.
#[derive(Clone, Debug)]
pub enum Formula {
    /// A literal: quarters.
    Quarters(i32),
    /// π
    Pi,
    /// x, y, z
    Coordinate(usize),
    /// −a
    Negate(Box<Formula>),
    /// a + b, a − b, a·b, a/b by their signs
    Binary(char, Box<Formula>, Box<Formula>),
    /// aⁿ, for any whole n or half of one
    Power(Box<Formula>, i32),
    /// f(a), f(a, b), f(a, b, c)
    Call(&'static str, Vec<Formula>),
    /// if a < b { c } else { d }
    If(Box<[Formula; 4]>),
}

/// The language's functions, with their number of arguments.
pub const FUNCTIONS: [(&str, usize); 29] = [
    ("sqrt", 1),
    ("abs", 1),
    ("exp", 1),
    ("ln", 1),
    ("sin", 1),
    ("cos", 1),
    ("tan", 1),
    ("asin", 1),
    ("acos", 1),
    ("atan", 1),
    ("sinh", 1),
    ("cosh", 1),
    ("tanh", 1),
    ("asinh", 1),
    ("acosh", 1),
    ("atanh", 1),
    ("cbrt", 1),
    ("exp2", 1),
    ("exp_m1", 1),
    ("ln_1p", 1),
    ("log2", 1),
    ("log10", 1),
    ("recip", 1),
    ("min", 2),
    ("max", 2),
    ("hypot", 2),
    ("atan2", 2),
    ("clamp", 3),
    ("pow", 2),
];

impl Formula {
    /// A formula of this depth at most; `rational` leaves out what has no rational value.
    pub fn random(random: &mut Random, depth: u32, rational: bool) -> Formula {
        let inner = |random: &mut Random| Box::new(Formula::random(random, depth - 1, rational));
        if depth == 0 || random.below(8) == 0 {
            return match random.below(10) {
                0..=2 => Formula::Quarters(random.below(17) as i32 - 8),
                3 if !rational => Formula::Pi,
                _ => Formula::Coordinate(random.below(3)),
            };
        }
        match random.below(16) {
            0 | 1 => Formula::Negate(inner(random)),
            2..=8 => {
                let sign = ['+', '+', '-', '-', '*', '*', '/'][random.below(7)];
                Formula::Binary(sign, inner(random), inner(random))
            }
            9 | 10 => Formula::Power(inner(random), 2 * (random.below(6) as i32 - 1)),
            11 if !rational => Formula::Power(inner(random), random.below(9) as i32 - 3),
            12 => Formula::If(Box::new(std::array::from_fn(|_| *inner(random)))),
            _ => {
                let (name, count) = loop {
                    let (name, count) = FUNCTIONS[random.below(FUNCTIONS.len())];
                    if !rational || ["abs", "min", "max", "clamp", "recip"].contains(&name) {
                        break (name, count);
                    }
                };
                let mut arguments: Vec<Formula> = (0..count).map(|_| *inner(random)).collect();
                if name == "clamp" {
                    // Bounds in order: the language refuses others where it can see them.
                    arguments[1] = Formula::Quarters(-3);
                    arguments[2] = Formula::Quarters(2);
                }
                Formula::Call(name, arguments)
            }
        }
    }

    /// In the macro's language.
    pub fn source(&self) -> String {
        match self {
            Formula::Quarters(n) if *n < 0 => format!("(-{})", f64::from(-n) / 4.0),
            Formula::Quarters(n) => format!("{}", f64::from(*n) / 4.0),
            Formula::Pi => "pi".into(),
            Formula::Coordinate(k) => ["x", "y", "z"][*k].into(),
            Formula::Negate(a) => format!("(-{})", a.source()),
            Formula::Binary(sign, a, b) => format!("({} {sign} {})", a.source(), b.source()),
            Formula::Power(a, halves) => format!("({})^({halves}/2)", a.source()),
            Formula::Call("pow", of) => format!("({})^({})", of[0].source(), of[1].source()),
            Formula::Call(name, of) => {
                let of: Vec<String> = of.iter().map(Formula::source).collect();
                format!("{name}({})", of.join(", "))
            }
            Formula::If(of) => {
                let [a, b, c, d] = of.each_ref().map(Formula::source);
                format!("(if {a} < {b} {{ {c} }} else {{ {d} }})")
            }
        }
    }

    /// The names of the functions in it.
    pub fn functions(&self, found: &mut Vec<&'static str>) {
        match self {
            Formula::Negate(a) | Formula::Power(a, _) => a.functions(found),
            Formula::Binary(_, a, b) => {
                a.functions(found);
                b.functions(found);
            }
            Formula::Call(name, of) => {
                found.push(name);
                of.iter().for_each(|a| a.functions(found));
            }
            Formula::If(of) => of.iter().for_each(|a| a.functions(found)),
            _ => {}
        }
    }

    /// In prefix form, for a reader in any language.
    pub fn prefix(&self) -> String {
        let mut text = String::new();
        self.write_prefix(&mut text);
        text
    }

    fn write_prefix(&self, out: &mut String) {
        // Writing to a string does not fail.
        let _ = match self {
            Formula::Quarters(n) => write!(out, " {n}/4"),
            Formula::Pi => write!(out, " pi"),
            Formula::Coordinate(k) => write!(out, " {}", ["x", "y", "z"][*k]),
            Formula::Negate(a) => {
                out.push_str(" neg");
                a.write_prefix(out);
                Ok(())
            }
            Formula::Binary(sign, a, b) => {
                out.push(' ');
                out.push(*sign);
                a.write_prefix(out);
                b.write_prefix(out);
                Ok(())
            }
            Formula::Power(a, halves) => {
                let written = write!(out, " halves {halves}");
                a.write_prefix(out);
                written
            }
            Formula::Call(name, of) => {
                let written = write!(out, " {name}");
                of.iter().for_each(|a| a.write_prefix(out));
                written
            }
            Formula::If(of) => {
                out.push_str(" if");
                of.iter().for_each(|a| a.write_prefix(out));
                Ok(())
            }
        };
    }
}
