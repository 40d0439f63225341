//! What a program is checked among: the programs that it calls, and the tables that its rows and tools are in.
//!
//! Invariant: nothing here knows files; who checks says what a name in a program means ([`Among`]). What cannot be told
//! stays unknown and is passed over.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::Against;
use super::definition::{Defined, with_meaning};
use super::facts::Facts;
use super::flow::{self, Through};
use super::values::bits;
use crate::base::diag::{Severity, Span};
use crate::program::syntax::{BlockKind, Program, StatementKind, ValueKind};

/// The meaning of a parameter that names a program.
const PROGRAM: &str = "program-to-call";

/// Says what stands around a program.
pub trait Among: Sync {
    /// The program that a call names.
    fn called(&self, name: &str) -> Called;
    /// Whether the tool table has a tool; nothing if it is not known which table that is.
    fn has_tool(&self, tool: ToolName<'_>) -> Option<bool>;
    /// Whether there is a tool table.
    fn knows_tools(&self) -> bool {
        false
    }
    /// The number in a column of the tool table, in mm or degrees; nothing if none is known.
    fn tool_value(&self, _tool: ToolName<'_>, _column: &str) -> Option<f64> {
        None
    }
    /// Whether it is known of any table which rows it has.
    fn knows_rows(&self) -> bool {
        true
    }
    /// Whether a table has a row; nothing if it is not known which table that is.
    fn has_row(&self, rows: Rows<'_>, row: f64) -> Option<bool>;
}

/// A tool as a table knows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToolName<'n> {
    /// Its number, with the step behind the point.
    Number(f64),
    /// Its name.
    Name(&'n str),
}

/// What tells tools apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum ToolKey<'n> {
    Number(u64),
    Name(&'n str),
}

impl<'n> ToolName<'n> {
    /// What tells it apart from other tools.
    pub(super) fn key(self) -> ToolKey<'n> {
        match self {
            Self::Number(number) => ToolKey::Number(bits(number)),
            Self::Name(name) => ToolKey::Name(name),
        }
    }
}

/// Rows that a program reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows<'n> {
    /// The preset table.
    Presets,
    /// The datum table that the program selects, or the one that there is.
    Datums(Option<&'n str>),
}

/// What is known of a program that is called.
#[derive(Clone, Debug)]
pub enum Called {
    /// Nothing.
    Unknown,
    /// It is not where the control would look for it.
    Missing(Severity),
    /// It is there.
    Is {
        /// What it does.
        callee: Arc<Callee>,
        /// Whether it calls the calling program, be it through others.
        round: bool,
    },
}

/// What a called program does to the one that calls it.
#[derive(Debug)]
pub struct Callee {
    /// Whether its lengths are inches; nothing if it does not begin with BEGIN PGM.
    pub inch: Option<bool>,
    pub(super) through: Through,
}

impl Callee {
    /// Reads off what a program does when it is called.
    pub fn of(program: &Program, against: &Against<'_>, among: Option<&dyn Among>) -> Self {
        Self { inch: inch(program), through: flow::through(&Facts::begun(program, against, among)) }
    }

    /// One that may do anything.
    pub fn anything(program: &Program) -> Self {
        Self { inch: inch(program), through: Through::anything() }
    }
}

fn inch(program: &Program) -> Option<bool> {
    program.blocks().iter().find_map(|block| match &block.kind {
        BlockKind::BeginPgm(frame) => Some(frame.inch),
        _ => None,
    })
}

/// A call of a program.
#[derive(Clone, Debug)]
pub struct ProgramCall {
    /// The block that calls it; of a program made a cycle, the first block of the definition.
    pub block: usize,
    /// Where its name stands.
    pub span: Span,
    /// Whether it is made a cycle, which calls execute.
    pub cycle: Option<usize>,
    /// Whether it is only read, for the contour or the points that it describes.
    pub read: bool,
    /// What is known of it.
    pub called: Called,
}

/// The programs that a program calls by name, in the order of the text.
pub fn named(program: &Program, against: &Against<'_>) -> Vec<String> {
    let facts = Facts::begun(program, against, None);
    facts.calls.iter().filter(|call| !call.read).map(|call| name(program, call.span).to_owned()).collect()
}

/// A program's name as calls know it.
pub(super) fn name(program: &Program, span: Span) -> &str {
    program.slice(span).trim().trim_matches('"').trim()
}

/// The calls of a program with what is known of them.
pub(super) fn calls(facts: &Facts<'_>) -> Vec<ProgramCall> {
    let mut calls = places(facts);
    if let Some(among) = facts.among {
        for call in &mut calls {
            call.called = match among.called(name(facts.program, call.span)) {
                Called::Is { .. } if call.read => Called::Unknown,
                called => called,
            };
        }
    }
    calls
}

/// Whether a definition makes a program a cycle.
fn makes_cycle(definition: &Defined<'_>) -> bool {
    definition.kin().is_some_and(|cycle| with_meaning(cycle, PROGRAM).is_some())
}

fn places(facts: &Facts<'_>) -> Vec<ProgramCall> {
    let program = facts.program;
    let mut calls = Vec::new();
    let mut push = |block, span, cycle, read| {
        calls.push(ProgramCall { block, span, cycle, read, called: Called::Unknown });
    };
    // What CALL SELECTED calls is known where one program is selected only.
    let mut selected: Option<Option<Span>> = None;
    let mut selecting = Vec::new();
    for (index, block) in program.blocks().iter().enumerate() {
        match &block.kind {
            BlockKind::CallPgm(span) => push(index, *span, None, false),
            BlockKind::Sel(selection) if program.slice(selection.what).eq_ignore_ascii_case("PGM") => {
                let same = |other: &Option<Span>| {
                    other.is_some_and(|other| name(program, other).eq_ignore_ascii_case(name(program, selection.name)))
                };
                selected = Some(match &selected {
                    None => Some(selection.name),
                    Some(before) if same(before) => *before,
                    Some(_) => None,
                });
            }
            BlockKind::Sel(selection) if program.slice(selection.what).eq_ignore_ascii_case("CONTOUR") => {
                push(index, selection.name, None, true);
            }
            BlockKind::Statement(statement) => match statement.kind {
                StatementKind::CallSelected => selecting.push(index),
                // What is no label there is a file.
                StatementKind::DeclareContour | StatementKind::ContourDef => {
                    for word in &statement.words {
                        if let ValueKind::Text(name) = word.value.kind {
                            push(index, name, None, true);
                        }
                    }
                }
                _ => {}
            },
            _ => {}
        }
    }
    if let Some(Some(span)) = selected {
        selecting.into_iter().for_each(|index| push(index, span, None, false));
    }
    for (index, definition) in facts.definitions.iter().enumerate().filter(|(_, own)| makes_cycle(own)) {
        let kin = definition.as_kin();
        let read = facts.read(&kin);
        if let Some(item) = read.item(PROGRAM) {
            push(definition.view.first, item.value_span, Some(index), false);
        }
    }
    calls
}

/// The calls of which the callee is known.
#[derive(Debug, Default)]
pub(super) struct Callees {
    /// By block.
    pub(super) blocks: BTreeMap<usize, Arc<Callee>>,
    /// By the definition that makes it a cycle.
    pub(super) cycles: BTreeMap<usize, Arc<Callee>>,
    /// The definitions that make programs cycles.
    pub(super) made: BTreeSet<usize>,
}

impl Callees {
    pub(super) fn of(facts: &Facts<'_>) -> Self {
        let made = facts.definitions.iter().enumerate().filter(|(_, own)| makes_cycle(own)).map(|(index, _)| index);
        let mut known = Self { made: made.collect(), ..Self::default() };
        for call in &facts.calls {
            if let Called::Is { callee, round: false } = &call.called {
                let (map, key) = match call.cycle {
                    Some(definition) => (&mut known.cycles, definition),
                    None => (&mut known.blocks, call.block),
                };
                map.insert(key, Arc::clone(callee));
            }
        }
        known
    }
}
