//! The document `ciklo-parse/1` that `ciklo parse` prints; described in `docs/parse.md`.
//!
//! Invariant: it shows what is printed in the program and nothing that a specification knows.
use std::collections::BTreeMap;

use serde::Serialize;

use super::{CycleForm, CycleView, Program, Value};

/// The document.
#[derive(Clone, Debug, Serialize)]
pub struct ParseDocument<'p> {
    /// `ciklo-parse/1`.
    pub format: &'static str,
    /// Physical lines.
    pub lines: usize,
    /// Blocks.
    pub blocks: usize,
    /// How many blocks of each kind.
    pub kinds: BTreeMap<&'static str, usize>,
    /// Lines that cannot be read.
    pub unknown: Vec<UnknownLine<'p>>,
    /// Cycle definitions.
    pub cycles: Vec<Cycle<'p>>,
}

/// A line that cannot be read.
#[derive(Clone, Debug, Serialize)]
pub struct UnknownLine<'p> {
    /// Its number, from 1.
    pub line: usize,
    /// Its text.
    pub text: &'p str,
}

/// A cycle definition.
#[derive(Clone, Debug, Serialize)]
pub struct Cycle<'p> {
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// Its number.
    pub number: u32,
    /// The line it begins on, from 1.
    pub line: usize,
    /// Parameters, or fields of the old form, in the order written.
    pub parameters: Vec<CycleParameter<'p>>,
}

/// A parameter or field.
#[derive(Clone, Debug, Serialize)]
pub struct CycleParameter<'p> {
    /// `Q200`, or of the old form number, line and printed name: `31.2 HEIGHT:`.
    pub q: String,
    /// The value as printed.
    pub value: &'p str,
    /// The printed label.
    pub label: Option<&'p str>,
}

/// The document of a program.
pub fn document(program: &Program) -> ParseDocument<'_> {
    let mut kinds = BTreeMap::new();
    for block in program.blocks() {
        *kinds.entry(block.kind.name()).or_insert(0) += 1;
    }
    ParseDocument {
        format: "ciklo-parse/1",
        lines: program.lines(),
        blocks: program.blocks().len(),
        kinds,
        unknown: unknown(program),
        cycles: program.cycles().iter().map(|cycle| self::cycle(program, cycle)).collect(),
    }
}

fn unknown(program: &Program) -> Vec<UnknownLine<'_>> {
    let text = program.source().text();
    let line = |at: usize| {
        let start = text.get(..at).and_then(|before| before.rfind(['\n', '\r'])).map_or(0, |eol| eol + 1);
        let rest = text.get(start..).unwrap_or_default();
        rest.get(..rest.find(['\n', '\r']).unwrap_or(rest.len())).unwrap_or_default()
    };
    let at = |at: usize| UnknownLine { line: program.source().line_of(at), text: line(at) };
    program.errors().map(|error| at(error.span.start)).collect()
}

fn cycle<'p>(program: &'p Program, view: &CycleView<'p>) -> Cycle<'p> {
    let parameters = match &view.form {
        CycleForm::Parameters(definition) => definition
            .parameters
            .iter()
            .map(|parameter| CycleParameter {
                q: parameter.q.to_string(),
                value: printed(program, &parameter.value),
                label: parameter.label.map(|label| program.slice(label)),
            })
            .collect(),
        CycleForm::Lines(lines) => lines
            .iter()
            .flat_map(|line| line.words.iter().map(move |word| (line, word)))
            .map(|(line, word)| CycleParameter {
                q: format!("{}.{} {}", line.number, line.line, program.slice(word.name)).trim_end().to_owned(),
                value: printed(program, &word.value),
                label: None,
            })
            .collect(),
    };
    Cycle { keyword: view.keyword.as_str(), number: view.number, line: view.line, parameters }
}

fn printed<'p>(program: &'p Program, value: &Value) -> &'p str {
    program.slice(value.span)
}
