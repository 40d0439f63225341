//! What a program does to its blank when it is executed, for the checker: the engine knows the ways through subprograms,
//! patterns, transformations and parameters that the checker does not follow.
//!
//! Tools of which nothing is known, presets and the way that the tool takes after a change are assumed, so only what does
//! not depend on them is reported: what a tool has removed is taken for more than it may be, and what it meets is looked
//! at along the line of its tip. Nothing is said while a rotary axis is away from zero, while the workpiece turns, while
//! a probe is in the spindle, and after a second preset.
//!
//! Invariant: a run is bounded, and ends where the engine cannot go on; what was seen before that holds.
use std::collections::{BTreeMap, HashMap};

use glam::DVec3;

use crate::base::diag::Source;
use crate::check::{Incident, Observed};
use crate::engine::geometry::{Axis, Frame, RotaryAxis};
use crate::engine::run::{
    Class, Coordinates, Engine, Event, EventKind, Fault, Limits, MoveKind, NoTexts, Status, Tool,
};
use crate::engine::scene::Scene;
use crate::engine::scene::guess::{Guess, Origin};
use crate::engine::solid::{Path, Shape};
use crate::engine::stock::Blank;
use crate::program::syntax::{self, Block, BlockKind, Program};
use crate::program::table::Table;
use crate::spec::{Catalogue, CycleKey, Group, Keyword, MM_PER_INCH, OnControl};

/// Longer programs are not executed: posts write them, and their ways are all in the text.
const MOST_BLOCKS: usize = 3_000;
/// What a run may do.
const LIMITS: Limits = Limits { blocks: 50_000, jumps: 10_000, depth: 19, members: 2_000, moves: 50_000 };
/// So many cells the longer side of the blank has.
const CELLS: f64 = 64.0;
/// So many places of a movement are looked at.
const PLACES: f64 = 128.0;
/// So many places may be cut.
const MOST_PLACES: usize = 400_000;
/// The radius of a tool that is not known, mm: larger ones are rare.
const RADIUS: f64 = 12.0;
/// What lies so little inside of the blank is at its faces, mm.
const SKIN: f64 = 0.05;
/// So far beside the blank a tool below its top has not been retracted, mm.
const BESIDE: f64 = 50.0;
/// A hole goes so far through the blank, mm.
const TIP: f64 = 25.0;
/// A movement that cuts goes so far below the blank, mm.
const UNDER: f64 = 15.0;
/// A place so far from the blank, besides its size, belongs to another one, mm.
const FAR: f64 = 50.0;
/// Places that are so near are the same, mm.
const SAME: f64 = 0.01;
/// The meaning of the value that says a thread is milled, and of one outside.
const MILLED: &str = "milling-type";

/// The program, what it is executed on, and what is known of its tools.
#[derive(Clone, Copy)]
pub struct Rehearsal<'r> {
    /// The control.
    pub on: &'r OnControl,
    /// The others, for cycles that the manual of this one only names.
    pub catalogue: &'r Catalogue,
    /// The files of machines.
    pub files: &'r [(String, String)],
    /// The tool table.
    pub tools: Option<&'r Table>,
}

impl Rehearsal<'_> {
    /// What the execution of a program shows. `beside` adds to its scene what lies beside the program.
    pub fn observed(&self, program: &Program, beside: &dyn Fn(&mut Scene)) -> Vec<Observed> {
        self.watch(program, beside).unwrap_or_default()
    }

    fn watch(&self, program: &Program, beside: &dyn Fn(&mut Scene)) -> Option<Vec<Observed>> {
        let blocks = program.blocks();
        if blocks.len() > MOST_BLOCKS || !blocks.iter().any(|own| matches!(own.kind, BlockKind::BlkForm(_))) {
            return None;
        }
        let nothing = Scene::parse(&Source::new("scene", "scene: 1\n"), self.files).ok()?;
        let bounds = Blank::find(program, &nothing).ok()?.bounds;
        let mut guess = Guess::of(self.on, &[program], Some(bounds), self.tools, self.files);
        for tool in &mut guess.tools {
            tool.plunges = !tool.probes && !tool.turns;
        }
        let mut text = guess.to_yaml(&|_| String::new());
        // Whatever preset is activated first is that of the blank.
        let rows: Vec<String> = (0..=99).map(|row| format!("{{NO: {row}}}")).collect();
        text.push_str(&format!("presets: {{active: 1, rows: [{}]}}\n", rows.join(", ")));
        let mut scene = Scene::parse(&Source::new("scene", text), self.files).ok()?;
        beside(&mut scene);
        let blank = Blank::find(program, &scene).ok()?;
        let box_along_z = matches!(blank.shape, Shape::Box { .. }) && blank.axis == Axis::Z;
        if !box_along_z {
            return None;
        }
        let mut watcher = Watcher::new(self.on, program, &blank);
        for tool in guess.tools.iter().filter(|tool| tool.origin != Origin::Assumed && tool.size[1] > 0.0) {
            watcher.radii.push((tool.number, tool.size[1]));
        }
        watcher.probes = guess.tools.iter().filter(|tool| tool.probes).map(|tool| tool.number).collect();
        let engine = Engine::new(program, self.on, &scene, &NoTexts).with_catalogue(self.catalogue).with_limits(LIMITS);
        engine.observe(&mut |event| watcher.see(event));
        Some(watcher.found)
    }
}

/// A hole, or all that a cycle does without another one between.
struct Work {
    line: usize,
    key: CycleKey,
    group: Group,
    milled: bool,
    /// Where its first cut begins, and whether that is certain.
    start: DVec3,
    known: bool,
    low: DVec3,
    high: DVec3,
}

struct Watcher<'w> {
    on: &'w OnControl,
    /// The blocks by their lines.
    blocks: BTreeMap<usize, &'w Block>,
    /// A millimetre in the unit of the program.
    unit: f64,
    low: DVec3,
    high: DVec3,
    to_blank: Frame,
    /// The height down to which the blank is there, by rows of cells.
    tops: Vec<f64>,
    cell: f64,
    columns: usize,
    places: usize,
    /// Whether something may have been removed that is not known.
    open: bool,
    /// Whether the blank is elsewhere from now on.
    lost: bool,
    /// Whether the plane is tilted, be it without the axes.
    tilted: bool,
    at: DVec3,
    known: [bool; 3],
    line: usize,
    angles: Vec<(RotaryAxis, f64)>,
    preset: Option<f64>,
    worked: bool,
    radii: Vec<(f64, f64)>,
    probes: Vec<f64>,
    tool: Option<f64>,
    calls: u32,
    with_speed: bool,
    spindle: i8,
    started: bool,
    work: Option<Work>,
    /// Whether more than holes was machined.
    others: bool,
    /// The holes, their bottoms and how wide they are, if that is known.
    holes: Vec<([f64; 2], f64, Option<f64>)>,
    machined: HashMap<(CycleKey, u32, [i64; 3]), usize>,
    found: Vec<Observed>,
}

impl<'w> Watcher<'w> {
    fn new(on: &'w OnControl, program: &'w Program, blank: &Blank) -> Self {
        let [low, high] = blank.bounds;
        let size = high - low;
        let cell = (size.x.max(size.y) / CELLS).max(0.01);
        let columns = (size.x / cell).ceil().max(1.0) as usize;
        let rows = (size.y / cell).ceil().max(1.0) as usize;
        let inch = program.blocks().iter().any(|block| match &block.kind {
            BlockKind::BeginPgm(frame) => frame.inch,
            _ => false,
        });
        Self {
            on,
            blocks: program.blocks().iter().rev().map(|block| (block.line, block)).collect(),
            unit: if inch { 1.0 / MM_PER_INCH } else { 1.0 },
            low,
            high,
            to_blank: blank.frame.inverse(),
            tops: vec![high.z; columns * rows],
            cell,
            columns,
            places: 0,
            open: false,
            lost: false,
            tilted: false,
            at: DVec3::ZERO,
            known: [false; 3],
            line: 0,
            angles: Vec::new(),
            preset: None,
            worked: false,
            radii: Vec::new(),
            probes: Vec::new(),
            tool: None,
            calls: 0,
            with_speed: false,
            spindle: 0,
            started: false,
            work: None,
            others: false,
            holes: Vec::new(),
            machined: HashMap::new(),
            found: Vec::new(),
        }
    }

    fn report(&mut self, line: usize, incident: Incident) {
        let once = |own: &Observed| std::mem::discriminant(&own.incident) == std::mem::discriminant(&incident);
        if !self.found.iter().any(once) {
            self.found.push(Observed { line, incident });
        }
    }

    fn see(&mut self, event: &Event) {
        let line = event.at.line;
        if line > 0 {
            self.line = line;
        }
        let key = event.at.cycle.as_ref().map(|(key, _)| *key).filter(|key| key.keyword == Keyword::CyclDef);
        if self.work.as_ref().is_some_and(|work| Some(work.key) != key || work.line != line) {
            self.finish();
        }
        match &event.kind {
            EventKind::Move { kind, path, turned, .. } => {
                let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
                self.lost |= turned.is_some();
                self.go(path, rapid, key);
            }
            EventKind::Turn { axes, .. } => {
                for turned in axes {
                    self.angles.retain(|(axis, _)| *axis != turned.axis);
                    self.angles.push((turned.axis, turned.machine));
                }
            }
            EventKind::Spindle { tool, direction, .. } => self.spindle(tool.as_ref().map(|(tool, _)| tool), *direction),
            EventKind::Transform(coordinates) => self.preset(coordinates),
            EventKind::Probe(_) => self.worked = true,
            EventKind::Error(fault) => self.fault(fault),
            EventKind::End(Status::Done) => {
                if let Some(height) = self.low_at(BESIDE).filter(|_| self.tool.is_some()) {
                    self.report(self.line, Incident::End(height));
                }
            }
            _ => {}
        }
    }

    /// Whether nothing can be said of where the tool goes.
    fn away(&self) -> bool {
        self.lost || self.tilted || self.angles.iter().any(|(_, angle)| angle.abs() > 1e-6)
    }

    fn is_probe(&self) -> bool {
        self.tool.is_some_and(|tool| self.probes.contains(&tool))
    }

    fn spindle(&mut self, tool: Option<&Tool>, direction: i8) {
        match tool {
            Some(tool) => {
                if let Some(height) = self.low_at(BESIDE).filter(|_| self.tool.is_some()) {
                    self.report(self.line, Incident::ToolChange(height));
                }
                self.with_speed = self.blocks.get(&self.line).is_some_and(|block| match &block.kind {
                    BlockKind::ToolCall(call) => call.speed.is_some(),
                    _ => false,
                });
                if self.tool != Some(tool.number) {
                    (self.known, self.started) = ([false; 3], false);
                }
                self.tool = Some(tool.number);
                self.calls += 1;
                self.spindle = direction;
            }
            None => {
                self.started |= direction != 0;
                self.spindle = direction;
            }
        }
    }

    /// A preset is that of the blank if nothing was done before it.
    fn preset(&mut self, now: &Coordinates) {
        self.tilted = now.tilt.is_some_and(|tilt| tilt.length() > 1e-6);
        let other = self.preset.is_some_and(|before| before != now.preset);
        self.lost |= other && self.worked;
        if other || self.preset.is_none() {
            self.preset = Some(now.preset);
        }
        self.lost |= now.origin.length() > SAME || now.basic_rotation.length() > SAME;
    }

    fn fault(&mut self, fault: &Fault) {
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
            _ => return,
        };
        self.report(self.line, Incident::Incalculable(why));
    }

    /// The height of the tool if it is below the top of the blank, at most so far beside it.
    fn low_at(&self, beside: f64) -> Option<f64> {
        let certain = self.known == [true; 3] && !self.away();
        let below = self.at.z < self.high.z - SKIN && self.low.z <= self.at.z;
        (certain && below && self.distance(self.at) <= beside).then_some(self.at.z * self.unit)
    }

    fn distance(&self, place: DVec3) -> f64 {
        let beyond = (self.low - place).max(place - self.high).max(DVec3::ZERO);
        libm::hypot(beyond.x, beyond.y)
    }

    /// How wide the tool is, if that is known.
    fn width(&self) -> Option<f64> {
        let own = self.radii.iter().find(|(number, _)| Some(*number) == self.tool);
        own.map(|(_, radius)| 2.0 * radius)
    }

    fn radius(&self) -> f64 {
        let own = |(number, _): &&(f64, f64)| Some(*number) == self.tool;
        self.radii.iter().find(own).map_or(RADIUS, |(_, radius)| *radius)
    }

    fn go(&mut self, path: &Path, rapid: bool, key: Option<CycleKey>) {
        let from_known = self.known;
        let from = self.to_blank.point(path.at(0.0));
        self.at = self.to_blank.point(path.at(1.0));
        self.learn(from, key.is_some());
        if self.away() {
            self.open |= !rapid;
            return;
        }
        if self.is_probe() || self.tool.is_none() {
            return;
        }
        self.worked |= !rapid;
        let places = self.places_of(path);
        let certain = self.known == [true; 3];
        let begun = from_known == [true; 3];
        if rapid {
            let lifts = from.x == self.at.x && from.y == self.at.y && from.z <= self.at.z;
            if certain && !self.open && !lifts {
                let looked: &[DVec3] =
                    if begun { &places } else { places.last().map(std::slice::from_ref).unwrap_or_default() };
                if looked.iter().any(|place| self.is_solid(*place)) {
                    self.report(self.line, Incident::Rapid(from.z.min(self.at.z) * self.unit));
                }
            }
            return;
        }
        self.note(key, from, certain && begun);
        let threads = key.and_then(|key| self.on.cycles.get(&key)).is_some_and(|own| own.file.group == Group::Threads);
        if certain && !self.open && self.with_speed && self.probes.is_empty() && !threads {
            let cuts = begun && places.iter().any(|place| self.is_solid(*place));
            if cuts && (self.spindle == 0 || !self.started) {
                self.report(self.line, Incident::Still { unstarted: self.spindle != 0 });
            }
        }
        if certain && key.is_none() {
            let plan = (self.high - self.low).truncate().max_element();
            let below = self.at.z < self.high.z - SKIN;
            if below && self.distance(self.at) > plan + FAR {
                self.report(self.line, Incident::Outside([self.at.x * self.unit, self.at.y * self.unit]));
            }
        }
        if certain && self.at.z < self.low.z - UNDER && self.distance(self.at) <= 0.0 && self.is_milling(key) {
            self.report(self.line, Incident::Below(self.at.z * self.unit));
        }
        self.others |= self.is_milling(key) && self.at.z < self.high.z;
        self.cut(&places);
    }

    fn is_milling(&self, key: Option<CycleKey>) -> bool {
        let group = key.and_then(|key| self.on.cycles.get(&key)).map(|own| own.file.group);
        !matches!(group, Some(Group::Drilling | Group::Threads))
    }

    /// What a movement says of where the tool is: coordinates that it changes, or that its block names.
    fn learn(&mut self, from: DVec3, in_cycle: bool) {
        let block = self.blocks.get(&self.line).filter(|_| !in_cycle);
        let words = block.and_then(|block| match &block.kind {
            BlockKind::Motion(element) => Some(element.words()),
            _ => None,
        });
        let axes = [syntax::Axis::X, syntax::Axis::Y, syntax::Axis::Z];
        for (index, axis) in axes.into_iter().enumerate() {
            let named = words.as_ref().is_some_and(|words| words.coord(axis).is_some_and(|coord| !coord.incremental));
            let moved = (from.to_array()[index] - self.at.to_array()[index]).abs() > 1e-9;
            self.known[index] |= named || moved;
        }
    }

    fn places_of(&self, path: &Path) -> Vec<DVec3> {
        let count = (path.length() / self.cell).ceil().clamp(1.0, PLACES);
        (0..=count as usize).map(|at| self.to_blank.point(path.at(at as f64 / count))).collect()
    }

    fn index(&self, x: f64, y: f64) -> Option<usize> {
        let column = ((x - self.low.x) / self.cell).floor();
        let row = ((y - self.low.y) / self.cell).floor();
        let inside = column >= 0.0 && (column as usize) < self.columns && row >= 0.0;
        inside.then(|| row as usize * self.columns + column as usize).filter(|at| *at < self.tops.len())
    }

    /// Whether a place is inside of what is left of the blank.
    fn is_solid(&self, place: DVec3) -> bool {
        let inside = (place - self.low).min_element() > SKIN && (self.high - place).min_element() > SKIN;
        inside && self.index(place.x, place.y).and_then(|at| self.tops.get(at)).is_some_and(|top| place.z < top - SKIN)
    }

    /// Takes away what a tool may cut at places.
    fn cut(&mut self, places: &[DVec3]) {
        if self.places + places.len() > MOST_PLACES {
            self.open = true;
            return;
        }
        self.places += places.len();
        let radius = self.radius() + self.cell;
        for place in places {
            let reach = DVec3::new(radius, radius, 0.0);
            let (from, to) = (*place - reach, *place + reach);
            let first = |value: f64, low: f64| ((value - low) / self.cell).floor().max(0.0) as usize;
            let rows = self.tops.len() / self.columns;
            let (left, right) = (first(from.x, self.low.x), first(to.x, self.low.x).min(self.columns - 1));
            let (lower, upper) = (first(from.y, self.low.y), first(to.y, self.low.y).min(rows - 1));
            if to.x < self.low.x || to.y < self.low.y {
                continue;
            }
            for row in lower..=upper {
                for top in self.tops.iter_mut().skip(row * self.columns).take(right + 1).skip(left) {
                    *top = top.min(place.z);
                }
            }
        }
    }

    /// Adds a cut to what a cycle does.
    fn note(&mut self, key: Option<CycleKey>, from: DVec3, known: bool) {
        let Some((key, cycle)) = key.and_then(|key| Some((key, self.on.cycles.get(&key)?))) else { return };
        let (at, line) = (self.at, self.line);
        let group = cycle.file.group;
        if !matches!(group, Group::Drilling | Group::Threads | Group::Pockets | Group::Contours | Group::Surfaces) {
            return;
        }
        let milled = cycle.params.iter().any(|param| param.is.as_str() == MILLED);
        let hole = matches!(group, Group::Drilling | Group::Threads) && !milled;
        let same = |own: &Work| (own.start - from).truncate().length() <= SAME;
        if hole && self.work.as_ref().is_some_and(|own| !same(own)) && (from - at).truncate().length() <= SAME {
            self.finish();
        }
        let work = self.work.get_or_insert(Work { line, key, group, milled, start: from, known, low: at, high: at });
        work.low = work.low.min(at);
        work.high = work.high.max(at);
    }

    /// A cycle has done what it does at a place.
    fn finish(&mut self) {
        // What does not go down is a way between, or cuts from below.
        let down =
            |own: &Work| own.low.z < own.start.z - SKIN || !matches!(own.group, Group::Drilling | Group::Threads);
        let Some(work) = self.work.take().filter(|own| own.known && down(own)) else { return };
        if self.away() {
            return;
        }
        let bottom = work.low.z;
        let place = [work.start.x * self.unit, work.start.y * self.unit];
        if bottom > self.high.z + SKIN {
            self.report(work.line, Incident::Above(bottom * self.unit));
        }
        let hole = matches!(work.group, Group::Drilling | Group::Threads) && !work.milled;
        let beside = DVec3::new(self.radius(), self.radius(), 0.0);
        if hole {
            if self.distance(work.start) > SKIN {
                self.report(work.line, Incident::Beside(place));
            } else if bottom < self.low.z - TIP {
                self.report(work.line, Incident::Through(bottom * self.unit));
            }
        } else if (work.high + beside - self.low).truncate().min_element() < 0.0
            || (self.high - work.low + beside).truncate().min_element() < 0.0
        {
            let middle = (work.low + work.high) / 2.0;
            self.report(work.line, Incident::Outside([middle.x * self.unit, middle.y * self.unit]));
        }
        if hole {
            self.again(&work, place);
        }
        if work.group == Group::Threads {
            self.thread(&work, place);
        } else if work.group == Group::Drilling {
            self.holes.push(([work.start.x, work.start.y], bottom, self.width()));
        }
    }

    /// A hole that the same tool has made already from another block, or on another round.
    fn again(&mut self, work: &Work, place: [f64; 2]) {
        let bits = work.start.with_z(work.low.z).to_array().map(|own| (own / SAME).round() as i64);
        if self.machined.insert((work.key, self.calls, bits), work.line).is_some() {
            self.report(work.line, Incident::Again(place));
        }
    }

    /// A thread goes into a hole that must be there, and not deeper than it.
    fn thread(&mut self, work: &Work, place: [f64; 2]) {
        let here = |own: &&([f64; 2], f64, Option<f64>)| {
            (own.0[0] - work.start.x).abs() <= SAME && (own.0[1] - work.start.y).abs() <= SAME
        };
        let here: Vec<_> = self.holes.iter().filter(here).copied().collect();
        let bottom = here.iter().map(|(_, bottom, _)| *bottom).reduce(f64::min);
        // What only centres is not as wide as its tool.
        let whole = here.iter().filter(|(_, own, _)| *own <= work.low.z);
        let hole = whole.filter_map(|(.., width)| *width).reduce(f64::max);
        if let Some((thread, hole)) = self.width().zip(hole).filter(|(thread, hole)| !work.milled && hole >= thread) {
            self.report(work.line, Incident::WideCore { thread: thread * self.unit, hole: hole * self.unit });
        }
        match bottom {
            Some(hole) if hole > self.low.z && work.low.z < hole - SKIN => {
                let incident = Incident::HoleTooShallow { tap: work.low.z * self.unit, hole: hole * self.unit };
                self.report(work.line, incident);
            }
            None if !work.milled && !self.holes.is_empty() && !self.others && self.distance(work.start) <= 0.0 => {
                self.report(work.line, Incident::NoHole(place));
            }
            _ => {}
        }
    }
}
