//! Movements of the machine: lines, arcs, rotary axes, the spindle, probing.
//!
//! Start reading at [`drives`], then [`moves`]. Invariant: knows no program, no Q parameter and no cycle; what is wanted
//! comes as coordinates and speeds, in mm. A movement that cannot be executed exactly is a fault.
mod around;
pub(crate) mod axis;
pub(crate) mod blank;
pub(crate) mod drives;
pub(crate) mod functions;
pub(crate) mod moves;
pub(crate) mod probe;
pub(crate) mod scan;
mod setter;
mod spindle;
mod tcpm;
pub(crate) mod tilt;
mod turn;
mod unit;
mod workpiece;
