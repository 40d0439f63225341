//! The virtual machine as it is at a moment: position, coordinate system, tool, tables, touch probe.
//!
//! Start reading at [`state`]. Invariant: nothing moves by itself here and nothing is reported; who moves the machine
//! is `engine::motion`.
pub(in crate::engine) mod coordinates;
pub(in crate::engine) mod state;
pub(in crate::engine) mod stylus;
