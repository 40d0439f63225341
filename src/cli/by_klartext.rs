//! Programs in DIN/ISO for another control: put into Klartext, converted, and what is new in DIN/ISO again.
//!
//! Invariant: a block that needs nothing keeps its bytes, a new one says in Klartext what the conversion wrote, and
//! whatever cannot be put into DIN/ISO stays as it was and is reported.
use crate::base::diag::{Diagnostic, Edit, Place, Severity, Source, Span, edited};
use crate::program::iso::{Codes, Lowered, to_iso, to_klartext};
use crate::program::syntax::{Block, BlockKind, Program, parse};
use crate::tools::compare;
use crate::tools::convert::{self, Conversion, Request};

/// Findings about the Klartext that the reader of the program does not see.
const SYNTAX: &str = "syntax-";
/// What Klartext has no equivalent of is not checked.
const NO_EQUIVALENT: &str = "klartext-no-equivalent";

/// Findings that say what was done.
const DONE: [&str; 4] =
    ["convert-parameter-added", "convert-parameter-dropped", "convert-parameter-renamed", "convert-form"];

/// Rewrites a program in DIN/ISO for another control.
pub(super) fn convert(written: &Program, request: &Request<'_>) -> Conversion {
    let codes = Codes::new(request.from.catalogue);
    let lowered = to_klartext(written, &codes, None);
    let conversion = convert::convert(&lowered.program, request);
    let theirs = conversion.found.into_iter().filter(|finding| !finding.code.starts_with(SYNTAX));
    let mut found: Vec<Diagnostic> = theirs.map(|finding| lowered.at_home(finding)).collect();
    found.extend(lowered.diagnostics.iter().cloned().map(|finding| match finding.code {
        NO_EQUIVALENT | "iso-word-not-allowed" => Diagnostic { code: "convert-iso-unread", ..finding },
        _ => finding,
    }));
    let (mut edits, mut made) = (Vec::new(), Vec::new());
    let mut refused = Vec::new();
    for edit in &conversion.edits {
        match block(written, &lowered, edit, &codes) {
            Some(new) => {
                edits.push(new);
                made.push(edit.clone());
            }
            None => refused.push(lowered.blocks(edit.span)),
        }
    }
    let mut text = edited(written.source().text(), &edits);
    if !edits.is_empty() && !is_same(&text, &lowered, &made, &codes, request) {
        refused.extend(edits.drain(..).map(|edit| edit.span));
        text = written.source().text().to_owned();
    }
    // What would have been done there is not done.
    let inside = |own: &Diagnostic, home: &Span| {
        own.place.as_ref().is_some_and(|place| home.start <= place.span.start && place.span.end <= home.end)
    };
    found.retain(|own| !(DONE.contains(&own.code) && refused.iter().any(|home| inside(own, home))));
    found.extend(refused.iter().map(|home| stays(written, *home)));
    found.sort_by_key(|finding| finding.place.as_ref().map(|place| (place.span.start, place.span.end)));
    Conversion { text, edits, found }
}

/// That a definition is not written anew.
fn stays(written: &Program, home: Span) -> Diagnostic {
    let block = written.blocks().iter().find(|block| block.span == home);
    let content = block.map_or(home, |block| written.content(block));
    let found = written.slice(content).lines().next().unwrap_or_default().trim();
    let place = Place::new(written.source(), Span::new(content.start, content.start + found.len()));
    Diagnostic { severity: Severity::Error, ..Diagnostic::error("convert-iso-stays", place) }.arg("found", found)
}

/// Whether the new program says in Klartext what was written there.
fn is_same(text: &str, lowered: &Lowered, made: &[Edit], codes: &Codes<'_>, request: &Request<'_>) -> bool {
    let name = lowered.program.source().name();
    let wanted = parse(&Source::new(name, edited(lowered.program.source().text(), made)));
    let is = to_klartext(&parse(&Source::new(name, text)), codes, None).program;
    let is = parse(&Source::new(name, is.source().text()));
    compare::fingerprint(&wanted, &request.to) == compare::fingerprint(&is, &request.to)
}

/// The block of DIN/ISO in the place of the one that a definition comes from; nothing if there is none.
fn block(written: &Program, lowered: &Lowered, edit: &Edit, codes: &Codes<'_>) -> Option<Edit> {
    let home = lowered.blocks(edit.span);
    let old = written.blocks().iter().find(|block| block.span == home)?;
    // Nothing else comes from the same block.
    let blocks = lowered.program.blocks().iter();
    let inside = |block: &Block| edit.span.start <= block.span.start && block.span.end <= edit.span.end;
    let mut of_home = blocks.filter(|block| lowered.blocks(block.span) == home);
    let BlockKind::Iso(own) = &old.kind else { return None };
    if !of_home.all(inside) || !own.remarks.is_empty() {
        return None;
    }
    let raised = to_iso(&parse(&Source::new("", edit.text.as_str())), codes);
    let numberless =
        raised.text.trim_start_matches(['N', '/']).trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    if !raised.diagnostics.is_empty() || has_more(numberless) {
        return None;
    }
    let labelled = own.parameters.iter().any(|parameter| parameter.label.is_some());
    let eol = if written.slice(home).contains("\r\n") { "\r\n" } else { "\n" };
    let mut lines = numberless.trim_end().lines();
    let code = lines.next()?;
    // The code and what follows it stay, unless it is another one.
    let content = written.content(old);
    let first = own.parameters.first().map_or(content.end, |parameter| parameter.span.start);
    let kept = written.slice(Span::new(content.start, first));
    let begins = |text: &str| text.split([' ', '*', ';', '\r', '\n']).next().map(str::to_ascii_uppercase);
    let head = if begins(kept) == begins(code) {
        written.slice(Span::new(home.start, first)).to_owned()
    } else if kept.contains(';') {
        return None;
    } else {
        let gap = kept.get(kept.trim_end().len()..).unwrap_or_default();
        format!("{}{code}{gap}", written.slice(Span::new(home.start, content.start)))
    };
    let indent = head.rsplit_once('\n').map_or("", |(_, indent)| indent);
    let between = if old.lines == 1 && !labelled { " ".to_owned() } else { format!("{eol}{indent}") };
    let lines = lines.map(|line| if labelled { line.to_owned() } else { without_label(line) });
    let joined = lines.collect::<Vec<_>>().join(&between);
    let whole = written.slice(home);
    let (body, tail) = whole.split_at(whole.trim_end_matches(['\r', '\n']).len());
    let joined = if body.trim_end().ends_with('*') { &joined } else { joined.trim_end_matches('*').trim_end() };
    Some(Edit { span: home, text: format!("{head}{joined}{tail}") })
}

/// Whether more than one block was written.
fn has_more(text: &str) -> bool {
    text.lines().skip(1).any(|line| line.starts_with('N'))
}

/// A line of a definition without its label; the end of the block stays.
fn without_label(line: &str) -> String {
    match line.split_once(';') {
        Some((value, label)) => value.trim_end().to_owned() + if label.ends_with('*') { "*" } else { "" },
        None => line.to_owned(),
    }
}
