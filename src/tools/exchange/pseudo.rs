//! A pseudo-language: the source texts with other letters and longer words, to see what would be cut or stays untranslated.
//!
//! Words of prose get accents and doubled vowels, which makes them about 40 % longer, and each text is in brackets. Labels and
//! names in NC programs keep their length and get only letters that the controls have. Placeables, variants, words of the
//! code (capitals, digits) and units stay as they are.
use super::fluent::{Pattern, Piece};
use super::markdown;
use crate::language::locale::SOURCE_LANGUAGE;

/// How texts of the pseudo-language look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pseudo {
    /// With accents.
    Accents,
    /// With accents, and marks that make each stretch of words run from right to left.
    Bidi,
}

impl Pseudo {
    /// The tag of the language.
    pub const fn tag(self) -> &'static str {
        match self {
            Self::Accents => "en-XA",
            Self::Bidi => "en-XB",
        }
    }
}

/// What is around each text.
const OPEN: char = '\u{27e6}';
const CLOSE: char = '\u{27e7}';
/// Right-to-left embedding, and its end.
const RIGHT_TO_LEFT: (char, char) = ('\u{202b}', '\u{202c}');
/// Attributes that are printed in NC programs, or compared with what is printed there.
const OF_PROGRAMS: [&str; 5] = ["label", "label-aliases", "nc", "nc-aliases", "word"];
/// Attributes that are lists of words which are looked for in texts.
const LISTS: [&str; 5] = ["forms", "forbidden", "endings", "cycle", "joining"];
/// Messages that are symbols, the same in all languages.
const SYMBOLS: &str = "unit-";
/// Messages that join others.
const JOINS: &str = "list-";

/// The files of the pseudo-language.
pub fn pseudo(files: &[(String, String)], kind: Pseudo) -> Vec<(String, String)> {
    let from = format!("locales/{SOURCE_LANGUAGE}/");
    let own = |path: &str, text: &str| {
        let name = path.strip_prefix(&from)?;
        let text = match name.rsplit_once('.')?.1 {
            "ftl" => fluent(text.strip_prefix('\u{feff}').unwrap_or(text), kind),
            "md" => prose(text, kind),
            _ => return None,
        };
        Some((format!("locales/{}/{name}", kind.tag()), text))
    };
    files.iter().filter_map(|(path, text)| own(path, text)).collect()
}

/// A file of Fluent.
fn fluent(file: &str, kind: Pseudo) -> String {
    let mut text = String::new();
    let (mut at, mut message) = (0, "");
    while let Some(rest) = file.get(at..).filter(|rest| !rest.is_empty()) {
        let line = rest.lines().next().unwrap_or_default();
        let next = at + rest.find('\n').map_or(rest.len(), |end| end + 1);
        let Some((name, attribute)) = named(line) else {
            text += file.get(at..next).unwrap_or_default();
            at = next;
            continue;
        };
        if !attribute {
            message = name;
        }
        let begin = at + (name.as_ptr() as usize - line.as_ptr() as usize);
        let Some(pattern) = Pattern::after(file, begin..begin + name.len()) else { break };
        let style = Style::of(message, attribute.then_some(name), kind);
        text += file.get(at..pattern.span.start).unwrap_or_default();
        text += &style.dressed(&pattern, file);
        // A message without a value goes on in its own line.
        let end = pattern.span.end.max(at + line.len().min(next - at));
        text += file.get(pattern.span.end..end).unwrap_or_default();
        at = end;
        if file.get(at..).is_some_and(|rest| rest.starts_with('\n')) {
            text.push('\n');
            at += 1;
        }
    }
    text
}

/// The name with which a line begins a message, a term or an attribute, and whether it is an attribute.
fn named(line: &str) -> Option<(&str, bool)> {
    let begin = line.trim_start_matches(' ');
    let (is_attribute, begin) = match begin.strip_prefix('.') {
        Some(rest) => (true, rest),
        None if begin.len() == line.len() => (false, begin.strip_prefix('-').unwrap_or(begin)),
        None => return None,
    };
    let (name, _) = begin.split_once('=')?;
    let name = name.trim_end_matches(' ');
    let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'));
    is_name.then_some((name, is_attribute))
}

/// What happens to a text.
#[derive(Clone, Copy)]
enum Style {
    Same,
    /// Accents only.
    Accents {
        long: bool,
        capitals: bool,
    },
    /// In brackets.
    Whole(Pseudo),
}

impl Style {
    fn of(message: &str, attribute: Option<&str>, kind: Pseudo) -> Self {
        match attribute {
            _ if message.starts_with(SYMBOLS) => Self::Same,
            Some("source") => Self::Same,
            Some(name) if OF_PROGRAMS.contains(&name) => Self::Accents { long: false, capitals: true },
            Some(name) if LISTS.contains(&name) => Self::Accents { long: true, capitals: false },
            _ if message.starts_with(JOINS) => Self::Accents { long: true, capitals: false },
            _ => Self::Whole(kind),
        }
    }

    fn dressed(self, pattern: &Pattern, file: &str) -> String {
        let plain = |text: String| text;
        let whole = |text: String| format!("{OPEN}{text}{CLOSE}");
        match self {
            Self::Same => file.get(pattern.span.clone()).unwrap_or_default().to_owned(),
            Self::Accents { long, capitals } => pattern.mapped(file, &|words| accented(words, long, capitals), &plain),
            Self::Whole(Pseudo::Accents) => pattern.mapped(file, &|words| accented(words, true, false), &whole),
            Self::Whole(Pseudo::Bidi) => pattern.mapped(file, &|words| turned(&accented(words, true, false)), &whole),
        }
    }
}

/// Words that run from right to left, line by line.
fn turned(text: &str) -> String {
    let line = |line: &str| {
        let words = line.trim();
        if !words.chars().any(char::is_alphabetic) {
            return line.to_owned();
        }
        let (begin, end) = RIGHT_TO_LEFT;
        line.replacen(words, &format!("{begin}{words}{end}"), 1)
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Words with accents; words of the code stay.
fn accented(text: &str, long: bool, capitals: bool) -> String {
    let mut out = String::with_capacity(text.len() * 2);
    let inside = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '$' | '%');
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| inside(c) != inside(first)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        rest = after;
        // An ordinal number such as “2nd” is a word.
        let is_ordinal = matches!(word.trim_start_matches(|c: char| c.is_ascii_digit()), "st" | "nd" | "rd" | "th");
        let is_code = !is_ordinal && word.chars().any(|c| c.is_ascii_digit() || matches!(c, '_' | '$' | '%'))
            || !word.chars().any(char::is_lowercase) && !matches!(word, "A" | "I");
        if !inside(first) || is_code && !capitals {
            out += word;
            continue;
        }
        for sign in word.chars() {
            let new = accent(sign);
            out.push(new);
            if long && "aeiou".contains(sign) {
                out.push(new);
            }
        }
    }
    out
}

/// The letter with an accent; all of them are letters that the controls have.
const fn accent(sign: char) -> char {
    match sign {
        'a' => 'à',
        'c' => 'ç',
        'd' => 'ď',
        'e' => 'é',
        'g' => 'ğ',
        'h' => 'ĥ',
        'i' => 'í',
        'j' => 'ĵ',
        'k' => 'ķ',
        'l' => 'ĺ',
        'n' => 'ñ',
        'o' => 'ö',
        'r' => 'ř',
        's' => 'š',
        't' => 'ť',
        'u' => 'ü',
        'w' => 'ŵ',
        'y' => 'ý',
        'z' => 'ž',
        'A' => 'À',
        'C' => 'Ç',
        'D' => 'Ď',
        'E' => 'É',
        'G' => 'Ğ',
        'H' => 'Ĥ',
        'I' => 'Í',
        'J' => 'Ĵ',
        'K' => 'Ķ',
        'L' => 'Ĺ',
        'N' => 'Ñ',
        'O' => 'Ö',
        'R' => 'Ř',
        'S' => 'Š',
        'T' => 'Ť',
        'U' => 'Ü',
        'W' => 'Ŵ',
        'Y' => 'Ý',
        'Z' => 'Ž',
        other => other,
    }
}

/// A page of prose; its marks and blocks of code stay.
fn prose(page: &str, kind: Pseudo) -> String {
    let mut text = String::new();
    let mut at = 0;
    for segment in markdown::segments(page).into_iter().filter(|segment| segment.kind != markdown::CODE) {
        text += page.get(at..segment.span.start).unwrap_or_default();
        let dressed = |piece| match piece {
            Piece::Text(words) if kind == Pseudo::Bidi => Piece::Text(turned(&accented(&words, true, false))),
            Piece::Text(words) => Piece::Text(accented(&words, true, false)),
            code => code,
        };
        text.push(OPEN);
        text += &markdown::written(&segment.pieces.into_iter().map(dressed).collect::<Vec<_>>(), false);
        text.push(CLOSE);
        at = segment.span.end;
    }
    text + page.get(at..).unwrap_or_default()
}
