//! Masks of formatted output (`FN 16`): texts in quotation marks with places for values, and keywords.
//!
//! ```text
//! "Diameter %8.3LF mm", Q153;
//! "%02d:%02d", HOUR, MIN;
//! M_CLOSE;
//! ```
//! Their form is common knowledge of the trade, see `docs/events.md`. Invariant: what is not known here is a mistake with
//! its line, never left out; no value is known here.
use crate::base::expr::QRef;

/// The widest field and the most decimals of a number.
const MOST: usize = 255;

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    Parameter(QRef),
    /// The program that prints.
    CallPath,
    Hour,
    Minute,
    Second,
    Day,
    Month,
    /// The month with three letters.
    NamedMonth,
    /// The year with two digits.
    ShortYear,
    Year,
}

/// How a value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// With so many decimals.
    Decimal(usize),
    /// The nearest whole number.
    Whole,
    Text,
}

/// A piece of a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Piece {
    Text(String),
    Value { of: Source, form: Form, width: usize, left: bool, zeros: bool },
}

impl Piece {
    /// A value in its field.
    pub(super) fn fill(text: &str, width: usize, left: bool, zeros: bool) -> String {
        let blanks = width.saturating_sub(text.chars().count());
        match (left, text.strip_prefix('-'), zeros) {
            (true, ..) => format!("{text}{}", " ".repeat(blanks)),
            (false, Some(digits), true) => format!("-{}{digits}", "0".repeat(blanks)),
            (false, None, true) => format!("{}{text}", "0".repeat(blanks)),
            (false, _, false) => format!("{}{text}", " ".repeat(blanks)),
        }
    }
}

/// What a mask says.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    Line(Vec<Piece>),
    /// The file ends here; the next output begins it anew.
    Close,
    /// The output goes to the end of a file that was closed.
    Append,
    /// The same, but only to a file that has less than so many KB.
    AppendUpTo(u32),
    /// The output begins its file anew.
    Truncate,
    /// Whether lines without any text are left out.
    HideEmpty(bool),
    /// What follows is for one language of the control (`L_ENGLISH`), or for all.
    Language(Option<String>),
}

/// A mistake: its line, from 1, and what was found there.
pub(super) type Mistake = (usize, String);

/// Reads a mask.
pub(super) fn read(text: &str) -> Result<Vec<Statement>, Mistake> {
    let mut found = Vec::new();
    for (line, written) in statements(text)? {
        found.push(statement(&written).map_err(|wrong| (line, wrong))?);
    }
    Ok(found)
}

/// What ends with a semicolon, each with its line. Lines that begin with an asterisk are comments.
fn statements(text: &str) -> Result<Vec<(usize, String)>, Mistake> {
    let (mut all, mut now, mut begins, mut quoted) = (Vec::new(), String::new(), 1, false);
    for (number, line) in (1..).zip(text.lines()) {
        if !quoted && line.trim_start().starts_with('*') {
            continue;
        }
        let mut escaped = false;
        for sign in line.chars() {
            match sign {
                '"' if !escaped => quoted = !quoted,
                ';' if !quoted => {
                    if !now.trim().is_empty() {
                        all.push((begins, now.trim().to_owned()));
                    }
                    now.clear();
                    continue;
                }
                _ => {}
            }
            escaped = sign == '\\' && !escaped;
            if now.trim().is_empty() {
                begins = number;
            }
            now.push(sign);
        }
        if quoted {
            return Err((number, line.trim().to_owned()));
        }
        now.push(' ');
    }
    if now.trim().is_empty() { Ok(all) } else { Err((begins, now.trim().to_owned())) }
}

fn statement(written: &str) -> Result<Statement, String> {
    if !written.starts_with('"') {
        let word = written.to_ascii_uppercase();
        return Ok(match word.as_str() {
            "M_CLOSE" => Statement::Close,
            "M_APPEND" => Statement::Append,
            "M_TRUNCATE" => Statement::Truncate,
            most if most.starts_with("M_APPEND_MAX") => {
                let most = most.trim_start_matches("M_APPEND_MAX").trim();
                Statement::AppendUpTo(most.parse().map_err(|_| written.to_owned())?)
            }
            "M_EMPTY_HIDE" => Statement::HideEmpty(true),
            "M_EMPTY_SHOW" => Statement::HideEmpty(false),
            "L_ALL" => Statement::Language(None),
            language if language.starts_with("L_") => Statement::Language(Some(word)),
            _ => return Err(written.to_owned()),
        });
    }
    let (format, rest) = quoted(written).ok_or_else(|| written.to_owned())?;
    let rest = rest.trim();
    let mut values = Vec::new();
    if let Some(list) = rest.strip_prefix(',') {
        for word in list.split(',') {
            values.push(source(word.trim()).ok_or_else(|| word.trim().to_owned())?);
        }
    } else if !rest.is_empty() {
        return Err(rest.to_owned());
    }
    pieces(&format, &values).map(Statement::Line)
}

/// The text in quotation marks at the beginning, and what follows. Marks that are written out stay as they are.
fn quoted(written: &str) -> Option<(String, &str)> {
    let inner = written.strip_prefix('"')?;
    let mut escaped = false;
    for (at, sign) in inner.char_indices() {
        if sign == '"' && !escaped {
            return Some((inner.get(..at)?.to_owned(), inner.get(at + 1..)?));
        }
        escaped = sign == '\\' && !escaped;
    }
    None
}

fn source(word: &str) -> Option<Source> {
    Some(match word.to_ascii_uppercase().as_str() {
        "CALL_PATH" => Source::CallPath,
        "HOUR" => Source::Hour,
        "MIN" => Source::Minute,
        "SEC" => Source::Second,
        "DAY" => Source::Day,
        "MONTH" => Source::Month,
        "STR_MONTH" => Source::NamedMonth,
        "YEAR2" => Source::ShortYear,
        "YEAR4" => Source::Year,
        _ => Source::Parameter(QRef::parse(word)?),
    })
}

/// The text between values, and the values in the order of their places.
fn pieces(format: &str, values: &[Source]) -> Result<Vec<Piece>, String> {
    let (mut pieces, mut text, mut values) = (Vec::new(), String::new(), values.iter());
    let mut signs = format.chars().peekable();
    while let Some(sign) = signs.next() {
        match (sign, signs.peek()) {
            ('\\', Some('n')) => text.push('\n'),
            ('\\', Some(mark @ ('\\' | '"'))) | ('%', Some(mark @ '%')) => text.push(*mark),
            ('%', _) => {
                let mut written = String::new();
                while let Some(next) = signs.next_if(|next| next.is_ascii_digit() || matches!(next, '+' | '-' | '.')) {
                    written.push(next);
                }
                if matches!(signs.peek(), Some('L' | 'l')) {
                    signs.next();
                }
                let kind = signs.next().map(|kind| kind.to_ascii_uppercase());
                // A text as it is, without a field.
                let is_bare = kind == Some('R') && signs.next_if(|next| matches!(next, 'S' | 's')).is_some();
                let shown = || format!("%{written}{}", kind.map(String::from).unwrap_or_default());
                let of = *values.next().ok_or_else(shown)?;
                let piece = match is_bare && written.is_empty() {
                    true => Piece::Value { of, form: Form::Text, width: 0, left: false, zeros: false },
                    false => field(&written, kind, of).ok_or_else(shown)?,
                };
                if !text.is_empty() {
                    pieces.push(Piece::Text(std::mem::take(&mut text)));
                }
                pieces.push(piece);
                continue;
            }
            _ => {
                text.push(sign);
                continue;
            }
        }
        signs.next();
    }
    if values.next().is_some() {
        return Err(format.to_owned());
    }
    if !text.is_empty() {
        pieces.push(Piece::Text(text));
    }
    Ok(pieces)
}

/// `9.3` and `F`: a field of nine characters with three decimals.
fn field(written: &str, kind: Option<char>, of: Source) -> Option<Piece> {
    let (left, rest) = match written.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, written.strip_prefix('+').unwrap_or(written)),
    };
    let (width, decimals) = match rest.split_once('.') {
        Some((width, decimals)) => (width, Some(decimals.parse::<usize>().ok()?)),
        None => (rest, None),
    };
    let zeros = width.len() > 1 && width.starts_with('0');
    let width = if width.is_empty() { 0 } else { width.parse::<usize>().ok()? };
    let form = match kind? {
        'F' => Form::Decimal(decimals.unwrap_or(6)),
        'D' | 'I' if decimals.is_none() => Form::Whole,
        'S' if decimals.is_none() => Form::Text,
        _ => return None,
    };
    let fits = width <= MOST && decimals.is_none_or(|decimals| decimals <= MOST);
    fits.then_some(Piece::Value { of, form, width, left, zeros })
}
