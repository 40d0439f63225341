//! What is known of a cycle before any program is read: its labels, its guards, what its definitions do to the state of
//! the control. Each is made ready once, from specifications and texts.
//!
//! Invariant: nothing here knows a program.
mod aspect;
mod effect;
mod guard;
mod labels;
mod turns;

pub use aspect::{Aspect, Tri};
pub(crate) use effect::removes_material;
pub(super) use effect::{Effect, Then, probes, probes_around, stops_spindle};
pub(super) use guard::{OFF, Ready, STATES, aspect_of, guards_of, read_as, replaced, state, tool};
pub use labels::{CycleLabels, LabelBook, LanguageLabels, ParamLabels};
pub(super) use labels::{Kept, LabelLanguages, fold};
pub(crate) use labels::{is_label, is_label_by_place};
pub(super) use turns::Turns;
