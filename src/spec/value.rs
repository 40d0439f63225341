//! Whether a control would take a value for a parameter.
//!
//! Invariant: only what a manual prints is refused; a value that is known only when the program runs
//! (a Q parameter) is taken. Linter, blocks, checker and engine all ask here.
use super::catalogue::Param;
use super::vocabulary::{ParameterKind, Shape};

/// Lengths in mm that differ by less are the same: no control reads as many decimals.
const ROUNDING: f64 = 1e-8;

/// mm in an inch.
pub const MM_PER_INCH: f64 = 25.4;

/// Why a value is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// It is not of the kind that the parameter takes.
    Kind,
    /// It is less than the least value.
    Below(f64),
    /// It is greater than the greatest value.
    Above(f64),
    /// It is none of the choices.
    NotOffered,
    /// It has more characters than the text, or more labels than the list may have.
    TooLong(u32),
}

/// Why the parameter refuses a number; nothing if it takes it.
fn number_refusal(param: &Param, value: f64) -> Option<Refusal> {
    let whole = matches!(
        param.kind,
        ParameterKind::Integer | ParameterKind::QNumber | ParameterKind::Row | ParameterKind::LabelList
    ) || param.field.as_ref().is_some_and(|field| field.shape == Shape::Row);
    if whole && value.fract() != 0.0 {
        return Some(Refusal::Kind);
    }
    let mut among = false;
    for choice in &param.choices {
        match offers(choice.value.as_str(), value) {
            // A value may be offered by name although it lies outside the printed range (0 = switched off).
            Offer::Exactly => return None,
            Offer::Within => among = true,
            Offer::Not => {}
        }
    }
    if !param.choices.is_empty() && !among {
        return Some(Refusal::NotOffered);
    }
    let below = param.min.filter(|min| value < *min).map(Refusal::Below);
    below.or(param.max.filter(|max| value > *max).map(Refusal::Above))
}

/// Why the parameter refuses a number of a program whose unit has so many mm. The ranges of lengths and feeds are those
/// of the manuals, in mm; a limit is reported in the unit of the program.
pub fn number_refusal_in(param: &Param, value: f64, unit: f64) -> Option<Refusal> {
    if unit == 1.0 || !param.is_measured() {
        return number_refusal(param, value);
    }
    // A limit that was converted and comes back is still the limit.
    let mm = libm::round(value * unit / ROUNDING) * ROUNDING;
    Some(match number_refusal(param, mm)? {
        Refusal::Below(min) => Refusal::Below(min / unit),
        Refusal::Above(max) => Refusal::Above(max / unit),
        other => other,
    })
}

/// Why the parameter refuses a value as it is printed; nothing if it takes it.
pub fn refusal(param: &Param, text: &str) -> Option<Refusal> {
    let text = text.trim();
    if param.words.iter().any(|word| word == text || fed(word, text) || feed_word(word, text)) {
        return None;
    }
    match (param.field.as_ref().map(|field| field.shape), param.kind) {
        (Some(Shape::AxisDirection), _) | (_, ParameterKind::AxisDirection) => kind(is_axis_direction(text)),
        (Some(Shape::Position), _) | (_, ParameterKind::Position) => {
            // Most are one coordinate without a blank.
            if !text.is_empty() && !text.contains(char::is_whitespace) {
                return coordinate(param, text);
            }
            coordinates(text).iter().find_map(|one| coordinate(param, one)).or(kind(!text.is_empty()))
        }
        (_, ParameterKind::Axis) => kind(text.len() == 1 && text.starts_with(is_axis)),
        (Some(Shape::Axes), _) => {
            let is_letter = |word: &str| word.len() == 1 && word.starts_with(is_axis);
            let most = param.max_length.filter(|most| text.split_whitespace().count() > *most as usize);
            most.map(Refusal::TooLong).or(kind(!text.is_empty() && text.split_whitespace().all(is_letter)))
        }
        (Some(Shape::Centre), _) => {
            let of_centre = |one: &str| match one.strip_prefix("CC") {
                Some(one) => coordinate(param, one),
                None => Some(Refusal::Kind),
            };
            text.split_whitespace().find_map(of_centre).or(kind(!text.is_empty()))
        }
        (Some(Shape::AxisCoordinate), _) => coordinate(param, text),
        (Some(Shape::Row), _) | (_, ParameterKind::Row) => match text.strip_prefix('#') {
            Some(row) => number(param, row),
            None => Some(Refusal::Kind),
        },
        (Some(Shape::Q), _) => kind(is_q(text)),
        (_, ParameterKind::QNumber) if is_q(text) => None,
        (_, ParameterKind::QNumber | ParameterKind::Integer) => number(param, text),
        (_, ParameterKind::Text) => quoted(param, text),
        (_, ParameterKind::NumberOrName) if text.starts_with('"') => quoted(param, text),
        (_, ParameterKind::LabelList) => labels(param, text),
        (Some(Shape::Word), _) => number(param, text.strip_prefix('I').unwrap_or(text)),
        _ => number(param, text),
    }
}

/// A feed per turn or per tooth with its number: `FU0.2`, `FZ Q5`.
fn fed(word: &str, text: &str) -> bool {
    let value = (word == "FU" || word == "FZ").then(|| text.strip_prefix(word)).flatten().map(str::trim);
    value.is_some_and(|value| is_q(value) || parse(value).is_some())
}

/// The control shows `FAUTO` as `AUTO` after the equals sign; `F AUTO` and `F MAX` are the same words.
fn feed_word(word: &str, text: &str) -> bool {
    let short = word.strip_prefix('F').filter(|short| matches!(*short, "AUTO" | "MAX"));
    short.is_some_and(|short| text.strip_prefix('F').unwrap_or(text).trim_start() == short)
}

fn kind(right: bool) -> Option<Refusal> {
    (!right).then_some(Refusal::Kind)
}

fn number(param: &Param, text: &str) -> Option<Refusal> {
    if is_q(text) {
        return None;
    }
    match parse(text) {
        Some(value) => number_refusal(param, value),
        None => Some(Refusal::Kind),
    }
}

/// Whether a choice offers a value.
enum Offer {
    /// By itself.
    Exactly,
    /// As one of many, such as `>0`.
    Within,
    /// No.
    Not,
}

fn offers(choice: &str, value: f64) -> Offer {
    type Holds = fn(f64, f64) -> bool;
    let comparisons: [(&str, Holds); 4] =
        [(">=", |a, b| a >= b), ("<=", |a, b| a <= b), (">", |a, b| a > b), ("<", |a, b| a < b)];
    for (sign, holds) in comparisons {
        if let Some(limit) = choice.strip_prefix(sign) {
            let within = parse(limit.trim()).is_some_and(|limit| holds(value, limit));
            return if within { Offer::Within } else { Offer::Not };
        }
    }
    if parse(choice) == Some(value) { Offer::Exactly } else { Offer::Not }
}

/// Reads a number as programs have it: signed, with a decimal point or comma.
fn parse(text: &str) -> Option<f64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text).as_bytes();
    let mut marks = digits.iter().filter(|byte| !byte.is_ascii_digit());
    let mark = marks.next();
    if marks.next().is_some() || !matches!(mark, None | Some(b'.' | b',')) || matches!(digits, [] | [b',', ..]) {
        return None;
    }
    if mark == Some(&b',') { text.replace(',', ".").parse().ok() } else { text.parse().ok() }
}

fn is_q(text: &str) -> bool {
    crate::base::expr::QRef::parse(text.strip_prefix(['+', '-']).unwrap_or(text)).is_some()
}

fn is_axis(c: char) -> bool {
    "XYZABCUVW".contains(c)
}

fn is_axis_direction(text: &str) -> bool {
    let mut chars = text.chars();
    matches!((chars.next(), chars.next(), chars.next()), (Some(axis), Some('+' | '-'), None) if is_axis(axis))
}

/// The coordinates of a position; a blank between axis and value does not separate them.
fn coordinates(text: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match all.last_mut() {
            Some(axis) if axis.ends_with(is_axis) => axis.push_str(word),
            _ => all.push(word.to_owned()),
        }
    }
    all
}

/// `X+60` or `IX+5`.
fn coordinate(param: &Param, text: &str) -> Option<Refusal> {
    let incremental = param.field.as_ref().is_some_and(|field| field.incremental);
    let text = if incremental { text.strip_prefix('I').unwrap_or(text) } else { text };
    match text.strip_prefix(is_axis) {
        Some(value) => number(param, value),
        None => Some(Refusal::Kind),
    }
}

/// `1/2/3`, with or without blanks; names of labels are in quotation marks.
fn labels(param: &Param, text: &str) -> Option<Refusal> {
    let most = param.max_length.filter(|most| text.split('/').count() > *most as usize);
    most.map(Refusal::TooLong).or_else(|| labels_of(text).find_map(|label| number(param, label)))
}

/// A label of a list without blanks, and without the joint of two lines.
fn trimmed(label: &str) -> &str {
    label.trim_matches(|c: char| c.is_whitespace() || c == '~')
}

/// The labels of a list that are numbers.
fn labels_of(text: &str) -> impl Iterator<Item = &str> {
    text.split('/').map(trimmed).filter(|label| !label.starts_with('"') && !is_q(label))
}

fn quoted(param: &Param, text: &str) -> Option<Refusal> {
    if text.starts_with("QS") && is_q(text) {
        return None;
    }
    let inner = match text.strip_prefix('"') {
        Some(rest) => rest.strip_suffix('"').filter(|inner| !inner.contains('"')),
        None => Some(text).filter(|inner| !inner.contains('"')),
    };
    // A block is a line a parameter.
    let inner = inner.filter(|inner| !inner.contains(char::is_control));
    match (inner, param.max_length) {
        (None, _) => Some(Refusal::Kind),
        (Some(inner), Some(most)) if inner.chars().count() > most as usize => Some(Refusal::TooLong(most)),
        _ => None,
    }
}
