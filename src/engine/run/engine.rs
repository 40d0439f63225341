//! A program, a control and a scene, ready to run; and what comes out of the run.
use std::collections::BTreeMap;

use glam::DVec3;

use crate::engine::flow::calls::program_key;
use crate::engine::flow::code::Prepared;
use crate::engine::flow::settings::{Limits, Programs, Settings, Texts};
use crate::engine::flow::state::Run;
use crate::engine::motion::drives::Drives;
use crate::engine::params::Params;
use crate::engine::plan::Compiled;
use crate::engine::report::ending::{Done, Leave};
use crate::engine::report::envelope::Touching;
use crate::engine::report::event::{At, Event, EventKind, Status};
use crate::engine::report::fault::Fault;
use crate::engine::report::outcome::{Outcome, Shown};
use crate::engine::report::reporter::Reporter;
use crate::engine::scene::Scene;
use crate::engine::world::state::World;
use crate::engine::world::stylus::OfMachine;
use crate::program::syntax::Program;
use crate::spec::{Catalogue, CycleKey, OnControl};

/// A program, a control and a world, ready to run.
pub struct Engine<'e> {
    program: &'e Program,
    scene: &'e Scene,
    settings: Settings<'e>,
}

impl<'e> Engine<'e> {
    /// A run of the program on the control in the world of the scene.
    pub fn new(program: &'e Program, on: &'e OnControl, scene: &'e Scene, texts: &'e dyn Texts) -> Self {
        let settings = Settings {
            others: BTreeMap::new(),
            around: None,
            on,
            texts,
            limits: Limits::default(),
            skip_blocks: false,
            envelope: false,
            after_faults: false,
            touching: Touching::AsScene,
            others_on: Vec::new(),
            watching: None,
        };
        Self { program, scene, settings }
    }

    /// The same with other limits.
    #[must_use]
    pub const fn with_limits(mut self, limits: Limits) -> Self {
        self.settings.limits = limits;
        self
    }

    /// The same with a program that others can call by that name (file name, extension and case do not matter).
    #[must_use]
    pub fn with_program(mut self, name: &str, program: &'e Program) -> Self {
        self.settings.others.insert(program_key(name), program);
        self
    }

    /// The same with programs that are looked for when they are called.
    #[must_use]
    pub const fn with_programs(mut self, around: &'e dyn Programs) -> Self {
        self.settings.around = Some(around);
        self
    }

    /// The same with the descriptions of the other controls for cycles that the manual of this one only names, such
    /// as a datum shift before probing. Later generations first: their names sort last.
    #[must_use]
    pub fn with_catalogue(mut self, catalogue: &'e Catalogue) -> Self {
        self.settings.others_on =
            catalogue.controls.values().filter(|other| other.id() != self.settings.on.id()).rev().collect();
        self
    }

    /// The same with blocks that begin with `/` left out.
    #[must_use]
    pub const fn skipping_blocks(mut self) -> Self {
        self.settings.skip_blocks = true;
        self
    }

    /// The same with an account of what each probing cycle would do in the worst case. A cycle that fails in the scene
    /// does not end such a run, if it could be rehearsed.
    #[must_use]
    pub const fn with_envelope(mut self) -> Self {
        self.settings.envelope = true;
        self
    }

    /// The same with a part that lies, and a tool that is, exactly as the cycles that probe them are entered, whatever the
    /// scene has: each probing finds its touch point at the clearance of the cycle, and nothing collides.
    #[must_use]
    pub const fn touching_as_expected(mut self) -> Self {
        self.settings.touching = Touching::AsExpected;
        self
    }

    /// The same, and the program goes on where it can: a cycle that is called and does not come to its end is left with
    /// an event that says why, one that nobody describes is passed over, and values that a definition has in addition,
    /// lacks or has out of their range do not matter.
    #[must_use]
    pub const fn going_on_after_faults(mut self) -> Self {
        self.settings.after_faults = true;
        self
    }

    /// The same with a run of a cycle that notes values each time that a step of it has been executed.
    #[must_use]
    pub const fn watching(mut self, cycle: CycleKey, watched: &'e Compiled) -> Self {
        self.settings.watching = Some((cycle, watched));
        self
    }

    /// Runs the program to its end and hands out every event.
    pub fn run(&self, emit: &mut dyn FnMut(Event)) -> Outcome {
        self.observe(&mut |event| emit(event.clone()))
    }

    /// Runs the program to its end and shows every event: what is not kept is never copied.
    pub fn observe(&self, emit: &mut dyn FnMut(&Event)) -> Outcome {
        let world = match World::new(self.scene, OfMachine::new(self.settings.on, self.scene)) {
            Ok(world) => world,
            Err(error) => return self.not_started(error.into(), emit),
        };
        let report = Reporter::new(self.program.source().name().into(), emit);
        let mut drives = Drives::new(world, report, self.settings.limits.moves);
        drives.touch(self.settings.touching);
        let mut run = Run::new(&self.settings, Prepared::new(self.program), drives, Run::blocks);
        let end = run.program();
        finish(run, end)
    }

    fn not_started(&self, fault: Fault, emit: &mut dyn FnMut(&Event)) -> Outcome {
        let at = At { program: self.program.source().name().into(), ..At::default() };
        let status = fault.class.status();
        emit(&Event { at: at.clone(), kind: EventKind::Error(fault.clone()) });
        emit(&Event { at, kind: EventKind::End(status) });
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
            noted: Vec::new(),
        }
    }
}

/// What came out of a run that ended like that.
fn finish(mut run: Run<'_, '_>, end: Done) -> Outcome {
    for event in run.contour.abandon(&mut run.drives) {
        run.drives.report.emit(&event);
    }
    let (status, fault) = match end {
        Ok(()) => (Status::Done, None),
        Err(Leave::Stopped) => (Status::Stopped, None),
        Err(Leave::Fault(fault)) => {
            run.drives.report.report(EventKind::Error(fault.clone()));
            (fault.class.status(), Some(fault))
        }
    };
    let diagnostic = fault.as_ref().map(|fault| {
        let calls = &run.calls;
        let blamed = run.contour.blamed().and_then(|(program, block)| calls.place_of(program, block));
        let mut diagnostic = fault.diagnostic(blamed.or_else(|| calls.place_of(calls.program, calls.block)));
        diagnostic.related.extend(calls.places().map(|place| ("called-here", place)));
        diagnostic
    });
    run.drives.report.at_mut().cycle = None;
    run.drives.report.report(EventKind::End(status));
    let shown = run.shown();
    let (world, records) = (run.drives.world, run.records);
    Outcome {
        status,
        fault,
        diagnostic,
        tables: world.written(),
        logs: records.logs,
        screens: records.screens,
        params: run.params,
        position: world.here,
        angles: world.program_angles(),
        shown,
        envelopes: records.envelopes,
        noted: records.noted,
    }
}
