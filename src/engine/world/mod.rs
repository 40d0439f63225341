//! The virtual machine as it is at a moment: position, coordinate system, tool, tables, touch probe.
//!
//! Start reading at [`state`]. Invariant: nothing moves by itself here and nothing is reported; who moves the machine
//! is `engine::motion`.
pub(crate) mod coordinates;
pub(crate) mod insert;
pub(crate) mod parallel;
pub(crate) mod setter;
pub(crate) mod setter_leaning;
pub(crate) mod state;
pub(crate) mod stylus;
