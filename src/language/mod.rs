//! Every text that a person reads, in the language of that person.
//!
//! [`locale`] is the one wrapper around Fluent, [`text`] gives the texts of one cycle, [`label`] prints NC blocks with
//! their comment labels, [`consistency`] compares what the languages state. Invariant: knows neither programs nor
//! pages; facts come from `spec`. Start with [`text`].
pub mod consistency;
pub mod label;
pub mod locale;
pub mod text;
