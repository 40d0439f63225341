//! What the execution of a checked program shows that reading it does not: rapid traverse through material, cuts above
//! the cutting edges, cycles that remove nothing, shapes that a cycle cannot machine.
//!
//! A program is executed if everything is known that its paths depend on: a tool table was named, it has a blank and no
//! errors, and each of its tools is in a table that was named or in a TOOL DEF.
//! Invariant: what depends on the machine, which is assumed, is not reported; nor is what the engine cannot do.
use std::collections::BTreeSet;
use std::path::Path;

use super::execution;
use super::neighbours::Neighbours;
use super::program::Understood;
use super::project::CheckedProgram;
use crate::base::data::Files;
use crate::base::diag::{Arg, Diagnostic, Place, Severity, Source};
use crate::check::ToolKind;
use crate::engine::run::FindingKind;
use crate::engine::run::{Engine, Event, EventKind, Limits, MoveKind, PASSED_OVER, Status};
use crate::engine::scene::Scene;
use crate::engine::scene::guess::{Guess, Origin};
use crate::engine::stock::{Blank, Finding, Machining};
use crate::language::locale::Locales;
use crate::program::syntax::{Block, BlockKind, Program, StatementKind};
use crate::program::table::{Table, TableKind};
use crate::tools::conform::LogTexts;
use crate::tools::rehearse::presets::{UNNAMED_PRESET, any_preset, goes_on};
use crate::tools::rehearse::works::{self, Works};
use crate::tools::rehearse::{describing, without_obstacles};

/// Less material than this is not reported, mm: columns of the stock end at its own walls.
const LEAST: f64 = 0.1;
/// The blank has so many columns along its greatest extent where the tool leans.
const OF_LEANING: f64 = 80.0;
/// How much of a program is executed: what most programs need, in a second or two.
const LIMITS: Limits = Limits { blocks: 1_000_000, jumps: 100_000, depth: 19, members: 10_000, moves: 200_000 };
/// Errors that follow from the program alone, whatever the machine.
const OF_PROGRAM: [&str; 14] = [
    "compensation-too-large",
    "contour-empty",
    "elements-overlap",
    "end-off-circle",
    "free-contour-contradicts",
    "infeeds-never-reach-depth",
    "insert-direction",
    "pattern-too-long",
    "radius-too-small",
    "recess-impossible",
    "rounding-impossible",
    "shape-impossible",
    "tangent-missing",
    "undercut-impossible",
];

/// What the data give to the execution of any program.
pub(super) struct DryRun<'d> {
    /// The files of machines and logs.
    pub(super) files: &'d Files,
    pub(super) locales: &'d Locales,
}

impl DryRun<'_> {
    /// Adds what is found when the program is executed.
    pub(super) fn check(
        &self,
        file: &Understood,
        path: &Path,
        program: &CheckedProgram<'_>,
        found: &mut Vec<Diagnostic>,
    ) {
        if found.iter().any(|known| known.severity == Severity::Error) {
            return;
        }
        let Some(new) = self.findings(file, path, program) else { return };
        for finding in new {
            // What was found by reading is not said a second time.
            let again = |known: &Diagnostic| {
                let same = [is_rapid, is_of_contour].iter().any(|is| is(known.code) && is(finding.code));
                let air = finding.code == works::IDLE && known.code == "surface-wrong";
                known.code == finding.code || same || air
            };
            if !found.iter().any(again) {
                found.push(finding);
            }
        }
    }

    fn findings(&self, file: &Understood, path: &Path, program: &CheckedProgram<'_>) -> Option<Vec<Diagnostic>> {
        // Findings are at the same lines.
        let without = without_obstacles(&file.program);
        let run = without.as_ref().unwrap_or(&file.program);
        let (against, tables) = (program.against(), program.named_tables());
        let of_kind = |kind: TableKind| tables.iter().copied().find(|table| table.kind() == kind);
        let tools = of_kind(TableKind::Tool);
        if tools.is_none() && of_kind(TableKind::Turning).is_none() {
            return None;
        }
        let neighbours = Neighbours::new(path, against.catalogue);
        // Cycles that the manual of the control only names do what they do on the others.
        let on = describing(against.on, against.catalogue, run);
        let guess = execution::guess(on, run, &neighbours, self.files, tools).ok()?;
        guess.blank.as_ref()?;
        if guess.tools.iter().any(|tool| tool.origin == Origin::Assumed && !tool.probes) {
            return None;
        }
        let knows_presets = tables.iter().any(|table| table.kind() == TableKind::Preset);
        let scene = self.scene(file, path, &guess, tables)?;
        let texts = LogTexts::new(self.locales.source()?, on.id(), self.files);
        let engine = Engine::new(run, on, &scene, &texts).with_limits(LIMITS);
        let engine = engine.with_catalogue(against.catalogue).with_programs(&neighbours).touching_as_expected();
        // An angle of an axis means another place of a tilted plane on every machine.
        let tilts =
            |block: &Block| matches!(&block.kind, BlockKind::Statement(own) if own.kind == StatementKind::Plane);
        let [tilts, positions] = [file.program.blocks().iter().any(tilts), guess.positions_rotary_axes()];
        let depends = tilts && positions;
        let mut part = Part::new(file, (run, &scene), knows_presets, tilts || positions)?;
        let name = |tool: f64| tools.and_then(|table| table.text(tool, "NAME").ok()).and_then(ToolKind::named);
        let kinds: Vec<_> = guess.tools.iter().filter_map(|tool| Some((tool.number, name(tool.number)?))).collect();
        let thread_mills = kinds.iter().filter(|(_, kind)| *kind == ToolKind::ThreadMill);
        part.sight.knows_inserts = of_kind(TableKind::Turning).is_some();
        part.sight.thread_mills = thread_mills.map(|(tool, _)| *tool).collect();
        let column = part.machining.stock().cell().max_element();
        let mut works = Works::new((against.on, against.catalogue), &file.program, kinds, column);
        let outcome = engine.run(&mut |event| {
            let followed = part.see(&event);
            works.see(&event, followed);
        });
        let mut found = if depends { Vec::new() } else { part.findings(file, &works) };
        let fault = outcome.diagnostic.filter(|_| outcome.status == Status::Error);
        if let Some(fault) = fault.filter(|fault| OF_PROGRAM.contains(&fault.code)) {
            found.push(fault);
        }
        Some(found.into_iter().map(|finding| file.at_home(finding)).collect())
    }

    /// What the program is executed on: its tables, and presets of any number where no table has them.
    fn scene(&self, file: &Understood, path: &Path, guess: &Guess, tables: &[&Table]) -> Option<Scene> {
        let mut text = guess.to_yaml(&|_| String::new());
        if !tables.iter().any(|table| table.kind() == TableKind::Preset) {
            text.push_str(&any_preset());
        }
        text.push_str(&goes_on());
        let mut scene = Scene::parse(&Source::new("scene", text), self.files).ok()?;
        for table in tables {
            match table.kind() {
                TableKind::Tool => scene.tools = (*table).clone(),
                TableKind::Turning => scene.turning_tools = (*table).clone(),
                _ => {}
            }
        }
        guess.assume_inserts(&scene.tools, &mut scene.turning_tools);
        execution::selected(path, file.program.source().text(), &mut scene).ok()?;
        Some(scene)
    }
}

/// The part that is machined, as far as it is certain where it is.
struct Part {
    machining: Machining,
    sight: Sight,
}

impl Part {
    /// Before a run in a scene; a tool that leans takes long, so that columns are wider then.
    fn new(file: &Understood, (run, scene): (&Program, &Scene), knows_presets: bool, leans: bool) -> Option<Self> {
        let blank = Blank::find(run, scene).ok()?;
        let [min, max] = blank.bounds;
        let resolution = leans.then(|| (max - min).max_element() / OF_LEANING);
        let mut machining = Machining::new(run, scene, resolution).ok()?;
        drop(machining.cuts());
        Some(Self { machining, sight: Sight::new(&file.program, knows_presets) })
    }

    /// Takes an event: whether the stock has seen it.
    fn see(&mut self, event: &Event) -> bool {
        let followed = self.sight.holds(event);
        if followed {
            self.machining.see(event);
        }
        followed
    }

    /// What was found in its material, and cycles that have removed none.
    fn findings(mut self, file: &Understood, works: &Works<'_>) -> Vec<Diagnostic> {
        let idle = works.idle(&self.machining.cuts());
        let mut found = of_material(&self.machining.finish().1.findings, &self.sight.threaded, file);
        found.extend(idle.and_then(|(number, key)| {
            let place = Place::new(file.program.source(), line(&file.program, number)?);
            Some(Diagnostic::warning(works::IDLE, place).arg("cycle", key.to_string()))
        }));
        found
    }
}

/// How long the stock is where it is thought to be, and the tool.
///
/// The second preset of a program whose presets are not known may be that of another face; where the workpiece is after
/// a rotary axis was turned without tilting the plane, and where a position in machine coordinates is, depends on the
/// machine.
struct Sight {
    knows_presets: bool,
    /// The program, and the lines that name positions in machine coordinates.
    program: std::sync::Arc<str>,
    of_machine: BTreeSet<usize>,
    preset: Option<f64>,
    tilted: bool,
    /// The thread mills, which are narrower above their edges; whether one is in the spindle, and the lines where it
    /// has moved.
    thread_mills: Vec<f64>,
    threading: bool,
    threaded: BTreeSet<usize>,
    moved: bool,
    /// Whether the inserts of turning tools are known, and whether something was turned.
    knows_inserts: bool,
    turned: bool,
    lost: bool,
    /// Axes of which it is not known where they are.
    unknown: [bool; 3],
}

impl Sight {
    fn new(program: &Program, knows_presets: bool) -> Self {
        let of_machine = |block: &&Block| match &block.kind {
            BlockKind::Motion(motion) => motion.functions().iter().any(|own| matches!(own.number, 91 | 92)),
            _ => false,
        };
        Self {
            knows_presets,
            program: program.source().name().into(),
            of_machine: program.blocks().iter().filter(of_machine).map(|block| block.line).collect(),
            preset: (!knows_presets).then_some(f64::from(UNNAMED_PRESET)),
            tilted: false,
            thread_mills: Vec::new(),
            threading: false,
            threaded: BTreeSet::new(),
            moved: false,
            knows_inserts: false,
            turned: false,
            lost: false,
            unknown: [false; 3],
        }
    }

    /// Takes an event: whether the stock may see it.
    fn holds(&mut self, event: &Event) -> bool {
        /// Less than this is no turn, degrees.
        const TURN: f64 = 1e-6;
        match &event.kind {
            EventKind::Transform(now) => {
                self.tilted = now.tilt.is_some_and(|tilt| tilt.length() > TURN);
                let other = self.preset.is_some_and(|before| before != now.preset);
                // A datum that is probed is that of the workpiece, which is elsewhere then than it was thought to be.
                let probed = now.origin.length() > TURN || now.basic_rotation.length() > TURN;
                self.lost |= (other && self.moved || probed) && !self.knows_presets;
                self.preset = Some(now.preset);
            }
            EventKind::Turn { axes, .. } => {
                self.lost |= !self.tilted && axes.iter().any(|turned| turned.to.abs() > TURN);
            }
            // What a cycle without a description removes is not known.
            EventKind::Function(what) if &**what == PASSED_OVER => self.lost = true,
            EventKind::Spindle { tool: Some((tool, _)), .. } => {
                self.threading = self.thread_mills.contains(&tool.number)
            }
            EventKind::Move { kind, from, to, turned, .. } => {
                self.moved = true;
                self.turned |= turned.is_some();
                if self.threading {
                    self.threaded.insert(event.at.line);
                }
                let of_machine = event.at.program == self.program && self.of_machine.contains(&event.at.line);
                let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
                // What inserts have left of which nothing is known is not known either.
                self.lost |= self.turned && turned.is_none() && !self.knows_inserts;
                // What cuts is seen in any case: too much is gone rather than too little.
                let hidden = rapid && (of_machine || self.unknown != [false; 3]);
                for (unknown, (from, to)) in self.unknown.iter_mut().zip(from.to_array().into_iter().zip(to.to_array()))
                {
                    if from.to_bits() != to.to_bits() {
                        *unknown = of_machine;
                    }
                }
                return !self.lost && !hidden;
            }
            _ => {}
        }
        !self.lost
    }
}

/// Whether it says that a contour or a shape cannot be calculated.
fn is_of_contour(code: &str) -> bool {
    code == "uncalculable-contour" || OF_PROGRAM.contains(&code)
}

fn is_rapid(code: &str) -> bool {
    matches!(code, "rapid-into-blank" | "rapid-through-material")
}

/// What was found in the material, the first of each kind.
fn of_material(all: &[Finding], threaded: &BTreeSet<usize>, file: &Understood) -> Vec<Diagnostic> {
    let source = file.program.source();
    // Where the spindle is stationary in material, as when a boring bar retracts, the stock does not know the shape of
    // the tool well enough.
    let stationary = |finding: &Finding| {
        let same = |other: &Finding| other.kind == FindingKind::SpindleStopped && other.line == finding.line;
        all.iter().any(same)
    };
    let first = |kind, code| {
        let mut same = all.iter().filter(|finding| finding.kind == kind && *finding.program == *source.name());
        let necked = |own: &Finding| own.kind == FindingKind::EdgesTooShort && threaded.contains(&own.line);
        let finding = same.find(|finding| finding.amount > LEAST && !stationary(finding) && !necked(finding))?;
        let place = Place::new(source, line(&file.program, finding.line)?);
        Some(Diagnostic::warning(code, place).arg("value", Arg::Number(finding.amount)))
    };
    [
        first(FindingKind::Rapid, "rapid-through-material"),
        first(FindingKind::EdgesTooShort, "milling-deeper-than-edges"),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The first line of the block that has a line of the file, without its end.
fn line(program: &Program, number: usize) -> Option<std::ops::Range<usize>> {
    let blocks = program.blocks();
    let block = blocks.get(blocks.partition_point(|block| block.line < number)).filter(|own| own.line == number)?;
    let own = program.source().text().get(block.span.start..block.span.end)?.split('\n').next()?;
    Some(block.span.start..block.span.start + own.trim_end().len())
}
