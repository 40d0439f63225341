//! Follows the events of a run: where the tool is, what it meets and what it is used for.
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use glam::DVec3;

use super::areas::Area;
use super::body::{Body, SAME, SKIN};
use super::lathe::Turned;
use super::presets::UNNAMED_PRESET;
use super::remains::Remains;
use super::series::Rows;
use super::tracks::Curves;
use super::undescribed;
use super::walls::Way;
use super::ways::Ways;
use super::work::{Hole, Thread, Work};
use crate::base::diag::{Arg, interned};
use crate::check::{Incident, Observed, ToolKind, removes_material};
use crate::engine::geometry::{Axis, Frame, RotaryAxis, WorkingPlane};
use crate::engine::machine::Machine;
use crate::engine::run::{
    Class, Coordinates, Event, EventKind, Fault, MessageKind, MoveKind, PASSED_OVER, Status, Tool,
};
use crate::engine::scene::Scene;
use crate::engine::solid::Path;
use crate::engine::stock::Blank;
use crate::program::syntax::{self, Block, BlockKind, Program};
use crate::spec::{Catalogue, Cycle, CycleKey, Group, Keyword, MM_PER_INCH, OnControl};

/// So many places of a movement are looked at.
const PLACES: f64 = 128.0;
/// So many places of a movement say how far it reaches.
const ROUND: u8 = 8;
/// The radius of a tool that is not known, mm: larger ones are rare.
pub(super) const RADIUS: f64 = 12.0;
/// So far beside the blank a tool below its top has not been retracted, mm.
const BESIDE: f64 = 50.0;
/// A movement that cuts goes so far below the blank, mm, and the floor of a pocket.
const UNDER: f64 = 15.0;
const UNDER_POCKET: f64 = 3.0;
/// A place so far from the blank, besides its size, belongs to another one, mm.
const FAR: f64 = 50.0;
/// So far beside the blank nothing is scaled on purpose, besides the radius of the tool, mm.
const SCALED: f64 = 20.0;

/// What is known while a program runs.
pub(super) struct Watcher<'w> {
    on: &'w OnControl,
    catalogue: &'w Catalogue,
    pub(super) program: &'w Program,
    /// The blocks by their lines.
    pub(super) blocks: BTreeMap<usize, &'w Block>,
    /// A millimetre in the unit of the program.
    pub(super) unit: f64,
    /// The blank, if its size is known.
    pub(super) body: Option<Body>,
    to_blank: Frame,
    /// The preset in machine coordinates that the blank was clamped for.
    datum: DVec3,
    pub(super) plane: WorkingPlane,
    pub(super) remains: Remains,
    /// What turning leaves.
    pub(super) turned: Turned,
    /// Whether the blank is elsewhere from now on.
    pub(super) lost: bool,
    /// Whether the workpiece turns.
    pub(super) turning: bool,
    /// Whether a fault was the last that was seen: the run may go on after the cycle that has it.
    pub(super) faulty: bool,
    /// Whether the plane is tilted, be it without the axes.
    pub(super) tilted: bool,
    /// Whether the plane was reset, and the rotary axes have stayed where they were.
    left_turned: bool,
    /// The tilt of the plane, spatial angles.
    tilt: DVec3,
    /// Whether it depends on the machine, which is assumed, where tilted planes are.
    pub(super) depends_on_machine: bool,
    /// Whether the tool has another axis than the blank.
    pub(super) across: bool,
    /// The preset, its place and its turn, and the tilt of the plane.
    pub(super) frame: Vec<i64>,
    scaled: bool,
    pub(super) at: DVec3,
    /// The same in machine coordinates.
    machine_at: DVec3,
    pub(super) known: [bool; 3],
    /// The line of the program itself that is executed, or from which another one was called.
    pub(super) line: usize,
    pub(super) angles: Vec<(RotaryAxis, f64)>,
    /// The machine, its rotary axes at the start, and the way from where the table has brought the blank back to there.
    machine: Machine,
    start: DVec3,
    parts: Option<Frame>,
    /// A cycle for holes in the tilted plane: its block, and whether it has met the blank.
    pub(super) tilted_holes: Option<(usize, bool)>,
    /// The first movement at feed in the tilted plane, and whether any has come to the blank.
    pub(super) tilted_ways: Option<(usize, bool)>,
    /// Whether this tool has gone sideways through solid material at the feed of its call.
    pub(super) cuts: bool,
    preset: Option<f64>,
    pub(super) worked: bool,
    /// Whether the operator was asked to go on after something was machined, and whether rows of holes were uncertain
    /// then.
    pub(super) stopped: Option<bool>,
    pub(super) radii: Vec<(f64, f64)>,
    /// The radii within which tools are flat at their end.
    pub(super) flat: Vec<(f64, f64)>,
    /// The angles of the points of tools, degrees.
    pub(super) points: Vec<(f64, f64)>,
    /// What tools are called.
    pub(super) kinds: Vec<(f64, ToolKind)>,
    pub(super) probes: Vec<f64>,
    /// Whether the cycles that no control describes only mill.
    pub(super) undescribed_mills: bool,
    /// Whether the tool table has a thread mill that the program does not call.
    pub(super) spare_thread_mill: bool,
    pub(super) tool: Option<f64>,
    pub(super) calls: u32,
    /// The line of the last tool call.
    pub(super) called: usize,
    with_speed: bool,
    spindle: i8,
    pub(super) speed: f64,
    started: bool,
    pub(super) work: Option<Work>,
    /// Whether more than holes was machined.
    pub(super) others: bool,
    pub(super) holes: Vec<Hole>,
    pub(super) threads: Vec<Thread>,
    pub(super) machined: HashMap<(CycleKey, u32, [i64; 3]), usize>,
    /// The pockets that were made: cycle, tool call, line, place and size.
    pub(super) milled: HashSet<(CycleKey, u32, usize, [i64; 5])>,
    /// The pockets with their ways, and the plain ways along the blank.
    pub(super) areas: Vec<Area>,
    pub(super) walls: Vec<Way>,
    /// Whether the contour with RL or RR was begun outside of the blank.
    pub(super) from_outside: bool,
    /// How many contours there were.
    pub(super) contour: usize,
    /// The lines of plain movements straight down: whether one goes into a hole, and one into solid material.
    pub(super) dips: BTreeMap<usize, [bool; 2]>,
    /// The lines of plain movements with radius compensation: whether one has cut along them below the top of the blank.
    pub(super) lines_cut: BTreeSet<(u32, usize)>,
    /// How often plain movements have come back to the same way, and how often is too often: tool call, line, beginning and end.
    pub(super) passes: HashMap<(u32, usize, [i64; 6]), (u8, u8)>,
    /// The places of holes, by what was done there.
    pub(super) series: Rows,
    /// The cycles with which tools have cut, each once.
    pub(super) used: BTreeSet<(u64, CycleKey)>,
    /// The plain movements since the last tool call.
    pub(super) ways: Ways,
    pub(super) curves: Curves,
    pub(super) found: Vec<Observed>,
}

impl<'w> Watcher<'w> {
    /// Before the run in a scene.
    pub(super) fn new(
        (on, catalogue): (&'w OnControl, &'w Catalogue),
        program: &'w Program,
        body: Option<Body>,
        scene: &Scene,
    ) -> Self {
        let frame = Blank::find(program, scene).map_or(scene.frame, |blank| blank.frame);
        let inch = program.blocks().iter().any(|block| match &block.kind {
            BlockKind::BeginPgm(frame) => frame.inch,
            _ => false,
        });
        Self {
            on,
            catalogue,
            program,
            blocks: program.blocks().iter().rev().map(|block| (block.line, block)).collect(),
            unit: if inch { 1.0 / MM_PER_INCH } else { 1.0 },
            body,
            to_blank: frame.inverse(),
            datum: DVec3::ZERO,
            plane: WorkingPlane::of_tool_axis(body.map_or(Axis::Z, |body| body.axis)),
            remains: Remains::of(body),
            turned: Turned::of(body),
            lost: false,
            turning: false,
            faulty: false,
            tilted: false,
            left_turned: false,
            tilt: DVec3::ZERO,
            depends_on_machine: false,
            across: false,
            frame: setting(f64::from(UNNAMED_PRESET), [DVec3::ZERO; 3]),
            scaled: false,
            at: DVec3::ZERO,
            machine_at: DVec3::ZERO,
            known: [false; 3],
            line: 0,
            angles: Vec::new(),
            machine: scene.machine.clone(),
            start: scene.start_angles,
            parts: None,
            tilted_holes: None,
            tilted_ways: None,
            cuts: false,
            preset: Some(f64::from(UNNAMED_PRESET)),
            worked: false,
            stopped: None,
            radii: Vec::new(),
            flat: Vec::new(),
            points: Vec::new(),
            kinds: Vec::new(),
            probes: Vec::new(),
            undescribed_mills: undescribed::only_mills(program, on, catalogue),
            spare_thread_mill: false,
            tool: None,
            calls: 0,
            called: 0,
            with_speed: false,
            spindle: 0,
            speed: 0.0,
            started: false,
            work: None,
            others: false,
            holes: Vec::new(),
            threads: Vec::new(),
            machined: HashMap::new(),
            milled: HashSet::new(),
            areas: Vec::new(),
            walls: Vec::new(),
            from_outside: false,
            contour: 0,
            dips: BTreeMap::new(),
            passes: HashMap::new(),
            lines_cut: BTreeSet::new(),
            series: Rows::default(),
            used: BTreeSet::new(),
            ways: Ways::default(),
            curves: Curves::default(),
            found: Vec::new(),
        }
    }

    pub(super) fn report(&mut self, line: usize, incident: Incident) {
        let once = |own: &Observed| std::mem::discriminant(&own.incident) == std::mem::discriminant(&incident);
        if !self.found.iter().any(once) {
            self.found.push(Observed { line, incident });
        }
    }

    /// Sees what happens next.
    pub(super) fn see(&mut self, event: &Event) {
        let own = *event.at.program == *self.program.source().name();
        if self.faulty && !matches!(event.kind, EventKind::End(_)) {
            self.leave_cycle();
        }
        if event.at.line > 0 {
            if own {
                self.pass_over(event.at.line);
            }
            self.line = if own { event.at.line } else { self.calling_line() };
        }
        let key = event.at.cycle.as_ref().map(|(key, _)| *key).filter(|key| key.keyword == Keyword::CyclDef);
        if self.work.as_ref().is_some_and(|work| Some(work.key) != key || work.written != event.at.line) {
            self.finish();
        }
        match &event.kind {
            EventKind::Move { kind, path, turned, feed, .. } => {
                let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
                self.note_turning(turned.is_some());
                let block = self.blocks.get(&self.line).copied().filter(|_| own && key.is_none());
                self.go(path, (!rapid).then_some(*feed), key, (event.at.line, block));
                if turned.is_some() {
                    self.turn(key, event.at.line, &self.places_turned(path), rapid);
                }
            }
            EventKind::Insert(insert) => self.hold_insert(*insert),
            EventKind::Function(what) if &**what == PASSED_OVER => self.pass_undescribed(),
            EventKind::Turn { axes, .. } => {
                self.left_turned = false;
                for turned in axes {
                    self.angles.retain(|(axis, _)| *axis != turned.axis);
                    self.angles.push((turned.axis, turned.machine));
                }
                let now = self.angles.iter().fold(self.start, |angles, (axis, angle)| axis.with(angles, *angle));
                let (before, after) = (self.machine.table(self.start), self.machine.table(now));
                self.parts = (before != after).then(|| before.of(after.inverse()));
                self.at = self.place(self.machine_at);
            }
            EventKind::Spindle { tool, direction, speed, .. } => {
                self.speed = *speed;
                self.spindle(tool.as_ref(), *direction);
            }
            EventKind::Transform(coordinates) => self.preset(coordinates),
            EventKind::Message { kind: MessageKind::Stop, .. } => self.stop(),
            EventKind::Error(fault) => {
                self.fault(fault, key);
                self.faulty = true;
            }
            EventKind::End(Status::Done) => {
                self.finish();
                self.judge_turned();
                self.judge_tilted();
                self.judge_tilted_ways();
                self.judge_rows();
                self.judge_ways();
                self.judge_walls();
                self.judge_curves();
                if let Some(height) = self.low_at(BESIDE).filter(|_| self.tool.is_some()) {
                    self.report(self.line, Incident::EndsInMaterial(height));
                }
            }
            // What can no longer be seen drills nothing.
            EventKind::End(_) if !self.drills_after(self.line) => {
                self.finish();
                self.judge_rows();
            }
            _ => {}
        }
    }

    /// Whether nothing can be said of where the tool goes.
    pub(super) fn away(&self) -> bool {
        let leans = self.tilted || self.across || self.angles.iter().any(|(_, angle)| angle.abs() > 1e-6);
        self.lost || self.turning || leans
    }

    pub(super) fn is_probe(&self) -> bool {
        self.tool.is_some_and(|tool| self.probes.contains(&tool))
    }

    fn spindle(&mut self, tool: Option<&(Tool, Axis)>, direction: i8) {
        let Some((tool, axis)) = tool else {
            self.started |= direction != 0;
            self.spindle = direction;
            return;
        };
        self.judge_ways();
        if let Some(height) = self.low_at(BESIDE).filter(|_| self.tool.is_some()) {
            self.report(self.line, Incident::ToolChangeInMaterial(height));
        }
        self.with_speed = self.blocks.get(&self.line).is_some_and(|block| match &block.kind {
            BlockKind::ToolCall(call) => call.speed.is_some(),
            _ => false,
        });
        if self.tool != Some(tool.number) {
            (self.known, self.started) = ([false; 3], false);
        }
        self.judge_tilted_ways();
        self.release_insert();
        self.across = *axis != self.plane.tool;
        self.tool = Some(tool.number);
        if let Some(radius) = self.width().map(|width| width / 2.0).filter(|radius| tool.deltas.0 > *radius) {
            let (value, radius) = (tool.deltas.0 * self.unit, radius * self.unit);
            self.report(self.line, Incident::Oversize { tool: tool.number, value, radius });
        }
        self.judge_tilted();
        self.cuts = false;
        (self.calls, self.called) = (self.calls + 1, self.line);
        self.spindle = direction;
    }

    /// A preset is that of the blank if nothing was done before it.
    fn preset(&mut self, now: &Coordinates) {
        if now.tilt.unwrap_or_default() != self.tilt {
            self.judge_tilted_ways();
        }
        let reset = self.tilted && now.tilt.is_none_or(|tilt| tilt.length() <= 1e-6);
        self.left_turned |= reset && self.angles.iter().any(|(_, angle)| angle.abs() > 1e-6);
        self.tilt = now.tilt.unwrap_or_default();
        self.tilted = now.tilt.is_some_and(|tilt| tilt.length() > 1e-6);
        self.scaled = (now.scaling.0 - 1.0).abs() > 1e-9 || now.scaling.1.is_some();
        self.transformed(now);
        let tilt = now.tilt.unwrap_or_default();
        self.frame = setting(now.preset, [now.origin, now.basic_rotation, tilt]);
        let other = self.preset.is_some_and(|before| before != now.preset);
        self.clamp_again(other);
        self.lost |= other && self.worked;
        self.turned.open |= other && self.worked;
        if other || self.preset.is_none() {
            self.preset = Some(now.preset);
        }
        // A datum that is set before anything is machined is that of the blank.
        if !self.worked {
            self.datum = now.origin;
        }
        let elsewhere = (now.origin - self.datum).length() > SAME || now.basic_rotation.length() > SAME;
        (self.lost, self.turned.open) = (self.lost || elsewhere, self.turned.open || elsewhere);
    }

    /// The run ends with a fault of the program, or with a message of a cycle whose tool is known.
    fn fault(&mut self, fault: &Fault, key: Option<CycleKey>) {
        if fault.of_cycle && self.width().is_some() {
            let machines = key.filter(|key| self.cycle(*key).is_some_and(removes_material));
            if let Some(key) = machines {
                self.report(self.line, Incident::Refused(key, interned(&fault.code)));
            }
        }
        if fault.class != Class::Program || fault.of_cycle {
            return;
        }
        let why = match &*fault.code {
            "free-contour-open" => "open",
            "free-contour-contradicts" => "contradicts",
            "free-contour-several" => "several",
            "rounding-impossible" => "rounding",
            "contour-crossing" => "crossing",
            "approach-impossible" => "approach",
            "feed-missing" if fault.args.iter().any(|(_, own)| *own == Arg::Number(0.0)) => {
                return self.report(self.line, Incident::NoFeed);
            }
            _ => return,
        };
        self.report(self.line, Incident::Incalculable(why));
    }

    /// The height of the tool if it is below the top of the blank, at most so far beside it.
    fn low_at(&self, beside: f64) -> Option<f64> {
        let body = self.body?;
        let certain = self.known == [true; 3] && !self.away();
        let below = self.at.z < body.high.z - SKIN && body.low.z <= self.at.z;
        (certain && below && body.distance(self.at) <= beside).then_some(self.at.z * self.unit)
    }

    /// How wide the tool is, if that is known.
    pub(super) fn width(&self) -> Option<f64> {
        let own = self.radii.iter().find(|(number, _)| Some(*number) == self.tool);
        own.map(|(_, radius)| 2.0 * radius)
    }

    /// How far the end of the tool may be round.
    fn rounding(&self) -> f64 {
        let flat = self.flat.iter().find(|(number, _)| Some(*number) == self.tool).map_or(0.0, |(_, radius)| *radius);
        (self.radius() - flat).max(0.0)
    }

    pub(super) fn radius(&self) -> f64 {
        self.width().map_or(RADIUS, |width| width / 2.0)
    }

    /// How much wider the tool is above its tip, mm for each mm: the flank of a cone is not in its radius.
    fn slope(&self) -> f64 {
        /// Half the angle of a cone that is not known, degrees: hardly any is wider.
        const HALF: f64 = 60.0;
        let tan = |angle: f64| libm::tan(angle.to_radians());
        let angle = self.points.iter().find(|(number, _)| Some(*number) == self.tool).map(|(_, angle)| angle / 2.0);
        match self.kind() {
            Some(ToolKind::Chamfer | ToolKind::Spot | ToolKind::Engraver) => tan(angle.unwrap_or(HALF)),
            Some(_) => 0.0,
            None => angle.map_or(0.0, tan),
        }
    }

    /// What the tool is called.
    pub(super) fn kind(&self) -> Option<ToolKind> {
        self.kinds.iter().find(|(number, _)| Some(*number) == self.tool).map(|(_, kind)| *kind)
    }

    /// A movement, at a feed if it is not a rapid one; with the line where it is written, and the block if that is one
    /// of the program itself and no cycle makes the movement.
    fn go(&mut self, path: &Path, feed: Option<f64>, key: Option<CycleKey>, (line, block): (usize, Option<&Block>)) {
        let begun = self.known == [true; 3];
        let from = self.place(path.at(0.0));
        self.machine_at = path.at(1.0);
        self.at = self.place(self.machine_at);
        self.learn(from, block);
        if self.is_at_pattern(key, line) {
            (self.known[0], self.known[1]) = (true, true);
        }
        if let (Some(key), Some(_), Some(tool)) = (key, feed, self.tool) {
            self.use_tool(tool, key);
        }
        if self.left_turned && self.tilted {
            self.left_turned = false;
        } else if self.left_turned && feed.is_some() && !self.is_probe() {
            self.report(self.line, Incident::AxesLeftTurned);
        }
        if self.away() {
            self.cut_tilted(path, feed.is_some(), key.is_none());
            self.drill_tilted(path, feed.is_some(), key);
            return;
        }
        if self.is_probe() || self.tool.is_none() {
            return;
        }
        self.worked |= feed.is_some();
        let places = self.places_of(path);
        let certain = self.known == [true; 3];
        if key.is_none() && certain && begun {
            self.note_entry(from);
        }
        let low = key.is_none() && block.is_some() && self.top().is_some_and(|top| self.at.z < top - SKIN);
        if low && self.known[2] && !(self.known[0] && self.known[1]) && !self.is_placed() {
            self.report(self.line, Incident::DownBeforePositioned(self.at.z * self.unit));
        }
        let Some(feed) = feed else {
            let lifts = from.x == self.at.x && from.y == self.at.y && from.z <= self.at.z;
            if certain && !self.remains.open && !lifts {
                let looked: &[DVec3] =
                    if begun { &places } else { places.last().map(std::slice::from_ref).unwrap_or_default() };
                if looked.iter().any(|place| self.is_solid(*place)) {
                    self.report(self.line, Incident::RapidInMaterial(from.z.min(self.at.z) * self.unit));
                }
            }
            return;
        };
        // An approach at rapid begins at the feed before it, on the way to its last line or arc.
        let approaches = block.is_some_and(|own| match &own.kind {
            BlockKind::Motion(motion) => matches!(motion.path(), syntax::Path::Appr(_)) && motion.outline().is_rapid(),
            _ => false,
        });
        if approaches && certain && begun && !self.remains.open && places.iter().any(|place| self.is_solid(*place)) {
            self.report(self.line, Incident::RapidInMaterial(from.z.min(self.at.z) * self.unit));
        }
        // Enough places of an arc to see how far it reaches.
        let round: Vec<DVec3> = (0..=ROUND).map(|at| self.place(path.at(f64::from(at) / f64::from(ROUND)))).collect();
        self.note(key, line, &round, certain && begun);
        self.meets(&places, certain && begun);
        if let Some(body) = self.body.filter(|_| certain) {
            // The way to a contour and away from it is no part of it.
            let plain = block.is_none_or(|own| match &own.kind {
                BlockKind::Motion(motion) => !matches!(motion.path(), syntax::Path::Appr(_) | syntax::Path::Dep(_)),
                _ => false,
            });
            self.look_at(&body, (key, plain), begun, from, feed, &places);
        }
        if key.is_none() && certain && begun {
            self.note_pass(from, line, &places);
            self.note_height(from, line);
            self.note_curve(from, line, &round);
            self.note_contour(from, line);
            self.note_lines(from);
            self.note_way(from, &places);
            self.dips(from);
        }
        let mills = self.is_milling(key) && self.top().is_none_or(|top| self.at.z < top);
        (self.others, self.turned.open) = (self.others || mills, self.turned.open || mills);
        self.cut(&places);
    }

    /// A movement at feed that is certain, in or beside a blank.
    fn look_at(
        &mut self,
        body: &Body,
        (key, plain): (Option<CycleKey>, bool),
        begun: bool,
        from: DVec3,
        feed: f64,
        places: &[DVec3],
    ) {
        let group = key.and_then(|key| self.cycle(key)).map(|own| own.file.group);
        let solid = !self.remains.open && begun && places.iter().any(|place| self.is_solid(*place));
        let drills = group == Some(Group::Drilling);
        if solid && self.spindle < 0 && (drills || group == Some(Group::Pockets)) {
            self.report(self.line, Incident::SpindleBackwards);
        }
        if !self.remains.open && self.with_speed && group != Some(Group::Threads) {
            // Where another tool has cut before, a tool that was not started still has to turn.
            let near = begun && places.iter().any(|own| own.z < body.high.z - SKIN && body.distance(*own) <= 0.0);
            if solid && (self.spindle == 0 || !self.started) || near && !self.started && key.is_none() {
                self.report(self.line, Incident::CutsWithoutSpindle { unstarted: self.spindle != 0 });
            }
        }
        if solid && (key.is_none() || drills) {
            self.plunges(from, feed, drills);
        }
        if solid && key.is_none() {
            self.cuts_sideways(from, places, feed);
            self.chamfers(from, places);
        }
        if solid && group == Some(Group::Threads) {
            self.mills_thread(key, from, places);
            self.mills_into_floor(key, places);
        }
        if solid {
            self.bites(from, places, feed);
        }
        self.ways.cycles |= key.is_some();
        if self.at.z < body.high.z - SKIN {
            self.ways.note_rotation();
        }
        if key.is_none() {
            let plan = (body.high - body.low).truncate().max_element();
            let below = self.at.z < body.high.z - SKIN;
            let room = if self.scaled { SCALED + self.radius() } else { plan + FAR };
            if below && body.distance(self.at) > room {
                self.report(self.line, Incident::OutsideBlank([self.at.x * self.unit, self.at.y * self.unit]));
            }
            if plain && self.away() {
                self.ways.note_unseen();
            } else if plain {
                let reach = self.radius() + SAME;
                let flank = |place: &DVec3| reach + self.slope() * (body.high.z - place.z).max(0.0);
                let meets =
                    places.iter().any(|own| body.distance(*own) <= flank(own) && own.z >= body.low.z - flank(own));
                let cuts = self.width().is_none_or(|width| self.remains.may_cut(places, width / 2.0));
                self.ways.note_lowest(from, places);
                self.ways.note(self.line, (from, self.at), body, (meets, cuts));
            }
        }
        let under = match group {
            _ if self.scaled => SCALED / 4.0,
            // The corners of its floor are as round as the tool.
            Some(Group::Pockets) => UNDER_POCKET + self.rounding(),
            _ => UNDER,
        };
        if self.at.z < body.low.z - under && body.distance(self.at) <= 0.0 && self.is_milling(key) {
            self.report(self.line, Incident::BelowBlank(self.at.z * self.unit));
        }
    }

    /// A cycle as the control describes it, or another one if the manual of this one only names it.
    pub(super) fn cycle(&self, key: CycleKey) -> Option<&'w Cycle> {
        self.on.cycles.get(&key).or_else(|| self.catalogue.describing(key).map(|(_, cycle)| cycle))
    }

    pub(super) fn top(&self) -> Option<f64> {
        self.body.map(|body| body.high.z)
    }

    pub(super) fn is_milling(&self, key: Option<CycleKey>) -> bool {
        let group = key.and_then(|key| self.cycle(key)).map(|own| own.file.group);
        !matches!(group, Some(Group::Drilling | Group::Threads))
    }

    /// A place of the machine in the coordinates of the blank, the tool axis last.
    pub(super) fn place(&self, machine: DVec3) -> DVec3 {
        let own = self.to_blank.point(self.parts.map_or(machine, |parts| parts.point(machine)) - self.datum);
        self.plane.flat(own).extend(self.plane.tool.of(own))
    }

    pub(super) fn places_of(&self, path: &Path) -> Vec<DVec3> {
        let count = (path.length() / self.remains.cell).ceil().clamp(1.0, PLACES);
        (0..=count as usize).map(|at| self.place(path.at(at as f64 / count))).collect()
    }

    /// Whether a place is inside of what is left of the blank.
    pub(super) fn is_solid(&self, place: DVec3) -> bool {
        self.remains.is_solid(place)
    }

    /// The way along the axis of the tool.
    pub(super) fn up(&self) -> DVec3 {
        let up = self.plane.tool.unit();
        let up = self.to_blank.vector(self.parts.map_or(up, |parts| parts.vector(up)));
        self.plane.flat(up).extend(self.plane.tool.of(up))
    }
}

/// What distinguishes a preset with its place, its turn and the tilt of the plane.
fn setting(preset: f64, places: [DVec3; 3]) -> Vec<i64> {
    let all = std::iter::once(preset).chain(places.into_iter().flat_map(|own| own.to_array()));
    all.map(|own| (own / SAME).round() as i64).collect()
}
