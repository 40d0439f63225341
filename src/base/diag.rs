//! Places in sources and the one type of diagnostic that every module reports with.
//!
//! A diagnostic is data: a stable code, a severity, a place and arguments. Its text is made from the
//! locale files at the edge of the program, never here. Invariant: this module knows no language and
//! no rule.
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// A stretch of bytes in a source, end exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// The byte after the last one.
    pub end: usize,
}

impl Span {
    /// The stretch from `start` up to, not including, `end`.
    pub const fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }
}

impl From<std::ops::Range<usize>> for Span {
    fn from(range: std::ops::Range<usize>) -> Self {
        Self::new(range.start, range.end)
    }
}

/// A line and a column, both counted from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

/// A text with the name of the file it came from.
pub struct Source {
    name: Cow<'static, str>,
    text: Cow<'static, str>,
    lines: OnceLock<Lines>,
}

/// Where lines start, found when it is first asked for.
struct Lines {
    count: usize,
    /// The start of each line whose number, counted from 0, is a multiple of [`STEP`].
    starts: Vec<usize>,
}

/// Of so many lines one is remembered; the others are counted from there.
const STEP: usize = 64;

/// The starts of lines after `from` up to `to`; lines end at `\n`, `\r\n` or a lone `\r`.
fn starts(text: &str, from: usize, to: usize) -> impl Iterator<Item = usize> + '_ {
    let bytes = text.as_bytes();
    let part = bytes.get(from..to.min(bytes.len())).unwrap_or_default();
    memchr::memchr2_iter(b'\n', b'\r', part).filter_map(move |at| {
        let at = from + at;
        let ends = bytes.get(at) == Some(&b'\n') || bytes.get(at + 1) != Some(&b'\n');
        ends.then_some(at + 1)
    })
}

/// A text on one line, with signs in place of control characters: a name of a file can have any of them.
pub fn visible(text: &str) -> Cow<'_, str> {
    let sign = |c: char| match u32::from(c) {
        code @ 0..0x20 => char::from_u32(0x2400 + code).unwrap_or(char::REPLACEMENT_CHARACTER),
        0x7F => '\u{2421}',
        _ if c.is_control() => char::REPLACEMENT_CHARACTER,
        _ => c,
    };
    if text.contains(char::is_control) { text.chars().map(sign).collect() } else { text.into() }
}

impl Source {
    /// A source with the given display name; lines end at `\n`, `\r\n` or a lone `\r`.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Arc<Self> {
        Arc::new(Self { name: name.into().into(), text: text.into().into(), lines: OnceLock::new() })
    }

    /// The same of a file that is a part of the program.
    pub fn embedded(name: &'static str, text: &'static str) -> Arc<Self> {
        Arc::new(Self { name: name.into(), text: text.into(), lines: OnceLock::new() })
    }

    /// The name as the user gave it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// How many lines it has.
    pub fn lines(&self) -> usize {
        self.table().count
    }

    fn table(&self) -> &Lines {
        self.lines.get_or_init(|| {
            let mut lines = Lines { count: 1, starts: vec![0] };
            for start in starts(&self.text, 0, self.text.len()) {
                if lines.count.is_multiple_of(STEP) {
                    lines.starts.push(start);
                }
                lines.count += 1;
            }
            lines
        })
    }

    /// The number (from 1) of the line that holds the byte, and its start.
    fn line_at(&self, byte: usize) -> (usize, usize) {
        let table = self.table();
        let step = table.starts.partition_point(|start| *start <= byte).saturating_sub(1);
        let first = table.starts.get(step).copied().unwrap_or_default();
        let after = starts(&self.text, first, byte);
        after.fold((step * STEP + 1, first), |(line, _), start| (line + 1, start))
    }

    /// The number (from 1) of the line that holds the byte.
    pub fn line_of(&self, byte: usize) -> usize {
        self.line_at(byte).0
    }

    /// Line and column of a byte; a byte past the end counts as the end.
    pub fn position(&self, byte: usize) -> Position {
        let byte = byte.min(self.text.len());
        let (line, start) = self.line_at(byte);
        let before = self.text.get(start..byte).unwrap_or_default();
        Position { line, column: before.chars().count() + 1 }
    }
}

impl fmt::Debug for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Source({:?}, {} bytes)", self.name, self.text.len())
    }
}

/// A stretch of one source.
#[derive(Clone, Debug)]
pub struct Place {
    /// The source.
    pub source: Arc<Source>,
    /// The stretch in it.
    pub span: Span,
}

impl Place {
    /// The stretch `span` of `source`.
    pub fn new(source: &Arc<Source>, span: impl Into<Span>) -> Self {
        Self { source: Arc::clone(source), span: span.into() }
    }

    /// Where the stretch starts.
    pub fn start(&self) -> Position {
        self.source.position(self.span.start)
    }

    /// Where the stretch ends (exclusive).
    pub fn end(&self) -> Position {
        self.source.position(self.span.end)
    }
}

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing.
    Note,
    /// Probably not meant.
    Warning,
    /// Wrong.
    Error,
}

impl Severity {
    /// The lower-case English word used in machine-readable output.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }

    /// The severity of that word.
    pub fn from_word(word: &str) -> Option<Self> {
        [Self::Note, Self::Warning, Self::Error].into_iter().find(|own| own.as_str() == word)
    }
}

/// A value that a diagnostic's text can show.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg {
    /// Text, shown as it is.
    Text(String),
    /// A number, shown as the language of the reader writes it.
    Number(f64),
}

impl From<&str> for Arg {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Arg {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<f64> for Arg {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Arg {
    fn from(number: usize) -> Self {
        Self::Number(number as f64)
    }
}

/// One finding. Its text is the message `diag-<code>` of the reader's locale, formatted with `args`.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// Stable code in kebab case.
    pub code: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// Where it is; nothing for findings about no file.
    pub place: Option<Place>,
    /// Values for the text, by argument name.
    pub args: Vec<(&'static str, Arg)>,
    /// Other places that belong to the finding, each with a code of its own for its caption.
    pub related: Vec<(&'static str, Place)>,
    /// What may be written there instead without changing what the program does, if anything.
    pub fix: Option<Edit>,
}

/// A range of a text and what replaces it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The stretch.
    pub span: Span,
    /// The new text.
    pub text: String,
}

/// A text with edits made; of edits that overlap the first one is.
pub fn edited(text: &str, edits: &[Edit]) -> String {
    let mut edits: Vec<&Edit> = edits.iter().collect();
    edits.sort_by_key(|edit| edit.span);
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        if edit.span.start >= at {
            out.push_str(text.get(at..edit.span.start).unwrap_or_default());
            out.push_str(&edit.text);
            at = edit.span.end;
        }
    }
    out.push_str(text.get(at..).unwrap_or_default());
    out
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(code: &'static str, place: Place) -> Self {
        Self { code, severity: Severity::Error, place: Some(place), args: Vec::new(), related: Vec::new(), fix: None }
    }

    /// A warning at a place.
    pub fn warning(code: &'static str, place: Place) -> Self {
        Self { severity: Severity::Warning, ..Self::error(code, place) }
    }

    /// An error about no file in particular.
    pub fn global(code: &'static str) -> Self {
        Self { code, severity: Severity::Error, place: None, args: Vec::new(), related: Vec::new(), fix: None }
    }

    /// The same with one more argument for its text.
    pub fn arg(mut self, name: &'static str, value: impl Into<Arg>) -> Self {
        self.args.push((name, value.into()));
        self
    }

    /// The same with one more place.
    pub fn related(mut self, caption: &'static str, place: Place) -> Self {
        self.related.push((caption, place));
        self
    }

    /// The same with a text that may replace `span`.
    pub fn fix(mut self, span: Span, text: impl Into<String>) -> Self {
        self.fix = Some(Edit { span, text: text.into() });
        self
    }

    /// The argument of that name.
    pub fn get(&self, name: &str) -> Option<&Arg> {
        self.args.iter().find(|(key, _)| *key == name).map(|(_, value)| value)
    }
}

/// Keeps the first of diagnostics that say the same of the same place: what several controls share
/// is found once for each of them.
pub fn dedupe(found: &mut Vec<Diagnostic>) {
    let mut seen = std::collections::HashSet::new();
    found.retain(|diagnostic| {
        let place = diagnostic.place.as_ref().map(|place| (place.source.name().to_owned(), place.span));
        seen.insert((diagnostic.code, place, format!("{:?}", diagnostic.args)))
    });
}

/// Mistakes that are found while something else is asked for; all clones share them.
#[derive(Clone, Debug, Default)]
pub struct Mistakes(Arc<Mutex<Vec<Diagnostic>>>);

impl Mistakes {
    /// Adds some.
    pub fn extend(&self, found: Vec<Diagnostic>) {
        if !found.is_empty() {
            self.0.lock().unwrap_or_else(PoisonError::into_inner).extend(found);
        }
    }

    /// All that were found so far.
    pub fn take(&self) -> Vec<Diagnostic> {
        std::mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// A word that is read while the program runs, for as long as it runs: the code of a finding, the name of an argument. Only
/// for words of which there are few.
pub fn interned(word: &str) -> &'static str {
    static WORDS: OnceLock<Mutex<BTreeSet<&'static str>>> = OnceLock::new();
    let mut words = WORDS.get_or_init(Mutex::default).lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = words.get(word) {
        return known;
    }
    let interned: &'static str = Box::leak(word.to_owned().into_boxed_str());
    words.insert(interned);
    interned
}
