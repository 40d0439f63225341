//! The interpreter: executes a program in the world of a scene and tells what happens as events.
//!
//! Cycles are executed from their plans, so a specification and its execution cannot differ. Invariant: knows no
//! cycle by number, reads and writes no files, prints nothing; the same program, scene and control give the same
//! events.
mod align;
mod block;
mod clear;
mod face;
mod measure;
mod plunge;
mod program;
mod strategy;
mod stud;
mod thread;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::DVec3;

pub use super::flow::calls::program_key;
pub use super::flow::params::Params;
pub use super::report::envelope::{Ended, Envelope, FORMAT as ENVELOPE_FORMAT, Near, Obstacle, Touching};
pub use super::report::event::{
    At, Content, Coordinates, Event, EventKind, FORMAT, FindingKind, MessageKind, MoveKind, Probing, Status, Threaded,
    Turned,
};
pub use super::report::fault::{CODES, Class, Fault};
pub use super::report::foreign_outcome::Told;
pub use super::report::trace::{Trace, Traced};
pub use super::world::coordinates::System;
pub use super::world::state::Tool;

use super::contour::{outline, path as contour};
use super::cycle::{execute as cycle, pattern, recall};
use super::flow::calls as flow;
use super::flow::code::Prepared;
use super::flow::definition::Definition;
use super::geometry::WorkingPlane;
use super::motion::{moves as motion, probe};
use super::plan::{self, Plan, Sentence};
use super::report::{envelope, fault, threads};
use super::scene::Scene;
use super::solid::Path;
use super::world::state::World;
use super::world::stylus::OfMachine;
use crate::base::diag::{Arg, Diagnostic, Place};
use crate::program::syntax::Program;
use crate::spec::{Catalogue, Cycle, CycleKey, OnControl};

/// Texts that a run needs for logs, in the language of the program.
pub trait Texts {
    /// The text of a message of the locale files.
    ///
    /// # Errors
    /// The message is missing or cannot be formatted.
    fn message(&self, id: &str, args: &[(&str, Arg)]) -> Result<String, Diagnostic>;

    /// The template of a log: the extension of its file and its text.
    fn template(&self, name: &str) -> Option<(String, String)>;
}

/// Texts for runs that write no log: every look-up fails.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoTexts;

impl Texts for NoTexts {
    fn message(&self, id: &str, _: &[(&str, Arg)]) -> Result<String, Diagnostic> {
        Err(Diagnostic::global("log-text").arg("reason", id))
    }

    fn template(&self, _: &str) -> Option<(String, String)> {
        None
    }
}

/// Programs that are looked for when they are called.
pub trait Programs {
    /// The program that is called by this [key](program_key), if there is one.
    fn program(&self, key: &str) -> Option<&Program>;
}

/// How much a run may do before it ends with a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Blocks executed.
    pub blocks: u64,
    /// Jumps back, repeats and calls.
    pub jumps: u64,
    /// Nested calls of subprograms and programs.
    pub depth: usize,
    /// Members of one series.
    pub members: u32,
    /// Moves of the tool, also those of cycles.
    pub moves: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { blocks: 10_000_000, jumps: 1_000_000, depth: 19, members: 100_000, moves: 10_000_000 }
    }
}

/// A sentence or guard of a cycle that a run has shown.
#[derive(Clone, Debug, Default)]
pub struct Shown {
    /// Steps and bullets executed.
    pub sentences: BTreeSet<(CycleKey, Sentence)>,
    /// Guards that applied, by code.
    pub guards: BTreeSet<(CycleKey, Arc<str>)>,
}

/// What came out of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Why, if it ended before its end.
    pub fault: Option<Fault>,
    /// The fault with its place in the program and the calls that led there.
    pub diagnostic: Option<Diagnostic>,
    /// Names and texts of the tables that were written.
    pub tables: Vec<(String, String)>,
    /// Names and texts of the logs that were written.
    pub logs: Vec<(String, String)>,
    /// The texts of the logs that were shown on the screen.
    pub screens: Vec<String>,
    /// The Q parameters at the end.
    pub params: Params,
    /// The tool tip at the end, in program coordinates.
    pub position: DVec3,
    /// The rotary axes at the end, in program coordinates.
    pub angles: DVec3,
    /// What was executed of the cycles.
    pub shown: Shown,
    /// What the probing cycles would do in the worst case, if that was asked for.
    pub envelopes: Vec<Envelope>,
}

/// A program, a control and a world, ready to run.
pub struct Engine<'e> {
    pub(in crate::engine) program: &'e Program,
    pub(in crate::engine) others: BTreeMap<String, &'e Program>,
    pub(in crate::engine) around: Option<&'e dyn Programs>,
    pub(in crate::engine) on: &'e OnControl,
    pub(in crate::engine) scene: &'e Scene,
    pub(in crate::engine) texts: &'e dyn Texts,
    pub(in crate::engine) limits: Limits,
    pub(in crate::engine) skip_blocks: bool,
    pub(in crate::engine) envelope: bool,
    /// Other controls, for cycles that the manual of this one only names.
    pub(in crate::engine) others_on: Vec<&'e OnControl>,
}

impl<'e> Engine<'e> {
    /// A run of the program on the control in the world of the scene.
    pub fn new(program: &'e Program, on: &'e OnControl, scene: &'e Scene, texts: &'e dyn Texts) -> Self {
        let limits = Limits::default();
        let (others, around, others_on) = (BTreeMap::new(), None, Vec::new());
        Self { program, others, around, on, scene, texts, limits, skip_blocks: false, envelope: false, others_on }
    }

    /// The same with other limits.
    #[must_use]
    pub const fn with_limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// The same with a program that others can call by that name (file name, extension and case do not matter).
    #[must_use]
    pub fn with_program(mut self, name: &str, program: &'e Program) -> Self {
        self.others.insert(flow::program_key(name), program);
        self
    }

    /// The same with programs that are looked for when they are called.
    #[must_use]
    pub const fn with_programs(mut self, around: &'e dyn Programs) -> Self {
        self.around = Some(around);
        self
    }

    /// The same with the descriptions of the other controls for cycles that the manual of this one only names, such
    /// as a datum shift before probing. Later generations first: their names sort last.
    #[must_use]
    pub fn with_catalogue(mut self, catalogue: &'e Catalogue) -> Self {
        self.others_on = catalogue.controls.values().filter(|other| other.id() != self.on.id()).rev().collect();
        self
    }

    /// The same with blocks that begin with `/` left out.
    #[must_use]
    pub const fn skipping_blocks(mut self) -> Self {
        self.skip_blocks = true;
        self
    }

    /// The same with an account of what each probing cycle would do in the worst case. A cycle that fails in the scene
    /// does not end such a run, if it could be rehearsed.
    #[must_use]
    pub const fn with_envelope(mut self) -> Self {
        self.envelope = true;
        self
    }

    /// Runs the program to its end and hands out every event.
    pub fn run(&self, emit: &mut dyn FnMut(Event)) -> Outcome {
        self.observe(&mut |event| emit(event.clone()))
    }

    /// Runs the program to its end and shows every event: what is not kept is never copied.
    pub fn observe(&self, see: &mut dyn FnMut(&Event)) -> Outcome {
        let world = match World::new(self.scene, OfMachine::new(self.on, self.scene)) {
            Ok(world) => world,
            Err(error) => return self.not_started(error.into(), see),
        };
        let mut run = Run::new(self, Prepared::new(self.program), world, see);
        let end = run.program();
        run.finish(end)
    }

    fn not_started(&self, fault: Fault, see: &mut dyn FnMut(&Event)) -> Outcome {
        let at = At { program: self.program.source().name().into(), ..At::default() };
        let status = fault.class.status();
        see(&Event { at: at.clone(), kind: EventKind::Error(fault.clone()) });
        see(&Event { at, kind: EventKind::End(status) });
        Outcome {
            status,
            diagnostic: Some(fault.diagnostic(None)),
            fault: Some(fault),
            tables: Vec::new(),
            logs: Vec::new(),
            screens: Vec::new(),
            params: Params::new(),
            position: DVec3::ZERO,
            angles: DVec3::ZERO,
            shown: Shown::default(),
            envelopes: Vec::new(),
        }
    }
}

/// Why execution leaves the straight way.
#[derive(Clone, Debug)]
pub(in crate::engine) enum Leave {
    /// With a fault.
    Fault(Fault),
    /// The program stopped and nobody continued it.
    Stopped,
}

impl<F: Into<Fault>> From<F> for Leave {
    fn from(fault: F) -> Self {
        Self::Fault(fault.into())
    }
}

/// What executing something gives.
pub(in crate::engine) type Done<T = ()> = Result<T, Leave>;

/// The spindle as the program set it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::engine) struct Spindle {
    pub(in crate::engine) speed: f64,
    pub(in crate::engine) direction: i8,
}

/// A pole, or centre of circles.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct Pole {
    /// Program coordinates by axis.
    pub(in crate::engine) at: DVec3,
    /// The plane of its two axes, where that is not the working plane.
    pub(in crate::engine) plane: Option<WorkingPlane>,
}

/// Modal data of the program.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::engine) struct Modal {
    /// The feed of the last F word, mm/min.
    pub(in crate::engine) feed: Option<f64>,
    /// The feed of the tool call.
    pub(in crate::engine) tool_feed: Option<f64>,
    pub(in crate::engine) spindle: Spindle,
    pub(in crate::engine) coolant: bool,
    /// The angle to which M19 and M20 orient the spindle.
    pub(in crate::engine) orientation: f64,
    /// The pole.
    pub(in crate::engine) pole: Option<Pole>,
    /// Whether every positioning block calls the last cycle (M89).
    pub(in crate::engine) call_always: bool,
    /// Whether the last positioning block went at rapid traverse.
    pub(in crate::engine) rapid: bool,
}

/// A run.
pub(in crate::engine) struct Run<'r, 'e> {
    pub(in crate::engine) engine: &'r Engine<'e>,
    pub(in crate::engine) see: &'r mut dyn FnMut(&Event),
    pub(in crate::engine) programs: Vec<Prepared<'e>>,
    /// Programs that were called, by name.
    pub(in crate::engine) names: BTreeMap<String, usize>,
    pub(in crate::engine) plans: BTreeMap<CycleKey, Arc<Plan>>,
    pub(in crate::engine) world: World<'e>,
    pub(in crate::engine) params: Params,
    pub(in crate::engine) modal: Modal,
    pub(in crate::engine) last_cycle: Option<Arc<Definition<'e>>>,
    /// How many cycles were defined.
    pub(in crate::engine) definitions: u64,
    /// What the named values of a definition were when it was called last.
    pub(in crate::engine) recall: Option<recall::Recall>,
    /// The points of the last pattern definition or point table.
    pub(in crate::engine) pattern: Option<pattern::Pattern>,
    /// Whether it was written in the program, and not read from a point table.
    pub(in crate::engine) pattern_is_defined: bool,
    /// Values of GLOBAL DEF by the parameter that takes them, with mm in the unit of their program.
    pub(in crate::engine) predefined: BTreeMap<u16, (f64, f64)>,
    /// How high the tool is retracted on patterns.
    pub(in crate::engine) retraction: pattern::Retraction,
    pub(in crate::engine) flow: flow::Flow,
    /// The contour that radius compensation, a rounding or an approach has begun.
    pub(in crate::engine) contour: contour::Contour,
    /// The event told last; its place is that of what is executed now.
    pub(in crate::engine) event: Event,
    /// Guards that applied.
    pub(in crate::engine) guards: BTreeSet<(CycleKey, Arc<str>)>,
    /// By cycle: which sentences of its plan were executed.
    pub(in crate::engine) executed: BTreeMap<CycleKey, Vec<bool>>,
    pub(in crate::engine) logs: Vec<(String, String)>,
    /// Logs shown on the screen.
    pub(in crate::engine) screens: Vec<String>,
    /// Nested executions of cycles.
    pub(in crate::engine) inside: usize,
    /// Moves of the tool so far.
    pub(in crate::engine) moves: u64,
    /// Whether a cycle is executed that probes.
    pub(in crate::engine) probing: bool,
    /// mm in the unit in which the cycle being executed calculates.
    pub(in crate::engine) calculating_in: f64,
    /// What the cycle that is executed has written to tables: told when it ends well.
    pub(in crate::engine) writing: Vec<Event>,
    /// What stops the probe.
    pub(in crate::engine) touching: envelope::Touching,
    /// The ways of the cycle whose envelope is looked for.
    pub(in crate::engine) recorder: Option<envelope::Recorder>,
    pub(in crate::engine) envelopes: Vec<Envelope>,
    /// Memory for the next execution of a cycle.
    pub(in crate::engine) spare: cycle::Spare,
    /// The threads that are being cut.
    pub(in crate::engine) threads: threads::Threads,
}

impl<'r, 'e> Run<'r, 'e> {
    fn new(engine: &'r Engine<'e>, program: Prepared<'e>, world: World<'e>, see: &'r mut dyn FnMut(&Event)) -> Self {
        let at = At { program: engine.program.source().name().into(), ..At::default() };
        Self {
            engine,
            see,
            flow: flow::Flow::new(&program),
            programs: vec![program],
            names: BTreeMap::new(),
            plans: BTreeMap::new(),
            world,
            params: Params::new(),
            modal: Modal::default(),
            last_cycle: None,
            definitions: 0,
            recall: None,
            pattern: None,
            pattern_is_defined: false,
            predefined: BTreeMap::new(),
            contour: contour::Contour::default(),
            retraction: pattern::Retraction::default(),
            event: Event { at, kind: EventKind::End(Status::Done) },
            guards: BTreeSet::new(),
            executed: BTreeMap::new(),
            logs: Vec::new(),
            screens: Vec::new(),
            inside: 0,
            moves: 0,
            probing: false,
            calculating_in: 1.0,
            writing: Vec::new(),
            touching: envelope::Touching::AsScene,
            recorder: None,
            envelopes: Vec::new(),
            spare: cycle::Spare::default(),
            threads: threads::Threads::default(),
        }
    }

    /// Tells what happens here, unless it only happens in a rehearsal.
    #[inline]
    pub(in crate::engine) fn tell(&mut self, kind: EventKind) {
        self.event.kind = kind;
        self.tell_it();
    }

    /// Tells the event that is there.
    pub(in crate::engine) fn tell_it(&mut self) {
        if self.contour.holds_events() {
            self.contour.hold(self.event.clone());
        } else if self.touching == Touching::AsScene {
            if let Some(thread) = self.threads.see(&self.event) {
                (self.see)(&thread);
            }
            (self.see)(&self.event);
        }
    }

    /// Tells a move; where one was told before, only its numbers change.
    pub(in crate::engine) fn tell_move(
        &mut self,
        kind: MoveKind,
        from: DVec3,
        to: DVec3,
        machine: DVec3,
        feed: f64,
        path: Path,
    ) {
        match &mut self.event.kind {
            EventKind::Move { kind: a, from: b, to: c, machine: d, feed: e, path: f } => {
                (*a, *b, *c, *d, *e, *f) = (kind, from, to, machine, feed, path);
            }
            other => *other = EventKind::Move { kind, from, to, machine, feed, path },
        }
        self.tell_it();
    }

    /// Tells an event that has waited.
    pub(in crate::engine) fn tell_later(&mut self, event: Event) {
        let at = std::mem::replace(&mut self.event.at, event.at);
        self.tell(event.kind);
        self.event.at = at;
    }

    /// The plan of a cycle, compiled when it is needed first.
    pub(in crate::engine) fn plan(&mut self, cycle: &Cycle, on: &OnControl) -> Done<Arc<Plan>> {
        if let Some(plan) = self.plans.get(&cycle.key) {
            return Ok(Arc::clone(plan));
        }
        let (plan, mistakes) = plan::compile(cycle, on);
        if let Some(mistake) = mistakes.first() {
            let fault = Fault::new(Class::Internal, "plan-mistake").arg("reason", mistake.code);
            return Err(fault.arg("cycle", cycle.key.to_string()).into());
        }
        let plan = Arc::new(plan);
        self.plans.insert(cycle.key, Arc::clone(&plan));
        Ok(plan)
    }

    /// What was executed of the cycles.
    pub(in crate::engine) fn shown(&mut self) -> Shown {
        let of_plan = |(key, plan): (&CycleKey, &Arc<Plan>)| {
            let executed = self.executed.get(key).map_or(&[][..], Vec::as_slice);
            let shown = plan.sentences.iter().zip(executed).filter(|(_, shown)| **shown);
            shown.map(|(sentence, _)| (*key, sentence.clone())).collect::<Vec<_>>()
        };
        let sentences = self.plans.iter().flat_map(of_plan).collect();
        Shown { sentences, guards: std::mem::take(&mut self.guards) }
    }

    fn finish(mut self, end: Done) -> Outcome {
        for event in self.contour.abandon() {
            (self.see)(&event);
        }
        let (status, fault) = match end {
            Ok(()) => (Status::Done, None),
            Err(Leave::Stopped) => (Status::Stopped, None),
            Err(Leave::Fault(fault)) => {
                self.tell(EventKind::Error(fault.clone()));
                (fault.class.status(), Some(fault))
            }
        };
        let diagnostic = fault.as_ref().map(|fault| {
            let blamed = self.contour.blamed().and_then(|(program, block)| self.place_of(program, block));
            let mut diagnostic = fault.diagnostic(blamed.or_else(|| self.place()));
            let calls = self.flow.calls().filter_map(|(program, block)| self.place_of(program, block));
            diagnostic.related.extend(calls.map(|place| ("called-here", place)));
            diagnostic
        });
        self.event.at.cycle = None;
        self.tell(EventKind::End(status));
        let shown = self.shown();
        Outcome {
            status,
            fault,
            diagnostic,
            tables: self.world.written(),
            logs: self.logs,
            screens: self.screens,
            params: self.params,
            position: self.world.here,
            angles: self.world.program_angles(),
            shown,
            envelopes: self.envelopes,
        }
    }

    pub(in crate::engine) fn place(&self) -> Option<Place> {
        self.place_of(self.flow.program, self.flow.block)
    }

    pub(in crate::engine) fn place_of(&self, program: usize, block: usize) -> Option<Place> {
        let prepared = self.programs.get(program)?;
        let block = prepared.block(block)?;
        let text = prepared.program.slice(block.span);
        // Line ends and blanks are no part of what is shown.
        let start = block.span.start + (text.len() - text.trim_start().len());
        Some(Place::new(prepared.program.source(), start..(block.span.start + text.trim_end().len()).max(start)))
    }
}
