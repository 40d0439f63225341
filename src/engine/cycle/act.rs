//! Actions of plans: each verb as an effect on the world.
//!
//! Invariant: coordinates of actions are main, minor and tool axis; they become axes here and nowhere deeper.
use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::base::expr::{QKind, QRef, Value};
use crate::engine::cycle::contours::LABELS;
use crate::engine::cycle::execute::Verdict;
use crate::engine::flow::definition::{FieldCoord, FieldValue};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, FitError, fit_circle};
use crate::engine::motion::moves::Speed;
use crate::engine::params::Content;
use crate::engine::plan::{Act, Builtin, Calc, Cancel, Cooling, Fitted, Inlined, Slot, SpindleTurn, Target, Transform};
use crate::engine::report::ending::Done;
use crate::engine::report::ending::Leave;
use crate::engine::report::event::Event;
use crate::engine::report::event::EventKind;
use crate::engine::report::event::MessageKind;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::sphere::fit_sphere;
use crate::engine::table::{Cell, TableKind};
use crate::engine::world::state::LOCKED;
use crate::spec::{Moment, Transformation};

impl<'e> Run<'_, 'e> {
    pub(crate) fn act(&mut self, act: &Act, exec: &mut Exec<'_, 'e>) -> Done {
        match act {
            Act::Rapid(target) => {
                let to = self.target_of(target, exec)?;
                self.drives.straight_to(to, None, Ok(Speed::Rapid))
            }
            Act::Feed(target, feed) => {
                let to = self.target_of(target, exec)?;
                let feed = self.number(feed, exec)? * self.drives.cycle_unit();
                self.drives.straight_to(to, None, Speed::of_feed(feed))
            }
            Act::Arc { centre, to, direction, feed } => self.arc_act(centre, to, direction, feed.as_ref(), exec),
            Act::Synchronized { tool, pitch, speed_factor } => {
                self.synchronized(tool, pitch, speed_factor.as_ref(), exec)
            }
            Act::Dwell(seconds) => {
                let seconds = self.number(seconds, exec)?;
                if seconds > 0.0 {
                    self.drives.report.report(EventKind::Dwell(seconds));
                }
                Ok(())
            }
            Act::Probe { towards, turned, into } => {
                self.knows_tool_axis(exec)?;
                let towards = self.point(towards, exec)?;
                let turned = turned.as_ref().map(|turned| self.number(turned, exec)).transpose()?;
                let centre = self.drives.probe(self.drives.to_mm(towards), turned)?;
                if let Some(slot) = into {
                    exec.put(*slot, Value::Point(self.drives.to_program(centre)));
                }
                Ok(())
            }
            Act::CallLast => self.call_last_cycle(),
            Act::Set(values) => {
                for (q, calc) in values {
                    let content = match self.value(calc, exec)? {
                        Value::Text(text) if q.kind == QKind::Qs => Content::Text(text),
                        Value::Number(number) => Content::Number(number),
                        _ => return Err(Fault::new(Class::Internal, "text-or-number").into()),
                    };
                    self.set_of_cycle(*q, content, exec)?;
                }
                Ok(())
            }
            Act::Store { field, next, value } => {
                let value = self.number(value, exec)?;
                let next = next.as_ref().map_or(Ok(0.0), |next| self.number(next, exec))?;
                match exec.definition.field(field) {
                    Some(FieldValue::Q(q)) => {
                        let number = q.number.saturating_add(next as u16);
                        Ok(self.set(QRef { number, ..*q }, Content::Number(value))?)
                    }
                    _ => Ok(()),
                }
            }
            Act::Let(lets) => {
                for named in lets {
                    let value = self.value(&named.value, exec)?;
                    exec.put(named.slot, value);
                }
                Ok(())
            }
            Act::Transform(transform) => self.transform(transform, exec),
            Act::ReadTable { table, row, column, into } => self.read_table(*table, row, column, *into, exec),
            Act::WriteTable { table, row, column, value, add } => {
                let (row, value) = (self.number(row, exec)?, self.number(value, exec)?);
                self.write_table(*table, row, column, value, *add)
            }
            Act::Log { name, screen, with } => {
                let mut values = Vec::with_capacity(with.len());
                for (name, calc) in with {
                    values.push((Arc::clone(name), self.value(calc, exec)?));
                }
                self.log(name, *screen, &values, exec)
            }
            Act::Fit { sphere, points, also, centre, radius } => {
                let points = self.fitted(points, also.as_ref(), exec)?;
                let found = if *sphere { Self::sphere_of(&points) } else { Self::circle_of(&points) };
                let (middle, far) = found.map_err(|error| Self::no_fit(error, points.len()))?;
                exec.put(*centre, Value::Point(middle));
                exec.put(*radius, Value::Number(far));
                Ok(())
            }
            Act::Lock(number) => {
                let number = self.number(number, exec)?;
                self.write_cell(TableKind::Tool, number, "TL", &Cell::Text(LOCKED.to_owned()))
            }
            Act::Spindle(turn) => {
                self.drives.spindle(match turn {
                    SpindleTurn::Clockwise => 1,
                    SpindleTurn::CounterClockwise => -1,
                    SpindleTurn::Stop => 0,
                });
                Ok(())
            }
            Act::Orient(angle) => {
                let angle = self.number(angle, exec)?;
                if let Some(probe) = self.drives.world.probe_if_any().filter(|_| self.drives.probing) {
                    self.drives.world.spindle_turned = angle - probe.angle;
                }
                self.drives.orient(angle);
                Ok(())
            }
            Act::Coolant(cooling) => {
                self.drives.coolant(*cooling == Cooling::On);
                Ok(())
            }
            Act::Fail(code) => {
                self.records.guards.insert((exec.definition.cycle.key, Arc::clone(code)));
                Err(Fault::of_cycle(code).into())
            }
            Act::Message(id) => {
                self.drives.report.report(EventKind::Message {
                    kind: MessageKind::Note,
                    id: Arc::clone(id),
                    answer: None,
                });
                Ok(())
            }
            Act::Ask { id, into } => self.ask_act(id, *into, exec),
            Act::Remember(values) => {
                for (name, calc) in values {
                    let value = self.value(calc, exec)?;
                    if &**name == LABELS {
                        self.cycles.sources.take_labels();
                    }
                    self.cycles.remembered.insert(Arc::clone(name), value);
                }
                Ok(())
            }
            Act::Use(inlined) => self.inlined(inlined, exec),
            Act::Strategy(call) => self.strategy(call, exec),
        }
    }

    /// While the tip is held, the tool may be askew to the working plane: a cycle that does not ask how it is
    /// would probe at another place than it believes.
    pub(crate) fn knows_tool_axis(&self, exec: &Exec<'_, 'e>) -> Result<(), Fault> {
        let asks = || exec.plan().builtins.iter().any(|(_, builtin)| *builtin == Builtin::ProbeUp);
        if self.drives.world.system.knows_tool() && self.drives.world.is_askew() && !asks() {
            return Err(Fault::unsupported("unsupported-tcpm").arg("cycle", exec.definition.cycle.key.to_string()));
        }
        Ok(())
    }

    /// The target of a move, by axes and in mm.
    fn target_of(&self, target: &Target, exec: &Exec<'_, 'e>) -> Result<DVec3, Fault> {
        match target {
            Target::Point(point) => Ok(self.drives.to_mm(self.point(point, exec)?)),
            Target::Axes(values) => {
                let plane = self.drives.world.system.plane;
                let mut to = self.drives.world.here;
                for (axis, calc) in [plane.main, plane.secondary, plane.tool].into_iter().zip(values) {
                    if let Some(calc) = calc {
                        to = self.drives.with_mm(axis, to, self.number(calc, exec)?);
                    }
                }
                Ok(to)
            }
        }
    }

    fn arc_act(
        &mut self,
        centre: &Calc,
        to: &Calc,
        direction: &Calc,
        feed: Option<&Calc>,
        exec: &Exec<'_, 'e>,
    ) -> Done {
        let centre = self.drives.world.system.axes(self.point(centre, exec)?) * self.drives.cycle_unit();
        let to = self.drives.to_mm(self.point(to, exec)?);
        let direction = self.number(direction, exec)?;
        let speed = match feed {
            Some(feed) => Speed::of_feed(self.number(feed, exec)? * self.drives.cycle_unit()),
            None => Ok(Speed::Rapid),
        };
        let near = (to - self.drives.world.here).length() == 0.0;
        if near || direction == 0.0 {
            return self.drives.straight_to(to, None, speed);
        }
        self.drives.arc_to(centre, to, direction.signum(), None, speed)
    }

    fn inlined(&mut self, inlined: &Inlined, exec: &mut Exec<'_, 'e>) -> Done {
        self.lets(&inlined.lets, exec);
        if self.guards(&inlined.guards, Moment::Call, exec)? == Verdict::Skip {
            return Ok(());
        }
        self.acts(&inlined.block, exec)
    }

    fn ask_act(&mut self, id: &Arc<str>, into: Option<Slot>, exec: &mut Exec<'_, 'e>) -> Done {
        let answer = self.ask(id);
        self.drives.report.report(EventKind::Message { kind: MessageKind::Question, id: Arc::clone(id), answer });
        match (answer, into) {
            (Some(agreed), Some(slot)) => {
                exec.put(slot, Value::Bool(agreed));
                Ok(())
            }
            (Some(true), None) => Ok(()),
            (Some(false), None) | (None, _) => Err(Leave::Stopped),
        }
    }

    /// The points that something is fitted to.
    fn fitted(&self, points: &Fitted, also: Option<&Calc>, exec: &Exec<'_, 'e>) -> Result<Vec<DVec3>, Fault> {
        let mut all: Vec<DVec3> = match points {
            Fitted::List(list) => {
                exec.lists.get(*list).map_or(&[][..], Vec::as_slice).iter().filter_map(as_point).collect()
            }
            Fitted::Points(points) => {
                points.iter().map(|point| self.point(point, exec)).collect::<Result<Vec<_>, _>>()?
            }
        };
        if let Some(point) = also {
            all.push(self.point(point, exec)?);
        }
        Ok(all)
    }

    fn circle_of(points: &[DVec3]) -> Result<(DVec3, f64), FitError> {
        let flat: Vec<DVec2> = points.iter().map(|point| point.truncate()).collect();
        let circle = fit_circle(&flat)?;
        let height = points.iter().map(|point| point.z).sum::<f64>() / points.len() as f64;
        Ok((circle.centre.extend(height), circle.radius))
    }

    fn sphere_of(points: &[DVec3]) -> Result<(DVec3, f64), FitError> {
        fit_sphere(points).map(|sphere| (sphere.centre, sphere.radius))
    }

    fn no_fit(error: FitError, points: usize) -> Fault {
        let fault = match error {
            // Cycles offer enough points; a specification that does not is wrong.
            FitError::TooFew => Fault::new(Class::Internal, "fit-too-few"),
            FitError::Collinear => Fault::control("fit-collinear"),
            FitError::NotFinite | FitError::NoConvergence => Fault::control("fit-failed"),
        };
        fault.arg("points", points)
    }

    fn transform(&mut self, transform: &Transform, exec: &Exec<'_, 'e>) -> Done {
        match transform {
            Transform::Cancel(ended) if ended.contains(&Cancel::RadiusCompensation) => self.end_contour()?,
            _ => self.drives.not_compensated(exec.definition.cycle.key.to_string())?,
        }
        let before = self.drives.world.system.reported();
        match transform {
            Transform::DatumShift(id) => {
                if let Some(FieldValue::Coords(coords)) = exec.definition.field(id) {
                    let system = &mut self.drives.world.system;
                    let shift = shifted(system.datum(), coords, false);
                    system.angle_shift = shifted(system.angle_shift, coords, true);
                    system.set_datum(shift);
                }
            }
            Transform::DatumRow(id) => {
                if let Some(FieldValue::Number { value: row, .. }) = exec.definition.field(id) {
                    let table = self.drives.world.table(TableKind::Datum)?;
                    let number = |column| table.number(*row, column).map(Option::unwrap_or_default);
                    let shift = DVec3::new(number("X")?, number("Y")?, number("Z")?);
                    let angles = DVec3::new(number("A")?, number("B")?, number("C")?);
                    let of_machine = self.datums_of_machine(exec);
                    let system = &mut self.drives.world.system;
                    if of_machine {
                        system.angle_shift = angles - system.angles;
                        system.set_datum(system.around_datum().0.inverse().point(shift));
                    } else {
                        system.angle_shift = angles;
                        system.set_datum(shift);
                    }
                }
            }
            Transform::Rotation(id) => {
                if let Some(FieldValue::Number { value, incremental, .. }) = exec.definition.field(id) {
                    let from = if *incremental { self.drives.world.system.rotation() } else { 0.0 };
                    self.drives.world.system.set_rotation(from + value);
                }
            }
            Transform::Mirroring(id) => {
                let (mut linear, mut rotary) = (DVec3::ONE, DVec3::ONE);
                if let Some(FieldValue::Coords(axes)) = exec.definition.field(id) {
                    for axis in axes {
                        let signs = if axis.rotary { &mut rotary } else { &mut linear };
                        *signs = axis.axis.with(*signs, -1.0);
                    }
                }
                self.drives.world.system.set_mirror(linear, rotary);
            }
            Transform::Scaling(id) => {
                if let Some(FieldValue::Number { value, .. }) = exec.definition.field(id) {
                    let factor = factor(*value)?;
                    self.drives.world.system.set_scale(factor);
                }
            }
            Transform::AxisScaling(factors, centre) => {
                let coords = |id: &Arc<str>, from: DVec3| match exec.definition.field(id) {
                    Some(FieldValue::Coords(coords)) => shifted(from, coords, false),
                    _ => from,
                };
                let (factors, about) = (coords(factors, DVec3::ONE), coords(centre, DVec3::ZERO));
                for axis in Axis::ALL {
                    factor(axis.of(factors))?;
                }
                self.drives.world.system.set_axis_scale(factors, about);
            }
            Transform::Tilting(id) => {
                let angles = match exec.definition.field(id) {
                    Some(FieldValue::Coords(coords)) => {
                        shifted(self.drives.world.system.tilt().unwrap_or_default(), coords, true)
                    }
                    _ => DVec3::ZERO,
                };
                self.drives.world.carry_system();
                self.drives.world.system.set_tilt(angles);
                self.drives.counted_alone()?;
            }
            Transform::Preset(row) => {
                let row = self.number(row, exec)?;
                let preset = self.drives.world.preset(row)?;
                self.drives.world.system.set_preset(row, preset);
            }
            Transform::Cancel(ended) => {
                for cancel in ended {
                    match cancel {
                        Cancel::DatumShift => {
                            self.drives.world.system.angle_shift = DVec3::ZERO;
                            self.drives.world.system.set_datum(DVec3::ZERO);
                        }
                        Cancel::Rotation => self.drives.world.system.set_rotation(0.0),
                        // Done before anything changes.
                        Cancel::RadiusCompensation => {}
                        Cancel::Mirroring => {
                            self.drives.ends(Transformation::Mirroring);
                            self.drives.world.system.set_mirror(DVec3::ONE, DVec3::ONE);
                        }
                        Cancel::Scaling => {
                            self.drives.ends(Transformation::Scaling);
                            self.drives.world.system.set_scale(1.0);
                        }
                        Cancel::AxisScaling => {
                            self.drives.ends(Transformation::AxisScaling);
                            self.drives.world.system.set_axis_scale(DVec3::ONE, DVec3::ZERO);
                        }
                    }
                }
            }
        }
        self.drives.transformed(before);
        Ok(())
    }

    /// The column of a word: `main`, `minor` and `tool` are the axes of the working plane.
    fn column(&self, word: &str) -> String {
        self.drives.world.system.axis_of_word(word).map_or_else(|| word.to_owned(), |axis| axis.letter().to_string())
    }

    fn read_table(&self, table: TableKind, row: &Calc, column: &str, into: Slot, exec: &mut Exec<'_, 'e>) -> Done {
        let row = self.number(row, exec)?;
        let column = self.column(column);
        let value = self.drives.world.table(table)?.number(row, &column)?;
        exec.put(into, Value::Number(value.unwrap_or_default() / self.drives.unit_of(table, &column)));
        Ok(())
    }

    fn write_table(&mut self, kind: TableKind, row: f64, column: &str, value: f64, add: bool) -> Done {
        let column = self.column(column);
        let old = if add { self.drives.world.table(kind)?.number(row, &column)?.unwrap_or_default() } else { 0.0 };
        let unit = self.drives.unit_of(kind, &column);
        self.write_cell(kind, row, &column, &Cell::Number(old + value * unit))
    }

    /// Whether the values of datum tables count from the machine datum and not from the preset.
    pub(super) fn datums_of_machine(&self, exec: &Exec<'_, 'e>) -> bool {
        self.machine_datum("datum-table-reference", exec) == Some(1.0)
    }

    /// Writes a cell and reports it. Rows of the tool table must be there; others are added.
    pub(crate) fn write_cell(&mut self, kind: TableKind, row: f64, column: &str, cell: &Cell) -> Done {
        let table = self.drives.world.table_to_write(kind)?;
        if kind != TableKind::Tool {
            table.add_row(row)?;
        }
        table.set(row, column, cell)?;
        let file = table.file().to_owned();
        let value = match cell {
            Cell::Number(number) => Content::Number(*number),
            Cell::Text(text) => Content::Text(text.as_str().into()),
            Cell::Empty => Content::Text("".into()),
        };
        let kind = EventKind::Table { file, row, column: column.to_owned(), value };
        if self.cycles.inside > 0 {
            self.cycles.writing.push(Event { at: self.drives.report.at().clone(), kind });
        } else {
            self.drives.report.report(kind);
        }
        Ok(())
    }
}

const fn as_point(value: &Value) -> Option<DVec3> {
    match value {
        Value::Point(point) => Some(*point),
        _ => None,
    }
}

/// A scaling factor; one of 0 leaves nothing of the part.
fn factor(value: f64) -> Result<f64, Fault> {
    if value > 0.0 { Ok(value) } else { Err(Fault::program("scaling-factor-zero").arg("found", value)) }
}

/// A datum shift with new coordinates, of the linear or of the rotary axes: axes not named keep theirs.
fn shifted(from: DVec3, coords: &[FieldCoord], rotary: bool) -> DVec3 {
    coords.iter().filter(|coord| coord.rotary == rotary).fold(from, |shift, coord| {
        let base = if coord.incremental { coord.axis.of(shift) } else { 0.0 };
        coord.axis.with(shift, base + coord.value)
    })
}
