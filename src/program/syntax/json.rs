//! The document `ciklo-parse/1` that `ciklo parse` prints; described in `docs/parse.md`.
//!
//! Invariant: it shows what is printed in the program and nothing that a specification knows.
use std::collections::BTreeMap;

use serde::ser::SerializeSeq as _;
use serde::{Serialize, Serializer};

use super::{BlockKind, CycleForm, CycleView, IsoKind, Parameter, Program, Value};

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
    pub cycles: Cycles<'p>,
}

/// The cycle definitions of a program, each made when it is written: long programs have many.
#[derive(Clone, Copy, Debug)]
pub struct Cycles<'p>(&'p Program);

impl<'p> Cycles<'p> {
    /// All of them, in the order of their lines.
    pub fn to_vec(self) -> Vec<Cycle<'p>> {
        let mut all = Vec::new();
        self.0.each_cycle(|view| all.push(cycle(self.0, &view)));
        all.extend(codes(self.0));
        all.sort_by_key(|cycle| cycle.line);
        all
    }
}

impl Serialize for Cycles<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // Codes of cycles are among the others.
        if codes(self.0).next().is_some() {
            return serializer.collect_seq(self.to_vec());
        }
        let mut list = serializer.serialize_seq(None)?;
        let mut done = Ok(());
        self.0.each_cycle(|view| {
            if done.is_ok() {
                done = list.serialize_element(&cycle(self.0, &view));
            }
        });
        done?;
        list.end()
    }
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
        cycles: Cycles(program),
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

/// The codes of cycles in a DIN/ISO program.
fn codes(program: &Program) -> impl Iterator<Item = Cycle<'_>> {
    let written = program.blocks().iter().filter_map(|block| match &block.kind {
        BlockKind::Iso(own) => match own.kind {
            IsoKind::Cycle(code) => Some((block.line, code, own)),
            _ => None,
        },
        _ => None,
    });
    written.map(|(line, code, block)| {
        let words = block.words.iter().skip(1).map(|word| CycleParameter {
            q: program.slice(word.name).to_owned(),
            value: program.slice(word.value.span),
            label: None,
        });
        let parameters = words.chain(block.parameters.iter().map(|own| parameter(program, own))).collect();
        Cycle { keyword: "G", number: u32::from(code), line, parameters }
    })
}

fn parameter<'p>(program: &'p Program, parameter: &Parameter) -> CycleParameter<'p> {
    CycleParameter {
        q: parameter.q.to_string(),
        value: printed(program, &parameter.value),
        label: parameter.label.map(|label| program.slice(label)),
    }
}

fn cycle<'p>(program: &'p Program, view: &CycleView<'p>) -> Cycle<'p> {
    let parameters = match &view.form {
        CycleForm::Parameters(definition) => definition.parameters.iter().map(|own| parameter(program, &own)).collect(),
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
