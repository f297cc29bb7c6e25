//! Brackets by arb, read from `fixtures/`.

use zeroset::interval::Interval;

/// An argument, and the neighbouring doubles around the exact value.
#[derive(Clone, Copy, Debug)]
pub struct Bracket {
    /// The arguments; a function of one variable ignores the second.
    pub at: [f64; 2],
    /// Is there one argument?
    pub unary: bool,
    /// The greatest double that is not above the value, and the least that is not below.
    pub value: Interval,
}

/// A line as `generate.py` writes it.
pub fn parse(line: &str) -> Option<Bracket> {
    let number = |field: &str| Some(f64::from_bits(u64::from_str_radix(field, 16).ok()?));
    let fields: Option<Vec<f64>> = line.split(' ').map(number).collect();
    match fields?[..] {
        [x, lo, hi] => Some(Bracket {
            at: [x, 1.0],
            unary: true,
            value: Interval { lo, hi },
        }),
        [x, y, lo, hi] => Some(Bracket {
            at: [x, y],
            unary: false,
            value: Interval { lo, hi },
        }),
        _ => None,
    }
}

/// The brackets of a function.
///
/// # Panics
/// If the file is missing or is not what `generate.py` writes.
pub fn brackets(name: &str) -> Vec<Bracket> {
    let path = format!("{}/fixtures/{name}.txt", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    // Miri is slow, and looks for undefined behaviour, not for bounds.
    text.lines()
        .step_by(if cfg!(miri) { 200 } else { 1 })
        .map(|line| parse(line).unwrap_or_else(|| panic!("{path}: {line}")))
        .collect()
}

/// How many doubles apart the bounds are.
pub fn steps(a: Interval) -> u64 {
    let place = |x: f64| {
        let bits = x.to_bits() as i64;
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    place(a.hi).abs_diff(place(a.lo))
}
