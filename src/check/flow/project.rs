//! The files that a program refers to: the programs that it calls, and the tables that its rows and tools are in.
//!
//! Invariant: nothing here knows files; who checks says what a name in a program means ([`Project`]). What is not known
//! stays unknown and is passed over.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::call_effect::CallEffect;
use crate::base::diag::{Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::Against;
use crate::check::incident::Observed;
use crate::check::machine::Machine;
use crate::check::program::{Defined, Definition, Reading, bits, reads, with_meaning};
use crate::program::syntax::{BlockKind, CycleForm, Program, StatementKind, ValueKind};

/// The meaning of a parameter that names a program.
const PROGRAM: &str = "program-to-call";

/// The files that a program refers to, as the caller of the checker knows them.
pub trait Project: Sync {
    /// The program that a call names.
    fn called(&self, name: &str) -> Called;
    /// How bad it is that a file which the program names is not in its folder; nothing if it is there or not known.
    fn lacks_file(&self, _name: &str) -> Option<Severity> {
        None
    }
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
    /// The word in a column of the tool table; nothing if none is known.
    fn tool_word(&self, _tool: ToolName<'_>, _column: &str) -> Option<&str> {
        None
    }
    /// The type of a turning tool, as the table of turning tools has it; nothing if none is known.
    fn turning_type(&self, _tool: ToolName<'_>) -> Option<&str> {
        None
    }
    /// A number of a turning tool, as the table of turning tools has it, lengths in mm; nothing if none is known.
    fn turning_value(&self, _tool: ToolName<'_>, _column: &str) -> Option<f64> {
        None
    }
    /// What the machine can do, as far as anything is known of that.
    fn machine(&self) -> Option<&Machine> {
        None
    }
    /// What an execution of the program shows; nothing where it is not executed.
    fn observed(&self, _program: &Program) -> Vec<Observed> {
        Vec::new()
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
    /// Its number, with the step after the point.
    Number(f64),
    /// Its name.
    Name(&'n str),
}

/// What distinguishes tools.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::check) enum ToolKey<'n> {
    Number(u64),
    Name(&'n str),
}

impl<'n> ToolName<'n> {
    /// What distinguishes it from other tools.
    pub(in crate::check) fn key(self) -> ToolKey<'n> {
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
    pub(super) effect: CallEffect,
    /// The free parameters that it reads and has not given a value before, in the order of its text.
    pub wants: Vec<QRef>,
    /// Those that it gives a value; nothing if that is not certain.
    pub gives: Option<BTreeSet<QRef>>,
}

/// What a program wants of the parameters of its caller, and what it leaves in them.
fn exchanges(program: &Program) -> (Vec<QRef>, Option<BTreeSet<QRef>>) {
    let (mut wants, mut gives, mut certain, mut read) = (Vec::new(), BTreeSet::new(), true, Vec::new());
    for block in program.blocks() {
        read.clear();
        reads(block, &mut read);
        let free = |q: &QRef| q.kind == QKind::Q && q.number < 100 && !gives.contains(q) && !wants.contains(q);
        let new: Vec<QRef> = read.iter().map(|(q, _)| *q).filter(free).collect();
        if certain {
            wants.extend(new);
        }
        match &block.kind {
            BlockKind::FnAssign(own) => _ = gives.insert(own.target),
            BlockKind::Formula(own) => _ = gives.insert(own.target),
            BlockKind::Statement(own) => certain &= matches!(own.kind, StatementKind::Plane | StatementKind::Trans),
            BlockKind::CallPgm(_) | BlockKind::Unknown(_) | BlockKind::OldCycleLine(_) => certain = false,
            _ => {}
        }
    }
    (wants, certain.then_some(gives))
}

impl Callee {
    /// One with that effect.
    pub(super) fn new(program: &Program, effect: CallEffect) -> Self {
        let (wants, gives) = exchanges(program);
        Self { inch: inch(program), effect, wants, gives }
    }

    /// One that may do anything.
    pub fn anything(program: &Program) -> Self {
        Self::new(program, CallEffect::anything())
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
    /// Where its name is.
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
    let calls = calls(&Reading::of(program, against), None);
    calls.iter().filter(|call| !call.read).map(|call| name(program, call.span).to_owned()).collect()
}

/// A program's name as calls know it.
pub(in crate::check) fn name(program: &Program, span: Span) -> &str {
    program.slice(span).trim().trim_matches('"').trim()
}

/// The calls of a program with what is known of them.
pub(in crate::check) fn calls(reading: &Reading<'_>, project: Option<&dyn Project>) -> Vec<ProgramCall> {
    let mut calls = places(reading);
    if let Some(project) = project {
        for call in &mut calls {
            call.called = match project.called(name(reading.program, call.span)) {
                Called::Is { .. } if call.read => Called::Unknown,
                called => called,
            };
        }
    }
    calls
}

/// Whether a definition makes a program a cycle.
fn makes_cycle(definition: &Defined<'_>) -> bool {
    definition.related_cycle().is_some_and(|cycle| with_meaning(cycle, PROGRAM).is_some())
}

fn places(reading: &Reading<'_>) -> Vec<ProgramCall> {
    let program = reading.program;
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
    for (index, definition) in reading.definitions.iter().enumerate().filter(|(_, own)| makes_cycle(own)) {
        let related = definition.as_related_cycle();
        let named = Definition::of(program, &related).item(PROGRAM).map(|item| item.value_span);
        if let Some(span) = named.or_else(|| bare_name(program, definition)) {
            push(definition.view.first, span, Some(index), false);
        }
    }
    calls
}

/// The name of a program that a line gives without the word before it, as older controls write it.
fn bare_name(program: &Program, definition: &Defined<'_>) -> Option<Span> {
    let CycleForm::Lines(lines) = &definition.view.form else { return None };
    let line = lines.iter().find(|line| line.line == 1)?;
    let own = program.blocks().get(definition.view.first..=definition.view.last)?;
    let block = own.iter().find(|block| block.span.start <= line.head.start && line.head.end <= block.span.end)?;
    let text = program.slice(Span::new(line.head.end, block.span.end));
    let code = text.split([';', '\n', '\r']).next().unwrap_or_default();
    let name = code.trim();
    let from = line.head.end + (code.len() - code.trim_start().len());
    (!name.is_empty() && !name.contains(char::is_whitespace)).then(|| Span::new(from, from + name.len()))
}

/// The calls of which the callee is known.
#[derive(Debug, Default)]
pub(in crate::check) struct Callees {
    /// By block.
    pub(super) blocks: BTreeMap<usize, Arc<Callee>>,
    /// By the definition that makes it a cycle.
    pub(super) cycles: BTreeMap<usize, Arc<Callee>>,
    /// The definitions that make programs cycles.
    pub(super) made: BTreeSet<usize>,
}

impl Callees {
    pub(in crate::check) fn of(reading: &Reading<'_>, calls: &[ProgramCall]) -> Self {
        let made = reading.definitions.iter().enumerate().filter(|(_, own)| makes_cycle(own)).map(|(index, _)| index);
        let mut known = Self { made: made.collect(), ..Self::default() };
        for call in calls {
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
    /// Whether the program has a call of one that may define or call cycles.
    pub(in crate::check) fn leave_open(&self, reading: &Reading<'_>) -> bool {
        reading.marked().any(|(index, block)| {
            let calls = match &block.kind {
                BlockKind::CallPgm(_) => true,
                BlockKind::Statement(statement) => statement.kind == StatementKind::CallSelected,
                _ => false,
            };
            calls && self.blocks.get(&index).is_none_or(|callee| callee.effect.calls_cycle)
        })
    }
}
