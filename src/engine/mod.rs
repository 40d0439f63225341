//! The reference engine: the virtual world in which programs run.
//!
//! Invariant: nothing here prints, reads files or knows a cycle; worlds are built from texts that are handed in.
pub mod geometry;
pub mod plan;
pub mod solid;
pub mod table;
