//! Holding the tool tip on the workpiece while rotary axes turn.
//!
//! Invariant: while it is held, the system is part of the workpiece and the control reckons with how the tool is.
use super::drives::Drives;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;

impl Drives<'_, '_> {
    /// From here on the tip is held, or no longer: the machine stays where it is.
    pub(crate) fn hold_tip(&mut self, held: bool) -> Done {
        self.not_beside_contour(if held { "M128" } else { "M129" })?;
        if held && self.world.tilting_axes.is_some() {
            return Err(Fault::unsupported("unsupported-m").arg("word", "M128, M138").into());
        }
        let before = self.world.system.reported();
        self.world.system.set_tip_held(held);
        self.world.carry_system();
        self.transformed(before);
        Ok(())
    }
}
