//! The facts that a text states, whatever its language.
use std::collections::BTreeMap;

/// What a fact is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// A number with its sign.
    Number,
    /// A unit after a number.
    Unit,
    /// A word of the code: `Q201`, `M140`, `FMAX`, `TOOL CALL`.
    Code,
    /// An argument that is filled in.
    Argument,
    /// A word that says from where something counts: absolute or incremental.
    Reference,
}

impl Kind {
    pub(super) const ALL: [Kind; 5] = [Kind::Number, Kind::Unit, Kind::Code, Kind::Argument, Kind::Reference];

    pub(super) const fn code(self) -> &'static str {
        match self {
            Kind::Number => "consistency-number",
            Kind::Unit => "consistency-unit",
            Kind::Code => "consistency-code",
            Kind::Argument => "consistency-argument",
            Kind::Reference => "consistency-reference-word",
        }
    }
}

/// Units that may be after a number, longest first.
pub(super) const UNITS: [&str; 6] = ["mm/min", "mm/r", "m/min", "mm", "%", "°"];

/// A degree sign is an ordinal after such a small number in some languages.
const LARGEST_ORDINAL: f64 = 9.0;

/// The roots of the words for absolute and incremental; they are the same in many languages.
const REFERENCES: [(&str, &[&str]); 2] =
    [("absolute", &["absolut", "assolut", "absoluut"]), ("incremental", &["incrementa", "inkrementa"])];

/// Where the same word is part of another term: the stepping angle in Italian.
const OTHER_TERMS: [&str; 2] = ["angolo incrementale", "angolare incrementale"];

/// The facts of a raw text (arguments as `‹name›`), each list sorted.
pub(super) fn facts(raw: &str, language: &str) -> BTreeMap<Kind, Vec<String>> {
    let mut facts: BTreeMap<Kind, Vec<String>> = BTreeMap::new();
    let text = arguments(raw, &mut facts);
    let chars: Vec<char> = text.chars().collect();
    let mut at = 0;
    while at < chars.len() {
        let c = chars[at];
        if c.is_alphabetic() || c == '_' {
            at = word(&chars, at, &mut facts);
        } else if c.is_ascii_digit() {
            at = number(&chars, at, language, &mut facts);
        } else {
            at += 1;
        }
    }
    for ((kind, _), count) in REFERENCES.iter().zip(references(&text)) {
        facts.entry(Kind::Reference).or_default().extend(std::iter::repeat_n((*kind).to_owned(), count));
    }
    facts.values_mut().for_each(|list| list.sort());
    facts
}

/// How often a text says absolute, and how often incremental.
pub(super) fn references(text: &str) -> [usize; 2] {
    let lower = OTHER_TERMS.iter().fold(text.to_lowercase(), |text, term| text.replace(term, ""));
    REFERENCES.map(|(_, roots)| roots.iter().map(|root| lower.matches(root).count()).sum())
}

/// Takes the arguments out of the text; one that occurs twice is one fact.
fn arguments(raw: &str, facts: &mut BTreeMap<Kind, Vec<String>>) -> String {
    let mut text = String::with_capacity(raw.len());
    let mut rest = raw;
    while let Some((before, inside)) = rest.split_once('‹') {
        let Some((name, after)) = inside.split_once('›') else { break };
        let list = facts.entry(Kind::Argument).or_default();
        if !list.iter().any(|known| known == name) {
            list.push(name.to_owned());
        }
        text.push_str(before);
        text.push('¤');
        rest = after;
    }
    text.push_str(rest);
    text
}

/// A run of letters, digits and `_`: a fact if it mixes capitals with digits. Gives its end.
fn word(chars: &[char], from: usize, facts: &mut BTreeMap<Kind, Vec<String>>) -> usize {
    let mut to = from;
    while to < chars.len() && (chars[to].is_alphanumeric() || chars[to] == '_') {
        to += 1;
    }
    let text: String = chars[from..to].iter().collect();
    let capitals = text.chars().take_while(|c| c.is_ascii_uppercase() || *c == '_').count();
    let rest = &text[capitals..];
    let is_code = capitals > 0 && !rest.is_empty() && rest.starts_with(|c: char| c.is_ascii_digit());
    // Letters after the digits are an ending of the language: `Q201:n`, `G54ssä`.
    if is_code {
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        facts.entry(Kind::Code).or_default().push(format!("{}{digits}", &text[..capitals]));
    } else if text.contains('_') && text.chars().all(|c| !c.is_lowercase()) {
        facts.entry(Kind::Code).or_default().push(text);
    }
    to
}

/// A number with sign and unit. Gives the end of what was read.
fn number(chars: &[char], from: usize, language: &str, facts: &mut BTreeMap<Kind, Vec<String>>) -> usize {
    let is_digit = |at: usize| chars.get(at).is_some_and(char::is_ascii_digit);
    let mut to = from;
    while is_digit(to) {
        to += 1;
    }
    let mut digits: String = chars[from..to].iter().collect();
    // A decimal part in either way of writing.
    if matches!(chars.get(to), Some('.' | ',')) && is_digit(to + 1) {
        let start = to + 1;
        to = start;
        while is_digit(to) {
            to += 1;
        }
        digits.push('.');
        digits.extend(&chars[start..to]);
    }
    let next: String = chars[to..].iter().take(3).collect();
    // Dimensions (`3-D`, `2½-D`) are words.
    if next.starts_with("-D") || next.starts_with('D') || next.starts_with("-u") || next.starts_with("-d") {
        return to + 1;
    }
    let before = from.checked_sub(1).map(|at| chars[at]);
    let two_before = from.checked_sub(2).map(|at| chars[at]);
    let begins = two_before.is_none_or(|c| !c.is_alphanumeric() && c != '¤');
    let minus = matches!(before, Some('-' | '\u{2212}')) && begins;
    let value: f64 = digits.parse().unwrap_or(0.0);
    // A number that begins with 0 names something, such as a software version.
    let named = digits.len() > 1 && digits.starts_with('0') && !digits.contains('.');
    let shown = if named { digits } else { format!("{value}") };
    let number = if minus { format!("\u{2212}{shown}") } else { shown };
    facts.entry(Kind::Number).or_default().push(number);
    let mut unit_at = to;
    while chars.get(unit_at).is_some_and(|c| matches!(c, ' ' | '\u{a0}' | '\u{202f}')) {
        unit_at += 1;
    }
    let after: String = chars[unit_at..].iter().take(7).collect();
    if let Some(unit) = UNITS.iter().find(|unit| after.starts_with(**unit)) {
        let end = unit_at + unit.chars().count();
        let ends = !chars.get(end).is_some_and(|c| c.is_alphanumeric());
        let after = chars.iter().skip(end).copied();
        let ordinal = *unit == "°" && unit_at == to && is_ordinal(value, after, language);
        if ends && !ordinal {
            facts.entry(Kind::Unit).or_default().push((*unit).to_owned());
            return end;
        }
    }
    // The endings of ordinals are words of the language.
    while to < chars.len() && (chars[to].is_alphabetic() || matches!(chars[to], 'ª' | 'º' | '°')) {
        to += 1;
    }
    to
}

/// Whether a degree sign right after a number makes an ordinal of it: `2° asse`, but not `5°.`
pub(super) fn is_ordinal(number: f64, mut after: impl Iterator<Item = char>, language: &str) -> bool {
    let word = after.next() == Some(' ') && after.next().is_some_and(char::is_alphabetic);
    (1.0..=LARGEST_ORDINAL).contains(&number) && word && matches!(language, "it" | "pt")
}
