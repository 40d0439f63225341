//! Strategies of measuring and calibrating: probing on a path of its own, the angles of a plane,
//! what a calibration found.
//!
//! Invariant: one value or one movement at a time; which cycle asks is not known here.
use glam::{DMat3, DVec3};

use crate::base::expr::{Value, atan2d};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::Axis;
use crate::engine::motion::moves::Speed;
use crate::engine::motion::probe::Approach;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::{Cell, TableKind};

/// Three points lie on a line if the triangle that they span is flatter than this, as a sine.
const ON_LINE: f64 = 1e-9;

impl<'e> Run<'_, 'e> {
    fn put_all(call: &StrategyCall, values: &[f64], exec: &mut Exec<'_, 'e>) {
        for (slot, value) in call.results.iter().zip(values) {
            exec.put(*slot, Value::Number(*value));
        }
    }

    fn optional(&self, call: &StrategyCall, index: usize, exec: &Exec<'_, 'e>) -> Result<Option<f64>, Fault> {
        call.with.get(index).and_then(Option::as_ref).map(|calc| self.number(calc, exec)).transpose()
    }

    /// Probes from where the probe is, on a path and at a feed of its own, and stays where it stops.
    pub(super) fn probe_with_own_path(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        self.knows_tool_axis(exec)?;
        let probe = self.drives.world.probe()?;
        let direction = self.drives.world.system.axes(self.point(Self::argument(call, 0)?, exec)?);
        let number =
            |index| Ok::<_, Fault>(self.number(Self::argument(call, index)?, exec)? * self.drives.cycle_unit());
        let (path, feed) = (number(1)?, number(2)?);
        let flag = |index| Ok::<_, Fault>(self.optional(call, index, exec)?.unwrap_or(0.0) != 0.0);
        let (in_machine, tolerant, silent) = (flag(3)?, flag(4)?, flag(5)?);
        let way = direction * path;
        let way = if in_machine { self.drives.world.system.back().vector(way) } else { way };
        let (frame, back) = (*self.drives.world.system.frame(), *self.drives.world.system.back());
        let here = back.point(self.drives.world.believed_centre(self.drives.world.machine, &probe));
        let (mut centre, mut status) = (here, 1.0);
        if way.length() > 0.0 {
            let approach = Approach { direction: way.normalize(), path: way.length(), feed };
            match self.drives.approach(&probe, &approach) {
                Ok(stop) => {
                    (centre, status) = (stop.centre, if stop.touched { 0.0 } else { 1.0 });
                    self.drives.world.machine = stop.tip;
                    self.drives.world.renew();
                }
                Err(crate::engine::report::ending::Leave::Fault(fault))
                    if silent && fault.code == "probe-deflected" =>
                {
                    status = 2.0
                }
                Err(leave) => return Err(leave),
            }
        }
        if status == 1.0 && !tolerant {
            return Err(Fault::control("probe-no-contact").arg("distance", way.length()).into());
        }
        let centre = self.drives.to_program(if in_machine { frame.point(centre) } else { centre });
        Self::put_all(call, &[centre.x, centre.y, centre.z, status], exec);
        Ok(())
    }

    /// Back against the direction in which the probe touched, not beyond where that movement began.
    pub(super) fn retract_from_touch_point(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let path = self.number(Self::argument(call, 0)?, exec)? * self.drives.cycle_unit();
        let Some(pressed) = self.drives.world.pressed else { return Ok(()) };
        let way = (self.drives.world.machine - pressed.from).dot(pressed.direction);
        let to = self.drives.world.machine - pressed.direction * path.clamp(0.0, way.max(0.0));
        self.drives.straight_to(self.drives.world.to_program(to), Some(to), Ok(Speed::Rapid))
    }

    /// The angles of the plane through three points: those of its sections along the axes, those of rotary axes A and B
    /// that tilt a plane parallel to it, and the spatial angles of a system in it, whose main axis runs from the first
    /// point to the second and whose secondary axis points to the side of the third.
    pub(super) fn plane_angles(&self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let point = |index| self.point(Self::argument(call, index)?, exec);
        let (first, second, third) = (point(0)?, point(1)?, point(2)?);
        let (along, aside) = (second - first, third - first);
        let normal = along.cross(aside);
        if normal.length() <= ON_LINE * along.length() * aside.length() {
            return Err(Fault::control("plane-through-line").into());
        }
        let normal = normal.normalize();
        // Out of the material, where the probe came from.
        let up = if normal.z < 0.0 { -normal } else { normal };
        let sections = [atan2d(-up.y, up.z), atan2d(up.x, up.z)];
        let rotary = [-atan2d(up.y, libm::hypot(up.x, up.z)), atan2d(up.x, up.z)];
        let [a, b, c] = self.spatial_angles(along.normalize(), normal);
        Self::put_all(call, &[sections[0], sections[1], rotary[0], rotary[1], a, b, c], exec);
        Ok(())
    }

    /// The angles about X, then the fixed Y, then the fixed Z that turn the working plane to a
    /// main axis and a tool axis.
    fn spatial_angles(&self, main: DVec3, tool: DVec3) -> [f64; 3] {
        let system = &self.drives.world.system;
        let turned = [main, tool.cross(main), tool].map(|axis| system.axes(axis));
        let plane = system.plane;
        let axes = [plane.main, plane.secondary, plane.tool];
        let column = |wanted: Axis| {
            axes.iter().zip(turned).find(|(axis, _)| **axis == wanted).map_or(DVec3::ZERO, |(_, column)| column)
        };
        let matrix = DMat3::from_cols(column(Axis::X), column(Axis::Y), column(Axis::Z));
        let (x, y, z) = (matrix.x_axis, matrix.y_axis, matrix.z_axis);
        let level = libm::hypot(x.x, x.y);
        let b = atan2d(-x.z, level);
        if level <= ON_LINE {
            // Only the sum or the difference of A and C matters: C stays 0.
            return [atan2d(-z.y, y.y), b, 0.0];
        }
        [atan2d(y.z, z.z), b, atan2d(x.y, x.x)]
    }

    /// Writes what a calibration found: effective radius and length into the tool table, the offset of the ball from
    /// the spindle axis into the probe table. The offset is given by how much it differs from the one in effect, in
    /// program coordinates. All of it acts at once.
    pub(super) fn store_probe_calibration(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let probe = self.drives.world.probe()?;
        let tool = self.drives.world.tool().unwrap_or_default();
        for (index, column) in ["R", "L"].into_iter().enumerate() {
            if let Some(value) = self.optional(call, index, exec)? {
                // The oversizes of the table and of the tool call stay.
                let delta = self.drives.world.table(TableKind::Tool)?.number(tool.number, &format!("D{column}"))?;
                let called = if index == 0 { tool.deltas.0 } else { tool.deltas.1 };
                let cell = Cell::Number(value * self.drives.cycle_unit() - delta.unwrap_or_default() - called);
                self.write_cell(TableKind::Tool, tool.number, column, &cell)?;
            }
        }
        if let Some(Some(calc)) = call.with.get(2) {
            let change = self.drives.world.system.axes(self.point(calc, exec)?) * self.drives.cycle_unit();
            let change = self.drives.world.system.plane.flat(self.drives.world.system.frame().vector(change));
            let offset = probe.calibrated + change;
            for (column, value) in [("CAL_OF1", offset.x), ("CAL_OF2", offset.y)] {
                self.write_cell(TableKind::Probe, probe.row, column, &Cell::Number(value))?;
            }
        }
        self.drives.world.renew_tool()?;
        Ok(())
    }
}
