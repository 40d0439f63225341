//! Tapping: along the tool axis in step with the spindle.
//!
//! Invariant: whatever the spindle does next is reported before the tool moves.
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::motion::moves::Speed;
use crate::engine::plan::Calc;
use crate::engine::report::ending::Done;

impl<'e> Run<'_, 'e> {
    /// Along the tool axis in step with the spindle, which turns as the thread asks for in this direction; the speed
    /// of the program stays in force.
    pub(crate) fn synchronized(
        &mut self,
        tool: &Calc,
        pitch: &Calc,
        factor: Option<&Calc>,
        exec: &Exec<'_, 'e>,
    ) -> Done {
        let (height, pitch) = (self.number(tool, exec)?, self.number(pitch, exec)?);
        let factor = factor.map_or(Ok(1.0), |factor| self.number(factor, exec))?;
        let here = self.drives.in_plane(self.drives.world.here);
        if height == here.z {
            return Ok(());
        }
        // A right-hand thread goes in clockwise, against the direction of the tool axis.
        let direction = if (height < here.z) == (pitch > 0.0) { 1 } else { -1 };
        let speed = self.drives.switched.spindle.speed * factor;
        self.drives.switched.spindle.direction = direction;
        self.drives.report_turning(None, direction, speed);
        let to = self.drives.world.system.axes(here.truncate().extend(height));
        self.drives.straight_to(to, None, Speed::of_feed(pitch.abs() * speed))
    }
}
