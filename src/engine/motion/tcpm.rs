//! Holding the tool tip on the workpiece while rotary axes turn (`M128`), and counting positions from where they have
//! brought tool and workpiece while the linear axes stay (`M144`).
//!
//! Invariant: in both, the system is part of the workpiece and the control reckons with how the tool is.
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
        if held && self.world.system.axes_counted {
            return Err(Fault::program("m144-together").arg("word", "M128").into());
        }
        let before = self.world.system.reported();
        self.world.system.set_tip_held(held);
        self.world.carry_system();
        self.transformed(before);
        Ok(())
    }

    /// From here on positions count from where the rotary axes are, or no longer: the machine stays where it is. Not
    /// together with a tilted plane or a tip that is held.
    pub(crate) fn count_axes(&mut self, counted: bool) -> Done {
        self.not_beside_contour(if counted { "M144" } else { "M145" })?;
        if counted && self.world.system.tip_held {
            return Err(Fault::program("m144-together").arg("word", "M128").into());
        }
        let before = self.world.system.reported();
        self.world.system.set_axes_counted(counted);
        self.counted_alone()?;
        self.world.carry_system();
        self.transformed(before);
        Ok(())
    }

    /// A fault where the plane is tilted while positions count from the rotary axes.
    pub(crate) fn counted_alone(&self) -> Result<(), Fault> {
        let system = &self.world.system;
        let tilted = system.axes_counted && system.tilt().is_some();
        if tilted { Err(Fault::program("m144-together").arg("word", "PLANE")) } else { Ok(()) }
    }
}
