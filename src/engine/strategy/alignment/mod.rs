//! Strategies that say where the workpiece is: datum and presets, basic rotation, rotary axes, the tilted plane.
//!
//! Start reading at [`datum`]. Invariant: nothing is measured here; the values come from a cycle.
pub mod basic_rotation;
pub mod datum;
pub mod rotary;
pub mod tilting;
