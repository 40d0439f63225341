//! Movements of the machine: lines, arcs, rotary axes, the spindle, and probing.
pub(in crate::engine) mod axis;
pub(in crate::engine) mod functions;
pub(in crate::engine) mod moves;
pub(in crate::engine) mod plane;
pub(in crate::engine) mod probe;
pub(in crate::engine) mod spindle;
pub(in crate::engine) mod tcpm;
pub(in crate::engine) mod tilt;
pub(in crate::engine) mod turn;
