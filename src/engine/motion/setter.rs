//! Measuring tools: the tool moves towards the tool setter until that triggers.
//!
//! Invariant: what the control learns is where the tip would be if the tool were as the tool table says; the true tool
//! and the true setter are the scene's.
use glam::DVec3;

use crate::engine::machine::Tool;
use crate::engine::motion::drives::Drives;
use crate::engine::report::ending::Done;
use crate::engine::report::event::{EventKind, Probing};
use crate::engine::report::fault::Fault;
use crate::engine::scene::{Edge, ToolSetter, TrueTool};
use crate::engine::world::setter::{Measured, Pose};

/// Ways that are shorter, mm, are none.
const NOTHING: f64 = 1e-9;

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
        Ok(gone.map(|_| stopped))
    }
}
