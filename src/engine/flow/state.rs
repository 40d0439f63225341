//! A run: a program under execution with all that belongs to it.
//!
//! Its parts know nothing of each other: the drives move the machine, the contour holds back what the next element
//! decides, calls know where the program is, parameters have values. What needs several of them is written for the run:
//! values and calls of programs here in `flow`, execution of plans in `engine::cycle`, blocks in `engine::run`.
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::access::Access;
use super::calls::Calls;
use super::code::Prepared;
use super::definition::Definition;
use super::memory::Memory;
use super::settings::{Settings, Watching};
use super::sources::Sources;
use crate::base::expr::Value;
use crate::engine::contour::element::Element;
use crate::engine::contour::path::Contour;
use crate::engine::geometry::WorkingPlane;
use crate::engine::motion::drives::Drives;
use crate::engine::params::Params;
use crate::engine::plan::{self, Plan};
use crate::engine::report::ending::Done;
use crate::engine::report::envelope::Envelope;
use crate::engine::report::event::Event;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::report::outcome::{Noted, Shown};
use crate::engine::strategy::contour::Contours;
use crate::engine::strategy::digitizing::range::Digitizing;
use crate::program::syntax::{Motion, Path};
use crate::spec::{Cycle, CycleKey, OnControl};

/// A pole, or centre of circles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pole {
    /// Program coordinates by axis.
    pub(crate) at: DVec3,
    /// The plane of its two axes, where that is not the working plane.
    pub(crate) plane: Option<WorkingPlane>,
}

/// Modal data of the program.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Modal {
    /// The feed of the last F word, mm/min.
    pub(crate) feed: Option<f64>,
    /// The feed of the tool call.
    pub(crate) tool_feed: Option<f64>,
    /// The pole.
    pub(crate) pole: Option<Pole>,
    /// The pole of free contours, in the working plane.
    pub(crate) free_pole: Option<DVec2>,
    /// Whether every positioning block calls the last cycle (M89).
    pub(crate) call_always: bool,
    /// Whether the last positioning block went at rapid traverse.
    pub(crate) rapid: bool,
    /// The share of the feed at which the tool goes down along its axis (`M103`).
    pub(crate) plunge_factor: Option<f64>,
    /// Whether rotary axes take the shorter way (`M126`).
    pub(crate) shorter_way: bool,
    /// Whether the feed of a rotary axis is that at the tool (`M116`).
    pub(crate) feed_at_tool: bool,
}

/// Points by main, minor and tool axis.
pub(crate) type Pattern = Vec<DVec3>;

/// How high the tool is retracted on a pattern.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Retraction {
    /// To the greater of the two heights below, as a program says that says nothing.
    #[default]
    Greater,
    /// To the second set-up clearance.
    Second,
    /// To where the tool was when the pattern was called.
    Start,
}

/// Where cycles are called by `CYCL CALL PAT`.
#[derive(Default)]
pub(crate) struct Patterns {
    /// The points of the last pattern definition or point table.
    pub(crate) points: Option<Pattern>,
    /// Whether it was written in the program, and not read from a point table.
    pub(crate) is_defined: bool,
    /// How high the tool is retracted on patterns.
    pub(crate) retraction: Retraction,
}

/// The cycles of a run: what is defined, and what is executed.
#[derive(Default)]
pub(crate) struct Cycles<'e> {
    /// The cycle that a call executes.
    pub(crate) last: Option<Arc<Definition<'e>>>,
    /// Whether a cycle was passed over that no description says how to execute: a call without a later one does nothing.
    pub(crate) passed_over: bool,
    /// How many cycles were defined.
    pub(crate) definitions: u64,
    /// Values of GLOBAL DEF by the parameter that takes them, with mm in the unit of their program.
    pub(crate) predefined: BTreeMap<u16, (f64, f64)>,
    /// What cycles that act from their definition have remembered for others, by name.
    pub(crate) remembered: BTreeMap<Arc<str>, Value>,
    /// The contours that the cycle being executed machines.
    pub(crate) contours: Contours,
    /// Where contours come from.
    pub(crate) sources: Sources,
    /// The range for digitizing, and what was digitized.
    pub(crate) digitizing: Digitizing,
    /// Nested executions.
    pub(crate) inside: usize,
    /// What the cycle that is executed has written to tables: reported when it ends well.
    pub(crate) writing: Vec<Event>,
    plans: BTreeMap<CycleKey, Arc<Plan>>,
}

impl Cycles<'_> {
    /// The plan of a cycle, compiled when it is needed first.
    pub(crate) fn plan(&mut self, cycle: &Cycle, on: &OnControl, watching: &Watching<'_>) -> Done<Arc<Plan>> {
        if let Some(plan) = self.plans.get(&cycle.key) {
            return Ok(Arc::clone(plan));
        }
        let own = watching.filter(|(key, _)| *key == cycle.key);
        let kept;
        let compiled = match own {
            Some((_, watched)) => watched,
            None => {
                kept = plan::compiled(cycle, on);
                &kept
            }
        };
        if let Some(mistake) = compiled.mistakes.first() {
            let fault = Fault::new(Class::Internal, "plan-mistake").arg("reason", mistake.code);
            return Err(fault.arg("cycle", cycle.key.to_string()).into());
        }
        let plan = Arc::clone(&compiled.plan);
        self.plans.insert(cycle.key, Arc::clone(&plan));
        Ok(plan)
    }
}

/// A free contour whose elements were calculated ahead.
#[derive(Default)]
pub(crate) struct Solved {
    /// The program in which it is written.
    pub(crate) program: usize,
    /// Its elements that are not executed yet, each with its block.
    pub(crate) elements: VecDeque<(usize, Element)>,
    /// The blocks that select solutions of it.
    pub(crate) selections: Vec<usize>,
}

/// What a run leaves next to its events.
#[derive(Default)]
pub(crate) struct Records {
    /// Guards that applied.
    pub(crate) guards: BTreeSet<(CycleKey, Arc<str>)>,
    /// By cycle: which sentences of its plan were executed.
    pub(crate) executed: BTreeMap<CycleKey, Vec<bool>>,
    /// Names and texts of logs.
    pub(crate) logs: Vec<(String, String)>,
    /// Files that a mask has closed.
    pub(crate) closed: BTreeSet<String>,
    /// Logs shown on the screen.
    pub(crate) screens: Vec<String>,
    pub(crate) envelopes: Vec<Envelope>,
    /// Values noted.
    pub(crate) noted: Vec<Noted>,
}

/// Executes blocks until the calls that deep have returned, or to the end. Cycles call programs, and execute no blocks
/// themselves.
pub(crate) type Blocks<'r, 'e> = fn(&mut Run<'r, 'e>, usize) -> Done;

/// A run.
pub(crate) struct Run<'r, 'e> {
    pub(crate) settings: &'r Settings<'e>,
    /// The programs, and where they are executed.
    pub(crate) calls: Calls<'e>,
    pub(crate) blocks: Blocks<'r, 'e>,
    pub(crate) params: Params,
    pub(crate) modal: Modal,
    pub(crate) drives: Drives<'r, 'e>,
    /// The contour that radius compensation, a rounding or an approach has begun.
    pub(crate) contour: Contour,
    /// The free contour under way.
    pub(crate) free: Solved,
    pub(crate) cycles: Cycles<'e>,
    pub(crate) patterns: Patterns,
    pub(crate) records: Records,
    pub(crate) memory: Memory,
    /// Tables that the program reads and writes by itself.
    pub(crate) access: Access,
    /// The program that `SEL PGM` has selected.
    pub(crate) selected_program: Option<Arc<str>>,
    /// Room for the words of a movement.
    pub(crate) words: Motion,
}

impl<'r, 'e> Run<'r, 'e> {
    pub(crate) fn new(
        settings: &'r Settings<'e>,
        program: Prepared<'e>,
        drives: Drives<'r, 'e>,
        blocks: Blocks<'r, 'e>,
    ) -> Self {
        Self {
            settings,
            calls: Calls::new(program),
            blocks,
            params: Params::new(),
            modal: Modal::default(),
            drives,
            contour: Contour::default(),
            free: Solved::default(),
            cycles: Cycles::default(),
            patterns: Patterns::default(),
            records: Records::default(),
            memory: Memory::default(),
            access: Access::default(),
            selected_program: None,
            words: Motion::new(Path::L),
        }
    }

    /// Executes what waits of the contour: the tool ends next to its end.
    pub(crate) fn end_contour(&mut self) -> Done {
        self.contour.end(&mut self.drives)
    }

    /// The programmed position: that of the contour while the tool runs next to it.
    pub(crate) fn programmed(&self) -> DVec3 {
        self.contour.programmed(&self.drives.world)
    }

    /// What was executed of the cycles.
    pub(crate) fn shown(&mut self) -> Shown {
        let of_plan = |(key, plan): (&CycleKey, &Arc<Plan>)| {
            let executed = self.records.executed.get(key).map_or(&[][..], Vec::as_slice);
            let shown = plan.sentences.iter().zip(executed).filter(|(_, shown)| **shown);
            shown.map(|(sentence, _)| (*key, sentence.clone())).collect::<Vec<_>>()
        };
        let sentences = self.cycles.plans.iter().flat_map(of_plan).collect();
        Shown { sentences, guards: std::mem::take(&mut self.records.guards) }
    }
}
