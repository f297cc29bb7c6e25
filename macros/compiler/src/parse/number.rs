//! Exact decimal literals: `0.1` is one tenth.

use crate::exact::{Natural, Rational};

/// The most digits that a literal may have; the longest `f64` has 767 significant ones.
pub const MOST_DIGITS: usize = 1000;

/// What a literal token says.
#[derive(Debug, PartialEq)]
pub enum Number<'a> {
    /// A number without a suffix.
    Exact(Rational),
    /// A number that runs into a name: `2x`, `2f32`.
    Suffixed(&'a str, &'a str),
    /// Not decimal: `0x10`. The value, if it is a number at all.
    Radix(Option<Natural>),
    /// Beyond the largest `f64`.
    TooLarge,
    /// Not zero, and below the smallest positive `f64`.
    TooSmall,
    /// More than [`MOST_DIGITS`] digits.
    TooLong,
    /// A string, a character and so on.
    Other,
}

/// Reads the text of a literal token.
pub fn number(text: &str) -> Number<'_> {
    if !text.starts_with(|c: char| c.is_ascii_digit()) {
        return Number::Other;
    }
    for (prefix, radix) in [("0x", 16), ("0o", 8), ("0b", 2)] {
        if let Some(digits) = text.strip_prefix(prefix) {
            let digits: String = digits
                .chars()
                .filter(|c| *c != '_')
                .take(MOST_DIGITS)
                .collect();
            return Number::Radix(Natural::parse(&digits, radix));
        }
    }
    let digits = |from: usize| {
        let rest = text.as_bytes().iter().skip(from);
        from + rest
            .take_while(|b| b.is_ascii_digit() || **b == b'_')
            .count()
    };
    let whole = digits(0);
    let mut end = whole;
    if text.as_bytes().get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    let mantissa = text.get(..end).unwrap_or_default();
    let fraction = end.saturating_sub(whole + 1);
    let fraction_digits = text
        .get(whole + 1..whole + 1 + fraction)
        .unwrap_or_default();
    let fraction_digits = fraction_digits.bytes().filter(u8::is_ascii_digit).count();
    let mut exponent = 0;
    if let Some(b'e' | b'E') = text.as_bytes().get(end) {
        let signed = matches!(text.as_bytes().get(end + 1), Some(b'+' | b'-'));
        let start = end + 1 + usize::from(signed);
        let stop = digits(start);
        let shown = text.get(end + 1..stop).unwrap_or_default().replace('_', "");
        if shown.bytes().any(|b| b.is_ascii_digit()) {
            // An exponent that does not fit is far out of range on either side.
            exponent =
                shown
                    .parse::<i64>()
                    .unwrap_or(if shown.starts_with('-') { -9999 } else { 9999 });
            end = stop;
        }
    }
    let (shown, suffix) = text.split_at_checked(end).unwrap_or((text, ""));
    if !suffix.is_empty() {
        return Number::Suffixed(shown, suffix);
    }
    scaled(mantissa, fraction_digits, exponent)
}

/// `mantissa · 10^exponent`, the mantissa's point ignored and counted by `fraction`.
fn scaled<'a>(mantissa: &str, fraction: usize, exponent: i64) -> Number<'a> {
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    if digits.len() > MOST_DIGITS {
        return Number::TooLong;
    }
    let Some(mantissa) = Natural::parse(&digits, 10) else {
        return Number::Other;
    };
    if mantissa.is_zero() {
        return Number::Exact(Rational::from(0));
    }
    // With at most 1,000 digits an exponent beyond ±5,000 is out of range whatever the digits are.
    let exponent = exponent.clamp(-5000, 5000) - i64::try_from(fraction).unwrap_or(5000);
    let power = Natural::from(10).power(u32::try_from(exponent.unsigned_abs()).unwrap_or(9999));
    let value = if exponent < 0 {
        Rational::new(false, mantissa, power)
    } else {
        Some(Rational::whole(mantissa.times(&power)))
    };
    match (
        value,
        Rational::from_f64(f64::MAX),
        Rational::from_f64(f64::from_bits(1)),
    ) {
        (Some(value), Some(most), _) if value > most => Number::TooLarge,
        (Some(value), _, Some(least)) if value < least => Number::TooSmall,
        (Some(value), ..) => Number::Exact(value),
        (None, ..) => Number::Other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(a: i64, b: i64) -> Number<'static> {
        Number::Exact(
            Rational::from(a)
                .over(&Rational::from(b))
                .expect("b is not 0"),
        )
    }

    #[test]
    fn decimals_are_exact() {
        assert_eq!(number("0.1"), ratio(1, 10));
        assert_eq!(number("1_000"), ratio(1000, 1));
        assert_eq!(number("1e-3"), ratio(1, 1000));
        assert_eq!(number("2."), ratio(2, 1));
        assert_eq!(number("1_0.2_5e+1"), ratio(205, 2));
        assert_eq!(number("0e999999999999999999999"), ratio(0, 1));
    }

    #[test]
    fn what_is_not_a_plain_decimal_is_told_apart() {
        assert_eq!(number("2f32"), Number::Suffixed("2", "f32"));
        assert_eq!(number("2x"), Number::Suffixed("2", "x"));
        assert_eq!(number("1.5e2pi"), Number::Suffixed("1.5e2", "pi"));
        assert_eq!(number("2em"), Number::Suffixed("2", "em"));
        assert_eq!(number("0x10"), Number::Radix(Some(16.into())));
        assert_eq!(number("\"2\""), Number::Other);
    }

    #[test]
    fn the_range_is_that_of_f64() {
        let largest = format!("{:e}", f64::MAX);
        assert!(matches!(number(&largest), Number::Exact(_)));
        assert!(matches!(number("4.95e-324"), Number::Exact(_)));
        assert_eq!(number("1.7976931348623159e308"), Number::TooLarge);
        assert_eq!(number("1e999999999999999999999"), Number::TooLarge);
        assert_eq!(number("4.9e-324"), Number::TooSmall);
        assert_eq!(number("1e-999999999999999999999"), Number::TooSmall);
        assert_eq!(number(&"1".repeat(2000)), Number::TooLong);
    }
}
