//! The control on which strategies act: a run, as far as they may see it.
//!
//! Invariant: nothing is decided here; each function does the one thing that its trait says.
use std::ops::RangeInclusive;
use std::sync::Arc;

use glam::DVec3;

use crate::base::expr::{QKind, QRef, Value};
use crate::engine::flow::definition::FieldValue;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Around, Axis, Frame, RotaryAxis, WorkingPlane};
use crate::engine::machine::{Arm, Carried, Insert, Machine, MemoryReport, SavedKinematics, Survey, TurningInsert};
use crate::engine::motion::drives::{Spindle as Turning, Switched};
use crate::engine::motion::functions::{Effect, effect};
use crate::engine::motion::moves::Speed;
use crate::engine::motion::probe::ProbingStroke;
use crate::engine::region::Way;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::scene::{ParameterValue, Plate, Preset};
use crate::engine::strategy::action::{
    Calibrated, Coordinate, Course, Felt, Function, Kept, Kinematics, KnownSetter, Probe, Probing, Programs, Rotary,
    RotaryAxes, Running, Spindle, Stopped, Stylus, System, Tables, ToolSetter, Turntable,
};
use crate::engine::strategy::contour::Contours;
use crate::engine::strategy::digitizing::range::Digitizing;
use crate::engine::strategy::turning::area::Turned;
use crate::engine::strategy::turning::groove::Groove;
use crate::engine::strategy::turning::thread::TurnedThread;
use crate::engine::table::{Cell, TableError, TableKind};
use crate::engine::world::insert::Aligned;
use crate::engine::world::setter::Pose;

/// A run while a cycle is executed.
pub(super) struct OfRun<'c, 'x, 'r, 'e> {
    pub(super) run: &'c mut Run<'r, 'e>,
    pub(super) exec: &'c Exec<'x, 'e>,
}

impl System for OfRun<'_, '_, '_, '_> {
    fn plane(&self) -> WorkingPlane {
        self.run.drives.world.system.plane
    }

    fn frame(&self) -> Frame {
        *self.run.drives.world.system.frame()
    }

    fn around_datum(&self) -> (Frame, Frame) {
        self.run.drives.world.system.around_datum()
    }

    fn datums_are_of_machine(&self) -> bool {
        self.run.datums_of_machine(self.exec)
    }

    fn move_preset(&mut self, way: DVec3) {
        let drives = &mut self.run.drives;
        let before = drives.world.system.reported();
        let origin = drives.world.system.origin + way;
        drives.world.system.set_origin(origin);
        drives.transformed(before);
    }

    fn basic_rotation(&self) -> f64 {
        self.run.drives.world.system.basic_rotation()
    }

    fn set_basic_rotation(&mut self, degrees: f64, held: Option<DVec3>) {
        let drives = &mut self.run.drives;
        let before = drives.world.system.reported();
        let system = &mut drives.world.system;
        let held = held.map(|point| (point, system.frame().point(point)));
        system.set_basic_rotation(degrees);
        if let Some((point, held)) = held {
            let slipped = system.frame().point(point) - held;
            system.set_origin(system.origin - slipped);
        }
        drives.transformed(before);
    }

    fn align_turning(&mut self, precession: Option<f64>, reversed: Option<bool>) -> Done {
        let drives = &mut self.run.drives;
        let before = drives.world.aligned();
        let mut aligned = before;
        aligned.precession = precession.unwrap_or(aligned.precession).rem_euclid(360.0);
        aligned.reversed = reversed.unwrap_or(aligned.reversed);
        drives.align(aligned);
        if precession.is_some() || aligned != before { drives.orient_insert() } else { Ok(()) }
    }

    fn end_turning_alignment(&mut self) {
        let correction = self.run.drives.world.aligned().correction;
        self.run.drives.align(Aligned { correction, ..Aligned::default() });
    }

    fn zero_of(&self, axis: RotaryAxis) -> (f64, f64) {
        let system = &self.run.drives.world.system;
        (axis.of(system.angles), axis.of(system.angle_shift))
    }

    fn set_zero_of(&mut self, axis: RotaryAxis, (zero, shift): (f64, f64)) {
        let drives = &mut self.run.drives;
        let before = drives.world.system.reported();
        let system = &mut drives.world.system;
        system.angles = axis.with(system.angles, zero);
        system.angle_shift = axis.with(system.angle_shift, shift);
        drives.transformed(before);
    }
}

impl Tables for OfRun<'_, '_, '_, '_> {
    fn has_row(&self, table: TableKind, row: f64) -> Result<bool, Fault> {
        Ok(self.run.drives.world.table(table)?.has_row(row))
    }

    fn number(&self, table: TableKind, row: f64, column: &str) -> Result<Option<f64>, Fault> {
        Ok(self.run.drives.world.table(table)?.number(row, column)?)
    }

    fn preset(&self, row: f64) -> Result<(DVec3, Frame), Fault> {
        let has_row = self.has_row(TableKind::Preset, row)?;
        let preset = if has_row { self.run.drives.world.preset(row)? } else { Preset::default() };
        Ok((preset.origin, preset.frame()))
    }

    fn write(&mut self, table: TableKind, row: f64, column: &str, cell: &Cell) -> Done {
        if let (TableKind::Preset, Cell::Number(number)) = (table, cell) {
            // Rows do not know what the kinematics displace.
            let base = self.run.drives.world.kinematics().base;
            let displaced = Axis::ALL.into_iter().find(|axis| column == axis.letter().to_string());
            let number = number - displaced.map_or(0.0, |axis| axis.of(base));
            return self.run.write_cell(table, row, column, &Cell::Number(number));
        }
        self.run.write_cell(table, row, column, cell)
    }

    fn tool(&self) -> Option<f64> {
        self.run.drives.world.tool().map(|tool| tool.number)
    }

    fn insert(&self) -> Result<TurningInsert, Fault> {
        let world = &self.run.drives.world;
        if world.system.knows_tool() && world.is_askew() {
            // Its angles and where its tip is are those of an upright tool.
            return Err(Fault::unsupported("insert-askew"));
        }
        Ok(world.turning_insert()?)
    }
}

impl RotaryAxes for OfRun<'_, '_, '_, '_> {
    fn rotary(&self, axis: RotaryAxis) -> Result<Rotary, Fault> {
        let (drives, world) = (&self.run.drives, &self.run.drives.world);
        let data = drives.rotary_axis(axis)?;
        let about = world.kinematics().turning(data, world.angles).direction;
        Ok(Rotary { about, carries_workpiece: data.carries == Carried::Workpiece })
    }

    fn angle(&self, axis: RotaryAxis) -> f64 {
        axis.of(self.run.drives.world.angles)
    }

    fn turn_to(&mut self, axis: RotaryAxis, angle: f64) -> Done {
        self.run.drives.turn_to(&[(axis, angle)], Ok(Speed::Rapid))
    }

    fn for_tilted_plane(&self) -> Result<DVec3, Fault> {
        match self.run.drives.world.system.tilt() {
            Some(_) => self.run.drives.rotary_positions(),
            None => Ok(DVec3::ZERO),
        }
    }

    fn turn_about_point(&mut self, angles: DVec3, distance: f64, feed: f64) -> Done {
        self.run.drives.turn_about_point(angles, distance, Speed::of_feed(feed))
    }

    fn spindle_is_across(&self) -> bool {
        self.run.drives.spindle_is_across()
    }
}

impl Probe for OfRun<'_, '_, '_, '_> {
    fn ball(&self) -> Result<DVec3, Fault> {
        self.run.knows_tool_axis(self.exec)?;
        let world = &self.run.drives.world;
        Ok(world.system.back().point(world.believed_centre(world.machine, &world.probe()?)))
    }

    fn stroke(&mut self, way: DVec3, feed: f64) -> Done<Stopped> {
        let drives = &mut self.run.drives;
        let probe = drives.world.probe()?;
        let approach = ProbingStroke { direction: way.normalize(), path: way.length(), feed };
        let stop = drives.stroke(&probe, &approach)?;
        drives.world.machine = stop.tip;
        drives.world.renew();
        Ok(Stopped { centre: stop.centre, touched: stop.touched })
    }

    fn retract(&mut self, way: f64) -> Done {
        let drives = &mut self.run.drives;
        let Some(pressed) = drives.world.pressed else { return Ok(()) };
        let gone = (drives.world.machine - pressed.from).dot(pressed.direction);
        let to = drives.world.machine - pressed.direction * way.clamp(0.0, gone.max(0.0));
        drives.straight_to(drives.world.to_program(to), Some(to), Ok(Speed::Rapid))
    }

    fn calibration(&self) -> Result<Calibrated, Fault> {
        let world = &self.run.drives.world;
        let (probe, tool) = (world.probe()?, world.tool().unwrap_or_default());
        Ok(Calibrated { row: probe.row, offset: probe.calibrated, tool: tool.number, oversizes: tool.deltas })
    }

    fn renew(&mut self) -> Result<(), Fault> {
        Ok(self.run.drives.world.renew_tool()?)
    }
}

impl Spindle for OfRun<'_, '_, '_, '_> {
    fn running(&self) -> Running {
        running(&self.run.drives.switched)
    }

    fn at_begin(&self) -> Running {
        running(&self.exec.switched)
    }

    fn turn(&mut self, direction: i8, speed: f64) {
        self.run.drives.switched.spindle = Turning { speed, direction };
        self.run.drives.report_spindle(None);
    }

    fn coolant(&mut self, on: bool) {
        self.run.drives.coolant(on);
    }

    fn keep_orientation(&mut self, angle: f64) {
        self.run.drives.switched.orientation = angle;
    }

    fn function(&self, number: f64) -> Option<Function> {
        let whole = (0.0..=f64::from(u16::MAX)).contains(&number) && number.fract() == 0.0;
        match effect(whole.then_some(number as u16)?)? {
            Effect::Spindle(direction) => Some(Function { spindle: Some(direction), coolant: None }),
            Effect::Coolant(on) => Some(Function { spindle: None, coolant: Some(on) }),
            Effect::SpindleAndCoolant(direction) => Some(Function { spindle: Some(direction), coolant: Some(true) }),
            Effect::Nothing => Some(Function::default()),
            _ => None,
        }
    }
}

const fn running(switched: &Switched) -> Running {
    let Turning { speed, direction } = switched.spindle;
    Running { direction, speed, coolant: switched.coolant }
}

impl Programs for OfRun<'_, '_, '_, '_> {
    fn call(&mut self, name: &str) -> Done {
        self.run.execute_program(name)
    }

    fn keep_tolerance(&mut self, tolerance: Option<[f64; 3]>) {
        self.run.drives.report.report(EventKind::Tolerance(tolerance));
    }
}

impl Kept for OfRun<'_, '_, '_, '_> {
    fn kept(&self, name: &str) -> Option<f64> {
        match self.run.cycles.remembered.get(name) {
            Some(Value::Number(number)) => Some(*number),
            _ => None,
        }
    }

    fn read_contours(&mut self, depth: f64) -> Done {
        self.run.read_contours(depth)
    }

    fn read_first_contour(&mut self) -> Done {
        self.run.read_first_contour()
    }

    fn read_turned_contour(&mut self) -> Done<Way> {
        self.run.read_turned_contour()
    }

    fn read_developed_contour(&mut self, mm_in_degree: Option<f64>) -> Done {
        self.run.read_developed_contour(mm_in_degree)
    }

    fn contours(&self) -> &Contours {
        &self.run.cycles.contours
    }

    fn note_left(&mut self, area: f64, at: DVec3) {
        let drives = &mut self.run.drives;
        let at = drives.world.system.axes(at);
        drives.report.report(EventKind::Left { area, at });
    }

    fn outline_of_blank(&self, seen: &dyn Fn(&Way) -> Way) -> Option<Way> {
        self.run.drives.outline_of_blank(seen)
    }

    fn updates_blank(&self) -> bool {
        self.run.drives.blank.is_some()
    }

    fn keep_groove(&mut self, groove: Groove) {
        self.run.cycles.contours.groove = Some(groove);
    }

    fn keep_turned(&mut self, turned: Turned) {
        self.run.cycles.contours.turned = Some(turned);
    }

    fn keep_thread(&mut self, thread: TurnedThread) {
        self.run.cycles.contours.thread = Some(thread);
    }

    fn hold_insert(&mut self, insert: Insert) {
        self.run.drives.hold_insert(insert);
    }

    fn tool_radius(&self) -> f64 {
        self.run.cutter().radius
    }
}

impl Kinematics for OfRun<'_, '_, '_, '_> {
    fn kinematics(&self) -> Machine {
        self.run.drives.world.kinematics().clone()
    }

    fn set_kinematics(&mut self, machine: Machine) {
        let drives = &mut self.run.drives;
        let before = drives.world.system.reported();
        let moved = machine.base - drives.world.kinematics().base;
        let origin = drives.world.system.origin + moved;
        drives.world.set_kinematics(machine);
        drives.world.system.set_origin(origin);
        drives.transformed(before);
    }

    fn memories(&self) -> Vec<SavedKinematics> {
        self.run.drives.world.memories().to_vec()
    }

    fn set_memories(&mut self, memories: Vec<SavedKinematics>) {
        self.run.drives.world.set_memories(memories);
    }

    fn name_given(&self, meaning: &str) -> Result<String, Fault> {
        let cycle = self.exec.definition.cycle;
        let param = cycle.params.iter().find(|param| param.is.as_str() == meaning);
        let q = param.and_then(|param| param.q).unwrap_or(QRef::q(0));
        let name = QRef { kind: QKind::Qs, number: q.number };
        match self.run.params.text(name) {
            Ok(name) => Ok(name.to_string()),
            Err(_) => Ok(self.run.params.number(q)?.to_string()),
        }
    }

    fn forget_texts(&mut self, numbers: RangeInclusive<u16>) {
        for number in numbers {
            self.run.params.forget(QRef { kind: QKind::Qs, number });
        }
    }

    fn moment(&self) -> String {
        let clock = self.run.drives.world.scene.clock;
        let date = format!("{:02}-{:02}-{:04}", clock.day, clock.month, clock.year);
        format!("{date} {}:{:02}:{:02}", clock.hour, clock.minute, clock.second)
    }

    fn keep_memory_report(&mut self, report: MemoryReport) {
        self.run.drives.world.memory_report = Some(Arc::new(report));
    }

    fn survey(&self) -> Result<Survey, Fault> {
        let survey = self.run.drives.world.survey.as_deref().cloned();
        survey.ok_or_else(|| Fault::new(Class::Internal, "strategy-argument"))
    }

    fn keep_survey(&mut self, survey: Survey) {
        self.run.drives.world.survey = Some(Arc::new(survey));
    }

    fn limit(&self, name: &str) -> Option<f64> {
        let printed = self.exec.definition.on.datum(name).unwrap_or(name);
        self.run.drives.world.machine_parameter(printed)
    }

    fn angles(&self) -> DVec3 {
        self.run.drives.world.angles
    }

    fn angle_datum(&self) -> DVec3 {
        self.run.drives.world.system.angle_datum()
    }

    fn preset_in_effect(&self) -> (f64, DVec3) {
        let system = &self.run.drives.world.system;
        (system.preset, system.origin)
    }

    fn linear(&self) -> DVec3 {
        self.run.drives.world.machine
    }

    fn arm(&self) -> Result<Arm, Fault> {
        let world = &self.run.drives.world;
        let probe = world.probe()?;
        let up = world.system.plane.tool.unit();
        let offset = world.offset_of_straight_head(&probe);
        Ok(Arm { pivot: world.to_pivot(), ball: up * probe.effective_radius, offset })
    }

    fn probing(&self) -> Result<Probing, Fault> {
        let probe = self.run.drives.world.probe()?;
        let feed = if probe.machine_rapid { f64::INFINITY } else { probe.fmax };
        Ok(Probing { set_up: probe.set_up, feed, radius: probe.effective_radius })
    }

    fn release_tip(&mut self) -> Done {
        if self.run.drives.world.system.tip_held { self.run.drives.hold_tip(false) } else { Ok(()) }
    }

    fn go_turning(&mut self, turns: &[(RotaryAxis, f64)], to: DVec3, feed: f64) -> Done {
        let drives = &mut self.run.drives;
        drives.turn_and_go(turns, drives.world.to_program(to), Some(to), Speed::of_feed(feed), None)
    }

    fn touch(&mut self, way: DVec3) -> Done<DVec3> {
        self.run.drives.touch_along(way)
    }
}

impl ToolSetter for OfRun<'_, '_, '_, '_> {
    fn setter(&self) -> Result<KnownSetter, Fault> {
        let world = &self.run.drives.world;
        let truth = self.run.drives.tool_setter()?;
        let (Plate::Disc(radius) | Plate::Cube(radius)) = truth.plate;
        let is_round = matches!(truth.plate, Plate::Disc(_));
        if let Some((at, radius)) = world.calibrated_setter {
            let at = truth.mounted().inverse().point(at);
            return Ok(KnownSetter { at, radius, is_round });
        }
        let printed = self.exec.definition.on.datum("setter-centre");
        let at = match printed.and_then(|name| world.scene.machine_parameter(name)) {
            Some(ParameterValue::List(values)) => match values[..] {
                [x, y, z] => DVec3::new(x, y, z),
                _ => truth.at,
            },
            _ => truth.at,
        };
        Ok(KnownSetter { at: truth.mounted().inverse().point(at), radius, is_round })
    }

    fn calibrate_setter(&mut self, known: KnownSetter) {
        let mounted = self.run.drives.setter_frame().unwrap_or(Frame::IDENTITY);
        self.run.drives.world.calibrated_setter = Some((mounted.point(known.at), known.radius));
    }

    fn setting(&self, name: &str) -> Result<f64, Fault> {
        let printed = self.exec.definition.on.datum(name).unwrap_or(name);
        let value = self.run.drives.world.machine_parameter(printed);
        value.ok_or_else(|| Fault::control("machine-parameter-missing").arg("name", printed))
    }

    fn setting_word(&self, name: &str) -> Option<String> {
        let printed = self.exec.definition.on.datum(name)?;
        match self.run.drives.world.scene.machine_parameter(printed)? {
            ParameterValue::Number(number) => Some(number.to_string()),
            ParameterValue::Text(text) => Some(text.clone()),
            ParameterValue::List(_) => None,
        }
    }

    fn setter_frame(&self) -> Result<Frame, Fault> {
        self.run.drives.setter_frame()
    }

    fn tip(&self) -> Result<DVec3, Fault> {
        self.run.drives.tip_at_setter()
    }

    fn reckoned(&self) -> (f64, f64) {
        self.run.drives.world.tool().map_or((0.0, 0.0), |tool| (tool.radius, tool.length))
    }

    fn go(&mut self, to: DVec3) -> Done {
        self.run.drives.go_at_setter(to)
    }

    fn touch_setter(&mut self, way: DVec3, feed: f64, at: Option<f64>) -> Done<Option<DVec3>> {
        self.run.drives.touch_setter(way, feed, at.map_or(Pose::Turning, Pose::At))
    }

    fn orient(&mut self, angle: f64) {
        self.run.drives.orient(angle.rem_euclid(360.0));
    }

    fn cuts_counter_clockwise(&self) -> Result<bool, Fault> {
        let world = &self.run.drives.world;
        let Some(tool) = world.tool() else { return Ok(false) };
        Ok(world.table(TableKind::Tool)?.text(tool.number, "DIRECT.")? == "+")
    }

    fn first_edge(&self) -> Result<f64, Fault> {
        self.run.drives.first_edge()
    }
}

impl Stylus for OfRun<'_, '_, '_, '_> {
    fn stylus(&self) -> Result<(DVec3, f64), Fault> {
        let drives = &self.run.drives;
        let probe = drives.world.probe()?;
        Ok((drives.stylus_at(&probe), probe.feed))
    }

    fn feel(&self, course: Course) -> Result<Option<Felt>, Fault> {
        let drives = &self.run.drives;
        let probe = drives.world.probe()?;
        let found = match course {
            Course::Line { from, to } => drives.feel(&probe, from, to, None)?,
            Course::Arc { centre, from, sweep } => drives.feel(&probe, from, from, Some((centre, sweep)))?,
        };
        Ok(found.map(|(at, out)| Felt { at, out }))
    }

    fn touches(&self, at: DVec3, nearer: f64) -> Result<bool, Fault> {
        let drives = &self.run.drives;
        drives.touches_at(&drives.world.probe()?, at, nearer)
    }

    fn fly(&mut self, to: DVec3, feed: Option<f64>) -> Done {
        let drives = &mut self.run.drives;
        let probe = drives.world.probe()?;
        let to = to - drives.world.calibrated_offset(&probe);
        let speed = feed.map_or(Ok(Speed::Rapid), Speed::of_feed);
        drives.straight_to(to, None, speed)
    }

    fn slide(&mut self, to: DVec3, out: DVec3, feed: f64) -> Done {
        let drives = &mut self.run.drives;
        let probe = drives.world.probe()?;
        drives.slide(&probe, to, out, feed)
    }

    fn digitizing(&mut self) -> &mut Digitizing {
        &mut self.run.cycles.digitizing
    }

    fn coordinates(&self, meaning: &str) -> Vec<Coordinate> {
        let definition = &self.exec.definition;
        let param = definition.cycle.params.iter().find(|param| param.is.as_str() == meaning);
        let id = param.and_then(|param| param.field.as_ref()).map(|field| field.id.as_str());
        match id.and_then(|id| definition.field(id)) {
            Some(FieldValue::Coords(coords)) => {
                coords.iter().map(|own| Coordinate { axis: own.axis, rotary: own.rotary, value: own.value }).collect()
            }
            _ => Vec::new(),
        }
    }

    fn feel_turned(&self, turned: (RotaryAxis, f64), from: DVec3, to: DVec3) -> Result<Option<Felt>, Fault> {
        let drives = &self.run.drives;
        let found = drives.feel_turned(&drives.world.probe()?, turned, from, to)?;
        Ok(found.map(|(at, out)| Felt { at, out }))
    }

    fn touches_while_turning(&self, turned: (RotaryAxis, f64), at: DVec3) -> Result<bool, Fault> {
        let drives = &self.run.drives;
        drives.touches_while_turning(&drives.world.probe()?, turned, at)
    }

    fn way_in_degree(&self, axis: RotaryAxis, at: DVec3) -> Result<DVec3, Fault> {
        let drives = &self.run.drives;
        drives.way_in_degree(&drives.world.probe()?, axis, at)
    }

    fn fly_turning(&mut self, turned: (RotaryAxis, f64), to: DVec3, feed: Option<f64>) -> Done {
        let drives = &mut self.run.drives;
        let probe = drives.world.probe()?;
        drives.fly_turning(&probe, turned, to, feed.map_or(Ok(Speed::Rapid), Speed::of_feed))
    }

    fn points_of_table(&self, name: &str) -> Result<Vec<DVec3>, Fault> {
        let found = self.run.drives.world.scene.points.iter().find(|table| table.is_named(name));
        let table = found.ok_or_else(|| TableError::NoTable { file: name.to_owned() })?;
        let number = |row, column| table.number(row, column).map(Option::unwrap_or_default);
        let point = |row| Ok(DVec3::new(number(row, "X")?, number(row, "Y")?, number(row, "Z")?));
        table.rows().map(point).collect()
    }

    fn write_data(&mut self) -> Done {
        let (plane, mm) = (self.plane(), self.run.drives.unit());
        let kept = &self.run.cycles.digitizing;
        let Some(range) = &kept.range else { return Ok(()) };
        let (name, text) = kept.file(range, plane, mm);
        self.run.write_file(name, text);
        Ok(())
    }
}

impl Turntable for OfRun<'_, '_, '_, '_> {
    fn around(&self) -> Result<Around, Fault> {
        self.run.drives.around_table()
    }

    fn datum_off_table(&self) -> Result<f64, Fault> {
        self.run.drives.datum_off_table()
    }

    fn go_around(&mut self, to: Around, radius: f64, feed: f64) -> Done {
        self.run.drives.go_around_table(to, radius, Speed::of_feed(feed))
    }
}
