//! Measuring tools: the tool moves towards the tool setter until that triggers.
//!
//! Invariant: what the control learns is where the tip would be if the tool were as the tool table says; the true tool
//! and the true setter are the scene's.
use glam::DVec3;

use crate::engine::machine::Tool;
use crate::engine::motion::drives::Drives;
use crate::engine::report::ending::Done;
use crate::engine::report::envelope::Touching;
use crate::engine::report::event::{EventKind, Probing};
use crate::engine::report::fault::Fault;
use crate::engine::scene::{Edge, ToolSetter, TrueTool};
use crate::engine::solid::Path;
use crate::engine::world::setter::{Course, Measured, Pose};

/// Ways that are shorter, mm, are none.
const NOTHING: f64 = 1e-9;
/// A circular path is straight pieces that are nowhere farther from it, mm.
const CHORD: f64 = 1e-4;
/// Two directions are the same if the cosine of the angle between them is not below this.
const STRAIGHT: f64 = 1.0 - 1e-9;

impl Drives<'_, '_> {
    /// The tool setter.
    pub(crate) fn tool_setter(&self) -> Result<&ToolSetter, Fault> {
        self.world.scene.setter.as_ref().ok_or_else(|| Fault::control("tool-setter-missing"))
    }

    /// What is true of the tool in the spindle.
    fn true_tool(&self, tool: &Tool) -> TrueTool {
        let said = self.world.scene.true_tools.iter().find(|(number, _)| *number == tool.number);
        let mut tool_is = said.map(|(_, tool)| tool.clone()).unwrap_or_default();
        if tool_is.edges.is_empty() {
            let of_start = self.world.scene_tool(tool.number).unwrap_or(*tool);
            let count = if tool.teeth >= 1.0 { tool.teeth as usize } else { 1 };
            tool_is.edges = vec![Edge { length: of_start.length, radius: of_start.radius }; count];
        }
        tool_is
    }

    /// Where the first edge is while the spindle is at 0: what the control finds while it touches with the tool turning.
    pub(crate) fn first_edge(&self) -> f64 {
        self.world.tool().map_or(0.0, |tool| self.true_tool(&tool).first)
    }

    /// Moves the tool in the machine until the setter triggers, and stays there. The tip then in machine coordinates;
    /// nothing, and at the end of the way, if it did not trigger. The way is along the tool axis or across it.
    pub(crate) fn touch_setter(&mut self, way: DVec3, feed: f64, pose: Pose) -> Done<Option<DVec3>> {
        self.count_move()?;
        let setter = self.tool_setter()?.clone();
        let tool = self.world.tool().unwrap_or_default();
        let true_tool = self.true_tool(&tool);
        let measured = Measured {
            tool: &tool,
            edges: &true_tool.edges,
            round: tool.teeth < 1.0,
            first: true_tool.first,
            misaligned: true_tool.misaligned,
        };
        let (plane, tip) = (self.world.system.plane, self.world.machine);
        let length = way.length();
        let direction = way / length;
        let (axis, up) = (plane.flat(tip - setter.at), plane.tool.of(tip - setter.at));
        // The spindle is as far above the tip as the table says that the tool is long.
        let spindle = up + tool.length;
        // It triggers once the face, or its side, is pushed in so far.
        let found = if plane.tool.of(direction).abs() > 0.5 {
            measured.length_over(setter.plate, axis, pose).map(|long| spindle - long + setter.pre_travel)
        } else {
            measured.way_to_side(setter.plate.smaller(setter.pre_travel), axis, plane.flat(direction), -spindle, pose)
        };
        if found.is_some_and(|gone| gone < -NOTHING) {
            return Err(Fault::control("probe-deflected").into());
        }
        let late = setter.scatter.get(self.world.triggered % setter.scatter.len().max(1)).copied().unwrap_or_default();
        let gone = found.map(|gone| gone.max(0.0) + late).filter(|gone| *gone <= length);
        self.world.triggered += usize::from(gone.is_some());
        let stopped = tip + direction * gone.unwrap_or(length);
        self.has_axes_to(stopped)?;
        self.world.within_limits(stopped)?;
        let (from, back) = (self.world.here, *self.world.system.back());
        let target = back.point(tip + way);
        let tip = back.point(stopped);
        let contact = gone.map(|_| (tip, tip));
        self.report.report(EventKind::Probe(Probing { from, target, contact, feed }));
        self.world.machine = stopped;
        self.world.renew();
        self.world.at_setter = gone.map(|_| direction);
        Ok(gone.map(|_| stopped))
    }

    /// An error if the tool gets into the tool setter on a path of its tip in the machine. Back from where it touched it
    /// may go. While the head is turned the setter is not looked at.
    pub(crate) fn meets_setter(&mut self, path: &Path) -> Done {
        let touched = self.world.at_setter.take();
        let Some(setter) = self.world.scene.setter.as_ref() else { return Ok(()) };
        let (Some(tool), None) = (self.world.tool(), &self.world.true_head) else { return Ok(()) };
        let back = |from: DVec3, to: DVec3| {
            touched.is_some_and(|touched| (from - to).normalize_or_zero().dot(touched) >= STRAIGHT)
        };
        if self.touching() != Touching::AsScene || matches!(*path, Path::Line { from, to } if back(from, to)) {
            return Ok(());
        }
        let (true_tool, plane) = (self.true_tool(&tool), self.world.system.plane);
        let (round, first, misaligned) = (true, true_tool.first, true_tool.misaligned);
        let measured = Measured { tool: &tool, edges: &true_tool.edges, round, first, misaligned };
        let at = |share: f64| {
            let from_face = path.at(share) - setter.at;
            (plane.flat(from_face), plane.tool.of(from_face) + tool.length)
        };
        let (pieces, nearer) = match *path {
            Path::Line { .. } => (1.0, 0.0),
            Path::Arc { centre, axis, from, sweep, .. } => {
                let radius = (from - centre).reject_from(axis).length();
                let angle = 2.0 * libm::acos(1.0 - (CHORD / radius).clamp(1e-12, 1.0));
                ((sweep.abs().to_radians() / angle).ceil().max(1.0), CHORD)
            }
        };
        // What is far from all of the path is far from each piece of it.
        let (middle, half) = (path.at(0.5), 0.5 * path.length());
        let widest = true_tool.edges.iter().map(|edge| edge.radius).fold(0.0, f64::max) + misaligned.length() + nearer;
        if plane.flat(middle - setter.at).length() > half + widest + setter.plate.reach() {
            return Ok(());
        }
        for piece in 0..pieces as u32 {
            let share = |piece: u32| f64::from(piece) / pieces;
            let course = Course { from: at(share(piece)), to: at(share(piece + 1)) };
            if measured.meets(setter.plate, &course, nearer) {
                let from = self.world.system.back().point(path.at(share(piece)));
                let fault = Fault::control("tool-setter-collision");
                return Err(fault.arg("x", from.x).arg("y", from.y).arg("z", from.z).into());
            }
        }
        Ok(())
    }
}
