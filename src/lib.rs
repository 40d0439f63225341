//! Ciklo: one declarative specification of each CNC cycle, read by a dialog generator, an NC block
//! printer, a manual generator, a program checker and a reference engine.
//!
//! See `ARCHITECTURE.md` for the map of the modules and what each of them must not know.
pub mod accord;
pub mod certify;
pub mod check;
pub mod cli;
pub mod compare;
pub mod conform;
pub mod convert;
pub mod coverage;
pub mod data;
pub mod diag;
pub mod dialog;
pub mod engine;
pub mod export;
pub mod expr;
pub mod fields;
pub mod iso;
pub mod label;
pub mod layout;
pub mod locale;
pub mod manual;
pub mod spec;
pub mod syntax;
pub mod system;
pub mod table;
pub mod text;
pub mod together;
pub mod translate;
