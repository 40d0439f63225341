//! Measuring tools: the tool moves towards the tool setter until that triggers.
//!
//! Invariant: what the control learns is where the tip would be if the tool were as the tool table says; the true tool
//! and the true setter are the scene's.
use glam::{DVec2, DVec3};

use crate::base::expr::atan2d;
use crate::engine::geometry::Frame;
use crate::engine::machine::Tool;
use crate::engine::motion::drives::Drives;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::envelope::Touching;
use crate::engine::report::event::{EventKind, Probing};
use crate::engine::report::fault::Fault;
use crate::engine::scene::{Edge, ToolSetter, TrueTool};
use crate::engine::solid::Path;
use crate::engine::world::setter::{Course, Measured, Pose};
use crate::engine::world::setter_leaning::Leaning;

/// Ways that are shorter, mm, are none.
const NOTHING: f64 = 1e-9;
/// A circular path is straight pieces that are nowhere farther from it, mm.
const CHORD: f64 = 1e-4;
/// A tool that leans by less, as a sine, is at right angles to a face.
const ASKEW: f64 = 1e-9;
/// Two directions are the same if the cosine of the angle between them is not below this.
const STRAIGHT: f64 = 1.0 - 1e-9;

/// Whether a spindle with these axes is not at right angles to the face.
fn leans(axes: [DVec3; 3]) -> bool {
    axes[2].distance(DVec3::Z) > ASKEW
}

/// By how much a spindle is turned whose main axis is that, degrees.
fn turned_by(main: DVec3) -> f64 {
    if main.truncate() == DVec2::X { 0.0 } else { atan2d(main.y, main.x) }
}

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

    /// The frame from the directions in which the tool setter is mounted to the machine.
    pub(crate) fn setter_frame(&self) -> Result<Frame, Fault> {
        Ok(self.tool_setter()?.mounted())
    }

    /// Main, minor and tool axis of a spindle in a head, as main, minor and tool coordinate in these directions.
    fn spindle_axes(&self, head: Option<Frame>) -> Result<[DVec3; 3], Fault> {
        let (plane, back) = (self.world.system.plane, self.setter_frame()?.inverse());
        Ok([plane.main, plane.secondary, plane.tool].map(|axis| {
            let unit = axis.unit();
            let seen = back.vector(head.map_or(unit, |head| head.vector(unit)));
            plane.flat(seen).extend(plane.tool.of(seen))
        }))
    }

    /// By how much the spindle is turned against these directions by the head as the control knows it, degrees; an error
    /// where the tool is not at right angles to the face.
    fn turned_by_head(&self) -> Result<f64, Fault> {
        let [main, _, tool] = self.spindle_axes(self.world.head)?;
        if tool.distance(DVec3::Z) > ASKEW {
            return Err(Fault::control("tool-setter-askew"));
        }
        Ok(turned_by(main))
    }

    /// The true tip of a tool as the table has it, while the linear axes are there, seen from the centre of the face.
    fn from_face(&self, setter: &ToolSetter, machine: DVec3) -> DVec3 {
        let swung = self.world.true_head.map_or(DVec3::ZERO, |head| self.world.swing(&head));
        let drift = self.world.scene.truth.as_ref().map_or(DVec3::ZERO, |truth| truth.drift);
        setter.mounted().inverse().vector(machine + swung + drift - setter.at)
    }

    /// The tip of the tool in the directions of the setter, as the control knows it.
    pub(crate) fn tip_at_setter(&self) -> Result<DVec3, Fault> {
        let world = &self.world;
        let tool = world.system.plane.tool.unit();
        let along = world.head.map_or(tool, |head| head.vector(tool));
        // A table that is turned leaves the tool as it is in the machine, if the plane was turned to it.
        let frame = world.system.frame();
        let plane_is_askew =
            world.system.is_on_workpiece() && frame.vector(tool).normalize_or_zero().cross(along).length() > ASKEW;
        // Without a plane the control goes on as if the head was at 0.
        let unknown = match world.head {
            Some(head) if !world.system.is_on_workpiece() => world.swing(&head).length() > ASKEW,
            _ => false,
        };
        if plane_is_askew || unknown {
            return Err(Fault::unsupported("unsupported-transformation").arg("name", "tilting"));
        }
        self.turned_by_head()?;
        Ok(self.setter_frame()?.inverse().point(world.machine + world.swung()))
    }

    /// Moves the tip there at rapid traverse.
    pub(crate) fn go_at_setter(&mut self, to: DVec3) -> Done {
        let machine = self.setter_frame()?.point(to) - self.world.swung();
        self.straight_to(self.world.to_program(machine), Some(machine), Ok(Speed::Rapid))
    }

    /// Where the first edge is from the main direction of the setter while the spindle is at 0: what the control finds
    /// while it touches with the tool turning.
    pub(crate) fn first_edge(&self) -> Result<f64, Fault> {
        let turned = self.turned_by_head()?;
        Ok(turned + self.world.tool().map_or(0.0, |tool| self.true_tool(&tool).first))
    }

    /// Moves the tool until the setter triggers, and stays there: a way in the directions of the setter, along the tool
    /// axis or across it. The tip then, as [`Drives::tip_at_setter`] gives it; nothing, and at the end of the way, if it
    /// did not trigger.
    pub(crate) fn touch_setter(&mut self, way: DVec3, feed: f64, pose: Pose) -> Done<Option<DVec3>> {
        self.count_move()?;
        let setter = self.tool_setter()?.clone();
        let mounted = setter.mounted();
        let tool = self.world.tool().unwrap_or_default();
        let true_tool = self.true_tool(&tool);
        let measured = Measured {
            tool: &tool,
            edges: &true_tool.edges,
            round: tool.teeth < 1.0,
            first: true_tool.first,
            misaligned: true_tool.misaligned,
        };
        self.turned_by_head()?;
        let axes = self.spindle_axes(self.world.true_head)?;
        let plane = self.world.system.plane;
        let machine = self.world.machine;
        let length = way.length();
        let direction = way / length;
        let beside = self.from_face(&setter, machine);
        let (axis, up) = (plane.flat(beside), plane.tool.of(beside));
        // The spindle is as far above the tip as the table says that the tool is long.
        let spindle = up + tool.length;
        // It triggers once the face, or its side, is pushed in so far.
        let is_down = plane.tool.of(direction).abs() > 0.5;
        let pushed = if is_down { setter.plate } else { setter.plate.smaller(setter.pre_travel) };
        let found = if leans(axes) {
            let nose = axis.extend(up) + axes[2] * tool.length;
            let along = plane.flat(direction).extend(plane.tool.of(direction));
            let way = Leaning { measured, axes }.way_to(pushed, nose, along, pose);
            way.map(|way| if is_down { way + setter.pre_travel } else { way })
        } else {
            let pose = match pose {
                Pose::At(angle) => Pose::At(angle + turned_by(axes[0])),
                Pose::Turning => Pose::Turning,
            };
            if is_down {
                measured.length_over(pushed, axis, pose).map(|long| spindle - long + setter.pre_travel)
            } else {
                measured.way_to_side(pushed, axis, plane.flat(direction), -spindle, pose)
            }
        };
        if found.is_some_and(|gone| gone < -NOTHING) {
            return Err(Fault::control("probe-deflected").into());
        }
        let late = setter.scatter.get(self.world.triggered % setter.scatter.len().max(1)).copied().unwrap_or_default();
        let gone = found.map(|gone| gone.max(0.0) + late).filter(|gone| *gone <= length);
        self.world.triggered += usize::from(gone.is_some());
        let direction = mounted.vector(direction);
        let stopped = machine + direction * gone.unwrap_or(length);
        self.has_axes_to(stopped)?;
        self.world.within_limits(stopped)?;
        let from = self.world.here;
        let target = self.world.to_program(machine + direction * length);
        let tip = self.world.to_program(stopped);
        let contact = gone.map(|_| (tip, tip));
        self.report.report(EventKind::Probe(Probing { from, target, contact, feed }));
        self.world.machine = stopped;
        self.world.renew();
        self.world.at_setter = gone.map(|_| direction);
        Ok(gone.map(|_| mounted.inverse().point(stopped + self.world.swung())))
    }

    /// An error if the tool gets into the tool setter on a path of its tip in the machine. Back from where it touched it
    /// may go. While the head is not turned so that the tool is at right angles to the face, the setter is not looked at.
    pub(crate) fn meets_setter(&mut self, path: &Path) -> Done {
        let touched = self.world.at_setter.take();
        let Some(setter) = self.world.scene.setter.as_ref() else { return Ok(()) };
        let Some(tool) = self.world.tool().filter(|_| self.turned_by_head().is_ok()) else { return Ok(()) };
        let axes = self.spindle_axes(self.world.true_head)?;
        let back = |from: DVec3, to: DVec3| {
            touched.is_some_and(|touched| (from - to).normalize_or_zero().dot(touched) >= STRAIGHT)
        };
        if self.touching() != Touching::AsScene || matches!(*path, Path::Line { from, to } if back(from, to)) {
            return Ok(());
        }
        let (true_tool, plane) = (self.true_tool(&tool), self.world.system.plane);
        let (round, first, misaligned) = (true, true_tool.first, true_tool.misaligned);
        let measured = Measured { tool: &tool, edges: &true_tool.edges, round, first, misaligned };
        // The spindle nose beside the centre of the face and above it.
        let at = |share: f64| {
            let tip = self.from_face(setter, path.at(share));
            let nose = plane.flat(tip).extend(plane.tool.of(tip)) + axes[2] * tool.length;
            (nose.truncate(), nose.z)
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
        let longest = true_tool.edges.iter().map(|edge| edge.length).fold(tool.length, f64::max);
        let leaning = axes[2].truncate().length() * longest;
        if plane.flat(self.from_face(setter, middle)).length() > half + widest + leaning + setter.plate.reach() {
            return Ok(());
        }
        for piece in 0..pieces as u32 {
            let share = |piece: u32| f64::from(piece) / pieces;
            let course = Course { from: at(share(piece)), to: at(share(piece + 1)) };
            let meets = if leans(axes) {
                let leaning = Leaning { measured, axes };
                leaning.meets(setter.plate, leaning.noses(&course), nearer)
            } else {
                measured.meets(setter.plate, &course, nearer)
            };
            if meets {
                let from = self.world.to_program(path.at(share(piece)));
                let fault = Fault::control("tool-setter-collision");
                return Err(fault.arg("x", from.x).arg("y", from.y).arg("z", from.z).into());
            }
        }
        Ok(())
    }
}
