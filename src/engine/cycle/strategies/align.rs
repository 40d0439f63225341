//! Strategies of misalignment: directions and intersections in the working plane, basic rotation, rotary axes.
//!
//! Invariant: a direction is never guessed: points that determine none are a fault; each strategy does one thing with
//! the values that it is given.
use glam::DVec2;

use crate::base::expr::{Value, atan2d};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, RotaryAxis, WorkingPlane};
use crate::engine::machine::Carried;
use crate::engine::motion::moves::Speed;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::{Cell, TableKind};

/// Points that are nearer to each other, in mm, determine no direction: a tenth of what controls take as input.
const SAME_POINT: f64 = 1e-5;
/// Lines are parallel if the sine of the angle between them is smaller.
const PARALLEL: f64 = 1e-9;
/// A rotary axis turns about a direction if the cosine of the angle between them differs from 1 by less.
const ALONG: f64 = 1e-9;

/// The angle from -180 (excluded) to 180 that means the same direction.
fn direction(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(360.0);
    if turned > 180.0 { turned - 360.0 } else { turned }
}

/// The angle from -90 (excluded) to 90 that means the same line.
fn line(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(180.0);
    if turned > 90.0 { turned - 180.0 } else { turned }
}

impl<'e> Run<'_, 'e> {
    fn result(call: &StrategyCall, values: &[f64], exec: &mut Exec<'_, 'e>) {
        for (slot, value) in call.results.iter().zip(values) {
            exec.put(*slot, Value::Number(*value));
        }
    }

    /// The vector from one point to another in the working plane.
    fn vector(&self, call: &StrategyCall, from: usize, exec: &Exec<'_, 'e>) -> Result<DVec2, Fault> {
        let to = self.point(Self::argument(call, from + 1)?, exec)?;
        let way = (to - self.point(Self::argument(call, from)?, exec)?).truncate();
        if way.length() < SAME_POINT {
            return Err(Fault::control("direction-undefined").arg("distance", way.length()));
        }
        Ok(way)
    }

    pub(super) fn direction_of(&self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let way = self.vector(call, 0, exec)?;
        Self::result(call, &[atan2d(way.y, way.x)], exec);
        Ok(())
    }

    pub(super) fn intersect_lines(&self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let (first, second) = (self.vector(call, 0, exec)?.normalize(), self.vector(call, 2, exec)?.normalize());
        let across = first.perp_dot(second);
        if across.abs() < PARALLEL {
            return Err(Fault::control("lines-parallel").into());
        }
        let a = self.point(Self::argument(call, 0)?, exec)?.truncate();
        let b = self.point(Self::argument(call, 2)?, exec)?.truncate();
        let met = a + first * ((b - a).perp_dot(second) / across);
        Self::result(call, &[met.x, met.y], exec);
        Ok(())
    }

    /// Sets the basic rotation in effect; the preset stays where it is.
    pub(super) fn set_basic_rotation(&mut self, degrees: f64) {
        let before = self.drives.world.system.reported();
        self.drives.world.system.set_basic_rotation(degrees);
        self.drives.transformed(before);
    }

    pub(super) fn write_basic_rotation(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let angle = self.number(Self::argument(call, 0)?, exec)?;
        let row = match call.with.get(1) {
            Some(Some(row)) => self.number(row, exec)?,
            _ => 0.0,
        };
        if row == 0.0 {
            self.set_basic_rotation(angle);
            return Ok(());
        }
        let column = format!("SP{}", self.drives.world.table_axis().letter());
        self.write_cell(TableKind::Preset, row, &column, &Cell::Number(angle))
    }

    /// The point keeps its coordinates in the program; without one, the preset stays where it is.
    pub(super) fn turn_basic_rotation(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let angle = self.number(Self::argument(call, 0)?, exec)?;
        let about = match call.with.get(1) {
            Some(Some(about)) => {
                Some(self.drives.world.system.axes(self.point(about, exec)?) * self.drives.cycle_unit())
            }
            _ => None,
        };
        let before = self.drives.world.system.reported();
        let system = &mut self.drives.world.system;
        let held = about.map(|about| system.frame().point(about));
        system.set_basic_rotation(direction(system.basic_rotation() + angle));
        if let (Some(about), Some(held)) = (about, held) {
            let slipped = system.frame().point(about) - held;
            system.set_origin(system.origin - slipped);
        }
        self.drives.transformed(before);
        Ok(())
    }

    /// By how much a rotary axis must go so that the workpiece, turned by an angle about an axis of the program, is
    /// straight relative to the tool.
    fn straightening(&self, axis: RotaryAxis, about: Axis, degrees: f64) -> Result<f64, Fault> {
        let data = self.drives.rotary_axis(axis)?;
        let turning = self.drives.world.scene.machine.turning(data, self.drives.world.angles);
        let along = turning.direction.dot(self.drives.world.system.frame().vector(about.unit()));
        if 1.0 - along.abs() > ALONG {
            return Err(Fault::control("rotary-axis-unsuitable").arg("axis", axis.letter().to_string()));
        }
        // A table turns the workpiece back, a head turns the tool after it.
        let sense = match data.carries {
            Carried::Workpiece => -along.signum(),
            Carried::Tool => along.signum(),
        };
        Ok(sense * degrees)
    }

    fn turn_by(&mut self, axis: RotaryAxis, way: f64) -> Done {
        let to = axis.of(self.drives.world.angles) + way;
        self.drives.turn_to(&[(axis, to)], Ok(Speed::Rapid))
    }

    pub(super) fn align_rotary_table(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let angle = self.number(Self::argument(call, 0)?, exec)?;
        let axis = self.drives.world.table_axis();
        let way = self.straightening(axis, axis.0, angle)?;
        self.turn_by(axis, way)?;
        Self::result(call, &[way], exec);
        Ok(())
    }

    /// The axis of a number: 4, 5, 6 mean A, B, C.
    pub(super) fn numbered_axis(
        &self,
        index: usize,
        call: &StrategyCall,
        exec: &Exec<'_, 'e>,
    ) -> Result<RotaryAxis, Fault> {
        let number = self.number(Self::argument(call, index)?, exec)?;
        let found = RotaryAxis::ALL.into_iter().zip([4.0, 5.0, 6.0]).find(|(_, known)| *known == number);
        let unknown = || Fault::program("parameter-out-of-range").arg("q", "").arg("value", number);
        found.map(|(axis, _)| axis).ok_or_else(unknown)
    }

    /// A line measured along an axis of the working plane shall lie along the other one; one measured along the tool
    /// axis shall be level across the rotary axis. With an angle, it shall lie at that angle to where it would lie so.
    pub(super) fn align_rotary_axis(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let from = self.point(Self::argument(call, 0)?, exec)?;
        let to = self.point(Self::argument(call, 1)?, exec)?;
        let plane = self.drives.world.system.plane;
        let measured = match self.number(Self::argument(call, 2)?, exec)? {
            1.0 => plane.main,
            2.0 => plane.secondary,
            _ => plane.tool,
        };
        let axis = self.numbered_axis(3, call, exec)?;
        let about = axis.0;
        // The axis along which the line shall lie, and the one that follows it about the rotary axis.
        let along = Axis::ALL.into_iter().find(|known| *known != measured && *known != about);
        let in_plane = about == plane.tool;
        let (Some(along), true) = (along, in_plane != (measured == plane.tool)) else {
            return Err(Fault::control("rotary-axis-unsuitable").arg("axis", axis.letter().to_string()).into());
        };
        let across = about.unit().cross(along.unit());
        let way = self.drives.world.system.axes(to) - self.drives.world.system.axes(from);
        let (x, y) = (along.of(way), way.dot(across));
        if libm::hypot(x, y) < SAME_POINT {
            return Err(Fault::control("direction-undefined").arg("distance", libm::hypot(x, y)).into());
        }
        let found = atan2d(y, x);
        let wanted = match call.with.get(4) {
            Some(Some(angle)) => self.number(angle, exec)?,
            _ => 0.0,
        };
        let angle = line(found - wanted);
        let way = self.straightening(axis, about, angle)?;
        self.turn_by(axis, way)?;
        Self::result(call, &[angle, way], exec);
        Ok(())
    }

    /// The directions are those in the plane across the rotary axis; the nominal one may be its second axis (Y for C).
    pub(super) fn align_direction(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let axis = self.numbered_axis(0, call, exec)?;
        let plane = WorkingPlane::of_tool_axis(axis.0);
        let flat = |index| -> Result<DVec2, Fault> {
            let point = self.point(Self::argument(call, index)?, exec)?;
            let flat = plane.flat(self.drives.world.system.axes(point));
            if flat.length() < SAME_POINT {
                return Err(Fault::control("direction-undefined").arg("distance", flat.length()));
            }
            Ok(flat)
        };
        let actual = flat(1)?;
        let along_second = self.number(Self::argument(call, 3)?, exec)? != 0.0;
        let nominal = if along_second { DVec2::Y } else { flat(2)? };
        let angle = direction(atan2d(actual.y, actual.x) - atan2d(nominal.y, nominal.x));
        let way = self.straightening(axis, axis.0, angle)?;
        self.turn_by(axis, way)?;
        Self::result(call, &[angle, way], exec);
        Ok(())
    }

    /// The display of a rotary axis shows 0 where it is.
    pub(super) fn zero_display(&mut self, axis: RotaryAxis) {
        let before = self.drives.world.system.reported();
        let system = &mut self.drives.world.system;
        let zero = axis.of(self.drives.world.angles) - axis.of(system.angle_shift);
        system.angles = axis.with(system.angles, zero);
        self.drives.transformed(before);
    }

    /// The preset table holds where the axis is in machine coordinates; in the datum table the shift of the
    /// present preset, which takes effect.
    pub(super) fn zero_rotary_axis(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let axis = self.numbered_axis(0, call, exec)?;
        let row = self.number(Self::argument(call, 1)?, exec)?;
        let into_preset = self.number(Self::argument(call, 2)?, exec)? != 0.0;
        let column = axis.letter().to_string();
        let machine = axis.of(self.drives.world.angles);
        if into_preset {
            self.write_cell(TableKind::Preset, row, &column, &Cell::Number(machine))?;
            self.zero_display(axis);
            return Ok(());
        }
        let shift = machine - axis.of(self.drives.world.system.angles);
        self.write_cell(TableKind::Datum, row, &column, &Cell::Number(shift))?;
        let before = self.drives.world.system.reported();
        self.drives.world.system.angle_shift = axis.with(self.drives.world.system.angle_shift, shift);
        self.drives.transformed(before);
        Ok(())
    }

    pub(super) fn add_angle_to_datum_row(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let angle = self.number(Self::argument(call, 0)?, exec)?;
        let row = self.number(Self::argument(call, 1)?, exec)?;
        let column = self.numbered_axis(2, call, exec)?.letter().to_string();
        let table = self.drives.world.table(TableKind::Datum)?;
        let old = if table.has_row(row) { table.number(row, &column)?.unwrap_or_default() } else { 0.0 };
        self.write_cell(TableKind::Datum, row, &column, &Cell::Number(old + angle))
    }
}
