//! The strategies that the engine has: storing datums, reading a tolerance band; others have files of their own.
//!
//! Invariant: each does one thing with the values that it is given; none knows which cycle asked for it.
use glam::DVec3;

use crate::base::expr::Value;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, Frame};
use crate::engine::plan::{Calc, Strategy, StrategyCall};
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::scene::Preset;
use crate::engine::table::{Cell, TableKind};

/// Coordinates that differ by less, in mm, are the same: cells keep no more.
const UNCHANGED: f64 = 1e-9;

/// A point of the program and the coordinates that it shall have on some axes.
struct Wanted {
    /// The point in program coordinates, by axis.
    point: DVec3,
    /// Axis and coordinate.
    values: Vec<(Axis, f64)>,
}

impl Wanted {
    /// By how much coordinates must change to become those that are wanted; axes not named stay.
    fn change(&self, from: DVec3) -> DVec3 {
        self.values.iter().fold(DVec3::ZERO, |change, (axis, value)| axis.with(change, value - axis.of(from)))
    }
}

impl<'e> Run<'_, 'e> {
    pub(crate) fn strategy(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        match call.strategy {
            Strategy::SetDatum => {
                let wanted = self.wanted(call, exec)?;
                self.set_datum(&wanted);
                Ok(())
            }
            Strategy::WritePreset => {
                let (wanted, row) = (self.wanted(call, exec)?, self.row(call, exec)?);
                self.write_preset(&wanted, row)
            }
            Strategy::WriteDatumRow => {
                let (wanted, row) = (self.wanted(call, exec)?, self.row(call, exec)?);
                self.write_datum_row(&wanted, row, exec)
            }
            Strategy::ResetBasicRotation => {
                self.set_basic_rotation(0.0);
                Ok(())
            }
            Strategy::WriteBasicRotation => self.write_basic_rotation(call, exec),
            Strategy::TurnBasicRotation => self.turn_basic_rotation(call, exec),
            Strategy::Direction => self.direction_of(call, exec),
            Strategy::IntersectLines => self.intersect_lines(call, exec),
            Strategy::AlignRotaryTable => self.align_rotary_table(call, exec),
            Strategy::AlignRotaryAxis => self.align_rotary_axis(call, exec),
            Strategy::AlignDirection => self.align_direction(call, exec),
            Strategy::ZeroRotaryTable => {
                let axis = match call.with.first() {
                    Some(Some(_)) => self.numbered_axis(0, call, exec)?,
                    _ => self.drives.world.table_axis(),
                };
                self.zero_display(axis);
                Ok(())
            }
            Strategy::ZeroRotaryAxis => self.zero_rotary_axis(call, exec),
            Strategy::AddAngleToDatumRow => self.add_angle_to_datum_row(call, exec),
            Strategy::ProbeWithOwnPath => self.probe_with_own_path(call, exec),
            Strategy::RetractFromTouchPoint => self.retract_from_touch_point(call, exec),
            Strategy::PlaneAngles => self.plane_angles(call, exec),
            Strategy::StoreProbeCalibration => self.store_probe_calibration(call, exec),
            Strategy::PlungeOnHelix => self.plunge_on_helix(call, exec),
            Strategy::PlungeInStrokes => self.plunge_in_strokes(call, exec),
            Strategy::PlungeAlongSlot => self.plunge_along_slot(call, exec),
            Strategy::PlungeAlongCircularSlot => self.plunge_along_circular_slot(call, exec),
            Strategy::ClearRectangleLevel => self.clear_rectangle_level(call, exec),
            Strategy::ClearCircleLevel => self.clear_circle_level(call, exec),
            Strategy::ClearSlotLevel => self.clear_slot_level(call, exec),
            Strategy::ClearCircularSlotLevel => self.clear_circular_slot_level(call, exec),
            Strategy::FinishRectangleSide => self.finish_rectangle_side(call, exec),
            Strategy::FinishCircleSide => self.finish_circle_side(call, exec),
            Strategy::FinishSlotSide => self.finish_slot_side(call, exec),
            Strategy::FinishCircularSlotSide => self.finish_circular_slot_side(call, exec),
            Strategy::FinishRectangleFloor => self.finish_rectangle_floor(call, exec),
            Strategy::FinishCircleFloor => self.finish_circle_floor(call, exec),
            Strategy::FinishSlotFloor => self.finish_slot_floor(call, exec),
            Strategy::FinishCircularSlotFloor => self.finish_circular_slot_floor(call, exec),
            Strategy::MillRectangularStudLevel => self.mill_rectangular_stud_level(call, exec),
            Strategy::MillCircularStudLevel => self.mill_circular_stud_level(call, exec),
            Strategy::HalfTurn => self.half_turn(call, exec),
            Strategy::MillFaceLevel => self.mill_face_level(call, exec),
            Strategy::MoveToThreadStartPlane => self.move_to_thread_start_plane(call, exec),
            Strategy::ApproachThreadOnHelix => self.approach_thread_on_helix(call, exec),
            Strategy::MillThreadHelix => self.mill_thread_helix(call, exec),
            Strategy::DepartThreadTangentially => self.depart_thread_tangentially(call, exec),
            Strategy::CountersinkOnCircle => self.countersink_on_circle(call, exec),
            Strategy::ReverseSpindle => {
                let direction = -self.drives.switched.spindle.direction;
                self.drives.spindle(direction);
                Ok(())
            }
            Strategy::RestoreSpindleAndCoolant => {
                self.restore_spindle_and_coolant(exec);
                Ok(())
            }
            Strategy::TurnSpindle => self.turn_spindle(call, exec),
            Strategy::ExecuteMFunction => self.execute_m_function(call, exec),
            Strategy::ComputeRotaryPositions => self.compute_rotary_positions(call, exec),
            Strategy::PositionRotaryAxes => self.position_rotary_axes(call, exec),
            Strategy::CheckSpindleAcrossRotaryAxis => {
                let across = f64::from(u8::from(self.drives.spindle_is_across()));
                call.results.iter().for_each(|slot| exec.put(*slot, Value::Number(across)));
                Ok(())
            }
            Strategy::TurningInsert => self.turning_insert(call, exec),
            Strategy::CallProgram => {
                let Value::Text(name) = self.value(Self::argument(call, 0)?, exec)? else { return Ok(()) };
                self.execute_program(&name)
            }
            Strategy::KeepOrientationAngle => {
                self.drives.switched.orientation = self.given(call, 0, exec)?;
                Ok(())
            }
            Strategy::KeepTolerance => {
                let mut values = [0.0; 3];
                for (value, calc) in values.iter_mut().zip(&call.with) {
                    if let Some(calc) = calc {
                        *value = self.number(calc, exec)?;
                    }
                }
                let given = call.with.first().is_some_and(Option::is_some);
                self.drives.report.report(EventKind::Tolerance(given.then_some(values)));
                Ok(())
            }
            Strategy::ToleranceBand => {
                let Some(Some(text)) = call.with.first() else { return Ok(()) };
                let Value::Text(text) = self.value(text, exec)? else { return Ok(()) };
                let band = tolerance_band(&text);
                let monitored = f64::from(u8::from(band.is_some()));
                let (upper, lower) = band.unwrap_or_default();
                for (slot, value) in call.results.iter().zip([upper, lower, monitored]) {
                    exec.put(*slot, Value::Number(value));
                }
                Ok(())
            }
        }
    }

    /// Cutting width and cutting radius of the tool, as the tool table has them; 0 where it has none.
    fn turning_insert(&self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let table = self.drives.world.table(TableKind::Tool)?;
        let number = self.drives.world.tool().map(|tool| tool.number).filter(|number| table.has_row(*number));
        for (slot, column) in call.results.iter().zip(["CUTWIDTH", "RS"]) {
            let value = number.map_or(Ok(None), |number| table.number(number, column))?.unwrap_or_default();
            exec.put(*slot, Value::Number(value / self.drives.unit_of(TableKind::Tool, column)));
        }
        Ok(())
    }

    /// An argument that must be there.
    pub(crate) fn argument(call: &StrategyCall, index: usize) -> Result<&Calc, Fault> {
        let missing = || Fault::new(Class::Internal, "strategy-argument");
        call.with.get(index).and_then(Option::as_ref).ok_or_else(missing)
    }

    /// The number of an argument that must be there.
    pub(crate) fn given(&self, call: &StrategyCall, index: usize, exec: &Exec<'_, 'e>) -> Result<f64, Fault> {
        self.number(Self::argument(call, index)?, exec)
    }

    /// The numbers of arguments from that index on.
    pub(crate) fn all_given<const N: usize>(
        &self,
        call: &StrategyCall,
        from: usize,
        exec: &Exec<'_, 'e>,
    ) -> Result<[f64; N], Fault> {
        let mut numbers = [0.0; N];
        for (offset, number) in numbers.iter_mut().enumerate() {
            *number = self.given(call, from + offset, exec)?;
        }
        Ok(numbers)
    }

    /// The feed given with the strategy.
    pub(crate) fn feed_given(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<f64, Fault> {
        let missing = || Fault::new(Class::Internal, "strategy-argument");
        self.number(call.feed.as_ref().ok_or_else(missing)?, exec)
    }

    fn wanted(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Wanted, Fault> {
        let internal = || Fault::new(Class::Internal, "strategy-argument");
        let [Some(point), main, minor, tool, ..] = call.with.as_slice() else { return Err(internal()) };
        let plane = self.drives.world.system.plane;
        let mut values = Vec::with_capacity(3);
        for (axis, calc) in [(plane.main, main), (plane.secondary, minor), (plane.tool, tool)] {
            if let Some(calc) = calc {
                values.push((axis, self.number(calc, exec)? * self.drives.cycle_unit()));
            }
        }
        Ok(Wanted { point: self.drives.world.system.axes(self.point(point, exec)?) * self.drives.cycle_unit(), values })
    }

    fn row(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<f64, Fault> {
        self.number(Self::argument(call, 4)?, exec)
    }

    fn set_datum(&mut self, wanted: &Wanted) {
        let before = self.drives.world.system.reported();
        let change = wanted.change(wanted.point);
        let origin = self.drives.world.system.origin - self.drives.world.system.frame().vector(change);
        self.drives.world.system.set_origin(origin);
        self.drives.transformed(before);
    }

    /// The row keeps its spatial angles; a new row has none.
    fn write_preset(&mut self, wanted: &Wanted, row: f64) -> Done {
        let machine = self.drives.world.system.frame().point(wanted.point);
        let has_row = self.drives.world.table(TableKind::Preset)?.has_row(row);
        let old = if has_row { self.drives.world.preset(row)? } else { Preset::default() };
        let frame = old.frame();
        let change = wanted.change(frame.inverse().point(machine));
        self.write_coordinates(TableKind::Preset, row, wanted, old.origin, old.origin - frame.vector(change))
    }

    /// What makes the point have its coordinates once the row is the datum shift, with all else as it is.
    fn write_datum_row(&mut self, wanted: &Wanted, row: f64, exec: &Exec<'_, 'e>) -> Done {
        let machine = self.drives.world.system.frame().point(wanted.point);
        let (outside, inside) = self.drives.world.system.around_datum();
        let to_machine = if self.datums_of_machine(exec) { outside } else { Frame::IDENTITY };
        let table = self.drives.world.table(TableKind::Datum)?;
        let mut old = DVec3::ZERO;
        if table.has_row(row) {
            let number = |column| table.number(row, column).map(Option::unwrap_or_default);
            old = DVec3::new(number("X")?, number("Y")?, number("Z")?);
        }
        let shift = to_machine.inverse().point(old);
        let change = wanted.change(inside.inverse().vector(outside.inverse().point(machine) - shift));
        let new = to_machine.point(shift - inside.vector(change));
        self.write_coordinates(TableKind::Datum, row, wanted, old, new)
    }

    /// Writes the coordinates of the axes that are wanted. Where the system of the row is turned, what moves its datum
    /// along one of its axes changes other coordinates, too.
    fn write_coordinates(&mut self, kind: TableKind, row: f64, wanted: &Wanted, old: DVec3, new: DVec3) -> Done {
        for axis in Axis::ALL {
            let asked = wanted.values.iter().any(|(known, _)| *known == axis);
            if asked || (axis.of(old) - axis.of(new)).abs() > UNCHANGED {
                self.write_cell(kind, row, &axis.letter().to_string(), &Cell::Number(axis.of(new)))?;
            }
        }
        Ok(())
    }

    /// Whether the values of datum tables count from the machine datum and not from the preset.
    pub(crate) fn datums_of_machine(&self, exec: &Exec<'_, 'e>) -> bool {
        self.machine_datum("datum-table-reference", exec) == Some(1.0)
    }
}

/// Upper and lower limit of a tolerance text: an unsigned upper value, a minus with a lower value, or both.
/// Anything else monitors nothing.
fn tolerance_band(text: &str) -> Option<(f64, f64)> {
    let text = text.trim().replace(',', ".");
    let (upper, lower) = match text.split_once('-') {
        Some((upper, lower)) => (upper, Some(lower)),
        None => (text.as_str(), None),
    };
    let number = |part: &str| {
        let plain = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        part.parse::<f64>().ok().filter(|_| plain)
    };
    let upper = if upper.is_empty() && lower.is_some() { Some(0.0) } else { number(upper) }?;
    let lower = lower.map_or(Some(0.0), number)?;
    (upper > 0.0 || lower > 0.0).then_some((upper, -lower))
}

#[cfg(test)]
mod tests {
    use super::tolerance_band;

    /// The rows of the manual (004, lines 151-162) and what the example of the NC block says.
    #[test]
    fn tolerance_texts_read_as_the_manual_says() {
        assert_eq!(tolerance_band("0.4-0.1"), Some((0.4, -0.1)));
        assert_eq!(tolerance_band("0.4"), Some((0.4, -0.0)));
        assert_eq!(tolerance_band("-0.1"), Some((0.0, -0.1)));
        assert_eq!(tolerance_band("1-1"), Some((1.0, -1.0)));
        for none in [" ", "", "0", "0.1+0.1", "x", "-", "--1", "1e3", "0.1-"] {
            assert_eq!(tolerance_band(none), None, "{none:?}");
        }
    }
}
