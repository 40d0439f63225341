//! Patterns of Fluent files in their bytes: what is text, what is a code, which variants there are and where.
//!
//! The files were parsed before, so their form is known to be sound. Invariant: every stretch is one of the file, and
//! what is not replaced stays as it is.
use std::collections::HashMap;
use std::ops::Range;

/// A part of what a translator works on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words.
    Text(String),
    /// A placeable as Fluent has it, braces included; a selection is `{ selector -> #n }`.
    Code(String),
}

/// A pattern.
#[derive(Clone, Debug)]
pub(super) struct Pattern {
    pub(super) span: Range<usize>,
    parts: Vec<Part>,
}

#[derive(Clone, Debug)]
enum Part {
    Text(Range<usize>),
    Code(Range<usize>),
    Select(Range<usize>, Select),
}

/// A selection in a pattern.
#[derive(Clone, Debug)]
pub(super) struct Select {
    pub(super) selector: String,
    pub(super) variants: Vec<Variant>,
}

/// One of the variants of a selection.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    pub(super) key: String,
    pub(super) default: bool,
    pub(super) value: Pattern,
}

impl Pattern {
    /// The pattern of the message or attribute whose name is at this place of the file.
    pub(super) fn after(file: &str, name: Range<usize>) -> Option<Self> {
        let equals = name.end + file.get(name.end..)?.find('=')?;
        Some(Self::within(file, equals + 1..end(file, equals + 1)))
    }

    fn within(file: &str, span: Range<usize>) -> Self {
        let text = file.get(span.clone()).unwrap_or_default();
        let start = span.start + (text.len() - text.trim_start().len());
        let span = start..(span.start + text.trim_end().len()).max(start);
        let mut parts = Vec::new();
        let (mut at, mut begun) = (span.start, span.start);
        while at < span.end {
            if !file.get(at..).is_some_and(|rest| rest.starts_with('{')) {
                at += 1;
                continue;
            }
            if begun < at {
                parts.push(Part::Text(begun..at));
            }
            let close = closing(file, at).min(span.end);
            parts.push(match select(file, at + 1..close.saturating_sub(1).max(at + 1)) {
                Some(select) => Part::Select(at..close, select),
                None => Part::Code(at..close),
            });
            (at, begun) = (close, close);
        }
        if begun < span.end {
            parts.push(Part::Text(begun..span.end));
        }
        Self { span, parts }
    }

    /// The selections, in order.
    pub(super) fn selects(&self) -> impl Iterator<Item = &Select> {
        self.parts.iter().filter_map(|part| match part {
            Part::Select(_, select) => Some(select),
            _ => None,
        })
    }

    /// What it says, lines without their indentation.
    pub(super) fn pieces(&self, file: &str) -> Vec<Piece> {
        let indent = self.indent(file);
        let mut selects = 0;
        let mut pieces = Vec::new();
        for part in &self.parts {
            pieces.push(match part {
                Part::Text(span) => Piece::Text(outdented(file.get(span.clone()).unwrap_or_default(), indent)),
                Part::Code(span) => Piece::Code(file.get(span.clone()).unwrap_or_default().to_owned()),
                Part::Select(_, select) => {
                    selects += 1;
                    Piece::Code(format!("{{ {} -> #{} }}", select.selector, selects - 1))
                }
            });
        }
        pieces
    }

    /// Whether it has words of its own around its selections.
    pub(super) fn has_words(&self, file: &str) -> bool {
        self.parts.iter().any(|part| match part {
            Part::Text(span) => file.get(span.clone()).is_some_and(|text| text.chars().any(char::is_alphabetic)),
            _ => false,
        })
    }

    /// Whether it is nothing but one selection, which has its own words in its variants.
    pub(super) fn only_select(&self) -> bool {
        matches!(self.parts.as_slice(), [Part::Select(..)])
    }

    /// The text of the file with other words, in variants as well; placeables stay. What is around the words of a
    /// variant that is all of its text is put there by `around`.
    pub(super) fn mapped(
        &self,
        file: &str,
        words: &dyn Fn(&str) -> String,
        around: &dyn Fn(String) -> String,
    ) -> String {
        let mut text = String::new();
        for part in &self.parts {
            match part {
                Part::Text(span) => text += &words(file.get(span.clone()).unwrap_or_default()),
                Part::Code(span) => text += file.get(span.clone()).unwrap_or_default(),
                Part::Select(span, select) => {
                    let mut at = span.start;
                    for variant in &select.variants {
                        text += file.get(at..variant.value.span.start).unwrap_or_default();
                        text += &variant.value.mapped(file, words, around);
                        at = variant.value.span.end;
                    }
                    text += file.get(at..span.end).unwrap_or_default();
                }
            }
        }
        if self.only_select() || text.is_empty() { text } else { around(text) }
    }

    /// The indentation that the lines after the first have in common.
    fn indent(&self, file: &str) -> usize {
        let texts = self.parts.iter().filter_map(|part| match part {
            Part::Text(span) => file.get(span.start..self.span.end.max(span.end)).map(|rest| (rest, span.len())),
            _ => None,
        });
        let lines = texts.flat_map(|(rest, own)| {
            rest.match_indices('\n')
                .filter(move |(at, _)| *at < own)
                .map(move |(at, _)| rest.get(at + 1..).unwrap_or(""))
        });
        let indents = lines.filter_map(|line| {
            let line = line.lines().next().unwrap_or_default();
            (!line.trim().is_empty()).then(|| line.len() - line.trim_start_matches(' ').len())
        });
        indents.min().unwrap_or(0)
    }

    /// The text of the file with other pieces in place of those of this pattern and of its variants; paths are those of
    /// units.
    pub(super) fn rewritten(&self, file: &str, path: &str, edits: &HashMap<String, Vec<Piece>>) -> String {
        let mut selects = Vec::new();
        let mut whole = String::new();
        for part in &self.parts {
            match part {
                Part::Text(span) | Part::Code(span) => whole += file.get(span.clone()).unwrap_or_default(),
                Part::Select(span, select) => {
                    let inner = format!("{path}#{}", selects.len());
                    let mut text = String::new();
                    let mut at = span.start;
                    for variant in &select.variants {
                        text += file.get(at..variant.value.span.start).unwrap_or_default();
                        text += &variant.value.rewritten(file, &format!("{inner}[{}]", variant.key), edits);
                        at = variant.value.span.end;
                    }
                    text += file.get(at..span.end).unwrap_or_default();
                    whole += &text;
                    selects.push(text);
                }
            }
        }
        let Some(pieces) = edits.get(path) else { return whole };
        let line = file.get(..self.span.start).unwrap_or_default().rsplit('\n').next().unwrap_or_default();
        let outer = line.len() - line.trim_start_matches(' ').len();
        let indent = if line.trim().is_empty() { outer } else { self.indent(file).max(outer + 4) };
        written(pieces, indent, &|index| selects.get(index).cloned())
    }
}

/// Pieces as a file has them, lines after the first indented by so many blanks.
pub(super) fn written(pieces: &[Piece], indent: usize, select: &dyn Fn(usize) -> Option<String>) -> String {
    let mut text = String::new();
    for piece in pieces {
        match piece {
            Piece::Code(code) => match number_of(code).and_then(select) {
                Some(code) => text += &code,
                None => text += code,
            },
            Piece::Text(words) => {
                for (index, line) in words.split('\n').enumerate() {
                    if index > 0 {
                        text.push('\n');
                        if !line.is_empty() {
                            text += &" ".repeat(indent);
                        }
                    }
                    let line = line.replace('{', "\u{1}").replace('}', "{\"}\"}").replace('\u{1}', "{\"{\"}");
                    let begins = text.is_empty() || index > 0;
                    match line.chars().next().filter(|c| begins && matches!(c, '[' | '*' | '.')) {
                        Some(first) => text += &format!("{{\"{first}\"}}{}", line.get(1..).unwrap_or_default()),
                        None => text += &line,
                    }
                }
            }
        }
    }
    text
}

/// The number of the selection that a code stands for.
pub(super) fn number_of(code: &str) -> Option<usize> {
    code.strip_suffix(" }")?.rsplit_once(" -> #")?.1.parse().ok()
}

fn outdented(text: &str, indent: usize) -> String {
    let mut lines = text.split('\n');
    let mut out = lines.next().unwrap_or_default().to_owned();
    for line in lines {
        out.push('\n');
        let blanks = (line.len() - line.trim_start_matches(' ').len()).min(indent);
        out += line.get(blanks..).unwrap_or_default();
    }
    out
}

/// Where the value that begins here ends.
fn end(file: &str, start: usize) -> usize {
    let mut end = start;
    let mut at = start;
    let mut first = true;
    while let Some(rest) = file.get(at..).filter(|rest| !rest.is_empty()) {
        let line_end = at + rest.find('\n').unwrap_or(rest.len());
        let line = file.get(at..line_end).unwrap_or_default();
        let begin = line.trim_start_matches(' ');
        if !first && !begin.trim().is_empty() && (begin.len() == line.len() || begin.starts_with(['.', '[', '*', '}']))
        {
            break;
        }
        // A placeable may go on over lines.
        let mut stop = line_end;
        let mut inner = at;
        while inner < stop {
            if file.get(inner..).is_some_and(|rest| rest.starts_with('{')) {
                inner = closing(file, inner);
                if inner > stop {
                    stop = inner + file.get(inner..).map_or(0, |rest| rest.find('\n').unwrap_or(rest.len()));
                }
            } else {
                inner += 1;
            }
        }
        if !begin.trim().is_empty() {
            end = stop;
        }
        first = false;
        at = stop + 1;
    }
    end
}

/// Just after the brace that closes the one at this byte.
fn closing(file: &str, open: usize) -> usize {
    let mut depth = 0_usize;
    let mut quoted = false;
    let mut escaped = false;
    for (at, byte) in file.bytes().enumerate().skip(open) {
        if quoted {
            quoted = escaped || byte != b'"';
            escaped = byte == b'\\' && !escaped;
            continue;
        }
        match byte {
            // In the text of a variant a quotation mark is a character like others.
            b'"' => quoted = opens_literal(file, at),
            b'{' => depth += 1,
            b'}' => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return at + 1;
                }
            }
            _ => {}
        }
    }
    file.len()
}

/// Whether a quotation mark begins a literal: after a brace, a parenthesis, a comma or a colon, not in text.
fn opens_literal(file: &str, at: usize) -> bool {
    let before = file.get(..at).unwrap_or_default().trim_end_matches(' ');
    let closes = file.get(at + 1..).and_then(|rest| {
        let line = rest.lines().next()?;
        let end = line.find('"')?;
        line.get(end + 1..)?.trim_start().chars().next()
    });
    before.ends_with(['{', '(', ',', ':']) && closes.is_some_and(|c| matches!(c, '}' | ')' | ',' | '\\' | '"'))
}

/// The selection inside of braces, if it is one.
fn select(file: &str, inside: Range<usize>) -> Option<Select> {
    let text = file.get(inside.clone())?;
    let arrow = text.find("->")?;
    let selector = text.get(..arrow)?.trim();
    if selector.contains(['{', '"']) && !selector.ends_with(')') {
        return None;
    }
    let mut heads: Vec<(usize, usize, String, bool)> = Vec::new();
    let mut at = inside.start + arrow + 2;
    let mut begins = true;
    while at < inside.end {
        let rest = file.get(at..inside.end).unwrap_or_default();
        if let Some(first) = rest.chars().next() {
            let head = rest.strip_prefix('*').unwrap_or(rest);
            if begins && head.starts_with('[') {
                let close = at + rest.find(']')?;
                let key = file.get(at + (rest.len() - head.len()) + 1..close)?.trim().to_owned();
                heads.push((at, close + 1, key, rest.starts_with('*')));
                at = close + 1;
                begins = false;
                continue;
            }
            if first == '{' {
                at = closing(file, at);
                begins = false;
                continue;
            }
            begins = first == '\n' || begins && first == ' ';
            at += first.len_utf8();
        } else {
            at += 1;
        }
    }
    let starts: Vec<usize> = heads.iter().map(|head| head.0).skip(1).chain([inside.end]).collect();
    let variants = heads.into_iter().zip(starts).map(|((_, value, key, default), next)| Variant {
        key,
        default,
        value: Pattern::within(file, value..next.max(value)),
    });
    Some(Select { selector: selector.to_owned(), variants: variants.collect() })
}

/// Words and codes as one text, codes between `‹` and `›`.
pub(super) fn flat(pieces: &[Piece]) -> String {
    let part = |piece: &Piece| match piece {
        Piece::Text(words) => words.clone(),
        Piece::Code(code) => format!("‹{code}›"),
    };
    pieces.iter().map(part).collect()
}

/// Neighbouring stretches of text as one.
pub(super) fn merged(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut all: Vec<Piece> = Vec::new();
    for piece in pieces {
        match (all.last_mut(), piece) {
            (Some(Piece::Text(words)), Piece::Text(more)) => words.push_str(&more),
            (_, piece) => all.push(piece),
        }
    }
    all.retain(|piece| !matches!(piece, Piece::Text(words) if words.is_empty()));
    all
}
