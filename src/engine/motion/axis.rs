//! Which axis of the machine an axis word of a program names.
use crate::engine::geometry::{Axis as LinearAxis, RotaryAxis};
use crate::engine::report::fault::Fault;
use crate::program::syntax::Axis;

/// The linear axis of an axis word.
pub(crate) fn linear(axis: Axis) -> Result<LinearAxis, Fault> {
    match axis {
        Axis::X => Ok(LinearAxis::X),
        Axis::Y => Ok(LinearAxis::Y),
        Axis::Z => Ok(LinearAxis::Z),
        other => Err(Fault::unsupported("unsupported-axis").arg("axis", other.name())),
    }
}

/// The rotary axis of an axis word.
pub(crate) const fn rotary(axis: Axis) -> Option<RotaryAxis> {
    match axis {
        Axis::A => RotaryAxis::from_letter('A'),
        Axis::B => RotaryAxis::from_letter('B'),
        Axis::C => RotaryAxis::from_letter('C'),
        _ => None,
    }
}

/// The letter of the parallel axis of an axis word.
pub(crate) const fn parallel(axis: Axis) -> Option<char> {
    match axis {
        Axis::U => Some('U'),
        Axis::V => Some('V'),
        Axis::W => Some('W'),
        _ => None,
    }
}
