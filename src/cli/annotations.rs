//! Findings for other tools: SARIF 2.1.0 and annotations of GitHub.
//!
//! Invariant: places count as the findings of `--format json` do; the order is that of files and places.
use std::fmt::Write as _;

use serde_json::{Value, json};

use super::Failure;
use super::session::{Session, json as document, place_key};
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::language::locale::{Args, Ui};

/// What a reader of the document checks it against.
const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

/// Prints findings as one SARIF document.
pub(super) fn sarif(session: &mut Session, mut found: Vec<Diagnostic>) -> Result<(), Failure> {
    found.sort_by(|a, b| place_key(a).cmp(&place_key(b)));
    let mut codes: Vec<&str> = found.iter().map(|diagnostic| diagnostic.code).collect();
    codes.sort_unstable();
    codes.dedup();
    let rules: Vec<Value> = codes.iter().map(|code| rule(code, &session.ui)).collect();
    let result = |diagnostic: &Diagnostic| {
        let mut result = json!({
            "ruleId": diagnostic.code,
            "ruleIndex": codes.binary_search(&diagnostic.code).unwrap_or_default(),
            "level": diagnostic.severity.as_str(),
            "message": { "text": session.ui.diagnostic(diagnostic) },
        });
        if let Some(place) = &diagnostic.place {
            let artifact = json!({ "uri": uri(place.source.name()) });
            result["locations"] =
                json!([{ "physicalLocation": { "artifactLocation": artifact, "region": region(place) } }]);
            if let Some(fix) = &diagnostic.fix {
                let deleted = region(&Place::new(&place.source, fix.span));
                let replacement = json!({ "deletedRegion": deleted, "insertedContent": { "text": fix.text } });
                let change = json!({ "artifactLocation": artifact, "replacements": [replacement] });
                result["fixes"] = json!([{ "artifactChanges": [change] }]);
            }
        }
        result
    };
    let results: Vec<Value> = found.iter().map(result).collect();
    let driver = json!({ "name": "ciklo", "version": env!("CARGO_PKG_VERSION"), "rules": rules });
    let run = json!({ "tool": { "driver": driver }, "columnKind": "unicodeCodePoints", "results": results });
    let text = document(&json!({ "$schema": SCHEMA, "version": "2.1.0", "runs": [run] }))?;
    session.output.print(&text)
}

fn rule(code: &str, ui: &Ui) -> Value {
    let explained = ui.find(&format!("explain-{code}"), &Args::new());
    let text = explained.or_else(|| ui.find("explain-guard", &Args::new())).unwrap_or_default();
    json!({ "id": code, "shortDescription": { "text": code }, "fullDescription": { "text": text } })
}

fn region(place: &Place) -> Value {
    let (start, end) = (place.start(), place.end());
    json!({ "startLine": start.line, "startColumn": start.column, "endLine": end.line, "endColumn": end.column })
}

/// A path as a relative reference, or as `file:` if it begins at the root.
fn uri(path: &str) -> String {
    let mut out = String::new();
    let path = path.replace('\\', "/");
    if path.starts_with('/') {
        out.push_str("file://");
    }
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            out.push(char::from(byte));
        } else {
            let _ = write!(out, "%{byte:02X}");
        }
    }
    out
}

/// Prints findings as commands that GitHub shows next to the lines of a change.
pub(super) fn github(session: &mut Session, mut found: Vec<Diagnostic>) -> Result<(), Failure> {
    found.sort_by(|a, b| place_key(a).cmp(&place_key(b)));
    for diagnostic in &found {
        let command = match diagnostic.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "notice",
        };
        let mut line = format!("::{command} ");
        if let Some(place) = &diagnostic.place {
            let (start, end) = (place.start(), place.end());
            let _ = write!(line, "file={},line={},endLine={}", property(place.source.name()), start.line, end.line);
            // Columns are only allowed within one line; there, the end is inclusive.
            if start.line == end.line {
                let _ =
                    write!(line, ",col={},endColumn={}", start.column, end.column.saturating_sub(1).max(start.column));
            }
            line.push(',');
        }
        let _ = writeln!(line, "title={}::{}", property(diagnostic.code), data(&session.ui.diagnostic(diagnostic)));
        session.output.print(&line)?;
    }
    Ok(())
}

fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
