//! What everything else is built on: the embedded data, diagnostics and their places, threads, and the formulas
//! of the controls.
//!
//! Invariant: knows no cycle, no block of a program and no language. Start with [`diag`].
pub mod data;
pub mod demand;
pub mod diag;
pub mod expr;
pub mod parallel;
pub mod renamed;
pub mod xml;
