//! The interpreter: executes a program in the world of a scene and reports what happens as events.
//!
//! Cycles are executed from their plans, so a specification and its execution cannot differ. Start reading at
//! [`Engine`], then `program` (the loop over blocks) and `block` (what each kind of block does). Invariant: knows no
//! cycle by number, reads and writes no files, prints nothing; the same program, scene and control give the same events.
mod block;
mod define;
mod engine;
mod form_element;
mod free;
mod lead;
mod mask;
mod motion;
mod parallel;
mod plane;
mod print;
mod program;
mod query;
mod spline;
mod sql;
mod statement;
mod surface;
mod tables;
mod tcpm;
mod texts;
mod transform;
mod turning;

pub use super::flow::calls::program_key;
pub use super::flow::settings::{Limits, NoTexts, Programs, Texts};
pub use super::machine::Tool;
pub use super::params::{Content, Params};
pub use super::report::envelope::{Ended, Envelope, FORMAT as ENVELOPE_FORMAT, Near, Obstacle, Touching};
pub use super::report::event::{
    At, Coordinates, Event, EventKind, FORMAT, FindingKind, MessageKind, MoveKind, OnDiameter, PASSED_OVER, Probing,
    Slid, Status, Threaded, Turned,
};
pub use super::report::fault::{CODES, Class, Fault};
pub use super::report::foreign_outcome::ForeignOutcome;
pub use super::report::json_line::Lines;
pub use super::report::outcome::{Noted, Outcome, Shown};
pub use super::report::trace::{Trace, Traced};
pub use super::world::coordinates::System;
pub use engine::Engine;
