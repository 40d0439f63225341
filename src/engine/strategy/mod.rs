//! Strategies: what specifications cannot say step by step, as functions from named, typed arguments to a path of the
//! tool, to values, or to a change at the control.
//!
//! Start reading at [`registry`], which has one line for each, then at one of the families: a strategy is a type whose
//! fields are its arguments, with
//! - [`Milling`]: it draws a path ([`pen`]) from where the tool is,
//! - [`OverContours`]: the same over what was read or said before it: contours, a turning area, a groove, a thread,
//! - [`Calculation`]: it calculates values, or
//! - [`Action`]: it changes something through narrow traits of the control ([`action`]).
//!
//! Invariant: no strategy knows a run, a program, a Q parameter, the cycle that asks for it or another strategy; it does
//! one thing, for one level or one value. So each can be called, drawn and timed by itself. `engine::cycle` evaluates
//! arguments, moves the machine along paths and lends the control.
pub mod action;
pub mod alignment;
pub mod calculation;
pub mod contour;
pub mod digitizing;
pub mod kinematics;
pub mod milling;
pub mod outline;
pub mod pen;
pub mod probing;
pub mod program;
pub mod registry;
pub mod shape;
pub mod signature;
pub mod spindle;
pub mod turning;

pub use super::report::ending::{Done, Leave};
pub use action::Action;
pub use calculation::Calculation;
pub use contour::OverContours;
pub use milling::Milling;
pub use pen::{Cutter, Leg, Path};
pub use registry::{Does, STRATEGIES, Strategy};
pub use signature::{Argument, Given, Mm, Output, Parameter, Resulting, Results, Signature};
