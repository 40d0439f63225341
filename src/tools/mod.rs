//! What is done with whole programs and with the whole catalogue: relabel, compare, convert, certify, execute the
//! examples of the specifications, count what is missing.
//!
//! Invariant: each tool yields values; how they are shown, and which files they come from, is for `cli`. A new command
//! that works on programs begins here.
pub mod certify;
pub mod compare;
pub mod conform;
pub mod convert;
pub mod coverage;
pub mod exchange;
pub mod rehearse;
pub mod translate;
