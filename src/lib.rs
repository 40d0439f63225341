//! Ciklo: one declarative specification of each CNC cycle, read by a dialog generator, an NC block
//! printer, a manual generator, a program checker and a reference engine.
//!
//! The groups in the order in which they may use each other: [`base`], [`spec`], [`language`], [`program`], [`check`],
//! [`engine`], [`tools`], [`output`], [`system`], [`cli`]. `ARCHITECTURE.md` says what each of their modules does and
//! must not know.
pub mod base;
pub mod check;
pub mod cli;
pub mod engine;
pub mod language;
pub mod output;
pub mod program;
pub mod spec;
pub mod system;
pub mod tools;
