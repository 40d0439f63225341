//! The coordinate system of a program: preset, datum shift, mirroring, rotation, scaling, tilting, in the order of
//! their definition.
//!
//! Invariant: program and machine coordinates convert into each other without loss of more than rounding.
use std::collections::BTreeSet;

use glam::DVec3;

use crate::engine::geometry::{Axis, Frame, WorkingPlane};
use crate::engine::report::event::Coordinates;
use crate::engine::scene::Preset;
use crate::spec::Transformation;

/// Relative differences of lengths and directions below this are rounding.
const SAME: f64 = 1e-9;

/// A change on top of the preset.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    Shift(DVec3),
    Rotate(f64),
    /// Axes that point the other way: -1, others 1; of the linear and the rotary axes.
    Mirror(DVec3, DVec3),
    Scale(f64),
    /// Factors of the axes and the point that stays.
    ScaleAxes(DVec3, DVec3),
    /// Spatial angles about the axes of the system so far: A, then B, then C.
    Tilt(DVec3),
    /// The point of a pattern at which a cycle is called.
    Point(DVec3),
}

/// A coordinate system.
#[derive(Clone, Debug)]
pub struct System {
    /// The row of the preset table.
    pub preset: f64,
    /// The preset in machine coordinates.
    pub origin: DVec3,
    /// Spatial angles of the preset: a basic rotation.
    pub basic: DVec3,
    /// Where the rotary axes have the coordinate 0 by the preset, in machine coordinates.
    pub angles: DVec3,
    /// The datum shift of the rotary axes.
    pub angle_shift: DVec3,
    /// The working plane.
    pub plane: WorkingPlane,
    /// Where the table has put the workpiece since the rotary axes were at 0; a tilted system goes with it, and so
    /// does every system while the tool tip is held.
    pub table: Frame,
    /// Whether the tool tip is held on the workpiece while rotary axes turn (M128, FUNCTION TCPM).
    pub tip_held: bool,
    /// Whether positions count from where the rotary axes have brought tool and workpiece (M144): the linear axes do not
    /// go with them.
    pub axes_counted: bool,
    /// Whether the workpiece is turned (`FUNCTION MODE TURN`): coordinates of X are diameters in programs.
    pub turning: bool,
    /// While a contour in the development of a cylinder is read whose coordinates of X are degrees: mm in a degree.
    pub unrolled: Option<f64>,
    /// Transformations in effect that the engine cannot execute: nothing moves until they end.
    pub unexecuted: BTreeSet<Transformation>,
    changes: Vec<Change>,
    /// In turning: by how much the system is turned about the rotary axis, degrees, and where the tip as the tables
    /// have it is beside the programmed position.
    turned: (f64, DVec3),
    frame: Frame,
    back: Frame,
}

impl System {
    pub(crate) fn new(plane: WorkingPlane) -> Self {
        Self {
            preset: 0.0,
            origin: DVec3::ZERO,
            basic: DVec3::ZERO,
            angles: DVec3::ZERO,
            angle_shift: DVec3::ZERO,
            plane,
            table: Frame::IDENTITY,
            tip_held: false,
            axes_counted: false,
            turning: false,
            unrolled: None,
            unexecuted: BTreeSet::new(),
            changes: Vec::new(),
            turned: (0.0, DVec3::ZERO),
            frame: Frame::IDENTITY,
            back: Frame::IDENTITY,
        }
    }

    /// From program coordinates to the machine.
    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// From the machine to program coordinates.
    pub const fn back(&self) -> &Frame {
        &self.back
    }

    /// From the coordinates of the preset to the machine.
    pub fn preset_frame(&self) -> Frame {
        Frame::placed(self.origin, self.basic)
    }

    /// The datum shift in effect.
    pub fn datum(&self) -> DVec3 {
        let shift = |change: &Change| if let Change::Shift(by) = change { Some(*by) } else { None };
        self.changes.iter().find_map(shift).unwrap_or(DVec3::ZERO)
    }

    /// The rotation in effect, degrees.
    pub fn rotation(&self) -> f64 {
        let angle = |change: &Change| if let Change::Rotate(angle) = change { Some(*angle) } else { None };
        self.changes.iter().find_map(angle).unwrap_or(0.0)
    }

    /// The spatial angles by which the working plane is tilted.
    pub fn tilt(&self) -> Option<DVec3> {
        self.changes.iter().find_map(|change| if let Change::Tilt(angles) = change { Some(*angles) } else { None })
    }

    /// The scaling factor and those of the axes, with the point that stays.
    pub fn scaling(&self) -> (f64, Option<(DVec3, DVec3)>) {
        let mut found = (1.0, None);
        for change in &self.changes {
            match change {
                Change::Scale(factor) => found.0 = *factor,
                Change::ScaleAxes(factors, about) => found.1 = Some((*factors, *about)),
                _ => {}
            }
        }
        found
    }

    /// Axes that point the other way, -1, others 1: the linear ones and the rotary ones.
    pub fn mirror(&self) -> (DVec3, DVec3) {
        let signs = |change: &Change| if let Change::Mirror(a, b) = change { Some((*a, *b)) } else { None };
        self.changes.iter().find_map(signs).unwrap_or((DVec3::ONE, DVec3::ONE))
    }

    /// Mirroring and rotation in effect as they act on the working plane about the datum, in the order in which they
    /// were defined.
    pub fn turned_about_datum(&self) -> Frame {
        let turns = self.changes.iter().filter(|change| matches!(change, Change::Rotate(_) | Change::Mirror(..)));
        turns.fold(Frame::IDENTITY, |frame, change| frame.of(self.frame_of(change)))
    }

    /// Whether a transformation is in effect, executed or not.
    pub fn has(&self, kind: Transformation) -> bool {
        let executed = self.changes.iter().any(|change| match change {
            Change::Mirror(..) => kind == Transformation::Mirroring,
            Change::Scale(_) => kind == Transformation::Scaling,
            Change::ScaleAxes(..) => kind == Transformation::AxisScaling,
            Change::Tilt(_) => kind == Transformation::Tilting,
            Change::Shift(_) | Change::Rotate(_) | Change::Point(_) => false,
        });
        executed || (kind == Transformation::Turning && self.turning) || self.unexecuted.contains(&kind)
    }

    /// By how much lengths of the working plane are scaled; nothing if circles become something else.
    pub fn plane_scale(&self) -> Option<f64> {
        let (a, b) = (self.frame.vector(self.plane.main.unit()), self.frame.vector(self.plane.secondary.unit()));
        let (long, other) = (a.length(), b.length());
        let round = (long - other).abs() <= SAME * long && a.dot(b).abs() <= SAME * long * other;
        round.then_some(if (long - 1.0).abs() <= SAME { 1.0 } else { long })
    }

    /// By how much lengths along the tool axis are scaled.
    pub fn depth_scale(&self) -> f64 {
        let long = self.frame.vector(self.plane.tool.unit()).length();
        if (long - 1.0).abs() <= SAME { 1.0 } else { long }
    }

    /// What lies outside the datum shift, as a frame, and what lies inside it: the preset with what was defined before
    /// it, and what was defined after it. A shift that is not in effect would come last.
    pub fn around_datum(&self) -> (Frame, Frame) {
        let is_shift = |change: &Change| matches!(change, Change::Shift(_));
        let at = self.changes.iter().position(is_shift).unwrap_or(self.changes.len());
        let (before, after) = self.changes.split_at(at);
        let inside = after.iter().skip(1).fold(Frame::IDENTITY, |frame, change| frame.of(self.frame_of(change)));
        (before.iter().fold(self.outermost(), |frame, change| frame.of(self.frame_of(change))), inside)
    }

    /// Where the rotary axes have the coordinate 0, in machine coordinates.
    pub fn angle_datum(&self) -> DVec3 {
        self.angles + self.angle_shift
    }

    pub(crate) fn set_preset(&mut self, row: f64, preset: Preset) {
        (self.preset, self.origin, self.basic, self.angles) = (row, preset.origin, preset.basic, preset.angles);
        self.rebuild();
    }

    /// Moves the preset that is in effect.
    pub(crate) fn set_origin(&mut self, origin: DVec3) {
        self.origin = origin;
        self.rebuild();
    }

    /// The basic rotation about the tool axis, degrees.
    pub fn basic_rotation(&self) -> f64 {
        self.plane.tool.of(self.basic)
    }

    pub(crate) fn set_basic_rotation(&mut self, degrees: f64) {
        self.basic = self.plane.tool.with(self.basic, degrees);
        self.rebuild();
    }

    pub(crate) fn set_plane(&mut self, axis: Axis) {
        self.plane = WorkingPlane::of_tool_axis(axis);
        self.rebuild();
    }

    pub(crate) fn set_datum(&mut self, by: DVec3) {
        self.change(Change::Shift(by), by == DVec3::ZERO);
    }

    pub(crate) fn set_rotation(&mut self, angle: f64) {
        self.change(Change::Rotate(angle), angle == 0.0);
    }

    /// Mirrors axes: those of -1; with all of them 1 nothing is mirrored.
    pub(crate) fn set_mirror(&mut self, linear: DVec3, rotary: DVec3) {
        self.change(Change::Mirror(linear, rotary), linear == DVec3::ONE && rotary == DVec3::ONE);
    }

    pub(crate) fn set_scale(&mut self, factor: f64) {
        self.change(Change::Scale(factor), factor == 1.0);
    }

    pub(crate) fn set_axis_scale(&mut self, factors: DVec3, about: DVec3) {
        self.change(Change::ScaleAxes(factors, about), factors == DVec3::ONE);
    }

    pub(crate) fn set_tilt(&mut self, angles: DVec3) {
        self.change(Change::Tilt(angles), angles == DVec3::ZERO);
    }

    /// An additional datum shift while a cycle is executed at a point of a pattern.
    pub(crate) fn set_point(&mut self, by: DVec3) {
        self.change(Change::Point(by), by == DVec3::ZERO);
    }

    /// Turns the system about the rotary axis, and puts the tip of the turning tool beside the programmed position.
    pub(crate) fn set_turned(&mut self, precession: f64, beside: DVec3) {
        self.turned = (precession, beside);
        self.rebuild();
    }

    /// The angle by which the system is turned about the rotary axis, degrees.
    pub const fn precession(&self) -> f64 {
        self.turned.0
    }

    pub(crate) fn set_tip_held(&mut self, held: bool) {
        self.tip_held = held;
        self.rebuild();
    }

    pub(crate) fn set_axes_counted(&mut self, counted: bool) {
        self.axes_counted = counted;
        self.rebuild();
    }

    pub(crate) fn set_table(&mut self, table: Frame) {
        self.table = table;
        self.rebuild();
    }

    /// Ends everything that programs change on top of the preset. Whether there was anything.
    pub(crate) fn end_changes(&mut self) -> bool {
        let any = !self.changes.is_empty() || self.angle_shift != DVec3::ZERO || self.tip_held || self.axes_counted;
        self.changes.clear();
        (self.tip_held, self.axes_counted) = (false, false);
        self.angle_shift = DVec3::ZERO;
        self.rebuild();
        any
    }

    /// What is newly defined acts in the system defined so far; what is redefined keeps its place.
    fn change(&mut self, change: Change, ends: bool) {
        let same = |other: &Change| std::mem::discriminant(other) == std::mem::discriminant(&change);
        match self.changes.iter().position(same) {
            Some(at) if ends => {
                self.changes.remove(at);
            }
            Some(at) => self.changes[at] = change,
            None if ends => {}
            None => self.changes.push(change),
        }
        self.rebuild();
    }

    /// Whether the system is part of the workpiece, and the control reckons with how the tool is.
    pub fn is_on_workpiece(&self) -> bool {
        self.knows_tool() || self.tilt().is_some()
    }

    /// Whether the control reckons with how the tool is, wherever the working plane is.
    pub const fn knows_tool(&self) -> bool {
        self.tip_held || self.axes_counted
    }

    /// The preset; of a system on the workpiece where the table has put it.
    fn outermost(&self) -> Frame {
        if self.is_on_workpiece() { self.table.of(self.preset_frame()) } else { self.preset_frame() }
    }

    fn rebuild(&mut self) {
        let mut frame = self.outermost();
        for change in &self.changes {
            frame = frame.of(self.frame_of(change));
        }
        let (precession, beside) = self.turned;
        if precession != 0.0 {
            frame = frame.of(Frame::rotate(Axis::Z, precession));
        }
        self.frame = if beside == DVec3::ZERO { frame } else { frame.of(Frame::shift(beside)) };
        self.back = self.frame.inverse();
    }

    fn frame_of(&self, change: &Change) -> Frame {
        match change {
            Change::Shift(by) | Change::Point(by) => Frame::shift(*by),
            Change::Rotate(angle) => Frame::rotate(self.plane.tool, *angle),
            Change::Mirror(signs, _) => Frame::scaled(*signs, DVec3::ZERO),
            Change::Scale(factor) => Frame::scaled(DVec3::splat(*factor), DVec3::ZERO),
            Change::ScaleAxes(factors, about) => Frame::scaled(*factors, *about),
            Change::Tilt(angles) => Frame::placed(DVec3::ZERO, *angles),
        }
    }

    /// What a coordinate of an axis is in a program where the way from the origin is 1: a diameter is twice as long.
    pub fn doubled(&self, axis: Axis) -> f64 {
        if self.turning && axis == Axis::X { 2.0 } else { 1.0 }
    }

    /// The same of all axes.
    pub fn doubled_axes(&self) -> DVec3 {
        if self.turning { DVec3::new(2.0, 1.0, 1.0) } else { DVec3::ONE }
    }

    /// Axis coordinates of a point given by main, minor and tool axis.
    pub fn axes(&self, plane_point: DVec3) -> DVec3 {
        self.plane.lift(glam::DVec2::new(plane_point.x, plane_point.y), plane_point.z)
    }

    /// The plane of contours: the working plane, in turning that of the rotary axis and X, in which the insert cuts.
    pub fn contour_plane(&self) -> WorkingPlane {
        let turned = self.turning && self.plane.tool == Axis::Z;
        if turned { WorkingPlane::of_tool_axis(self.plane.secondary) } else { self.plane }
    }

    /// Main, minor and tool coordinates of a point given by axes.
    pub fn in_plane(&self, axes: DVec3) -> DVec3 {
        let flat = self.plane.flat(axes);
        DVec3::new(flat.x, flat.y, self.plane.tool.of(axes))
    }

    /// The axis of a name in specifications.
    pub fn axis_of_word(&self, word: &str) -> Option<Axis> {
        Some(match word {
            "main" => self.plane.main,
            "minor" => self.plane.secondary,
            "tool" => self.plane.tool,
            _ => return None,
        })
    }

    /// The system as an event says it.
    pub fn reported(&self) -> Coordinates {
        Coordinates {
            preset: self.preset,
            origin: self.origin,
            basic_rotation: self.basic,
            datum: self.datum(),
            rotation: self.rotation(),
            mirror: self.mirror(),
            scaling: self.scaling(),
            tilt: self.tilt(),
            tip_held: self.tip_held,
            axes_counted: self.axes_counted,
            matrix: self.frame.rows(),
            angles: self.angle_datum(),
        }
    }
}
