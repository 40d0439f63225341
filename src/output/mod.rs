//! What is made from the specifications for readers and for other programs: the manual, the parameter dialogs, the
//! export.
//!
//! Invariant: yields paths and bytes, writes no file. Start with [`manual`].
pub mod dialog;
pub mod export;
pub mod figure;
pub mod manual;
