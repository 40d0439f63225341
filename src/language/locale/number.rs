//! Numbers as a language writes them.
//!
//! Numbers are never grouped: the manuals print `99999,9999` and `100000` without separators, and a
//! grouped `1.000` would read as one where the programs of the same page use decimal points. Prose
//! has a real minus sign (U+2212); NC text has what a control reads, a hyphen. Invariant: the result
//! depends on the language, the value and the digits alone, and there is no negative zero.
use fixed_decimal::{Decimal, UnsignedDecimal, UnsignedRoundingMode};
use icu_decimal::DecimalFormatter;
use icu_decimal::options::{DecimalFormatterOptions, GroupingStrategy};
use icu_locale_core::Locale;

/// How many digits follow the decimal sign at most, if nothing else is asked for: a nanometre.
const USUAL_MAXIMUM: u8 = 6;
/// How many digits a text may ask for; a binary64 has no more.
pub(super) const MOST_DIGITS: u8 = 15;
/// Digits that remain of a value which the usual maximum would show as nothing.
const SIGNIFICANT_OF_TINY: i16 = 2;

/// How many digits follow the decimal sign.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digits {
    /// At least this many.
    pub minimum: u8,
    /// At most this many; without it six, or two significant ones for a value that six would hide.
    pub maximum: Option<u8>,
}

impl Digits {
    /// Exactly this many.
    pub const fn exactly(count: u8) -> Self {
        Self { minimum: count, maximum: Some(count) }
    }
}

/// The digits and the decimal sign of a language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbers {
    digits: [char; 10],
    decimal: String,
}

impl Numbers {
    /// Those of the language; of the root locale where the tag is unknown.
    pub(super) fn of(tag: &str) -> Self {
        // ICU's formatter cannot be shared between threads, so its signs are read off once.
        Self::from_icu(tag).unwrap_or_else(Self::plain)
    }

    /// ASCII digits and a decimal point, as NC programs and JSON have them.
    pub fn plain() -> Self {
        Self { digits: ['0', '1', '2', '3', '4', '5', '6', '7', '8', '9'], decimal: ".".to_owned() }
    }

    fn from_icu(tag: &str) -> Option<Self> {
        let locale: Locale = tag.parse().ok()?;
        let mut options = DecimalFormatterOptions::default();
        options.grouping_strategy = Some(GroupingStrategy::Never);
        let formatter = DecimalFormatter::try_new(locale.into(), options).ok()?;
        let mut digits = ['0'; 10];
        for (value, digit) in (0_u8..).zip(&mut digits) {
            *digit = formatter.format(&Decimal::from(value)).to_string().chars().next()?;
        }
        let half = formatter.format(&Decimal::try_from_str("0.5").ok()?).to_string();
        let decimal = half.strip_prefix(digits[0])?.strip_suffix(digits[5])?.to_owned();
        Some(Self { digits, decimal })
    }

    /// The number for prose, with a real minus sign; nothing unless it is finite.
    pub fn prose(&self, value: f64, digits: Digits) -> Option<String> {
        self.signed(value, digits, '\u{2212}')
    }

    /// The number for NC text, with a hyphen as its minus sign; nothing unless it is finite.
    pub fn nc(&self, value: f64, digits: Digits) -> Option<String> {
        self.signed(value, digits, '-')
    }

    fn signed(&self, value: f64, digits: Digits, minus: char) -> Option<String> {
        let magnitude = rounded(value, digits)?;
        let mut text = String::new();
        if value < 0.0 && !magnitude.is_zero() {
            text.push(minus);
        }
        for sign in magnitude.to_string().chars() {
            match sign.to_digit(10).and_then(|digit| self.digits.get(digit as usize)) {
                Some(digit) => text.push(*digit),
                None => text.push_str(&self.decimal),
            }
        }
        Some(text)
    }

    /// Reads a number back; accepts both minus signs and no grouping.
    pub fn parse(&self, text: &str) -> Option<f64> {
        let (negative, magnitude) = match text.strip_prefix(['-', '\u{2212}']) {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (whole, fraction) = match magnitude.split_once(self.decimal.as_str()) {
            Some((whole, fraction)) => (whole, Some(fraction)),
            None => (magnitude, None),
        };
        let mut plain = self.ascii(whole)?;
        if let Some(fraction) = fraction {
            plain.push('.');
            plain.push_str(&self.ascii(fraction)?);
        }
        let value: f64 = plain.parse().ok()?;
        Some(if negative { -value } else { value })
    }

    fn ascii(&self, digits: &str) -> Option<String> {
        let value = |digit| self.digits.iter().position(|own| *own == digit);
        let ascii: Option<String> =
            digits.chars().map(|digit| char::from_digit(u32::try_from(value(digit)?).ok()?, 10)).collect();
        ascii.filter(|text| !text.is_empty())
    }
}

fn rounded(value: f64, digits: Digits) -> Option<UnsignedDecimal> {
    if !value.is_finite() {
        return None;
    }
    // Rust prints the shortest decimal that reads back as the same value.
    let exact = UnsignedDecimal::try_from_str(&value.abs().to_string()).ok()?;
    let least = digits.minimum.min(MOST_DIGITS);
    let most = digits.maximum.unwrap_or(USUAL_MAXIMUM).min(MOST_DIGITS).max(least);
    let mut position = -i16::from(most);
    if digits.maximum.is_none() && !exact.is_zero() && exact.nonzero_magnitude_start() < position {
        position = exact.nonzero_magnitude_start() + 1 - SIGNIFICANT_OF_TINY;
    }
    let mut number = exact.rounded_with_mode(position, UnsignedRoundingMode::HalfExpand);
    number.trim_end();
    number.pad_end(-i16::from(least));
    Some(number)
}
