//! The test vectors of ITF1788: `name operand … = result …;`, one case per line.

use zeroset::interval::Interval;

/// A set of numbers in a test vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Set {
    /// No number.
    Empty,
    /// An interval.
    Some(Interval),
    /// A plain number, as the exponent of `pown`.
    Number(f64),
}

/// One case.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The operation as the standard names it.
    pub name: String,
    /// The operands.
    pub operands: Vec<Set>,
    /// The tightest results.
    pub results: Vec<Set>,
}

/// All cases of a file. Decorations are dropped; cases with NaI have no interval and are left out.
pub fn parse(text: &str) -> Vec<Case> {
    text.lines().filter_map(case).collect()
}

fn case(line: &str) -> Option<Case> {
    let (left, right) = line.trim().strip_suffix(';')?.split_once('=')?;
    let (name, operands) = left.trim().split_once(' ')?;
    Some(Case {
        name: name.to_owned(),
        operands: sets(operands)?,
        results: sets(right)?,
    })
}

fn sets(text: &str) -> Option<Vec<Set>> {
    let mut sets = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        if let Some(inner) = rest.strip_prefix('[') {
            let (set, after) = inner.split_once(']')?;
            sets.push(set_of(set)?);
            // A decoration: _com, _dac, _def, _trv.
            let after = after
                .strip_prefix('_')
                .map_or(after, |d| d.trim_start_matches(char::is_alphabetic));
            rest = after.trim_start();
        } else {
            let (word, after) = rest.split_once(' ').unwrap_or((rest, ""));
            sets.push(Set::Number(number(word)?));
            rest = after.trim_start();
        }
    }
    Some(sets)
}

fn set_of(text: &str) -> Option<Set> {
    match text.trim() {
        "empty" => Some(Set::Empty),
        "entire" => Some(Set::Some(Interval::ENTIRE)),
        other => {
            let (lo, hi) = other.split_once(',')?;
            Interval::try_new(number(lo)?, number(hi)?)
                .ok()
                .map(Set::Some)
        }
    }
}

/// A decimal or hexadecimal number, to nearest.
fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let (negative, size) = match text.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let lower = size.to_ascii_lowercase();
    let value = match lower.strip_prefix("0x") {
        Some(hex) => hexadecimal(hex)?,
        None if lower == "infinity" => f64::INFINITY,
        None => lower.parse().ok()?,
    };
    Some(if negative { -value } else { value })
}

/// `h.hhhp±d` with at most 53 significant bits, so the value is exact.
fn hexadecimal(text: &str) -> Option<f64> {
    let (digits, exponent) = text.split_once('p').unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
    let exponent = exponent.parse::<i32>().ok()? - 4 * fraction.len() as i32;
    // Two steps: the power alone may be no double while the product is one.
    let half = exponent / 2;
    Some(mantissa as f64 * 2f64.powi(half) * 2f64.powi(exponent - half))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_read() {
        let text = "testcase x {\n  add [1.0,2.0]_com [-infinity,-0X1.8P+1] = [-infinity,-1.0]_dac;\n  pown [13.1, 13.1] 2 = [empty];\n  neg [nai] = [nai];\n}";
        let cases = parse(text);
        assert_eq!(cases.len(), 2);
        assert_eq!(
            cases[0].operands[1],
            Set::Some(Interval {
                lo: f64::NEG_INFINITY,
                hi: -3.0
            })
        );
        assert_eq!(cases[1].operands[1], Set::Number(2.0));
        assert_eq!(cases[1].results, [Set::Empty]);
    }

    #[test]
    fn hexadecimal_numbers_are_exact() {
        assert_eq!(number("0X0.0000000000001P-1022"), Some(f64::from_bits(1)));
        assert_eq!(number("-0x1.FFFFFFFFFFFFFp1023"), Some(-f64::MAX));
        assert_eq!(number("0x1p-1074"), Some(f64::from_bits(1)));
        assert_eq!(number("0x1.8p-1022"), Some(1.5 * f64::MIN_POSITIVE));
    }
}
