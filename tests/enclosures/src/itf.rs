//! The test vectors of ITF1788: `name operand … = result …;`, in `testcase … { }`, with comments as in C.

use std::fmt;

use zeroset::interval::Interval;

pub mod exception;
pub mod plan;
mod scan;
pub mod tally;

/// A value in a test vector. Decorations are dropped.
#[derive(Clone, Debug, PartialEq)]
pub enum Set {
    /// No number.
    Empty,
    /// An interval.
    Some(Interval),
    /// A plain number, as the exponent of `pown`.
    Number(f64),
    /// "Not an interval".
    Nai,
    /// Anything else that the format allows: `true`, a text, a list.
    Other(String),
}

/// One case.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Where it stands.
    pub place: Place,
    /// The operation as the standard names it.
    pub name: String,
    /// The operands.
    pub operands: Vec<Set>,
    /// The tightest results.
    pub results: Vec<Set>,
}

/// A line of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file's name.
    pub file: String,
    /// The line, from 1 on.
    pub line: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.file, self.line)
    }
}

/// Why a file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ItfError {
    /// Where.
    pub place: Place,
    /// What is wrong there.
    pub what: String,
}

impl fmt::Display for ItfError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.what)
    }
}

impl std::error::Error for ItfError {}

/// All cases of a file; `file` is its name for messages.
///
/// # Errors
/// If a statement is none, or a number cannot be read. Nothing is left out in silence.
pub fn parse(file: &str, text: &str) -> Result<Vec<Case>, ItfError> {
    let at = |line, what| ItfError {
        place: Place {
            file: file.to_owned(),
            line,
        },
        what,
    };
    let mut cases = Vec::new();
    for (line, statement) in scan::statements(text).map_err(|(line, what)| at(line, what))? {
        let (name, operands, results) = case(&statement).map_err(|what| at(line, what))?;
        cases.push(Case {
            place: at(line, String::new()).place,
            name,
            operands,
            results,
        });
    }
    Ok(cases)
}

/// `name operand … = result …`, perhaps followed by `<= wider result …` or `signal …`.
fn case(statement: &str) -> Result<(String, Vec<Set>, Vec<Set>), String> {
    let (left, right) =
        scan::split_outside(statement, '=').ok_or_else(|| format!("`{statement}` has no `=`"))?;
    let right = right.split("<=").next().unwrap_or_default();
    let right = right.split(" signal ").next().unwrap_or_default();
    let left = left.trim();
    let (name, operands) = left
        .split_once(char::is_whitespace)
        .ok_or_else(|| format!("`{left}` has no operand"))?;
    let results = sets(right)?;
    if results.is_empty() {
        return Err(format!("`{statement}` has no result"));
    }
    Ok((name.to_owned(), sets(operands)?, results))
}

fn sets(text: &str) -> Result<Vec<Set>, String> {
    let mut sets = Vec::new();
    let mut rest = text.trim();
    while let Some(first) = rest.chars().next() {
        let (set, after) = match first {
            '[' => {
                let (inner, after) = rest[1..]
                    .split_once(']')
                    .ok_or_else(|| format!("`{rest}` lacks a `]`"))?;
                // A decoration: _com, _dac, _def, _trv, _ill.
                let after = after
                    .strip_prefix('_')
                    .map_or(after, |d| d.trim_start_matches(char::is_alphabetic));
                (set_of(inner)?, after)
            }
            '"' | '{' => {
                let close = if first == '"' { '"' } else { '}' };
                let (inner, after) = rest[1..]
                    .split_once(close)
                    .ok_or_else(|| format!("`{rest}` lacks a `{close}`"))?;
                (Set::Other(inner.to_owned()), after)
            }
            _ => {
                let (word, after) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
                (word_of(word)?, after)
            }
        };
        sets.push(set);
        rest = after.trim_start();
    }
    Ok(sets)
}

/// What stands between brackets.
fn set_of(text: &str) -> Result<Set, String> {
    match text.trim().to_ascii_lowercase().as_str() {
        "empty" => return Ok(Set::Empty),
        "nai" => return Ok(Set::Nai),
        "entire" => return Ok(Set::Some(Interval::ENTIRE)),
        _ => {}
    }
    let (lo, hi) = text.split_once(',').unwrap_or((text, text));
    let bound = |x| enclosed(x).ok_or_else(|| format!("[{text}]: `{x}` is not a number"));
    Interval::try_new(bound(lo)?.0, bound(hi)?.1)
        .map(Set::Some)
        .map_err(|error| format!("[{text}]: {error}"))
}

/// A number, or a word such as `true`, or a number between two doubles; what begins like a number must be one.
fn word_of(word: &str) -> Result<Set, String> {
    let like_a_number = |c: char| c.is_ascii_digit() || "+-.".contains(c);
    match enclosed(word) {
        Some((least, most)) if least == most => Ok(Set::Number(least)),
        None if word.starts_with(like_a_number) => Err(format!("`{word}` is not a number")),
        _ => Ok(Set::Other(word.to_owned())),
    }
}

/// The doubles around a number: decimal ones count as their nearest double, which is what the authors' programs read.
fn enclosed(text: &str) -> Option<(f64, f64)> {
    let text = text.trim();
    let (negative, size) = match text.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let lower = size.to_ascii_lowercase();
    let both = |x| (x, x);
    let (least, most) = match lower.strip_prefix("0x") {
        Some(hex) => hexadecimal(hex)?,
        None if lower == "infinity" || lower == "inf" => both(f64::INFINITY),
        None if lower.starts_with(|c: char| c.is_ascii_digit() || c == '.') => {
            both(lower.parse().ok()?)
        }
        None => return None,
    };
    Some(if negative {
        (-most, -least)
    } else {
        (least, most)
    })
}

/// The doubles around `h.hhhp±d`; `None` for more digits than 64 bits hold, and beyond the range of doubles.
fn hexadecimal(text: &str) -> Option<(f64, f64)> {
    let (digits, exponent) = text.split_once('p').unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
    let places = i32::try_from(fraction.len()).ok()?;
    let exponent = exponent.parse::<i32>().ok()?.checked_sub(4 * places)?;
    if mantissa == 0 {
        return Some((0.0, 0.0));
    }
    // Without zeros at its end the whole number is at most 53 bits long, if this is a double.
    let zeros = mantissa.trailing_zeros();
    let (mantissa, exponent) = (mantissa >> zeros, exponent.checked_add(zeros as i32)?);
    let bits = 64 - mantissa.leading_zeros() as i32;
    if !(-1074..=1024 - bits).contains(&exponent) {
        return None;
    }
    let spare = (bits - 53).max(0);
    let (mantissa, exponent) = (mantissa >> spare, exponent + spare);
    // Two steps: the power alone may be no double while the product is one.
    let half = exponent / 2;
    let power = |n: i32| f64::from_bits(((1023 + n) as u64) << 52);
    let least = mantissa as f64 * power(half) * power(exponent - half);
    Some((least, if spare > 0 { least.next_up() } else { least }))
}

#[cfg(test)]
mod tests;
