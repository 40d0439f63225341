//! Diagnostics for people (with an excerpt of the file) and for programs (a JSON object a line).
//!
//! Invariant: what is shown of a source is bounded, however long its lines are; line and column
//! always count in the whole source.
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use serde::Serialize;

use super::ui::Ui;
use crate::base::diag::{Arg, Diagnostic, Place, Severity, visible};

/// How many bytes of a line are shown before and after the stretch in question.
const EDGE: usize = 160;
/// How many bytes of the stretch itself are shown.
const LONGEST: usize = 2000;
/// Stands where a line was cut.
const CUT: &str = "…";

/// The diagnostic as text of several lines, coloured by ANSI sequences if `color` is set.
pub fn render(diagnostic: &Diagnostic, ui: &Ui, color: bool) -> String {
    let severity = ui.severity(diagnostic.severity);
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let title = level.with_name(severity.as_str()).primary_title(ui.diagnostic(diagnostic)).id(diagnostic.code);
    let mut group = Group::with_title(title);
    if let Some(place) = &diagnostic.place {
        group = excerpt(group, place, AnnotationKind::Primary, None);
    }
    for (caption, place) in &diagnostic.related {
        let caption = ui.caption(caption, diagnostic);
        group = excerpt(group, place, AnnotationKind::Context, Some(caption));
    }
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    let mut text = renderer.decor_style(DecorStyle::Ascii).render(&[group]);
    text.push('\n');
    text
}

fn excerpt<'a>(group: Group<'a>, place: &Place, kind: AnnotationKind, label: Option<String>) -> Group<'a> {
    let window = Window::around(place);
    let start = place.start();
    let name = visible(place.source.name()).into_owned();
    let snippet = Snippet::source(window.text).line_start(start.line).annotation(kind.span(window.marked).label(label));
    if window.cut_before {
        // The renderer counts columns in what it is given, so the true one is said apart.
        let origin = Origin::path(name).line(start.line).char_column(start.column);
        return group.element(origin).element(snippet);
    }
    group.element(snippet.path(name))
}

/// The lines of a stretch, cut where they are too long.
struct Window {
    text: String,
    marked: std::ops::Range<usize>,
    cut_before: bool,
}

impl Window {
    fn around(place: &Place) -> Self {
        let text = place.source.text();
        let bytes = text.as_bytes();
        let mut start = boundary(text, place.span.start);
        if start > 0 && bytes.get(start) == Some(&b'\n') && bytes.get(start - 1) == Some(&b'\r') {
            start -= 1;
        }
        let end = boundary(text, place.span.end.min(start.saturating_add(LONGEST))).max(start);
        let low = boundary(text, start.saturating_sub(EDGE));
        let high = boundary(text, end.saturating_add(EDGE));
        let before = text.get(low..start).unwrap_or_default();
        let after = text.get(end..high).unwrap_or_default();
        let (from, cut_before) = match before.rfind(['\n', '\r']) {
            Some(at) => (low + at + 1, false),
            None => (low, low > 0),
        };
        let (to, cut_after) = match after.find(['\n', '\r']) {
            Some(at) => (end + at, false),
            None => (high, high < text.len()),
        };
        let mut shown = String::with_capacity(to - from + 2 * CUT.len());
        if cut_before {
            shown.push_str(CUT);
        }
        let shift = shown.len();
        push_lines(&mut shown, text.get(from..to).unwrap_or_default());
        if cut_after {
            shown.push_str(CUT);
        }
        Self { text: shown, marked: start - from + shift..end - from + shift, cut_before }
    }
}

/// A lone carriage return ends a line here, but not for the renderer.
fn push_lines(shown: &mut String, text: &str) {
    let mut signs = text.chars().peekable();
    while let Some(sign) = signs.next() {
        let lone = sign == '\r' && signs.peek() != Some(&'\n');
        shown.push(if lone { '\n' } else { sign });
    }
}

/// The last start of a character at or before the byte.
fn boundary(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

/// A diagnostic as programs read it; positions are null for findings about no file.
#[derive(Serialize)]
struct Line<'a> {
    file: Option<&'a str>,
    line: Option<usize>,
    column: Option<usize>,
    end_line: Option<usize>,
    end_column: Option<usize>,
    severity: &'static str,
    code: &'static str,
    message: String,
    /// The parameters that the finding names.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parameters: Vec<&'a str>,
}

/// The diagnostic as one line of JSON, without a line end: lines and columns (in characters) from 1,
/// the end exclusive.
pub fn to_json_line(diagnostic: &Diagnostic, ui: &Ui) -> String {
    let place = diagnostic.place.as_ref();
    let (start, end) = (place.map(Place::start), place.map(Place::end));
    let parameters = match diagnostic.get("parameter") {
        Some(Arg::Text(names)) if !names.is_empty() => names.split(", ").collect(),
        _ => Vec::new(),
    };
    let line = Line {
        file: place.map(|place| place.source.name()),
        line: start.map(|position| position.line),
        column: start.map(|position| position.column),
        end_line: end.map(|position| position.line),
        end_column: end.map(|position| position.column),
        severity: diagnostic.severity.as_str(),
        code: diagnostic.code,
        message: ui.diagnostic(diagnostic),
        parameters,
    };
    serde_json::to_string(&line).unwrap_or_default()
}
