//! What cycles take away in an execution: one that mills or drills, and removes nothing at all, works in the air.
//!
//! Each call of a cycle is one piece of work, as are calls from one block in a row. Left out are cycles that finish, as
//! they may take away less than the columns of the stock show; threads, reamed and bored holes for the same reason;
//! tools that are hardly wider than a column or take away an oversize of their own; and what the stock could not follow.
use std::collections::BTreeSet;

use crate::check::{ToolKind, is_reaming};
use crate::engine::run::{Event, EventKind, MoveKind};
use crate::program::fields::key;
use crate::program::syntax::{CycleForm, Program, ValueKind};
use crate::spec::{Catalogue, Cycle, CycleKey, Group, Keyword, OnControl, Param};

/// The code of a cycle that removes nothing.
pub const IDLE: &str = "cycle-removes-nothing";
/// The meaning of the choice between roughing and finishing, and the values of it that rough.
const OPERATION: &str = "machining-operation";
const ROUGHS: [f64; 2] = [0.0, 1.0];
/// A tool is so many times as wide as a column at least: then one of them is certainly below it.
const COLUMNS: f64 = 1.5;
/// So many oversizes are remembered.
const MOST: usize = 1 << 8;

/// What a cycle does at one call.
struct Work {
    key: CycleKey,
    line: usize,
    /// The events of its moves at feed, by their numbers in the stock.
    first: u64,
    last: u64,
    /// Whether something of it was not followed.
    hidden: bool,
}

/// The work of a run.
pub struct Works<'w> {
    on: &'w OnControl,
    catalogue: &'w Catalogue,
    program: &'w Program,
    /// The cycles of the program that do not always rough.
    finishing: BTreeSet<CycleKey>,
    /// How wide a column of the stock is, mm.
    column: f64,
    /// What the tool in the spindle is called, and whether it is wide enough.
    kinds: Vec<(f64, ToolKind)>,
    kind: Option<ToolKind>,
    wide: bool,
    /// The oversizes with which each tool was called, and whether that of the last call is smaller than one before.
    oversizes: Vec<(f64, f64)>,
    thin: bool,
    all: Vec<Work>,
    seen: u64,
}

impl<'w> Works<'w> {
    /// Before the run, with what the tools are called and the width of a column.
    pub fn new(
        (on, catalogue): (&'w OnControl, &'w Catalogue),
        program: &'w Program,
        kinds: Vec<(f64, ToolKind)>,
        column: f64,
    ) -> Self {
        let mut works = Self {
            on,
            catalogue,
            program,
            finishing: BTreeSet::new(),
            column,
            kinds,
            kind: None,
            wide: false,
            oversizes: Vec::new(),
            thin: false,
            all: Vec::new(),
            seen: 0,
        };
        works.finishing = works.finish();
        works
    }

    /// Takes an event; `followed` says whether the stock sees it.
    pub fn see(&mut self, event: &Event, followed: bool) {
        self.seen += u64::from(followed);
        match &event.kind {
            EventKind::Spindle { tool: Some((tool, _)), .. } => {
                self.kind = self.kinds.iter().find(|(number, _)| *number == tool.number).map(|(_, kind)| *kind);
                self.wide = 2.0 * tool.radius > COLUMNS * self.column;
                let (number, own) = (tool.number, tool.deltas.0);
                self.thin = self.oversizes.iter().any(|(other, before)| *other == number && own < *before);
                if self.oversizes.len() < MOST && !self.oversizes.contains(&(number, own)) {
                    self.oversizes.push((number, own));
                }
            }
            EventKind::Move { kind: MoveKind::Rapid | MoveKind::Arc { rapid: true, .. }, .. } => {}
            EventKind::Move { turned, .. } => {
                let own = *event.at.program == *self.program.source().name();
                let Some((key, _)) = event.at.cycle.as_ref().filter(|_| own && turned.is_none()) else { return };
                if !self.removes(*key) {
                    return;
                }
                let line = event.at.line;
                match self.all.last_mut().filter(|work| work.key == *key && work.line == line) {
                    Some(work) => (work.last, work.hidden) = (self.seen, work.hidden || !followed),
                    None => {
                        let (first, last) = (self.seen, self.seen);
                        self.all.push(Work { key: *key, line, first, last, hidden: !followed });
                    }
                }
            }
            _ => {}
        }
    }

    /// The first line at which a cycle removes nothing, with the cycle. `cuts` are the events that have removed
    /// something, in their order.
    pub fn idle(&self, cuts: &[u64]) -> Option<(usize, CycleKey)> {
        let cuts_in = |work: &Work| {
            let from = cuts.partition_point(|event| *event < work.first);
            cuts.get(from).is_some_and(|event| *event <= work.last)
        };
        self.all.iter().find(|work| !work.hidden && !cuts_in(work)).map(|work| (work.line, work.key))
    }

    /// Whether a cycle takes away so much with this tool that the stock shows it.
    fn removes(&self, key: CycleKey) -> bool {
        let Some(cycle) = self.cycle(key).filter(|_| self.wide && !self.thin && key.keyword == Keyword::CyclDef) else {
            return false;
        };
        let has = |meaning: &str| parameter(cycle, meaning).is_some();
        match cycle.file.group {
            Group::Pockets => has(OPERATION) && !self.finishing.contains(&key),
            Group::Surfaces => has("starting-point-tool"),
            Group::Drilling => has("plunging-depth") && self.kind == Some(ToolKind::Drill) && !is_reaming(cycle),
            _ => false,
        }
    }

    /// The cycles of which a definition does not rough, or does so as a parameter says.
    fn finish(&self) -> BTreeSet<CycleKey> {
        let mut found = BTreeSet::new();
        self.program.each_cycle(|view| {
            let key = key(view.keyword, view.number);
            let operation = self.cycle(key).and_then(|cycle| parameter(cycle, OPERATION)).and_then(|own| own.q);
            let (Some(q), CycleForm::Parameters(definition)) = (operation, &view.form) else { return };
            let mut written = definition.parameters.iter().filter(|own| own.q == q);
            let roughs = |kind: ValueKind| matches!(kind, ValueKind::Number(number) if ROUGHS.contains(&number));
            if !written.next().is_some_and(|own| roughs(own.value.kind)) {
                found.insert(key);
            }
        });
        found
    }

    fn cycle(&self, key: CycleKey) -> Option<&'w Cycle> {
        self.on.cycles.get(&key).or_else(|| self.catalogue.describing(key).map(|(_, cycle)| cycle))
    }
}

/// The parameter of a cycle that has a meaning.
fn parameter<'c>(cycle: &'c Cycle, meaning: &str) -> Option<&'c Param> {
    cycle.params.iter().find(|param| param.is.as_str() == meaning)
}
