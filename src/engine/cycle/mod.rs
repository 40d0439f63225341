//! Execution of a cycle from its plan: values, guards, steps, series, patterns, logs.
mod act;
pub(in crate::engine) mod execute;
mod log;
pub(in crate::engine) mod pattern;
pub(in crate::engine) mod recall;
mod series;
