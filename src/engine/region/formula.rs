//! Formulas of contours: `(QC1 | QC2) \ QC3`.
//!
//! Operators have the same rank and are taken from left to right; the manuals give them none. Invariant: nothing here
//! knows where the reliefs come from.
use super::relief::{Operator, Relief};

/// Why a formula has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// No contour of this number is known.
    Contour(u32),
    /// It is no formula.
    Form,
}

/// The relief that a formula describes, from those of its contours.
///
/// # Errors
/// A contour is not known, or the text is no formula.
pub fn evaluate(formula: &str, relief: impl Fn(u32) -> Option<Relief>) -> Result<Relief, Unknown> {
    // What is left of each opening bracket: a value and what is to be done with it.
    let mut open: Vec<Option<(Relief, Operator)>> = Vec::new();
    let mut left: Option<(Relief, Operator)> = None;
    let mut value: Option<Relief> = None;
    let join = |left: Option<(Relief, Operator)>, right: Relief| match left {
        Some((before, operator)) => before.joined(operator, &right),
        None => right,
    };
    let mut rest = formula.trim();
    while let Some(sign) = rest.chars().next() {
        let mut length = sign.len_utf8();
        match (sign, value.take()) {
            ('(', None) => open.push(left.take()),
            (')', Some(inner)) => value = Some(join(open.pop().ok_or(Unknown::Form)?, inner)),
            ('Q' | 'q', None) => {
                let name = rest.get(2..).filter(|_| rest.get(1..2).is_some_and(|c| c.eq_ignore_ascii_case("C")));
                let name = name.ok_or(Unknown::Form)?;
                let digits = name.trim_start();
                let count = digits.bytes().take_while(u8::is_ascii_digit).count();
                let number = digits.get(..count).and_then(|own| own.parse().ok()).ok_or(Unknown::Form)?;
                length = rest.len() - digits.len() + count;
                value = Some(join(left.take(), relief(number).ok_or(Unknown::Contour(number))?));
            }
            ('&' | '|' | '^' | '\\', Some(before)) => {
                let operator = match sign {
                    '&' => Operator::And,
                    '|' if rest.starts_with("|\\") => Operator::Xor,
                    '|' => Operator::Or,
                    '^' => Operator::Xor,
                    _ => Operator::Without,
                };
                length += usize::from(rest.starts_with("|\\"));
                left = Some((before, operator));
            }
            _ => return Err(Unknown::Form),
        }
        rest = rest.get(length..).unwrap_or_default().trim_start();
    }
    value.filter(|_| open.is_empty() && left.is_none()).ok_or(Unknown::Form)
}
