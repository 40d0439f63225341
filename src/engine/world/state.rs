//! The state of the virtual machine: where the tool is, which tool it is, the tables as they are now.
//!
//! Invariant: the scene is never changed; what a program writes is kept here and handed out as texts.
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use crate::engine::geometry::{Axis, Frame, RotaryAxis, WorkingPlane};
use crate::engine::machine::{Machine, MemoryReport, SavedKinematics, Survey, Tool};
use crate::engine::report::fault::Fault;
use crate::engine::scene::{Answers, Preset, Scene};
use crate::engine::solid::Path as BallPath;
use crate::engine::table::{Table, TableError, TableKind};
use crate::engine::world::coordinates::System;
use crate::engine::world::insert::Aligned;
use crate::engine::world::parallel::Parallels;
use crate::engine::world::stylus::{OfMachine, ProbeData};

/// How far away a tool is that stands aside, mm.
pub(crate) const ASIDE: f64 = 98_765.432_1;
/// The file of the kinematics that a program has changed.
const KINEMATICS_FILE: &str = "KINEMATICS.YAML";
/// The file of the memories in which kinematics are saved (001:14137-14143).
const MEMORIES_FILE: &str = "DATA450.KD";
/// The word that locks a tool in the column TL.
pub(crate) const LOCKED: &str = "L";

/// The probe where it stopped after touching, until it moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pressed {
    /// Where the movement began: the tool tip in machine coordinates.
    pub from: DVec3,
    /// Its direction in the machine.
    pub direction: DVec3,
    /// How far the ball went on after touching, mm.
    pub depth: f64,
}

/// Tables, and which were written.
#[derive(Clone)]
struct Kept {
    tables: BTreeMap<TableKind, Arc<Table>>,
    datums: Vec<Arc<Table>>,
    free: Vec<Arc<Table>>,
    kinematics: Arc<Machine>,
    memories: Arc<Vec<SavedKinematics>>,
    written: Vec<String>,
}

/// The tables at a moment, to return to.
pub(crate) struct Tables(Arc<Kept>);

/// The virtual machine.
#[derive(Clone)]
pub(crate) struct World<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// The coordinate system.
    pub system: System,
    /// The tool tip in program coordinates, by axis.
    pub here: DVec3,
    /// The tool tip in machine coordinates: where it is while the head is at 0.
    pub machine: DVec3,
    /// The rotary axes in machine coordinates, degrees.
    pub angles: DVec3,
    /// The parallel axes.
    pub(crate) parallels: Parallels,
    /// How far the table has turned the parts since the start, as a frame from the machine to where they were then;
    /// nothing while it is as at the start.
    parts: Option<Frame>,
    /// How the head is turned as the control believes, if it is not at 0.
    pub(crate) head: Option<Frame>,
    /// How it really is turned.
    pub(crate) true_head: Option<Frame>,
    /// How far what the rotary axes carry is from where they say, degrees.
    lag: DVec3,
    /// How often A, B and C have turned.
    turned: [usize; 3],
    /// What was measured of the rotary axes last.
    pub(crate) survey: Option<Arc<Survey>>,
    /// What was saved, restored, shown or deleted of the kinematics last.
    pub(crate) memory_report: Option<Arc<MemoryReport>>,
    /// How far the spindle is turned from the angle at which the probe was calibrated, degrees.
    pub spindle_turned: f64,
    /// How many triggers there were that the scene lets scatter.
    pub(crate) triggered: usize,
    /// The probe where it stopped after touching, until it moves.
    pub(crate) pressed: Option<Pressed>,
    /// The direction in which the tool has touched the tool setter, until it moves.
    pub(crate) at_setter: Option<DVec3>,
    /// While the table turns a cylinder under the tool: a tilted system stays as it is in the machine, so that its tool
    /// axis remains that of the tool.
    pub(crate) system_stays: bool,
    /// Whether the machine has all linear axes.
    all_axes: bool,
    /// Where the control believes the tool setter to be since its calibration: the centre of its face in machine
    /// coordinates, and its radius.
    pub(crate) calibrated_setter: Option<(DVec3, f64)>,
    /// The rotary axes that take part in tilting, where not all of them do.
    pub(crate) tilting_axes: Option<Vec<RotaryAxis>>,
    /// What machine parameters say of touch probes.
    pub(crate) of_machine: OfMachine,
    /// What the operator will say.
    pub answers: Answers,
    /// What is set for turning with the tool in the spindle.
    pub(super) aligned: Aligned,
    tool: Option<Tool>,
    /// The touch probe as the tables describe it, read when it is asked for first; see [`World::probe`].
    probe: OnceCell<Result<ProbeData, Fault>>,
    kept: Arc<Kept>,
    /// The active datum table.
    datum: usize,
}

impl<'s> World<'s> {
    pub(crate) fn new(scene: &'s Scene, of_machine: OfMachine) -> Result<Self, TableError> {
        let mut tables = BTreeMap::new();
        for (kind, table) in [
            (TableKind::Tool, &scene.tools),
            (TableKind::Turning, &scene.turning_tools),
            (TableKind::Probe, &scene.probes),
            (TableKind::Preset, &scene.presets),
        ] {
            tables.insert(kind, Arc::new(table.clone()));
        }
        let system = System::new(WorkingPlane::of_tool_axis(scene.machine.spindle));
        let mut world = Self {
            scene,
            system,
            here: DVec3::ZERO,
            machine: scene.start,
            angles: scene.start_angles,
            parallels: Parallels::new(&scene.machine.parallel),
            parts: None,
            head: None,
            true_head: None,
            lag: DVec3::ZERO,
            turned: [0; 3],
            survey: None,
            memory_report: None,
            spindle_turned: 0.0,
            triggered: 0,
            pressed: None,
            at_setter: None,
            system_stays: false,
            all_axes: Axis::ALL.into_iter().all(|axis| scene.machine.axis(axis).is_some()),
            calibrated_setter: None,
            tilting_axes: None,
            of_machine,
            answers: scene.answers.clone(),
            aligned: Aligned::default(),
            tool: None,
            probe: OnceCell::new(),
            kept: Arc::new(Kept {
                tables,
                datums: scene.datums.iter().cloned().map(Arc::new).collect(),
                free: scene.free_tables.iter().cloned().map(Arc::new).collect(),
                kinematics: Arc::new(scene.machine.clone()),
                memories: Arc::new(scene.saved_kinematics.clone()),
                written: Vec::new(),
            }),
            datum: 0,
        };
        let preset = world.preset(scene.active_preset)?;
        world.system.set_preset(scene.active_preset, preset);
        world.turn(scene.start_angles);
        world.renew();
        Ok(world)
    }

    /// Program coordinates follow a change of the system; the machine stays where it is.
    pub(crate) fn renew(&mut self) {
        self.here = self.to_program(self.machine);
    }

    /// Program coordinates of a position of the linear axes, given by the tool tip while the head is at 0.
    pub(crate) fn to_program(&self, machine: DVec3) -> DVec3 {
        self.system.back().point(machine + self.swung())
    }

    /// The way back from [`World::to_program`].
    pub(crate) fn to_machine(&self, program: DVec3) -> DVec3 {
        self.system.frame().point(program) - self.swung()
    }

    /// By how much the head, as it is turned, has moved the tool tip; nothing where the control goes on as if it was
    /// at 0.
    pub(crate) fn swung(&self) -> DVec3 {
        match self.head {
            Some(head) if self.system.is_on_workpiece() => self.swing(&head),
            _ => DVec3::ZERO,
        }
    }

    /// By how much a head that is turned so moves the tool tip.
    pub(crate) fn swing(&self, head: &Frame) -> DVec3 {
        let up = self.to_pivot();
        up + head.point(-up)
    }

    /// From the tool tip to the point about which the head turns, while it is at 0.
    pub(crate) fn to_pivot(&self) -> DVec3 {
        let length = self.tool.map_or(0.0, |tool| tool.length) + self.kinematics().pivot;
        self.system.plane.tool.unit() * length
    }

    /// A preset of the table.
    pub(crate) fn preset(&self, row: f64) -> Result<Preset, TableError> {
        let preset = Preset::of_row(self.table(TableKind::Preset)?, row)?;
        Ok(Preset { origin: preset.origin + self.kinematics().base, ..preset })
    }

    /// The kinematics as the control believes them to be.
    pub(crate) fn kinematics(&self) -> &Machine {
        &self.kept.kinematics
    }

    /// The machine as it really is.
    pub(crate) fn true_machine(&self) -> &Machine {
        self.scene.truth.as_ref().map_or(&self.scene.machine, |truth| &truth.machine)
    }

    /// The control has other kinematics from now on; the machine stays where it is.
    pub(crate) fn set_kinematics(&mut self, machine: Machine) {
        Arc::make_mut(&mut self.kept).kinematics = Arc::new(machine);
        self.is_written(KINEMATICS_FILE);
        self.turn(self.angles);
        self.renew();
    }

    /// The kinematics that are saved.
    pub(crate) fn memories(&self) -> &[SavedKinematics] {
        &self.kept.memories
    }

    /// Other kinematics are saved from now on.
    pub(crate) fn set_memories(&mut self, memories: Vec<SavedKinematics>) {
        Arc::make_mut(&mut self.kept).memories = Arc::new(memories);
        self.is_written(MEMORIES_FILE);
    }

    fn is_written(&mut self, file: &str) {
        let written = &mut Arc::make_mut(&mut self.kept).written;
        if !written.iter().any(|known| known == file) {
            written.push(file.to_owned());
        }
    }

    /// The rotary axes get new coordinates.
    pub(crate) fn turn(&mut self, angles: DVec3) {
        let (way, truth) = (angles - self.angles, self.scene.truth.as_ref());
        self.angles = angles;
        if let Some(truth) = truth {
            self.lag = truth.lag(self.lag, way);
        }
        let mut astray = DVec3::ZERO;
        for (axis, turned) in RotaryAxis::ALL.into_iter().zip(&mut self.turned) {
            *turned += usize::from(axis.of(way) != 0.0);
            astray = axis.with(astray, truth.map_or(0.0, |truth| truth.astray(axis, *turned)));
        }
        let (machine, true_angles) = (self.true_machine(), angles + self.lag + astray);
        let head = |machine: &Machine, angles| Some(machine.head(angles)).filter(|head| *head != Frame::IDENTITY);
        let true_head = head(machine, true_angles);
        self.parts = self.parts_turned(true_angles);
        self.head = head(self.kinematics(), angles);
        self.true_head = true_head;
        if !self.system_stays || self.system.tip_held {
            self.carry_system();
        }
    }

    /// From the machine to the parts while the rotary axes really are there; nothing where that changes nothing.
    fn parts_turned(&self, true_angles: DVec3) -> Option<Frame> {
        let machine = self.true_machine();
        let (table, at_start) = (machine.table(true_angles), machine.table(self.scene.start_angles));
        let parts = (table != at_start).then(|| at_start.of(table.inverse()));
        match self.scene.truth.as_ref().filter(|truth| truth.drift != DVec3::ZERO) {
            Some(truth) => Some(parts.unwrap_or(Frame::IDENTITY).of(Frame::shift(truth.drift))),
            None => parts,
        }
    }

    /// The same as they will be once the axes have turned there, but for what turning scatters.
    pub(crate) fn parts_after(&self, angles: DVec3) -> Frame {
        self.parts_turned(angles + self.lag).unwrap_or(Frame::IDENTITY)
    }

    /// A system on the workpiece goes with the table.
    pub(crate) fn carry_system(&mut self) {
        let table = self.carried(self.angles);
        if self.system.table != table {
            self.system.set_table(table);
            self.renew();
        } else if self.system.is_on_workpiece() {
            self.renew();
        }
    }

    /// Where the table puts the workpiece when the rotary axes are there.
    pub(crate) fn carried(&self, angles: DVec3) -> Frame {
        let machine = self.kinematics();
        machine.table(angles).of(machine.table(self.system.angle_datum()).inverse())
    }

    /// The tables as they are now.
    pub(crate) fn tables(&self) -> Tables {
        Tables(Arc::clone(&self.kept))
    }

    /// Makes the tables again what they were.
    pub(crate) fn restore(&mut self, tables: Tables) {
        self.kept = tables.0;
        self.probe.take();
    }

    /// A point of the machine as the parts see it, that is where it was relative to them at the start.
    pub(crate) fn at_parts(&self, point: DVec3) -> DVec3 {
        self.parts.map_or(point, |parts| parts.point(point))
    }

    /// The direction of a vector of the machine as the parts see it.
    pub(crate) fn along_parts(&self, vector: DVec3) -> DVec3 {
        self.parts.map_or(vector, |parts| parts.vector(vector))
    }

    /// The way back from [`World::along_parts`].
    pub(crate) fn vector_off_parts(&self, vector: DVec3) -> DVec3 {
        self.parts.map_or(vector, |parts| parts.inverse().vector(vector))
    }

    /// The way back from [`World::at_parts`].
    pub(crate) fn off_parts(&self, point: DVec3) -> DVec3 {
        self.parts.map_or(point, |parts| parts.inverse().point(point))
    }

    /// A path of the ball as the parts see it.
    pub(crate) fn path_at_parts(&self, path: &BallPath) -> BallPath {
        match *path {
            BallPath::Line { from, to } => BallPath::line(self.at_parts(from), self.at_parts(to)),
            BallPath::Arc { centre, axis, from, sweep, rise } => BallPath::Arc {
                centre: self.at_parts(centre),
                axis: self.along_parts(axis),
                from: self.at_parts(from),
                sweep,
                rise,
            },
        }
    }

    /// The path of the tool tip, of a path of the linear axes.
    pub(crate) fn path_of_tip(&self, path: &BallPath) -> BallPath {
        let swung = self.swung();
        if swung == DVec3::ZERO { *path } else { path.moved(swung) }
    }

    /// The table of a kind; of datum tables the active one.
    pub(crate) fn table(&self, kind: TableKind) -> Result<&Table, TableError> {
        let table = match kind {
            TableKind::Points | TableKind::Free => None,
            TableKind::Datum => self.kept.datums.get(self.datum),
            _ => self.kept.tables.get(&kind),
        };
        table.map(Arc::as_ref).ok_or_else(|| TableError::NoTable { file: kind.file_name().to_owned() })
    }

    /// The table of a kind, to be written; it counts as written from now on.
    pub(crate) fn table_to_write(&mut self, kind: TableKind) -> Result<&mut Table, TableError> {
        let Kept { tables, datums, written, .. } = Arc::make_mut(&mut self.kept);
        let table = match kind {
            TableKind::Points | TableKind::Free => None,
            TableKind::Datum => datums.get_mut(self.datum),
            _ => tables.get_mut(&kind),
        };
        let table = table.map(Arc::make_mut);
        let table = table.ok_or_else(|| TableError::NoTable { file: kind.file_name().to_owned() })?;
        self.probe.take();
        if !written.iter().any(|file| file == table.file()) {
            written.push(table.file().to_owned());
        }
        Ok(table)
    }

    /// The table that a path in a program means.
    pub(crate) fn table_named(&self, name: &str) -> Result<&Table, TableError> {
        let Kept { tables, datums, free, .. } = &*self.kept;
        let found = free.iter().chain(tables.values()).chain(datums).find(|table| table.is_named(name));
        found.map(Arc::as_ref).ok_or_else(|| TableError::NoTable { file: name.to_owned() })
    }

    /// The table that a path in a program means, to be written; it counts as written from now on.
    pub(crate) fn named_table_to_write(&mut self, name: &str) -> Result<&mut Table, TableError> {
        let Kept { tables, datums, free, written, .. } = Arc::make_mut(&mut self.kept);
        let found = free.iter_mut().chain(tables.values_mut()).chain(datums).find(|table| table.is_named(name));
        let table = found.map(Arc::make_mut).ok_or_else(|| TableError::NoTable { file: name.to_owned() })?;
        self.probe.take();
        if !written.iter().any(|file| file == table.file()) {
            written.push(table.file().to_owned());
        }
        Ok(table)
    }

    /// A table that the program itself fills: it does not count as written.
    pub(crate) fn tools_of_program(&mut self) -> Option<&mut Table> {
        self.probe.take();
        Arc::make_mut(&mut self.kept).tables.get_mut(&TableKind::Tool).map(Arc::make_mut)
    }

    /// Makes a datum table the active one.
    pub(crate) fn select_datum_table(&mut self, name: &str) -> Result<(), TableError> {
        let found = self.kept.datums.iter().position(|table| table.is_named(name));
        self.datum = found.ok_or_else(|| TableError::NoTable { file: name.to_owned() })?;
        Ok(())
    }

    /// Names and texts of the tables that were written.
    pub(crate) fn written(&self) -> Vec<(String, String)> {
        let all = self.kept.tables.values().chain(&self.kept.datums).chain(&self.kept.free);
        let text =
            |file: &String| all.clone().find(|table| table.file() == file).map(|table| (file.clone(), table.to_text()));
        let written = |file: &String| match file.as_str() {
            KINEMATICS_FILE => Some((file.clone(), self.kept.kinematics.to_yaml())),
            MEMORIES_FILE => Some((file.clone(), SavedKinematics::file(&self.kept.memories))),
            _ => text(file),
        };
        self.kept.written.iter().filter_map(written).collect()
    }

    /// The number of the tool of a name.
    pub(crate) fn tool_named(&self, name: &str) -> Result<Option<f64>, TableError> {
        let found = self.table(TableKind::Tool)?.find("NAME", name)?;
        if found.is_some() { Ok(found) } else { self.table(TableKind::Turning)?.find("NAME", name) }
    }

    /// Whether tool calls are checked against the tables.
    pub(crate) fn has_tools(&self) -> bool {
        let any = |kind| self.table(kind).is_ok_and(|table| table.rows().next().is_some());
        any(TableKind::Tool) || any(TableKind::Turning)
    }

    /// Whether one of the tables of tools has a tool.
    pub(crate) fn has_tool(&self, number: f64) -> bool {
        [TableKind::Tool, TableKind::Turning].iter().any(|kind| self.table(*kind).is_ok_and(|own| own.has_row(number)))
    }

    /// The data of a tool with the oversizes of a tool call.
    pub(crate) fn tool_data(&self, number: f64, delta_radius: f64, delta_length: f64) -> Result<Tool, TableError> {
        let table = self.table(TableKind::Tool)?;
        if !self.has_tools() {
            let deltas = (delta_radius, delta_length);
            return Ok(Tool { number, radius: delta_radius, length: delta_length, deltas, ..Tool::default() });
        }
        let of_turning = self.turning_length(number)?;
        if !table.has_row(number) && self.has_tool(number) {
            let length = of_turning.unwrap_or_default() + delta_length;
            let deltas = (delta_radius, delta_length);
            return Ok(Tool { number, radius: delta_radius, length, deltas, ..Tool::default() });
        }
        let value = |column| table.number(number, column).map(Option::unwrap_or_default);
        let length = of_turning.map_or_else(|| Ok::<_, TableError>(value("L")? + value("DL")?), Ok)?;
        Ok(Tool {
            number,
            radius: value("R")? + value("DR")? + delta_radius,
            length: length + delta_length,
            corner: value("R2")? + value("DR2")?,
            point: value("T-ANGLE")?,
            angle: value("ANGLE")?,
            lcuts: value("LCUTS")?,
            corner_radius: value("R2")?,
            teeth: value("CUT")?,
            probe: table.number(number, "TP_NO")?.filter(|row| *row > 0.0),
            deltas: (delta_radius, delta_length),
        })
    }

    /// The tool, once one was called.
    pub(crate) const fn tool(&self) -> Option<Tool> {
        self.tool
    }

    /// The data that a tool had at the start, without the oversizes of a call.
    pub(crate) fn scene_tool(&self, number: f64) -> Option<Tool> {
        let value = |column| self.scene.tools.number(number, column).ok().flatten().unwrap_or_default();
        let (radius, length) = (value("R") + value("DR"), value("L") + value("DL"));
        self.scene.tools.has_row(number).then(|| Tool { number, radius, length, ..Tool::default() })
    }

    /// Puts a tool into the spindle.
    pub(crate) fn take_tool(&mut self, tool: Tool) {
        self.tool = Some(tool);
        self.align(Aligned::default());
        (self.spindle_turned, self.pressed) = (0.0, None);
        self.probe.take();
        if self.swung() != DVec3::ZERO {
            self.renew();
        }
    }

    /// Sets the world up for a contour that is only read: the tool has no radius, and is so far away that the first
    /// block moves it; far away along all axes, where each coordinate that is programmed shall show.
    pub(crate) fn stand_aside(&mut self, along_all: bool) {
        if let Some(tool) = &mut self.tool {
            tool.radius = 0.0;
        }
        let plane = self.system.plane;
        self.here = plane.main.with(self.here, plane.main.of(self.here) + ASIDE);
        if along_all {
            self.here = plane.secondary.with(self.here, plane.secondary.of(self.here) + ASIDE);
            self.here = plane.tool.with(self.here, plane.tool.of(self.here) + ASIDE);
        }
        self.machine = self.to_machine(self.here);
    }

    /// The tool in the spindle gets the data that its row has now. The spindle stays where it is, so a new length
    /// moves the tip.
    pub(crate) fn renew_tool(&mut self) -> Result<(), TableError> {
        let Some(old) = self.tool else { return Ok(()) };
        let new = self.tool_data(old.number, old.deltas.0, old.deltas.1)?;
        let tool = self.system.plane.tool.unit();
        let up = if self.system.is_on_workpiece() { tool } else { self.system.frame().vector(tool) };
        self.tool = Some(new);
        self.probe.take();
        if new.length != old.length {
            self.machine -= up * (new.length - old.length);
            self.renew();
        }
        Ok(())
    }

    /// The touch probe that a probing cycle uses now. Where no tool has a row of the probe table, the tool in
    /// the spindle is taken for the scene's probe.
    pub(crate) fn probe(&self) -> Result<ProbeData, Fault> {
        self.probe.get_or_init(|| self.read_probe()).clone()
    }

    /// The same, if there is one.
    pub(crate) fn probe_if_any(&self) -> Option<ProbeData> {
        self.probe.get_or_init(|| self.read_probe()).as_ref().ok().copied()
    }

    /// The point about which the head turns when the tool tip is there, in machine coordinates.
    pub(crate) fn pivot(&self, tip: DVec3) -> DVec3 {
        tip + self.to_pivot()
    }

    /// The number that a machine parameter has in the scene, by the name that the control prints.
    pub(crate) fn machine_parameter(&self, printed: &str) -> Option<f64> {
        self.scene.machine_number(printed)
    }

    /// An error where a position in machine coordinates takes an axis beyond its limits.
    pub(crate) fn within_limits(&self, machine: DVec3) -> Result<(), Fault> {
        self.beyond_limits(machine).map_or(Ok(()), Err)
    }

    /// The first axis that a position in machine coordinates takes beyond its limits.
    pub(crate) fn beyond_limits(&self, machine: DVec3) -> Option<Fault> {
        let fault = |letter: char, found: f64, min: f64, max: f64| {
            let fault = Fault::control("axis-limit").arg("axis", letter.to_string()).arg("found", found);
            fault.arg("min", min).arg("max", max).arg("unit", "mm")
        };
        if let Some((axis, found)) = self.parallels.beyond(&self.scene.machine, machine) {
            return Some(fault(axis.letter, found, axis.min, axis.max));
        }
        let linear = self.parallels.linear(machine);
        let axis = self.scene.machine.beyond_limits(linear)?;
        Some(fault(axis.axis.letter(), axis.axis.of(linear), axis.min, axis.max))
    }

    /// The rapid rate of a way of the tool tip in the machine, mm/min.
    pub(crate) fn rapid_feed(&self, way: DVec3) -> f64 {
        self.parallels.rapid_feed(&self.scene.machine, way)
    }

    /// The first rotary axis that angles in machine coordinates take beyond its limits.
    pub(crate) fn turned_too_far(&self, angles: DVec3) -> Option<Fault> {
        let axis = self.scene.machine.turned_too_far(angles)?;
        let (min, max) = axis.limits?;
        let letter = axis.axis.letter().to_string();
        let fault = Fault::control("axis-limit").arg("axis", letter).arg("found", axis.axis.of(angles));
        Some(fault.arg("min", min).arg("max", max).arg("unit", "°"))
    }

    /// The rotary axes in program coordinates.
    pub(crate) fn program_angles(&self) -> DVec3 {
        (self.angles - self.system.angle_datum()) * self.system.mirror().1
    }

    /// Whether a rotary axis takes part in tilting.
    pub(crate) fn tilts(&self, axis: RotaryAxis) -> bool {
        self.tilting_axes.as_ref().is_none_or(|axes| axes.contains(&axis))
    }

    /// Whether the machine has all linear axes.
    pub(crate) const fn has_all_axes(&self) -> bool {
        self.all_axes
    }

    /// The axes of the machine that a program can move.
    pub(crate) fn has_axis(&self, axis: Axis) -> bool {
        self.scene.machine.axis(axis).is_some()
    }
}
