//! Spindle and coolant: turning, orienting, reversing, and moves in step with the spindle.
//!
//! Invariant: whatever the spindle does next is reported before the tool moves.
use crate::engine::geometry::Axis;
use crate::engine::machine::Tool;
use crate::engine::motion::drives::Drives;
use crate::engine::motion::drives::Spindle;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;

impl Drives<'_, '_> {
    pub(crate) fn spindle(&mut self, direction: i8) {
        self.switched.spindle = Spindle { direction, ..self.switched.spindle };
        self.report_spindle(None);
    }

    /// Reports how the spindle turns now, with the tool that it just got.
    pub(crate) fn report_spindle(&mut self, tool: Option<(Tool, Axis)>) {
        let Spindle { speed, direction } = self.switched.spindle;
        self.report_turning(tool, direction, speed);
    }

    pub(crate) fn report_turning(&mut self, tool: Option<(Tool, Axis)>, direction: i8, speed: f64) {
        if tool.is_some() {
            self.release_insert();
        }
        let speed = if direction == 0 { 0.0 } else { speed };
        self.report.report(EventKind::Spindle { tool, direction, speed, orient: None });
    }

    /// Turns the spindle so that the insert of the turning tool cuts where turning is aligned: by the angle of the insert
    /// in the tool table, the precession angle, and half a turn if the tool is reversed.
    pub(crate) fn orient_insert(&mut self) -> Done {
        let aligned = self.world.aligned();
        let half = if aligned.reversed { 180.0 } else { 0.0 };
        let angle = (self.world.insert_angle()? + aligned.precession + half).rem_euclid(360.0);
        self.orient(angle);
        Ok(())
    }

    /// The spindle is at an angle.
    pub(crate) fn orient(&mut self, angle: f64) {
        self.switched.spindle.direction = 0;
        self.switched.orientation = angle;
        self.report.report(EventKind::Spindle { tool: None, direction: 0, speed: 0.0, orient: Some(angle) });
    }

    pub(crate) fn coolant(&mut self, on: bool) {
        self.switched.coolant = on;
        self.report.report(EventKind::Coolant(on));
    }
}
