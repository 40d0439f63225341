//! M functions: what each number does.
//!
//! Invariant: a number that is not listed here is a fault where it is programmed, never ignored.

/// What an M function does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    Stop,
    End,
    Spindle(i8),
    Coolant(bool),
    /// The spindle is at the angle of the last orientation that was defined.
    Orient,
    SpindleAndCoolant(i8),
    CallAlways,
    CallOnce,
    /// Coordinates of the block are machine coordinates.
    MachineCoordinates,
    /// The tool tip is held on the workpiece while rotary axes turn, or no longer.
    HoldTip(bool),
    /// The tool moves away from the workpiece along its axis.
    Retract,
    /// Corners of the block are gone round in another way.
    Corner,
    /// It changes nothing that events say (tool change at the machine, display, look-ahead).
    Nothing,
}

pub(crate) fn effect(number: u16) -> Option<Effect> {
    Some(match number {
        0 | 1 => Effect::Stop,
        2 | 30 => Effect::End,
        3 => Effect::Spindle(1),
        4 => Effect::Spindle(-1),
        5 => Effect::Spindle(0),
        8 => Effect::Coolant(true),
        19 | 20 => Effect::Orient,
        9 => Effect::Coolant(false),
        13 => Effect::SpindleAndCoolant(1),
        14 => Effect::SpindleAndCoolant(-1),
        89 => Effect::CallAlways,
        99 => Effect::CallOnce,
        91 => Effect::MachineCoordinates,
        97 | 98 => Effect::Corner,
        140 => Effect::Retract,
        128 => Effect::HoldTip(true),
        129 => Effect::HoldTip(false),
        6 | 90 | 101 | 102 | 107 | 108 | 120 | 127 | 137 => Effect::Nothing,
        _ => return None,
    })
}
