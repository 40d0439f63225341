//! The strategies that specifications name and the engine does not have yet, in alphabetical order.
//!
//! A run that comes to one of them ends as unsupported, and `ciklo coverage` lists it. Whoever writes one takes its name
//! from here; a specification that needs another one adds it.

/// Their names.
pub const PENDING: &[&str] = &[];
